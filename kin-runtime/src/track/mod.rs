//! Paths of poses, or of places, followed in joint values, without a flip where one can be avoided, through singular poses too.
//!
//! # What a continuous step is
//!
//! From one pose to the next no joint moves by more than the *leap* (45°; a slide by that part of the arm's reach), and
//! halfway along the straight joint move the tool is no farther from halfway between the poses than these are apart, or
//! than 1e-4 of the reach if that is more. A step that is not continuous is a [`Step::Flip`], and says why.
//!
//! # What is guaranteed
//!
//! A flip is reported only where no solution of the pose, of any branch or winding and within the limits, and none of the
//! members of its families that are tried, continues the joints as they stand; it is never hidden in a continuous step. Where
//! branches meet (a stretched elbow, a straight wrist, the wrist centre crossing axis 1) or lie close, several solutions
//! continue: the one nearest to where the joints were heading is followed over the poses *ahead* (32), in steps of the same
//! kind; if it ends there, so are the others, and the one that goes farthest is taken. In the same way the end of a flip that
//! cannot be avoided is chosen.
//!
//! Within a family the free coordinates keep their values until the exit is in sight, and are then led to it in equal steps, so
//! that a wrist leaves its singularity without a jump if the exit is within the poses ahead. Where that would move the others
//! suddenly, and where rounding has lost the joints, they settle on the pose from where they were heading, to the same residual
//! as any solution: where two singular sets meet, the one member that goes on is found so, and no other is near it. (With the
//! wrist centre on axis 1 and the wrist straight, a joint 1 that is off by 1e-3 bends the wrist towards a side of its own.)
//!
//! Random paths of 41 poses, all in sight, by nine arms (elbow, slide, three skew axes, an oblique wrist, a spherical shoulder, two
//! solved from positions), through no singular set, through one, and where two and three meet, are followed by
//! `cargo run --release -p tests --bin motion -- --trajectories 0 --crossings 0 --paths 1e6`, which fails if one flips. Of its
//! 1,000,000 paths none flips and none is blocked; 3,196 end on other joint values than those that made them.
//! A choice whose consequence lies farther ahead is made by heading alone; and where two branches both continue, the path alone
//! cannot tell which of them it came from.
//!
//! Each step costs one solution of the pose; near meetings of branches about three; in a family, or where what is followed
//! ends among the poses ahead, up to the number of poses ahead times the number of branches, and to settle costs as much as a
//! few solutions more. Nothing is allocated: the poses ahead are read from a clone of the iterator.
//!
//! An arm that is solved from a position follows a path of points in the same way; of the tool only its place counts then, in
//! what a continuous step is too: [`track_position`](crate::PositionInverse::track_position).
//!
//! ```
//! use kin_runtime::prelude::*;
//!
//! fn follow<const N: usize, A: InverseKinematics<N>>(arm: &A, start: &Joints<f64, N>, path: &[Pose<f64>]) -> bool {
//!     let mut track = arm.track(start, path.iter().copied()).within(&arm.limits());
//!     track.all(|step| matches!(step, Step::Continuous(_)))
//! }
//! ```

mod census;
mod goal;
mod strand;

pub use census::{Census, Counted, Stop};
pub use goal::{ByPoint, ByPose, Goal};

use crate::arm::Arm;
use crate::choice::{Metric, Offers, refusal};
use crate::limits::Limits;
use crate::math::{self, Float};
use crate::pose::{self, Joints, Pose};
use crate::solutions::{Reason, Winding};
use core::fmt;
use core::marker::PhantomData;
use strand::{Choice, Seat, combined};

/// How far the tool may be off the way between two poses that coincide, in parts of the reach.
const ASIDE: f64 = 1e-4;

/// What became of one pose of a path.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: nalgebra::Scalar + serde::Serialize, B: serde::Serialize",
        deserialize = "T: nalgebra::Scalar + serde::Deserialize<'de>, B: serde::Deserialize<'de>"
    ))
)]
pub enum Step<T, const N: usize, B> {
    /// The joints go on without a jump.
    Continuous(Winding<T, N, B>),
    /// They cannot: the pose is reached, but not from where they stand.
    Flip {
        /// The joint values before it.
        from: Joints<T, N>,
        /// The joint values that reach the pose.
        to: Winding<T, N, B>,
        /// The joint that moves most, counted from 0.
        joint: usize,
        /// By how much it moves: radians or the declared unit of length.
        jump: T,
        /// Why there is no other way.
        cause: Cause<T>,
    },
    /// The pose cannot be reached; the joints stay, and the next pose is judged from where they are.
    Blocked(Reason<T>),
}

/// Why a flip cannot be avoided.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Cause<T> {
    /// The solution that was followed ends here: out of reach, or beyond the limit of a joint.
    Ended(Reason<T>),
    /// It goes on, but farther off than one step may go: the path passes a singular pose closely, or its poses are too
    /// far apart.
    Steep,
}

