//! A wrist that the rounding of the base has bent: led back to where it is straight.
//!
//! Near a stretched elbow, or where the shoulders meet, joints 1 to 3 follow from the wrist centre with its round-off
//! magnified, and a wrist that was straight comes out bent by as much. There are joint values nearby at which axes 4 and 6
//! coincide and the wrist centre is where it was, because the base hardly moves it in that direction. They are found by
//! least squares: joints 1, 2, 3 and 6 move, joints 4 and 5 are held (of an arm whose first three axes meet, the same seen
//! from its tool).

use crate::arm::Arm;
use crate::ik::base::Placed;
use crate::ik::general::{less, solved};
use crate::ik::settle::{add, error, product};
use crate::ik::sphere::{View, motion};
use crate::ik::target::Target;
use crate::ik::wrist::WristFamily;
use crate::ik::{Base, DOUBTFUL, ROUND_OFF, given_out};
use crate::math::{self, Float};
use crate::pose::{self, Jacobian};
use crate::singularity::units;

/// How much more than the bend the joints may move: a turn by the bend takes about as much of them.
const FARTHEST: f64 = 16.0;

/// How often the motions of the joints are looked at, at most.
const LOOKS: usize = 3;

/// Steps at most after each look.
const STEPS: usize = 3;

/// A step, in radians and reaches, after which they are looked at anew.
const FAR: f64 = 1e-5;

/// What the members of a family that is declared here may miss the pose by, in units of ε: no more than any solution does.
const MISSED: f64 = 8.0;

/// How much of a bend may be round-off that the base has magnified, in units of ε times what the base makes of it.
const MAGNIFIED: f64 = 8.0;

/// And no more than so many √ε where branches of the base touch.
const TOUCHING: f64 = 256.0;

/// Or, where one figure touches and the next one, links all but folded or a slide all but pulled in, does so with what the first has
/// left, than so many roots of that.
const TWICE: f64 = 0.5;

/// Placements within this, in radians and reaches, are mostly one, seen through a base whose branches nearly touch.
const TOGETHER: f64 = 1e-4;

/// A bend that may be round-off.
#[derive(Clone, Copy)]
pub(super) struct Doubt<T> {
    pub(super) placed: Placed<T>,
    family: WristFamily<T>,
    bend: T,
}

impl<T: Float> Doubt<T> {
    /// Nothing, if the bend is more than round-off may be.
    pub(super) fn of(bend: T, family: WristFamily<T>, placed: &Placed<T>, base: &Base<T>) -> Option<Self> {
        let doubtful = may_be_round_off(bend, T::lit(MAGNIFIED), placed, base);
        doubtful.then_some(Doubt { placed: *placed, family, bend })
    }

    /// Whether the other has as good as the same bend: two figures of one, mirrored.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        math::abs(self.bend - other.bend) <= T::lit(TOGETHER) * self.bend
    }

    /// Whether no other bend together with this one is smaller.
    pub(super) fn is_likeliest<V: View>(&self, view: &V, all: &[Option<Self>; 4]) -> bool {
        let nearer =
            |other: &Self| other.bend < self.bend && together(view, self.placed.rows, other.placed.rows);
        !all.iter().flatten().any(nearer)
    }
}

/// Whether an angle that the sphere is bent by, or misses, may be round-off, of its own or of the base: so many ε, times what the base
/// makes of them.
pub(super) fn may_be_round_off<T: Float>(angle: T, most: T, placed: &Placed<T>, base: &Base<T>) -> bool {
    if angle <= T::lit(DOUBTFUL) * T::EPS {
        return true;
    }
    let (times, seen, touching) = base.magnified(placed);
    // Roots are taken last: few angles come so far.
    angle <= most * T::EPS * times
        && (!touching
            || angle <= T::lit(TOUCHING) * math::sqrt(T::EPS)
            || angle <= T::lit(TWICE) * math::sqrt(T::EPS * seen))
}

/// Whether row values of the base are mostly one placement.
pub(super) fn together<T: Float, V: View>(view: &V, here: [T; 3], there: [T; 3]) -> bool {
    let (joints, _) = V::apart(V::Arm::JOINTS);
    let ways = pose::entries(&given_out(less(here, there), &joints));
    let units = units(&joints, T::lit(view.arm().reach()));
    ways.into_iter().zip(units).all(|(way, unit)| math::abs(way) <= T::lit(TOGETHER) * unit)
}

