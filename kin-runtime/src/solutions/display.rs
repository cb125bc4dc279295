//! The sentences: those that the program of seed 000 prints (its sections 5 and 6), each followed by our numbers.

use super::{Boundary, Branch, Constraint, Family, JointSet, Reason, Slot, Solution, Solutions};
use crate::math::{self, Float};
use crate::pose::{self, plain};
use core::fmt;

/// `theta4 and theta6`, `theta1, theta4 and theta6`; the words of the report.
impl fmt::Display for JointSet {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (count, joint) in self.iter().enumerate() {
            match count {
                0 => {}
                _ if count + 1 == self.len() => f.write_str(" and ")?,
                _ => f.write_str(", ")?,
            }
            write!(f, "theta{}", joint + 1)?;
        }
        Ok(())
    }
}

impl fmt::Display for Boundary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Boundary::Cylinder => "the cylinder about axis 1",
            Boundary::OuterCircle => "the outer circle",
            Boundary::InnerCircle => "the inner circle",
            Boundary::Envelope => "the surface that the arm reaches",
            Boundary::WristCone => "the cone of the wrist",
            Boundary::HandCylinder => "the cylinder about axis 6",
            Boundary::ShoulderCone => "the cone of the shoulder",
            Boundary::Surface => "the surface on which two joints carry the tool",
            Boundary::Reach => "the reach of the arm",
        })
    }
}

/// From here on a number is written with its exponent: nobody reads its last digits, and it may have three hundred.
const LARGE: f64 = 1e9;

/// Six decimals; what they would show as nothing, or as a long row of digits, is written with its exponent.
fn write_amount<T: Float>(f: &mut fmt::Formatter<'_>, by: T) -> fmt::Result {
    if by < T::lit(1e-3) || by >= T::lit(LARGE) { write!(f, "{by:.3e}") } else { write!(f, "{by:.6}") }
}

impl<T: Float> fmt::Display for Reason<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Reason::NotFinite => f.write_str("the coordinates inserted are not finite numbers"),
            Reason::NotAnArm => f.write_str(
                "the lengths and angles of the arm itself are not finite, or its lengths come to nothing",
            ),
            Reason::NotARotation { defect } => {
                write!(f, "the orientation inserted is not a rotation: R'R differs from 1 by {defect:.3e}")
            }
            Reason::LeftHanded => f.write_str(
                "the orientation inserted is left-handed: its determinant is -1, a rotation's is 1",
            ),
            Reason::OutOfReach { by, towards, theta1 } => {
                if let Some(theta1) = theta1 {
                    write!(f, "for theta1 = {:.4}, ", plain(*theta1, 4))?;
                }
                f.write_str("the coordinates inserted are out of reach: ")?;
                write_amount(f, *by)?;
                let side = match towards {
                    Boundary::OuterCircle | Boundary::Reach => "beyond",
                    Boundary::WristCone | Boundary::ShoulderCone | Boundary::Envelope | Boundary::Surface => {
                        "off"
                    }
                    Boundary::Cylinder | Boundary::HandCylinder | Boundary::InnerCircle => "inside",
                };
                write!(f, " {side} {towards}")
            }
            Reason::NoSuchBranch => f.write_str("the arm has no such branch there"),
            Reason::Orientation { by } => {
                f.write_str("the tool cannot be turned like that there: ")?;
                write_amount(f, *by)?;
                f.write_str(" radians are missing")
            }
            Reason::Limit { joint, by } => {
                write!(f, "the limit of joint {} is passed by ", joint + 1)?;
                write_amount(f, *by)
            }
            Reason::Inaccurate { residual } => {
                write!(
                    f,
                    "the joint values found miss the pose by {residual:.3e}, more than round-off explains"
                )
            }
        }
    }
}

impl<T: Float, const N: usize, B: Branch> fmt::Display for Family<'_, T, N, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.constraint() {
            Constraint::Sum { joints: [i, j], difference, equals } => {
                let sign = if difference { '-' } else { '+' };
                write!(f, "theta{} {sign} theta{} = {:.4}", i + 1, j + 1, plain(equals, 4))
            }
            Constraint::Line(line) => {
                let [line] = line.data.0;
                write!(f, "{} free along {line:?}", self.moving())
            }
            Constraint::Follow => {
                write!(f, "theta{} free", self.free() + 1)?;
                let followers = self.followers();
                match followers.len() {
                    0 => Ok(()),
                    1 => write!(f, ", {followers} follows"),
                    _ => write!(f, ", {followers} follow"),
                }
            }
        }
    }
}

