//! Pictures of arms: links, joints, frames, a target, several configurations over one another or side by side, from any
//! view.

use crate::model::{Body, Frame};
use crate::svg::{Anchor, Svg};
use crate::view::{Point, View, along, dot};

/// How a configuration is drawn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Look {
    /// In full colour.
    Solid,
    /// Pale, behind others.
    Ghost,
}

/// What stands in a picture, in the units of the arm.
#[derive(Clone, Debug)]
enum Item {
    Link { course: Vec<Point>, look: Look },
    Joint { at: Point, axis: Point, slides: bool, look: Look },
    Ground,
    Frame(Frame<f64>, f64),
    Target(Point),
    Path(Vec<Point>, &'static str),
    Note { at: Point, text: String },
}

/// A picture being composed.
#[derive(Clone, Debug)]
pub struct Picture {
    view: View,
    /// What the sizes of joints are a part of: the sum of the arm's lengths.
    reach: f64,
    unit: &'static str,
    items: Vec<Item>,
    labels: Vec<(Point, String)>,
}

/// What is seen of the world: left, right, bottom, top.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Window {
    /// Left, bottom.
    pub low: (f64, f64),
    /// Right, top.
    pub high: (f64, f64),
}

impl Window {
    /// The smallest window that shows what both show.
    pub fn with(self, other: Window) -> Window {
        Window {
            low: (self.low.0.min(other.low.0), self.low.1.min(other.low.1)),
            high: (self.high.0.max(other.high.0), self.high.1.max(other.high.1)),
        }
    }
}

/// From the world to pixels.
struct Sheet {
    view: View,
    scale: f64,
    corner: (f64, f64),
}

impl Sheet {
    fn at(&self, p: Point) -> (f64, f64) {
        let [x, y, _] = self.view.seen(p);
        (self.corner.0 + self.scale * x, self.corner.1 - self.scale * y)
    }
}

/// Radius and half the length of a joint, as parts of the reach.
const RADIUS: f64 = 0.024;
const HALF: f64 = 0.034;
/// Pixels around the drawing, and below it for the scale.
const MARGIN: f64 = 16.0;
const FOOT: f64 = 26.0;

impl Picture {
    /// An empty picture with the ground; `unit` names the lengths.
    pub fn new(view: View, reach: f64, unit: &'static str) -> Picture {
        Picture { view, reach, unit, items: vec![Item::Ground], labels: Vec::new() }
    }

    /// An arm, its tool frame drawn.
    #[must_use]
    pub fn arm(mut self, body: &Body<f64>, look: Look) -> Picture {
        for course in &body.links {
            self.items.push(Item::Link { course: course.clone(), look });
        }
        for (at, axis, slides) in &body.joints {
            self.items.push(Item::Joint { at: *at, axis: *axis, slides: *slides, look });
        }
        if look == Look::Solid {
            self.items.push(Item::Frame(body.tip, 0.09 * self.reach));
        }
        self
    }

    /// The joints' names beside them.
    #[must_use]
    pub fn named(mut self, body: &Body<f64>) -> Picture {
        let labels = body.joints.iter().enumerate().map(|(i, (at, ..))| (*at, format!("J{}", i + 1)));
        self.labels.extend(labels);
        self
    }

    /// The frame at the end of each joint's row.
    #[must_use]
    pub fn frames(mut self, body: &Body<f64>) -> Picture {
        let frames = [Frame::base()].into_iter().chain(body.frames.iter().copied());
        self.items.extend(frames.map(|frame| Item::Frame(frame, 0.06 * self.reach)));
        self
    }

    /// The point that is to be reached.
    #[must_use]
    pub fn target(mut self, at: Point) -> Picture {
        self.items.push(Item::Target(at));
        self
    }

    /// A course through space; `class` is one of the sheet's: `path`, `guide`, `figure`.
    #[must_use]
    pub fn path(mut self, points: Vec<Point>, class: &'static str) -> Picture {
        self.items.push(Item::Path(points, class));
        self
    }

    /// Words at a point.
    #[must_use]
    pub fn note(mut self, at: Point, text: impl Into<String>) -> Picture {
        self.items.push(Item::Note { at, text: text.into() });
        self
    }

