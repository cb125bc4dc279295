//! The first three joints: the constants by which they put the wrist centre in its place.
//!
//! # The shoulder frame
//!
//! z along joint axis 1; the origin at the foot, on axis 1, of the common normal of axes 1 and 2; x along that normal
//! (towards axis 2 where a1 > 0). ψ1 turns this frame about z; in the turned frame axis 2 passes through (a1, 0, 0) in the direction
//! z2 = (0, -sin α, cos α), the twist α being counted about x. ψ2 and ψ3 turn about z2.
//!
//! The figures themselves are in `planar`, `elbow` and [`general`](crate::ik::general).

use crate::ik::general::GeneralBase;
use crate::ik::planar::Planar;
use crate::ik::wrist::figure_angle;
use crate::math::{self, Float};
use crate::solutions::{ArmPosture, Boundary, Branch, Reason};

/// The constants of the first three joints: generated code writes them, or a run-time loader.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Base<T> {
    /// Three revolute joints, axes 2 and 3 parallel.
    Elbow(ElbowBase<T>),
    /// Two revolute joints and a slide at right angles to axis 2.
    Telescope(TelescopeBase<T>),
    /// Any other three joints.
    General(GeneralBase<T>),
}

/// Three revolute joints with axes 2 and 3 parallel: shoulder, upper arm and forearm.
///
/// Figure angles from row values: ψ = offset + t, or offset - t where the joint is reversed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ElbowBase<T> {
    /// From axis 1 to axis 2 along their common normal: negative where x points away from axis 2, as a table may have it.
    pub a1: T,
    /// Sine and cosine of the angle from axis 1 to axis 2 about their common normal; the sine is not zero.
    pub twist: (T, T),
    /// The distance of the wrist centre, along axis 2, from the foot of the common normal: h.
    pub lateral: T,
    /// The distance between axes 2 and 3, positive.
    pub upper: T,
    /// The distance of the wrist centre from axis 3, positive; nothing only where parameters put it on the axis.
    pub fore: T,
    /// The figure angles where the row values are 0.
    pub offset: [T; 3],
    /// Whether a figure angle falls where its row value rises.
    pub reversed: [bool; 3],
    /// The arm's reach.
    pub reach: T,
}

/// Two revolute joints and a slide at right angles to axis 2, as in the Stanford arm.
///
/// ψ3 is a length s along the slide, from the foot of the perpendicular on axis 2 (where the slide's line misses it).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TelescopeBase<T> {
    /// From axis 1 to axis 2 along their common normal: negative where x points away from axis 2, as a table may have it.
    pub a1: T,
    /// Sine and cosine of the angle from axis 1 to axis 2 about their common normal; the sine is not zero.
    pub twist: (T, T),
    /// The distance of the wrist centre, along axis 2, from the foot of the common normal: h.
    pub lateral: T,
    /// The distance between axis 2 and the line on which the wrist centre slides, not negative: b. The wrist centre is
    /// at Rz(ψ2)·(b, s).
    pub arm: T,
    /// The figure angles, and the figure length, where the row values are 0.
    pub offset: [T; 3],
    /// Whether a figure value falls where its row value rises.
    pub reversed: [bool; 3],
    /// The arm's reach.
    pub reach: T,
}

/// Row values that put the wrist centre in its place.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Placed<T> {
    /// Of joints 1, 2 and 3.
    pub rows: [T; 3],
    /// The distance of the wrist centre from the plane in which both shoulders are one.
    pub shoulder: T,
    /// The elbow's angle from stretched or folded, or the slide's extension.
    pub elbow: T,
    /// Whether joint 1 may take any other value.
    pub shoulder_free: bool,
    /// Whether joint 2 may take any other value.
    pub elbow_free: bool,
}

/// What became of the four branches of the base.
pub type Placements<T> = <ArmPosture as Branch>::Slots<Result<Placed<T>, Reason<T>>>;