/// A path of poses, or of places, being followed: an iterator over its [`Step`]s. The [module](self) says what is guaranteed.
#[derive(Clone, Debug)]
pub struct Track<'a, A: Arm<N>, T: Float, const N: usize, I, G: Goal<A, N> = ByPose> {
    arm: &'a A,
    path: I,
    limits: Limits<N>,
    metric: Metric<T>,
    leap: T,
    ahead: usize,
    seat: Seat<T, N>,
    /// The branch of the last solution.
    branch: Option<G::Branch>,
    /// How many of the next poses are known to be reached without a flip.
    clear: usize,
    goal: PhantomData<G>,
}

impl<'a, A: Arm<N>, T: Float, const N: usize, I: Iterator<Item = G::Target<T>> + Clone, G: Goal<A, N>>
    Track<'a, A, T, N, I, G>
{
    pub(crate) fn new(arm: &'a A, start: &Joints<T, N>, path: I) -> Self {
        Self {
            arm,
            path,
            limits: Limits::NONE,
            metric: Metric::new(&A::JOINTS, arm.reach()),
            leap: math::half_turn::<T>() * T::lit(0.25),
            ahead: 32,
            seat: Seat::at(*start),
            branch: None,
            clear: 0,
            goal: PhantomData,
        }
    }

    /// Keeps the limits: every joint value that is given out lies in its range, windings included.
    #[must_use]
    pub fn within(mut self, limits: &Limits<N>) -> Self {
        self.limits = *limits;
        self
    }

    /// The largest joint move of a continuous step, in radians; 45° unless set.
    #[must_use]
    pub fn leap(mut self, leap: T) -> Self {
        self.leap = leap;
        self
    }

    /// How many poses ahead are looked at where branches meet; 32 unless set.
    #[must_use]
    pub fn ahead(mut self, poses: usize) -> Self {
        self.ahead = poses;
        self
    }

    /// Counts the solutions of each pose as well, for one solution of the pose more.
    pub fn counted(self) -> Counted<'a, A, T, N, I, G> {
        Counted(self)
    }

    /// Where the joints are.
    pub fn q(&self) -> &Joints<T, N> {
        &self.seat.q
    }

    /// The poses ahead.
    fn coming(&self) -> impl Iterator<Item = Pose<T>> + use<A, T, N, I, G> {
        self.path.clone().take(self.ahead).map(|target| G::pose(&target))
    }

    /// For how many of the poses ahead a solution goes on; all of them if the path ends before.
    fn lasts(&self, seat: &Seat<T, N>, to: &Winding<T, N, G::Branch>) -> usize {
        let mut seat = seat.moved(to);
        for (count, pose) in self.coming().enumerate() {
            match self.headed(&seat, &pose) {
                Some(next) => seat = seat.moved(&next),
                None => return count,
            }
        }
        self.ahead
    }

    /// What lasts longest of the offers, those that continue or all of them; among equals the one nearest to where the joints
    /// were heading.
    fn longest(
        &self,
        pose: &Pose<T>,
        offers: impl Iterator<Item = Winding<T, N, G::Branch>>,
        continuous: bool,
    ) -> Option<Choice<T, N, G::Branch>> {
        let mut best: Option<Choice<T, N, G::Branch>> = None;
        for winding in offers {
            if continuous && !self.continues(&self.seat, pose, &winding.q) {
                continue;
            }
            let (lasts, off) = (self.lasts(&self.seat, &winding), self.off(&self.seat, &winding.q));
            if best.as_ref().is_none_or(|best| lasts > best.lasts || (lasts == best.lasts && off < best.off))
            {
                best = Some(Choice { winding, lasts, off });
            }
        }
        best
    }

    /// The step to a pose: what heads on, unless that ends ahead and something else goes farther.
    fn chosen(
        &mut self,
        pose: &Pose<T>,
        offers: &Offers<T, N, G::Branch>,
    ) -> Option<Winding<T, N, G::Branch>> {
        let (headed, count) = self.heading(&self.seat, pose, offers);
        let found = self.steadied(&self.seat, pose, headed.map(|choice| choice.winding), offers)?;
        self.clear = self.clear.saturating_sub(1);
        if (count < 2 && found.solution.is_isolated()) || self.clear > self.ahead / 2 {
            return Some(found);
        }
        self.clear = self.lasts(&self.seat, &found);
        if self.clear >= self.ahead {
            return Some(found);
        }
        let free = !found.solution.is_isolated();
        let others = [
            if free { self.settled(&self.seat, pose, offers) } else { None },
            if free { self.let_go(&self.seat, pose, offers) } else { None },
        ];
        let all = offers.as_ref().iter().flatten().flatten().chain(others.iter().flatten()).copied();
        let longest = self.longest(pose, all, true).filter(|choice| choice.lasts > self.clear);
        let Some(choice) = longest else { return Some(found) };
        self.clear = choice.lasts;
        Some(choice.winding)
    }

    /// The member of a family on the way to where the path leaves it, if that is in sight.
    fn led(&self, pose: &Pose<T>, held: Winding<T, N, G::Branch>) -> Winding<T, N, G::Branch> {
        let Some((steps, exit)) = self.exit(&held) else { return held };
        let share = T::lit(1.0) / T::lit(steps as f64 + 1.0);
        let hold = combined(&self.seat.q, &exit, |now, then| now + (then - now) * share);
        let offers = self.offers(&self.seat, pose, &hold, &self.limits);
        for member in offers.as_ref().iter().flatten().flatten() {
            let nearer = || {
                let off = |q: &Joints<T, N>| self.metric.between(&hold, q).largest;
                off(&member.q) < off(&held.q) && self.continues(&self.seat, pose, &member.q)
            };
            if member.solution.branch == held.solution.branch && nearer() {
                return *member;
            }
        }
        held
    }

    /// The joint values at the first pose ahead that leaves nothing free, and how many steps ahead it is.
    fn exit(&self, held: &Winding<T, N, G::Branch>) -> Option<(usize, Joints<T, N>)> {
        let mut seat = self.seat.moved(held);
        for (count, pose) in self.coming().enumerate() {
            let next = self.headed(&seat, &pose)?;
            if next.solution.is_isolated() {
                return Some((count + 1, next.q));
            }
            seat = seat.moved(&next);
        }
        None
    }

    /// Why none of the offers continues.
    fn cause(&self, pose: &Pose<T>, offers: &Offers<T, N, G::Branch>) -> Cause<T> {
        if self.limits != Limits::NONE {
            let unlimited = self.offers(&self.seat, pose, &self.seat.q, &Limits::NONE);
            if let Some(choice) = self.heading(&self.seat, pose, &unlimited).0
                && let Some(reason) = self.passed(&choice.winding.q)
            {
                return Cause::Ended(reason);
            }
        }
        let ended = |branch: G::Branch| {
            crate::Branch::of(branch, offers).as_ref().and_then(|offer| offer.as_ref().err().copied())
        };
        self.branch.and_then(ended).map_or(Cause::Steep, Cause::Ended)
    }

    /// The step to a pose that no continuous step reaches.
    fn flip(&self, pose: &Pose<T>, offers: &Offers<T, N, G::Branch>) -> Step<T, N, G::Branch> {
        let all = offers.as_ref().iter().flatten().flatten().copied();
        let Some(choice) = self.longest(pose, all, false) else {
            return Step::Blocked(refusal::<T, N, G::Branch>(offers));
        };
        let (mut joint, mut most, mut jump) = (0, T::lit(-1.0), T::lit(0.0));
        let ways = combined(&choice.winding.q, &self.seat.q, |a, b| math::abs(a - b));
        for (count, way) in pose::entries(&ways).into_iter().enumerate() {
            let weight = self.metric.weigh(count, way);
            if weight > most {
                (joint, most, jump) = (count, weight, way);
            }
        }
        Step::Flip { from: self.seat.q, to: choice.winding, joint, jump, cause: self.cause(pose, offers) }
    }
}

