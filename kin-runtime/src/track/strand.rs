//! One step of a strand: what the branches offer from where the joints are, which of it continues, and which heads on.

use super::{ASIDE, Goal, Track};
use crate::arm::Arm;
use crate::choice::{Offers, offers};
use crate::ik::given_out;
use crate::ik::target::distance;
use crate::limits::Limits;
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use crate::solutions::{Branch, Reason, Solution, Winding};

/// Where the joints are, and by how much they came there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seat<T, const N: usize> {
    pub(super) q: Joints<T, N>,
    pub(super) way: Joints<T, N>,
    /// How many poses have left a coordinate free: so many steps more are there to share its way to the exit.
    pub(super) free: usize,
}

impl<T: Float, const N: usize> Seat<T, N> {
    pub(super) fn at(q: Joints<T, N>) -> Self {
        Self { q, way: pose::column([T::lit(0.0); N]), free: 0 }
    }

    pub(super) fn moved<B: crate::Branch>(&self, to: &Winding<T, N, B>) -> Self {
        let free = if to.solution.is_isolated() { 0 } else { self.free + 1 };
        Self { q: to.q, way: combined(&to.q, &self.q, |a, b| a - b), free }
    }
}

/// Joint by joint.
pub(super) fn combined<T: Float, const N: usize>(
    a: &Joints<T, N>,
    b: &Joints<T, N>,
    join: impl Fn(T, T) -> T,
) -> Joints<T, N> {
    let mut joined = pose::entries(a);
    for (x, y) in joined.iter_mut().zip(pose::entries(b)) {
        *x = join(*x, y);
    }
    pose::column(joined)
}

/// What a branch offers, and how well.
#[derive(Clone, Copy)]
pub(super) struct Choice<T, const N: usize, B> {
    pub(super) winding: Winding<T, N, B>,
    /// For how many of the poses ahead it goes on.
    pub(super) lasts: usize,
    /// How far it is from where the joints were heading.
    pub(super) off: T,
}