impl<T: Float> Base<T> {
    /// All ways of putting the wrist centre at `p`, in the shoulder frame. `size` is what round-off is compared with;
    /// `hold` are row values for joints that turn out to be free; without one, such a joint takes the value 0.
    pub fn place(&self, p: [T; 3], size: T, hold: [Option<T>; 2]) -> Placements<T> {
        match self {
            Base::Elbow(base) => Planar::Elbow(base).place(p, size, hold),
            Base::Telescope(base) => Planar::Telescope(base).place(p, size, hold),
            Base::General(base) => base.place(p, size, hold),
        }
    }

    /// Whether every constant is a finite number: parameters may have made it otherwise.
    pub fn is_finite(&self) -> bool {
        match self {
            Base::Elbow(base) => Planar::Elbow(base).is_finite(),
            Base::Telescope(base) => Planar::Telescope(base).is_finite(),
            Base::General(base) => base.is_finite(),
        }
    }

    /// How much round-off of the point is magnified in the row values that are not free, about; how much of that the second figure
    /// sees of the first, which makes no more of it than its square root; and whether branches touch, so that it grows to its
    /// square root and no more.
    pub(crate) fn magnified(&self, placed: &Placed<T>) -> (T, T, bool) {
        let (zero, one, reach) = (T::lit(0.0), T::lit(1.0), self.reach());
        let by = |margin: T, free| match free {
            true => zero,
            false if margin == zero => T::lit(16.0) / math::sqrt(T::EPS),
            false => one / margin,
        };
        // The second figure sees what the first one has magnified as far as it lies along its distance.
        let (elbow, aside, distance) = match self {
            Base::Elbow(base) => (placed.elbow, base.a1, base.closing(placed)),
            Base::Telescope(base) => (placed.elbow / reach, base.a1, placed.elbow),
            Base::General(_) => (placed.elbow, reach, zero),
        };
        let aside = math::abs(aside) + placed.shoulder;
        let through = if aside < distance { aside / distance } else { one };
        let (first, second) =
            (by(placed.shoulder / reach, placed.shoulder_free), by(elbow, placed.elbow_free));
        let seen = through * math::min(first, T::lit(16.0) / math::sqrt(T::EPS));
        let touching = placed.shoulder == zero || placed.elbow == zero;
        (one + first + second * (one + through * first), seen, touching)
    }

    /// How far the point, which is at `p`, is from the axes of joints 1 and 2, where that is no more than `near`: round-off over it is
    /// what its place tells of their values. Of a general base only the part counts that the other two joints do not make up for. A
    /// slide has no such axis.
    pub(crate) fn beside_axes(&self, placed: &Placed<T>, p: [T; 3], near: T) -> [Option<T>; 2] {
        let [x, y, _] = p;
        // Most points are told by less than their distance.
        let is_far = |a: T| math::abs(a) > near;
        let beside = |a: T, b: T| (!is_far(a) && !is_far(b)).then(|| math::hypot(a, b));
        match self {
            Base::Elbow(base) => {
                let second = (!is_far(base.upper - base.fore)).then(|| base.second_distance(placed));
                [beside(x, y), second]
            }
            Base::Telescope(base) => [beside(x, y), beside(base.arm, placed.elbow)],
            Base::General(base) => {
                let near = |distance: Option<T>, joint| {
                    let distance = distance.filter(|distance| !is_far(*distance))?;
                    Some(distance * base.alone(placed, joint))
                };
                [near(base.first_distance(p), 0), near(base.second_distance(placed), 1)]
            }
        }
        .map(|distance| distance.filter(|distance| *distance <= near))
    }

    /// The arm's reach.
    pub fn reach(&self) -> T {
        match self {
            Base::Elbow(base) => base.reach,
            Base::Telescope(base) => base.reach,
            Base::General(base) => base.reach,
        }
    }
}

impl<T: Float> ElbowBase<T> {
    /// The distance that the links span where they are stretched or folded, whichever is nearer.
    fn closing(&self, placed: &Placed<T>) -> T {
        let ([_, _, t3], [_, _, offset], [_, _, reversed]) = (placed.rows, self.offset, self.reversed);
        let bend = math::abs(math::wrap(figure_angle(t3, offset, reversed)));
        if bend < math::half_turn::<T>() * T::lit(0.5) {
            self.upper + self.fore
        } else {
            math::abs(self.upper - self.fore)
        }
    }