impl<A: Arm<N>, T: Float, const N: usize, I: Iterator<Item = G::Target<T>> + Clone, G: Goal<A, N>> Iterator
    for Track<'_, A, T, N, I, G>
{
    type Item = Step<T, N, G::Branch>;

    fn next(&mut self) -> Option<Self::Item> {
        let pose = G::pose(&self.path.next()?);
        if !pose::entries(&self.seat.q).iter().all(|value| math::is_finite(*value)) {
            return Some(Step::Blocked(Reason::NotFinite));
        }
        let offers = self.offers(&self.seat, &pose, &self.seat.q, &self.limits);
        let step = match self.chosen(&pose, &offers) {
            Some(winding) if winding.solution.is_isolated() => Step::Continuous(winding),
            Some(winding) => {
                // What lay ahead was seen from a member that is not to be kept.
                self.clear = 0;
                Step::Continuous(self.led(&pose, winding))
            }
            None => self.flip(&pose, &offers),
        };
        match &step {
            Step::Continuous(to) => {
                self.seat = Seat { free: 0, ..self.seat.moved(to) };
                self.branch = Some(to.solution.branch);
            }
            Step::Flip { to, .. } => {
                (self.seat, self.branch, self.clear) = (Seat::at(to.q), Some(to.solution.branch), 0);
            }
            Step::Blocked(_) => (self.seat, self.clear) = (Seat::at(self.seat.q), 0),
        }
        Some(step)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.path.size_hint()
    }
}

impl<T, const N: usize, B> Step<T, N, B> {
    /// The joint values that reach the pose, by a jump or without one.
    pub fn q(&self) -> Option<&Joints<T, N>> {
        match self {
            Step::Continuous(to) | Step::Flip { to, .. } => Some(&to.q),
            Step::Blocked(_) => None,
        }
    }
}

impl<T: Float> fmt::Display for Cause<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Cause::Ended(reason) => write!(f, "{reason}"),
            Cause::Steep => f.write_str("no solution is nearer"),
        }
    }
}
