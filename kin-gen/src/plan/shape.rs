//! What a plan depends on: how the axes of an arm lie to each other, and which of its lengths are zero.
//!
//! The frames of [`crate::algebra::frame`] leave some freedom: a quarter turn may stand before a joint or behind the
//! one before it, an origin may slide along its axis. [`super::gauge`] uses that freedom up, so that what is left is a
//! [`Shape`]: every two neighbouring groups stand at Rx(90°) to each other, every offset along an axis stands once, and
//! arms that differ in signs and conventions only have the same shape.
//!
//! ```text
//! F₀ ── d·z, Rz(Θ), x·x ──► F₁ ── Rx(90°) ── d·z, Rz(Θ), x·x ──► F₂ … tip
//! ```

use std::fmt;

/// Which lengths a joint of a group carries, from its axis to the next, in the frame that turns with it.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Link {
    /// A length along x.
    pub x: bool,
    /// A length along y.
    pub y: bool,
}

/// A run of joints with parallel axes.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Group {
    /// Whether there is an offset along the common direction of the axes.
    pub d: bool,
    /// One link for each joint.
    pub links: Vec<Link>,
}

/// A direction fixed in a group: its axis, or x or y of the frame that turns with one of its joints.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Direction {
    /// Along the axis of the group.
    Axis(usize),
    /// Along x of the joint's frame: group, joint in it.
    X(usize, usize),
    /// Along y of the joint's frame.
    Y(usize, usize),
}

/// The structure of a stretch of a chain.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Shape {
    /// The groups, each at Rx(90°) to the one before.
    pub groups: Vec<Group>,
    /// The directions in which prismatic joints move, in order.
    pub slides: Vec<Direction>,
}

impl Shape {
    /// The joints: (group, joint in it), in order.
    pub fn joints(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let of = |(group, g): (usize, &Group)| (0..g.links.len()).map(move |joint| (group, joint));
        self.groups.iter().enumerate().flat_map(of)
    }

    /// Reads what [`Shape`] prints.
    pub fn parse(text: &str) -> Option<Shape> {
        let mut shape = Shape::default();
        for word in text.split_whitespace() {
            if let Some(slide) = word.strip_prefix('/') {
                shape.slides.push(direction(slide)?);
                continue;
            }
            let (d, links) = match word.strip_prefix('d') {
                Some(rest) => (true, rest),
                None => (false, word),
            };
            shape.groups.push(Group { d, links: links.chars().map(link).collect::<Option<_>>()? });
        }
        Some(shape)
    }
}

fn link(letter: char) -> Option<Link> {
    match letter {
        '.' => Some(Link { x: false, y: false }),
        'x' => Some(Link { x: true, y: false }),
        'w' => Some(Link { x: true, y: true }),
        _ => None,
    }
}

fn direction(text: &str) -> Option<Direction> {
    let (kind, rest) = text.split_at_checked(1)?;
    let mut numbers = rest.split('.').map(|n| n.parse::<usize>().ok());
    let group = numbers.next()??;
    match (kind, numbers.next()) {
        ("z", None) => Some(Direction::Axis(group)),
        ("x", Some(joint)) => Some(Direction::X(group, joint?)),
        ("y", Some(joint)) => Some(Direction::Y(group, joint?)),
        _ => None,
    }
}

/// `d. dxx d. . .`: a word for each group, `d` for an offset, then `.`, `x` or `w` (x and y) for each joint's link;
/// `/z2` for a slide along the axis of group 2.
impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, group) in self.groups.iter().enumerate() {
            f.write_str(if index > 0 { " " } else { "" })?;
            f.write_str(if group.d { "d" } else { "" })?;
            for link in &group.links {
                f.write_str(match (link.x, link.y) {
                    (false, false) => ".",
                    (true, false) => "x",
                    _ => "w",
                })?;
            }
        }
        for slide in &self.slides {
            match slide {
                Direction::Axis(group) => write!(f, " /z{group}")?,
                Direction::X(group, joint) => write!(f, " /x{group}.{joint}")?,
                Direction::Y(group, joint) => write!(f, " /y{group}.{joint}")?,
            }
        }
        Ok(())
    }
}
