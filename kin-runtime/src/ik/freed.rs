//! Joints that the place of the carried point leaves free, asked of the orientation: for arms of [two to five joints](super::short).
//!
//! How well the axes of the turns fit the pose is A + B·cos t + C·sin t in the value of such a joint: it is asked for three values.
//! Where the point lies on the axes of joints 1 and 2 both, joint 1 alone tells how axis 2 stands. Seen from the turns the mean over
//! all turns about axis 2 of the rotation that is left is n·fᵀ: n is axis 2 as the arm has it, f as the pose asks for it. The same for
//! the last joint that carries the point, where lengths that are parameters put the point on its axis.

use crate::ik::general::{SLACK, length};
use crate::ik::short::{Task, Turns};
use crate::ik::wave::Wave;
use crate::math::{self, Float};
use crate::pose::{self, dot};
use crate::private::SolveShort;
use crate::solutions::{ArmPosture, Elbow, Free, JointSet, Loose, Shoulder};

/// How many values of a joint that stays free are tried, where not all of them leave the turns a way.
const TRIED: i32 = 16;

/// The angles at which a wave is asked for.
fn asked<T: Float>() -> [T; 3] {
    let quarter = math::half_turn::<T>() * T::lit(0.5);
    [T::lit(0.0), quarter, quarter + quarter]
}

fn with<T: Copy>(mut rows: [T; 3], index: usize, value: T) -> [T; 3] {
    if let Some(row) = rows.get_mut(index) {
        *row = value;
    }
    rows
}