impl<T: Float, const N: usize, B: Branch> Family<'_, T, N, B> {
    /// The moving joints but for the free one.
    fn followers(&self) -> JointSet {
        self.moving().iter().filter(|&joint| joint != self.free()).fold(JointSet::EMPTY, JointSet::with)
    }

    /// The warning that the program of seed 000 shows for this singularity.
    fn warn(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "SINGULARITY: There are infinite solutions for the value of {}. ", self.moving())?;
        if self.line().is_some() {
            return f.write_str("These angles will then assume symmetrical values.");
        }
        let [q] = self.solution().q.data.0;
        let value = q.get(self.free()).copied().unwrap_or(T::lit(0.0));
        write!(f, "By default, theta{} will assume the value {:.4}.", self.free() + 1, plain(value, 4))?;
        let followers = self.followers();
        if followers.is_empty() {
            return Ok(());
        }
        write!(f, " The value of {followers} must take into account other angles, ")?;
        f.write_str("and will be defined accordingly.")
    }
}

/// A joint value as it stands in its column.
fn write_joint<T: Float>(f: &mut fmt::Formatter<'_>, value: T, width: usize, digits: usize) -> fmt::Result {
    if math::abs(value) >= T::lit(LARGE) {
        write!(f, "{value:width$.digits$e}")
    } else {
        write!(f, "{:width$.digits$}", plain(value, digits))
    }
}

/// How many characters a joint value takes, its sign always counted, and exponents and what they stand for as well.
fn length<T: Float>(value: T, digits: usize) -> usize {
    let (mut left, mut whole) = (math::abs(value), 1);
    // At most nine rounds: larger numbers have exponents.
    while left >= T::lit(10.0) && left < T::lit(LARGE) {
        left /= T::lit(10.0);
        whole += 1;
    }
    let exponent = if left >= T::lit(LARGE) { "e308".len() } else { 0 };
    "-.".len() + whole + digits + exponent
}

/// The columns are as wide as the formatter says, or as an angle needs; a value that is wider still stands apart.
impl<T: Float, const N: usize, B: Branch> fmt::Display for Solution<T, N, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:<18}", self.branch)?;
        let digits = f.precision().unwrap_or(4);
        let width = f.width().unwrap_or(digits + 6);
        for value in pose::entries(&self.q) {
            f.write_str("  ")?;
            write_joint(f, value, width.saturating_sub(2), digits)?;
        }
        for (count, family) in self.families().enumerate() {
            write!(f, "{}{family}", if count == 0 { "   " } else { "; " })?;
        }
        Ok(())
    }
}

impl<T: Float, const N: usize, B: Branch> fmt::Display for Slot<T, N, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Slot::Solved(solution) => fmt::Display::fmt(solution, f),
            Slot::Merged { with } => write!(f, "the same as {with}"),
            Slot::Empty(reason) => write!(f, "{reason}"),
        }
    }
}

/// First each warning once, then one row for each branch.
impl<T: Float, const N: usize, B: Branch> fmt::Display for Solutions<T, N, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (count, slot) in self.slots().iter().enumerate() {
            if let Slot::Empty(reason) = slot
                && !self.slots().iter().take(count).any(|earlier| *earlier == Slot::Empty(*reason))
            {
                writeln!(f, "{reason}")?;
            }
        }
        for (count, solution) in self.iter().enumerate() {
            for family in solution.families() {
                let told = |earlier: &Solution<T, N, B>| {
                    earlier.families().any(|other| {
                        other.singularity() == family.singularity() && other.moving() == family.moving()
                    })
                };
                if !self.iter().take(count).any(told) {
                    family.warn(f)?;
                    writeln!(f)?;
                }
            }
        }
        let digits = f.precision().unwrap_or(4);
        let lengths = self.iter().flat_map(|s| pose::entries(&s.q)).map(|value| length(value, digits) + 2);
        let width = lengths.fold(digits + 6, usize::max);
        for (count, (branch, slot)) in self.branches().enumerate() {
            if count > 0 {
                writeln!(f)?;
            }
            match slot {
                Slot::Solved(solution) => write!(f, "{solution:width$.digits$}")?,
                Slot::Merged { with } => write!(f, "{branch:<18}  the same as {with}")?,
                Slot::Empty(_) => write!(f, "{branch:<18}  none")?,
            }
        }
        Ok(())
    }
}