    /// How far the wrist centre is from axis 2: the side of a triangle with the links, by the law of cosines.
    fn second_distance(&self, placed: &Placed<T>) -> T {
        let ([_, _, t3], [_, _, offset], [_, _, reversed]) = (placed.rows, self.offset, self.reversed);
        let (sine, cosine) = math::sin_cos(figure_angle(t3, offset, reversed) * T::lit(0.5));
        math::hypot((self.upper + self.fore) * cosine, (self.upper - self.fore) * sine)
    }
}

impl<T: Float> Reason<T> {
    pub(super) fn beyond(by: T, towards: Boundary) -> Self {
        Reason::OutOfReach { by, towards, theta1: None }
    }

    /// Remembers the value of joint 1 at which a later figure failed.
    pub(super) fn at(self, t1: T) -> Self {
        match self {
            Reason::OutOfReach { by, towards, .. } => Reason::OutOfReach { by, towards, theta1: Some(t1) },
            other => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Random;

    /// An elbow or a telescope of any proportions, in a unit of so many metres.
    fn base(random: &mut Random, unit: f64) -> Base<f64> {
        let [a1, lateral, upper, fore] = [(); 4].map(|()| unit * random.within(0.1, 0.6));
        let angle = random.within(0.5, 2.5);
        let (twist, reach) = (math::sin_cos(angle), 2.0 * unit);
        let (offset, reversed) =
            ([(); 3].map(|()| random.within(-1.0, 1.0)), [(); 3].map(|()| random.coin()));
        if random.coin() {
            Base::Elbow(ElbowBase { a1, twist, lateral, upper, fore, offset, reversed, reach })
        } else {
            let [o1, o2, o3] = offset;
            let offset = [o1, o2, o3 * unit];
            Base::Telescope(TelescopeBase { a1, twist, lateral, arm: upper, offset, reversed, reach })
        }
    }

    fn placed(base: &Base<f64>, p: [f64; 3]) -> [Option<Placed<f64>>; 4] {
        let mut all = [None; 4];
        let placements = base.place(p, base.reach(), [None; 2]);
        for (slot, posture) in all.iter_mut().zip(ArmPosture::ALL) {
            *slot = posture.of(&placements).as_ref().ok().copied();
        }
        all
    }

    fn moved(base: &Base<f64>, a: &Placed<f64>, b: &Placed<f64>) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|joint| a.rows[joint] - b.rows[joint]);
        let z = if matches!(base, Base::Telescope(_)) { z / base.reach() } else { math::wrap(z) };
        math::wrap(x).abs().max(math::wrap(y).abs()).max(z.abs())
    }

    /// Differences of neighbouring points show what round-off of the point does to the joints; it is never made out as less than
    /// a fraction of that, nor as less than its own, whatever the unit of length.
    #[test]
    fn what_magnifies_round_off_is_known_in_any_unit() {
        let mut random = Random(101);
        let mut seen = 0;
        for seed in 0..400 {
            let p = [(); 3].map(|()| random.within(-1.0, 1.0));
            let [metres, small] = [1.0, 1024.0].map(|unit| base(&mut Random(seed), unit));
            let (here, same) = (placed(&metres, p), placed(&small, p.map(|x| 1024.0 * x)));
            for (here, same) in here.iter().zip(&same) {
                let (Some(here), Some(same)) = (here, same) else { continue };
                let (times, second, touching) = metres.magnified(here);
                assert_eq!((times, second, touching), small.magnified(same), "{metres:?} at {p:?}");
                let h = 1e-7 / times;
                for axis in 0..3 {
                    let mut near = p;
                    near[axis] += h * metres.reach();
                    let there = placed(&metres, near);
                    let nearest = there.iter().flatten().map(|there| moved(&metres, here, there));
                    let rate = nearest.fold(f64::INFINITY, f64::min) / h;
                    assert!(rate <= 16.0 * times, "{rate} of {times}: {metres:?} at {p:?}, {here:?}");
                }
                seen += 1;
                // What is free takes its round-off from nowhere.
                let free = Placed { shoulder_free: true, elbow_free: true, ..*here };
                assert_eq!(metres.magnified(&free).0, 1.0);
            }
        }
        assert!(seen > 400, "{seen}");
    }
}