    /// What has to be seen.
    pub fn window(&self) -> Window {
        let room = 1.6 * HALF * self.reach;
        let mut window: Option<Window> = None;
        let mut see = |p: Point, room: f64| {
            let [x, y, _] = self.view.seen(p);
            let own = Window { low: (x - room, y - room), high: (x + room, y + room) };
            window = Some(window.map_or(own, |w| w.with(own)));
        };
        for item in &self.items {
            match item {
                Item::Link { course, .. } => course.iter().for_each(|p| see(*p, room)),
                Item::Joint { at, .. } => see(*at, room),
                Item::Ground => see([0.0; 3], 2.0 * room),
                Item::Frame(frame, size) => {
                    see(frame.origin, room);
                    (0..3).for_each(|i| see(along(frame.origin, *size, frame.axis(i)), room));
                }
                Item::Target(at) | Item::Note { at, .. } => see(*at, room),
                Item::Path(points, _) => points.iter().for_each(|p| see(*p, 0.0)),
            }
        }
        window.unwrap_or(Window { low: (0.0, 0.0), high: (1.0, 1.0) })
    }

    /// The drawing, as wide as given, and as high as what it shows needs; `name` says what that is.
    pub fn draw(&self, width: f64, name: &str) -> Svg {
        self.draw_in(self.window(), width, name)
    }

    /// The drawing of a given window, so that pictures side by side have one scale.
    pub fn draw_in(&self, window: Window, width: f64, name: &str) -> Svg {
        let (wide, high) = (window.high.0 - window.low.0, window.high.1 - window.low.1);
        // A tall, narrow arm would fill a page: it is never more than 1.25 times as high as wide.
        let scale = ((width - 2.0 * MARGIN) / wide).min((1.25 * width - 2.0 * MARGIN) / high);
        let height = scale * high + 2.0 * MARGIN + FOOT;
        let left = (width - scale * wide) / 2.0;
        let corner = (left - scale * window.low.0, MARGIN + scale * window.high.1);
        let sheet = Sheet { view: self.view, scale, corner };
        let mut svg = Svg::new(width, height, name);
        let mut order: Vec<&Item> = self.items.iter().collect();
        order.sort_by(|a, b| self.rank(a).total_cmp(&self.rank(b)));
        for item in order {
            self.item(&mut svg, &sheet, item);
        }
        self.names(&mut svg, &sheet, width);
        self.scale_bar(&mut svg, scale, (MARGIN, height - 8.0));
        svg
    }

    /// What is farther from the viewer is drawn first, the ground before and words after everything.
    fn rank(&self, item: &Item) -> f64 {
        let depth = |p: Point| self.view.seen(p)[2];
        let far = 1e3 * self.reach;
        let ghostly = |look: &Look| if *look == Look::Ghost { -far } else { 0.0 };
        match item {
            Item::Ground => -3.0 * far,
            Item::Link { course, look } => {
                let sum: f64 = course.iter().map(|p| depth(*p)).sum();
                ghostly(look) + sum / course.len().max(1) as f64
            }
            Item::Joint { at, look, .. } => ghostly(look) + depth(*at) + HALF * self.reach,
            Item::Path(_, "path") => -1.5 * far,
            Item::Path(..) => far,
            Item::Frame(..) => 1.1 * far,
            Item::Target(_) => 1.2 * far,
            Item::Note { .. } => 1.3 * far,
        }
    }

    fn item(&self, svg: &mut Svg, sheet: &Sheet, item: &Item) {
        match item {
            Item::Ground => {
                let radii = 1.9 * HALF * self.reach * sheet.scale;
                let tilt = self.view.seen([0.0, 0.0, 1.0])[2].abs().max(0.12);
                svg.ellipse(sheet.at([0.0; 3]), (radii, radii * tilt), 0.0, "ground");
            }
            Item::Link { course, look } => {
                let points: Vec<_> = course.iter().map(|p| sheet.at(*p)).collect();
                let width = (0.75 * RADIUS * self.reach * sheet.scale).clamp(3.0, 9.0);
                with(svg, *look, |svg| {
                    svg.stroke(&points, width + 2.0, "edge");
                    svg.stroke(&points, width, "bar");
                });
            }
            Item::Joint { at, axis, slides, look } => {
                with(svg, *look, |svg| self.joint(svg, sheet, *at, *axis, *slides));
            }
            Item::Frame(frame, size) => {
                for (index, class) in ["x", "y", "z"].into_iter().enumerate() {
                    let end = along(frame.origin, *size, frame.axis(index));
                    svg.line(sheet.at(frame.origin), sheet.at(end), class);
                }
            }
            Item::Target(at) => {
                let (x, y) = sheet.at(*at);
                svg.circle((x, y), 7.0, "ring");
                svg.circle((x, y), 2.0, "dot");
            }
            Item::Path(points, class) => {
                let points: Vec<_> = points.iter().map(|p| sheet.at(*p)).collect();
                svg.polyline(&points, class);
            }
            Item::Note { at, text } => {
                let (x, y) = sheet.at(*at);
                svg.text((x + 6.0, y - 6.0), Anchor::Start, "halo", text);
            }
        }
    }