impl<T: Float, A> Task<'_, T, A> {
    /// Row values of the joints that carry the point, those of the free ones as the orientation asks for them; and what it leaves
    /// free all the same.
    pub(super) fn oriented<const N: usize>(
        &self,
        posture: ArmPosture,
        rows: [T; 3],
        free: [bool; 2],
    ) -> ([T; 3], Free<N>)
    where
        A: SolveShort<N>,
    {
        let down = posture.elbow == Elbow::Down;
        match free {
            [false, false] => (rows, Free::NOTHING),
            [false, true] => self.either(1, down, rows),
            [true, false] if A::CARRIERS == 3 => self.either(0, posture.shoulder == Shoulder::Left, rows),
            [true, false] => self.either(0, down, rows),
            [true, true] => self.both(posture, rows),
        }
    }

    /// How well the axes of the turns fit, by the value of a joint.
    fn fit<const N: usize>(&self, index: usize, rows: [T; 3]) -> Wave<T>
    where
        A: SolveShort<N>,
    {
        Wave::through(asked().map(|value| self.turns.gap(&self.rest(with(rows, index, value)))))
    }

    /// Where they fit. With none or one they fit where they fit best; with two on either side of that.
    fn fitting(&self, fit: &Wave<T>, far: bool) -> T {
        match self.turns {
            Turns::Two { .. } => fit.zero(far),
            Turns::None | Turns::One { .. } => fit.top(),
        }
    }

    /// One joint.
    fn either<const N: usize>(&self, index: usize, far: bool, rows: [T; 3]) -> ([T; 3], Free<N>)
    where
        A: SolveShort<N>,
    {
        let fit = self.fit(index, rows);
        if fit.is_flat() {
            return (rows, self.family(index, rows, |value| with(rows, index, value)));
        }
        (with(rows, index, self.fitting(&fit, far)), Free::NOTHING)
    }

    /// Joints 1 and 2.
    fn both<const N: usize>(&self, posture: ArmPosture, rows: [T; 3]) -> ([T; 3], Free<N>)
    where
        A: SolveShort<N>,
    {
        let (down, left) = (posture.elbow == Elbow::Down, posture.shoulder == Shoulder::Left);
        let [t1, ..] = rows;
        let second = |t1: T| self.either::<N>(1, down, with(rows, 0, t1));
        let first = match self.turns {
            Turns::None | Turns::One { .. } => self.standing([0, 1], rows, left),
            Turns::Two { .. } if self.is_same_for_second(rows) => {
                let fit = self.fit(0, rows);
                (!fit.is_flat()).then(|| fit.zero(left))
            }
            Turns::Two { .. } => None,
        };
        if let Some(t1) = first {
            return second(t1);
        }
        let step = math::half_turn::<T>() * T::lit(2.0 / f64::from(TRIED));
        let mut values = (0..TRIED).map(|turn| math::wrap(t1 + step * T::lit(f64::from(turn))));
        let fits = |t1: &T| self.fit(1, with(rows, 0, *t1)).crosses();
        let tried = matches!(self.turns, Turns::Two { .. }) && !self.held;
        let t1 = if tried { values.find(fits).unwrap_or(t1) } else { t1 };
        let (chosen, _) = second(t1);
        (chosen, self.family(0, chosen, |t1| second(t1).0))
    }

    /// Whether the axes of the turns fit as well whatever joint 2 does.
    fn is_same_for_second<const N: usize>(&self, rows: [T; 3]) -> bool
    where
        A: SolveShort<N>,
    {
        let [t1, ..] = rows;
        // The last axis as the pose asks for it may happen to be axis 2, but not at both.
        [t1, t1 + T::lit(1.0)].into_iter().all(|t1| self.fit(1, with(rows, 0, t1)).is_flat())
    }

    /// Row values with the last joint that carries the point as the orientation asks for it, and the first of those before it that are
    /// free.
    pub(super) fn ended<const N: usize>(
        &self,
        posture: ArmPosture,
        mut rows: [T; 3],
        free: [bool; 2],
    ) -> [T; 3]
    where
        A: SolveShort<N>,
    {
        let last = A::CARRIERS.saturating_sub(1);
        let (down, left) = (posture.elbow == Elbow::Down, posture.shoulder == Shoulder::Left);
        if let Some(joint) = free.iter().position(|free| *free)
            && !matches!(self.turns, Turns::Two { .. })
            && let Some(value) = self.standing([joint, last], rows, left)
        {
            rows = with(rows, joint, value);
        }
        with(rows, last, self.fitting(&self.fit(last, rows), down))
    }

    /// The value of a joint at which the axis of one after it is where the pose asks for it, if it moves it at all: with one turn at the
    /// angle to the last axis that it has in the arm, of which there are two.
    fn standing<const N: usize>(&self, [joint, after]: [usize; 2], rows: [T; 3], far: bool) -> Option<T>
    where
        A: SolveShort<N>,
    {
        let [start, _, half] = asked();
        let means = asked().map(|value| {
            let [mut mean, there] =
                [start, half].map(|turn| self.rest(with(with(rows, joint, value), after, turn)));
            for (x, y) in mean.iter_mut().flatten().zip(there.iter().flatten()) {
                *x = (*x + *y) * T::lit(0.5);
            }
            mean
        });
        let [mean, ..] = &means;
        let [mut own, y, z] = pose::transposed(mean);
        for column in [y, z] {
            if dot(&column, &column) > dot(&own, &own) {
                own = column;
            }
        }
        let unit = length(own);
        let own @ [_, _, along] = own.map(|c| c / unit);
        let wanted = means.map(|mean| pose::transposed(&mean).map(|column| dot(&own, &column)));
        let alone = self.turns == Turns::None;
        let fit = Wave::through(
            wanted.map(|w @ [_, _, z]| if alone { dot(&own, &w) - T::lit(1.0) } else { z - along }),
        );
        (!fit.is_flat()).then(|| if alone { fit.top() } else { fit.zero(far) })
    }

    /// A joint that the orientation leaves free too, and the joints that follow it.
    fn family<const N: usize>(&self, index: usize, here: [T; 3], with: impl Fn(T) -> [T; 3]) -> Free<N>
    where
        A: SolveShort<N>,
    {
        let joint = A::ORDER.get(index).copied().unwrap_or(0);
        let mut moving = JointSet::EMPTY.with(joint);
        let now = here.get(index).copied().unwrap_or(T::lit(0.0));
        let (here, there) = (self.joints::<N>(here), self.joints::<N>(with(now + T::lit(0.5))));
        for (other, (a, b)) in pose::entries(&here).into_iter().zip(pose::entries(&there)).enumerate() {
            if math::abs(math::wrap(a - b)) > T::lit(SLACK) * math::sqrt(T::EPS) {
                moving = moving.with(other);
            }
        }
        let loose = Some(Loose::Follow { joint: joint as u8, moving });
        let (shoulder, elbow) = if index == 0 { (loose, None) } else { (None, loose) };
        Free { shoulder, elbow, wrist: None }
    }
}