impl<A: Arm<N>, T: Float, const N: usize, I: Iterator<Item = G::Target<T>> + Clone, G: Goal<A, N>>
    Track<'_, A, T, N, I, G>
{
    /// What the branches offer at a pose to joints that stand there.
    pub(super) fn offers(
        &self,
        seat: &Seat<T, N>,
        pose: &Pose<T>,
        hold: &Joints<T, N>,
        limits: &Limits<N>,
    ) -> Offers<T, N, G::Branch> {
        offers(&|hold: &_| G::solutions(self.arm, pose, hold), &A::JOINTS, (&seat.q, hold), limits)
    }

    /// Whether the step is a continuous one.
    pub(super) fn continues(&self, seat: &Seat<T, N>, pose: &Pose<T>, to: &Joints<T, N>) -> bool {
        let shares = T::lit(1.0) + T::lit(seat.free as f64);
        let largest = self.metric.between(&seat.q, to).largest;
        if largest > self.leap * shares || math::is_nan(largest) {
            return false;
        }
        let halfway = combined(&seat.q, to, |a, b| a + (b - a) * T::lit(0.5));
        let [here, middle, there] =
            [G::reached(self.arm, &seat.q), G::reached(self.arm, &halfway), *pose].map(|p| self.scaled(&p));
        let (mut apart, mut aside) = (T::lit(0.0), T::lit(0.0));
        for ((a, b), m) in here.iter().zip(&there).zip(&middle) {
            let mean = pose::entries(&combined(&pose::column(*a), &pose::column(*b), |a, b| {
                a + (b - a) * T::lit(0.5)
            }));
            apart = math::max(distance(a, b), apart);
            aside = math::max(distance(m, &mean), aside);
        }
        aside <= math::max(apart, T::lit(ASIDE))
    }

    /// The rows of a rotation, and the position in parts of the reach.
    pub(super) fn scaled(&self, pose: &Pose<T>) -> [[T; 3]; 4] {
        let ([x, y, z], p) = pose::rows(pose);
        let reach = T::lit(self.arm.reach());
        [x, y, z, p.map(|x| x / reach)]
    }

    /// How far joint values are from where the joints were heading: the sum of squares.
    pub(super) fn off(&self, seat: &Seat<T, N>, q: &Joints<T, N>) -> T {
        let heading = combined(&seat.q, &seat.way, |a, b| a + b);
        let ways = pose::entries(&combined(q, &heading, |a, b| a - b));
        ways.into_iter().enumerate().fold(T::lit(0.0), |sum, (joint, way)| {
            let way = self.metric.weigh(joint, way);
            sum + way * way
        })
    }

    /// Of the offers that continue, the one nearest to where the joints were heading, and how many there are.
    pub(super) fn heading(
        &self,
        seat: &Seat<T, N>,
        pose: &Pose<T>,
        offers: &Offers<T, N, G::Branch>,
    ) -> (Option<Choice<T, N, G::Branch>>, usize) {
        let (mut best, mut count): (Option<Choice<T, N, G::Branch>>, usize) = (None, 0);
        for winding in offers.as_ref().iter().flatten().flatten() {
            if !self.continues(seat, pose, &winding.q) {
                continue;
            }
            count += 1;
            let off = self.off(seat, &winding.q);
            if best.as_ref().is_none_or(|best| off < best.off) {
                best = Some(Choice { winding: *winding, lasts: 0, off });
            }
        }
        (best, count)
    }

    /// The continuous step that heads on, without looking further ahead.
    pub(super) fn headed(&self, seat: &Seat<T, N>, pose: &Pose<T>) -> Option<Winding<T, N, G::Branch>> {
        let offers = self.offers(seat, pose, &seat.q, &self.limits);
        let headed = self.heading(seat, pose, &offers).0.map(|choice| choice.winding);
        self.steadied(seat, pose, headed, &offers)
    }

    /// Where the figures have lost the joints to rounding: those that settle on the pose from where they were heading,
    /// the rest of the solution as the nearest offer has it.
    pub(super) fn settled(
        &self,
        seat: &Seat<T, N>,
        pose: &Pose<T>,
        offers: &Offers<T, N, G::Branch>,
    ) -> Option<Winding<T, N, G::Branch>> {
        let heading = combined(&seat.q, &seat.way, |a, b| a + b);
        let (q, residual) = G::settled(self.arm, pose, &heading)?;
        // Where nothing is offered, the pose that the joints were heading for is nearly this one.
        let like = self.nearest(seat, offers).or_else(|| {
            let offers = self.offers(seat, &G::reached(self.arm, &heading), &heading, &Limits::NONE);
            self.nearest(seat, &offers)
        });
        let like = like?.solution;
        let solution = Solution { q: given_out(pose::entries(&q), &A::JOINTS), residual, ..like };
        let continues = self.passed(&q).is_none() && self.continues(seat, pose, &q);
        continues.then_some(Winding { q, solution })
    }

    /// The offer nearest to where the joints were heading, whether it continues or not.
    fn nearest(
        &self,
        seat: &Seat<T, N>,
        offers: &Offers<T, N, G::Branch>,
    ) -> Option<Winding<T, N, G::Branch>> {
        let mut nearest: Option<(Winding<T, N, G::Branch>, T)> = None;
        for winding in offers.as_ref().iter().flatten().flatten() {
            let off = self.off(seat, &winding.q);
            if nearest.as_ref().is_none_or(|(_, least)| off < *least) {
                nearest = Some((*winding, off));
            }
        }
        nearest.map(|(winding, _)| winding)
    }

    /// The step itself, once it is known which offer heads on: another where none does, or where that one leaps and others
    /// are nearer to where the joints were heading.
    pub(super) fn steadied(
        &self,
        seat: &Seat<T, N>,
        pose: &Pose<T>,
        headed: Option<Winding<T, N, G::Branch>>,
        offers: &Offers<T, N, G::Branch>,
    ) -> Option<Winding<T, N, G::Branch>> {
        let Some(found) = headed.or_else(|| self.let_go(seat, pose, offers)) else {
            return self.settled(seat, pose, offers);
        };
        if self.is_steady(seat, &found) {
            return Some(found);
        }
        // A free coordinate may keep its value at a small price; it lets go of it where that is several times the other's.
        let price = if self.is_calm(seat, &found) { T::lit(1.0) } else { T::lit(4.0) };
        let nearer =
            |near: &Winding<T, N, G::Branch>| self.off(seat, &near.q) * price < self.off(seat, &found.q);
        Some(self.settled(seat, pose, offers).filter(nearer).unwrap_or(found))
    }

    /// Whether a step is not suddenly much longer than the one before it.
    fn is_calm(&self, seat: &Seat<T, N>, found: &Winding<T, N, G::Branch>) -> bool {
        self.metric.between(&seat.q, &found.q).largest <= T::lit(2.0) * self.metric.size(&seat.way)
    }

    /// Whether an offer can be trusted to be where the joints are heading, if any is there.
    ///
    /// Near a singular pose the figures give what rounding left of the joints, or nothing where they were, and the nearest
    /// branch beside it. And where two sets meet, the members that keep one of the free coordinates may be bent the other way:
    /// with joint 1 held, a wrist centre on axis 1 leaves a straight wrist bent by next to nothing, but towards a side of its
    /// own. Such steps are suddenly long.
    fn is_steady(&self, seat: &Seat<T, N>, found: &Winding<T, N, G::Branch>) -> bool {
        let (margins, reach) = (found.solution.margins, T::lit(self.arm.reach()));
        let wrist = margins.wrist.unwrap_or(reach);
        let (angle, length) =
            if G::Branch::MIRRORED { (margins.shoulder, wrist) } else { (wrist, margins.shoulder) };
        let far = math::min(angle, length / reach) > T::lit(64.0) * math::sqrt(T::EPS);
        self.is_calm(seat, found) && (far || !found.solution.is_isolated())
    }

    /// Free coordinates that go on as they were heading, where none of the members that keep them continues.
    pub(super) fn let_go(
        &self,
        seat: &Seat<T, N>,
        pose: &Pose<T>,
        held: &Offers<T, N, G::Branch>,
    ) -> Option<Winding<T, N, G::Branch>> {
        if held.as_ref().iter().flatten().flatten().all(|winding| winding.solution.is_isolated()) {
            return None;
        }
        let heading = combined(&seat.q, &seat.way, |a, b| a + b);
        let offers = self.offers(seat, pose, &heading, &self.limits);
        self.heading(seat, pose, &offers).0.map(|choice| choice.winding)
    }

    /// The joint that passes its range most, whole turns counted as such.
    pub(super) fn passed(&self, q: &Joints<T, N>) -> Option<Reason<T>> {
        let mut worst: Option<(usize, T)> = None;
        for (joint, value) in pose::entries(q).into_iter().enumerate() {
            let Some((low, high)) = self.limits.range(joint) else { continue };
            let (low, high) = (T::lit(low), T::lit(high));
            if low <= value && value <= high {
                continue;
            }
            // No value keeps a range that ends in what is not a number.
            let by = math::max(low - value, value - high);
            let by = if by > T::lit(0.0) { by } else { T::lit(f64::INFINITY) };
            if by > worst.map_or(T::lit(0.0), |(_, most)| most) {
                worst = Some((joint, by));
            }
        }
        worst.map(|(joint, by)| Reason::Limit { joint, by })
    }
}