    /// A cylinder about the axis of a turning joint, a box along that of a sliding one.
    fn joint(&self, svg: &mut Svg, sheet: &Sheet, at: Point, axis: Point, slides: bool) {
        let seen = self.view.seen(axis);
        // The cap that faces the viewer is drawn last.
        let axis = if seen[2] < 0.0 { axis.map(|x| -x) } else { axis };
        let [ax, ay, depth] = self.view.seen(axis);
        let half = HALF * self.reach;
        let (far, near) = (sheet.at(along(at, -half, axis)), sheet.at(along(at, half, axis)));
        let radius = (RADIUS * self.reach * sheet.scale).max(3.5);
        let flat = ax.hypot(ay);
        let across = if flat > 1e-9 { (ay / flat, ax / flat) } else { (1.0, 0.0) };
        let side =
            |p: (f64, f64), sign: f64| (p.0 + sign * radius * across.0, p.1 + sign * radius * across.1);
        let barrel = [side(far, 1.0), side(near, 1.0), side(near, -1.0), side(far, -1.0)];
        let turn = across.1.atan2(across.0);
        if slides {
            svg.polygon(&barrel, "barrel");
            return;
        }
        svg.ellipse(far, (radius, radius * depth), turn, "cap");
        svg.polygon(&barrel, "barrel");
        svg.ellipse(near, (radius, radius * depth), turn, "cap");
    }

    /// The names of joints, those that fall together in one word.
    fn names(&self, svg: &mut Svg, sheet: &Sheet, width: f64) {
        let mut placed: Vec<((f64, f64), String)> = Vec::new();
        for (at, text) in &self.labels {
            let (x, y) = sheet.at(*at);
            match placed.iter_mut().find(|((px, py), _)| (x - px).hypot(y - py) < 18.0) {
                Some((_, together)) => *together = format!("{together}, {text}"),
                None => placed.push(((x, y), text.clone())),
            }
        }
        let mut taken: Vec<[f64; 4]> = Vec::new();
        for ((x, y), text) in placed {
            let wide = 7.5 * text.chars().count() as f64;
            // Beside the joint, right before left, above before below: the first place that no other name has.
            let places = [(14.0, -8.0), (-14.0, -8.0), (14.0, 18.0), (-14.0, 18.0)].map(|(dx, dy)| {
                let left = if dx > 0.0 { x + dx } else { x + dx - wide };
                ([left, y + dy - 11.0, left + wide, y + dy + 3.0], (x + dx, y + dy), dx > 0.0)
            });
            let free = |area: &[f64; 4]| {
                let apart =
                    |t: &[f64; 4]| area[0] > t[2] || t[0] > area[2] || area[1] > t[3] || t[1] > area[3];
                area[0] > 2.0 && area[2] < width - 2.0 && taken.iter().all(apart)
            };
            let (area, at, right) = places.into_iter().find(|(area, ..)| free(area)).unwrap_or(places[0]);
            taken.push(area);
            let anchor = if right { Anchor::Start } else { Anchor::End };
            svg.text(at, anchor, "halo small", &text);
        }
    }

    /// A length of one, two or five times a power of ten, about a fifth of the width.
    fn scale_bar(&self, svg: &mut Svg, scale: f64, (x, y): (f64, f64)) {
        let wanted = 70.0 / scale;
        let power = 10f64.powf(wanted.log10().floor());
        let length = [5.0, 2.0, 1.0].into_iter().map(|k| k * power).find(|l| *l <= wanted).unwrap_or(power);
        let end = x + length * scale;
        svg.line((x, y), (end, y), "axis");
        svg.line((x, y - 4.0), (x, y + 4.0), "axis");
        svg.line((end, y - 4.0), (end, y + 4.0), "axis");
        let text = format!("{length} {}", self.unit);
        svg.text((end + 6.0, y + 4.0), Anchor::Start, "soft small", &text);
    }
}

fn with(svg: &mut Svg, look: Look, draw: impl FnOnce(&mut Svg)) {
    if look == Look::Ghost {
        svg.group("ghost");
        draw(svg);
        svg.close();
    } else {
        draw(svg);
    }
}

/// The angle of `p` in a plane through `origin`, for arcs between directions.
pub fn arc(origin: Point, radius: f64, first: Point, second: Point, from: f64, to: f64) -> Vec<Point> {
    let point = |k: usize| {
        let angle = from + (to - from) * k as f64 / 24.0;
        along(along(origin, radius * angle.cos(), first), radius * angle.sin(), second)
    };
    debug_assert!(dot(first, second).abs() < 1e-6);
    (0..=24).map(point).collect()
}
