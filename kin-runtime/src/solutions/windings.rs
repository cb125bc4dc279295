//! Windings: the same solution some whole turns further, joint by joint, as far as the limits let it.

use super::{Branch, Move, Reason, Solution, Solutions};
use crate::limits::{Limits, Standing, Turns, principal, wound};
use crate::math::{self, Float};
use crate::pose::{self, Joints};

/// Joint values to be commanded, and the solution that they wind.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize, B: serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>, B: serde::Deserialize<'de>"
    ))
)]
pub struct Winding<T, const N: usize, B> {
    /// The joint values: those of the solution, whole turns added to angles. They may leave (-π, π].
    pub q: Joints<T, N>,
    /// The solution, its angles in (-π, π].
    pub solution: Solution<T, N, B>,
}

/// All windings of a set of solutions within limits: see [`Solutions::windings`].
#[derive(Clone, Debug)]
pub struct Windings<'a, T: Float, const N: usize, B: Branch> {
    solutions: &'a Solutions<T, N, B>,
    limits: Limits<N>,
    /// The slot to be looked at next.
    slot: usize,
    /// Of the solution before it, if windings are left.
    wheels: Option<Wheels<T, N, B>>,
}

/// A solution, and of each joint the turns that it may have and those that it has next.
type Wheels<T, const N: usize, B> = (Solution<T, N, B>, [(Turns<T>, T); N]);

impl<T: Float, const N: usize, B: Branch> Solutions<T, N, B> {
    /// Every solution with every choice of whole turns that keeps the limits: ranges longer than a turn have several,
    /// a range such as 170° .. 190° has its own. A joint that is not bounded on both sides counts once, least turned.
    ///
    /// Solutions come in the order of their branches, the windings of one in rising order, the last joint changing
    /// first. A family is represented by the member that it holds. There is no allocation, and no end is further than
    /// [`TURNS`](crate::limits::TURNS) turns; yet the windings of six joints multiply.
    pub fn windings(&self, limits: &Limits<N>) -> Windings<'_, T, N, B> {
        Windings { solutions: self, limits: *limits, slot: 0, wheels: None }
    }

    /// The winding within the limits that is nearest to `q`: the one whose largest joint move is smallest, among equals
    /// the one whose moves have the smallest sum. Moves are real ones: a turn more is a turn away. Slides count as in
    /// [`nearest`](Solutions::nearest).
    pub fn nearest_winding(&self, q: &Joints<T, N>, limits: &Limits<N>) -> Option<Winding<T, N, B>> {
        let mut best: Option<(Winding<T, N, B>, Move<T>)> = None;
        for solution in self.iter() {
            let Ok(winding) = self.wound(solution, q, limits) else { continue };
            let step = Move::between(&winding.q, q, |_, way| way);
            if best.as_ref().is_none_or(|(_, least)| step.is_smaller_than(least)) {
                best = Some((winding, step));
            }
        }
        best.map(|(winding, _)| winding)
    }

    /// The winding of one solution within the limits that is nearest to `q`.
    ///
    /// # Errors
    /// The joint that passes its range most.
    pub(crate) fn wound(
        &self,
        solution: &Solution<T, N, B>,
        q: &Joints<T, N>,
        limits: &Limits<N>,
    ) -> Result<Winding<T, N, B>, Reason<T>> {
        let mut values = pose::entries(&solution.q);
        for (joint, (value, to)) in values.iter_mut().zip(pose::entries(q)).enumerate() {
            match limits.nearest(joint, self.kind(joint), *value, to) {
                Some(nearest) => *value = nearest,
                None => return Err(self.outside(limits, &solution.q, joint)),
            }
        }
        Ok(Winding { q: pose::column(values), solution: *solution })
    }

    /// The joint that passes its range most; `joint` is one that does.
    fn outside(&self, limits: &Limits<N>, q: &Joints<T, N>, joint: usize) -> Reason<T> {
        self.passed(limits, q).unwrap_or(Reason::Limit { joint, by: T::lit(f64::INFINITY) })
    }

    /// By how much a joint vector passes the limits at most; nothing if it keeps them.
    pub(crate) fn passed(&self, limits: &Limits<N>, q: &Joints<T, N>) -> Option<Reason<T>> {
        let mut worst: Option<(usize, T)> = None;
        for (joint, value) in pose::entries(q).into_iter().enumerate() {
            if let Standing::Passed(by) = limits.standing(joint, self.kind(joint), value)
                && worst.is_none_or(|(_, most)| by > most)
            {
                worst = Some((joint, by));
            }
        }
        worst.map(|(joint, by)| Reason::Limit { joint, by })
    }
}

impl<T: Float, const N: usize, B: Branch> Windings<'_, T, N, B> {
    /// The next solution that has a winding, its wheels at their first turns.
    fn next_solution(&mut self) -> Option<Wheels<T, N, B>> {
        loop {
            let slot = self.solutions.slots().get(self.slot)?;
            self.slot += 1;
            let Some(solution) = slot.solution() else { continue };
            let mut joint = 0;
            let wheels = pose::entries(&solution.q).map(|value| {
                let turns = self.limits.counted(joint, self.solutions.kind(joint), value);
                joint += 1;
                (turns, turns.first)
            });
            if wheels.iter().all(|(turns, _)| turns.first <= turns.last) {
                return Some((*solution, wheels));
            }
        }
    }
}

impl<T: Float, const N: usize, B: Branch> Iterator for Windings<'_, T, N, B> {
    type Item = Winding<T, N, B>;

    fn next(&mut self) -> Option<Winding<T, N, B>> {
        let (solution, mut wheels) = match self.wheels.take() {
            Some(standing) => standing,
            None => self.next_solution()?,
        };
        let mut q = pose::entries(&solution.q);
        for (joint, (value, (_, turns))) in q.iter_mut().zip(&wheels).enumerate() {
            let kind = self.solutions.kind(joint);
            *value = wound(principal(kind, *value), *turns);
        }
        let mut carried = true;
        for (turns, now) in wheels.iter_mut().rev() {
            if !carried {
                break;
            }
            carried = *now >= turns.last;
            *now = if carried { turns.first } else { *now + T::lit(1.0) };
        }
        // A carry out of the first joint: all windings of this solution are out.
        self.wheels = (!carried).then_some((solution, wheels));
        Some(Winding { q: pose::column(q), solution })
    }
}

impl<T: Float> Move<T> {
    /// How far the joints move from one vector to another, as real moves; `weigh` may scale the way of a joint.
    pub(crate) fn between<const N: usize>(
        from: &Joints<T, N>,
        to: &Joints<T, N>,
        weigh: impl Fn(usize, T) -> T,
    ) -> Self {
        let mut step = Move { largest: T::lit(0.0), sum: T::lit(0.0) };
        for (joint, (a, b)) in pose::entries(from).into_iter().zip(pose::entries(to)).enumerate() {
            let way = math::abs(weigh(joint, b - a));
            step.largest = math::max(step.largest, way);
            step.sum += way;
        }
        step
    }
}