/// Row values of the base at which the outer axes of the sphere coincide, and the family there, if its members reach the
/// pose. All of them turn the tool alike, so that one speaks for the rest.
#[inline(never)]
pub(super) fn straightened<T: Float, V: View>(
    view: &V,
    target: &Target<T>,
    Doubt { placed, family, bend }: &Doubt<T>,
) -> Option<([T; 3], WristFamily<T>)> {
    let (arm, zero, mut rows, mut family) = (view.arm(), T::lit(0.0), placed.rows, *family);
    let (reach, window) = (T::lit(arm.reach()), T::lit(MISSED) * T::EPS);
    let ([unit1, unit2, unit3], _) = V::apart(units(&V::Arm::JOINTS, reach));
    let member =
        |rows, family: &WristFamily<T>| pose::column(view.command(V::joined(rows, family.member(zero))));
    for _ in 0..LOOKS {
        let (mut at, jacobian) = arm.fk_jacobian(&member(rows, &family));
        let motions = Motions::new(view, placed, &jacobian, reach);
        let (mut moved, mut most) = (zero, T::lit(FARTHEST) * *bend);
        for _ in 0..STEPS {
            let ([d1, d2, d3], outer, left) = motions.step(error(&target.pose, &at, reach));
            let size = math::abs(d1) + math::abs(d2) + math::abs(d3);
            moved += size;
            // Of second order, and so not in what the step is seen to leave.
            let unseen = moved * size;
            if left > window + unseen || size > most {
                return None;
            }
            let [t1, t2, t3] = rows;
            rows = [t1 + d1 * unit1, t2 + d2 * unit2, t3 + d3 * unit3];
            family = family.straightened(outer);
            if unseen <= T::lit(ROUND_OFF) * T::EPS {
                return (left <= window).then_some((rows, family));
            }
            if size > T::lit(FAR) {
                break;
            }
            // After a short step the joints move the tool as they did before.
            (at, most) = (arm.fk(&member(rows, &family)), size * T::lit(0.125));
        }
    }
    None
}

/// How joints 1 to 3 move the tool for each radian or reach, joint 6 turning so that it makes up for as much as it can.
struct Motions<T> {
    base: [[T; 6]; 3],
    /// How far joint 6 would turn with each of them if it went along.
    shares: [T; 3],
    outer: [T; 6],
    /// One over the square of the length of `outer`.
    per_outer: T,
    /// The products of the motions with one another, by rows.
    products: [[T; 3]; 3],
}

impl<T: Float> Motions<T> {
    fn new<V: View>(view: &V, placed: &Placed<T>, jacobian: &Jacobian<T, 6>, reach: T) -> Self {
        let (zero, one) = (T::lit(0.0), T::lit(1.0));
        let ([unit1, unit2, unit3], _) = V::apart(units(&V::Arm::JOINTS, reach));
        let moving = |base, sphere| {
            let [vx, vy, vz, wx, wy, wz] = motion(view, jacobian, V::joined(base, sphere));
            [vx / reach, vy / reach, vz / reach, wx, wy, wz]
        };
        let still = [zero; 3];
        // A joint that is free stays where it was chosen.
        let chosen = |free| if free { zero } else { one };
        let (first, second) = (chosen(placed.shoulder_free), chosen(placed.elbow_free));
        let mut base = [
            moving([first * unit1, zero, zero], still),
            moving([zero, second * unit2, zero], still),
            moving([zero, zero, unit3], still),
        ];
        let outer = moving(still, [zero, zero, one]);
        let per_outer = one / product(&outer, &outer);
        let shares = base.each_ref().map(|motion| product(&outer, motion) * per_outer);
        for (motion, share) in base.iter_mut().zip(shares) {
            add(motion, &outer, -share);
        }
        let [a, b, c] = &base;
        let (aa, bb, cc) = (product(a, a), product(b, b), product(c, c));
        let (ab, ac, bc) = (product(a, b), product(a, c), product(b, c));
        let damping = (aa + bb + cc) * T::EPS * T::lit(16.0);
        let products = [[aa + damping, ab, ac], [ab, bb + damping, bc], [ac, bc, cc + damping]];
        Motions { base, shares, outer, per_outer, products }
    }

    /// The step of joints 1 to 3, in radians and reaches, that of joint 6, and the largest part of what is missed that they leave.
    fn step(&self, mut missed: [T; 6]) -> ([T; 3], T, T) {
        let zero = T::lit(0.0);
        let own = product(&self.outer, &missed) * self.per_outer;
        add(&mut missed, &self.outer, -own);
        let right = self.base.each_ref().map(|motion| product(motion, &missed));
        let step = solved(self.products, right).unwrap_or([zero; 3]);
        for (motion, by) in self.base.iter().zip(step) {
            add(&mut missed, motion, -by);
        }
        let left = missed.into_iter().fold(zero, |most, x| math::max(most, math::abs(x)));
        (step, own - pose::dot(&self.shares, &step), left)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ik::wrist::{Rows, Wrist, zyz};

    /// Of two figures of one placement the second is not tried again; what is bent otherwise is another.
    #[test]
    fn bends_are_alike_where_they_differ_by_a_ten_thousandth() {
        let placed = Placed {
            rows: [0.1, 0.2, 0.3],
            shoulder: 1.0,
            elbow: 1.0,
            shoulder_free: false,
            elbow_free: false,
        };
        let rows = Rows { offset: [0.0; 3], reversed: [false; 3] };
        let doubt = |bend: f64| {
            let upright = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            let Wrist::Family(family) = zyz(upright, &rows) else { panic!("it is straight") };
            Doubt { placed, family, bend }
        };
        for bend in [1e-14, 1e-9, 1e-4] {
            for near in [1.0, 1.0 + 5e-5, 1.0 - 5e-5] {
                assert!(doubt(bend).is_like(&doubt(bend * near)), "{bend:e} {near}");
            }
            for other in [0.0, 0.5, 1.0 - 2e-4, 1.0 + 2e-4, 3.0] {
                assert!(!doubt(bend).is_like(&doubt(bend * other)), "{bend:e} {other}");
            }
        }
    }
}
