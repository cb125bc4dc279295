//! The sentences: those that the program of seed 000 prints (its sections 5 and 6), each followed by our numbers.

use super::{Boundary, Branch, Constraint, Family, JointSet, Reason, Singularity, Slot, Solution, Solutions};
use crate::math::Float;
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
        })
    }
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
                // A distance that six decimals would show as nothing is written with its exponent.
                if *by < T::lit(1e-3) {
                    write!(f, "{by:.3e}")?
                } else {
                    write!(f, "{by:.6}")?
                }
                let side = match towards {
                    Boundary::OuterCircle => "beyond",
                    Boundary::WristCone | Boundary::Envelope => "off",
                    Boundary::Cylinder | Boundary::InnerCircle => "inside",
                };
                write!(f, " {side} {towards}")
            }
            Reason::Limit { joint, by } => write!(f, "the limit of joint {} is passed by {by:.6}", joint + 1),
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
        match self.singularity() {
            Singularity::Wrist => f.write_str("These angles will then assume symmetrical values."),
            Singularity::Shoulder | Singularity::Elbow => {
                let [q] = self.solution().q.data.0;
                let value = q.get(self.free()).copied().unwrap_or(T::lit(0.0));
                write!(
                    f,
                    "By default, theta{} will assume the value {:.4}.",
                    self.free() + 1,
                    plain(value, 4)
                )?;
                let followers = self.followers();
                if followers.is_empty() {
                    return Ok(());
                }
                write!(f, " The value of {followers} must take into account other angles, ")?;
                f.write_str("and will be defined accordingly.")
            }
        }
    }
}

/// Writes the joint values in columns of the given number of decimals.
fn write_joints<T: Float, const N: usize, B>(
    f: &mut fmt::Formatter<'_>,
    solution: &Solution<T, N, B>,
    digits: usize,
) -> fmt::Result {
    let width = digits + 6;
    for value in pose::entries(&solution.q) {
        write!(f, "{:width$.digits$}", plain(value, digits))?;
    }
    Ok(())
}

impl<T: Float, const N: usize, B: Branch> fmt::Display for Solution<T, N, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:<18}", self.branch)?;
        write_joints(f, self, f.precision().unwrap_or(4))?;
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
        for (count, (branch, slot)) in self.branches().enumerate() {
            if count > 0 {
                writeln!(f)?;
            }
            match slot {
                Slot::Solved(solution) => write!(f, "{solution:.digits$}")?,
                Slot::Merged { with } => write!(f, "{branch:<18}  the same as {with}")?,
                Slot::Empty(_) => write!(f, "{branch:<18}  none")?,
            }
        }
        Ok(())
    }
}
