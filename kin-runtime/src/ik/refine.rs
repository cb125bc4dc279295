//! What the conics of a [general base](crate::ik::general) leave open, closed on the arm itself: damped Newton steps, undamped ones
//! beside a double root, and steps along the direction that is lost there.

use crate::ik::ROUND_OFF;
use crate::ik::conic::Way;
use crate::ik::general::{SLACK, Sized, across, cross, largest, length, less, plus, solved};
use crate::math::{self, Float};
use crate::pose::dot;
use crate::solutions::{ArmPosture, Elbow, Shoulder, tolerance};

/// The most refining steps; an ordinary solution needs one.
pub(super) const STEPS: usize = 16;

/// Damping, in ε of the trace, with which a step stays below √ε where the joints cannot close what is missed.
const STEADIED: f64 = 16.0;

/// Steps along a direction that is lost, each a quarter of the one before: from the longest to less than the root of what round-off may
/// leave open. The best of them takes back a tenth at least, and leaves the extremum, so that Newton's steps go on.
const SHORTER: usize = 12;

/// How often steps along what is lost are tried in one refinement, at most: each time costs as much as twice `SHORTER` steps.
const SOUGHT: usize = 3;

/// The longest step along a direction that is lost, in radians or parts of the size.
pub(super) const FARTHEST: f64 = 0.125;

/// A way that begins no farther beyond the middle of two roots, in parts of half of what is between them, begins on neither side.
const MIDDLE: f64 = 1.0 / 16.0;

/// The arm at some figure values, with the first joint taken back: what is missed, and how the joints move the point.
pub(super) struct Stance<T> {
    pub(super) missed: [T; 3],
    pub(super) velocities: [[T; 3]; 3],
}

impl<T: Float> Sized<T> {
    /// A way whose point passes axis 2, brought nearer: the conics know the square of its distance, of which round-off leaves
    /// nothing there, so that the direction in which joint 2 must point would be lost with it. Joints 1 and 3 make the heights
    /// equal, and the distances too, by a root of a quadratic equation: of the two, on either side of the nearest approach, the one that
    /// is the way's, and from there on the nearer one.
    pub(super) fn beside_second(&self, way: &Way<T>, side: Side) -> Way<T> {
        let ([first, second, third], mut way) = (&self.axes, *way);
        let near = T::lit(SLACK) * math::sqrt(T::EPS);
        let apart = |way: &Way<T>| {
            let (from, to) = (third.moved(self.carried, way.third), first.moved(self.point, -way.first));
            let (arm, goal) = (second.arm(from), second.arm(to));
            let gap = [dot(&second.direction, &less(to, from)), length(goal) - length(arm)];
            ((from, to), (arm, goal), math::max(math::abs(gap[0]), math::abs(gap[1])))
        };
        let ((mut from, mut to), (mut arm, mut goal), mut gap) = apart(&way);
        let mut before: Option<[T; 2]> = None;
        for count in 0..STEPS {
            if second.slides
                || way.free
                || length(arm) > near
                || length(goal) > near
                || gap <= T::EPS * T::EPS
            {
                break;
            }
            let (one, three) = (first.velocity(to).map(|c| -c), third.velocity(from));
            // The steps of joints 1 and 3 that make the heights equal: the shortest of them, and on from it along a line.
            let (gap1, gap3) = (dot(&second.direction, &one), -dot(&second.direction, &three));
            let (square, height) = (gap1 * gap1 + gap3 * gap3, dot(&second.direction, &less(to, from)));
            let scale = math::sqrt(square);
            let level = [gap1, gap3].map(|gap| -height * gap / square);
            let ahead =
                [math::abs(gap3), if gap3 < T::lit(0.0) { gap1 } else { -gap1 }].map(|gap| gap / scale);
            // Where the heights do not tell of joint 3 it may point either way: right stays right from step to step.
            let [onward, upward] = ahead;
            let ahead = match before {
                Some([x, y]) if x * onward + y * upward < T::lit(0.0) => [-onward, -upward],
                _ => ahead,
            };
            before = Some(ahead);
            // Only what is across axis 2 changes the distance.
            let across = |v: [T; 3]| plus(v, second.direction, -dot(&second.direction, &v));
            let ([level1, level3], [ahead1, ahead3]) = (level, ahead);
            let (one, three) = (across(one), across(three));
            let (reached, carried) = (plus(goal, one, level1), plus(arm, three, level3));
            let (one, three) = (one.map(|c| c * ahead1), three.map(|c| c * ahead3));
            let square = dot(&one, &one) - dot(&three, &three);
            let slope = dot(&reached, &one) - dot(&carried, &three);
            let rest = dot(&reached, &reached) - dot(&carried, &carried);
            let by = side.root(square, slope, rest, count == 0);
            let next = Way {
                first: way.first + level1 + by * ahead1,
                third: way.third + level3 + by * ahead3,
                ..way
            };
            let there = apart(&next);
            if there.2 < gap {
                (way, ((from, to), (arm, goal), gap)) = (next, there);
            } else {
                break;
            }
        }
        way
    }

    /// The angle by which joint 1 still turns the carried point to the side of axis 1 on which the point to be reached lies.
    pub(super) fn facing(&self, [v1, v2, v3]: [T; 3]) -> T {
        let [first, second, third] = &self.axes;
        let carried = second.moved(third.moved(self.carried, v3), v2);
        let (from, to) = (first.arm(carried), first.arm(first.moved(self.point, -v1)));
        math::atan2(dot(&first.direction, &cross(from, to)), dot(&from, &to))
    }

    /// Figure values brought nearer to the point, as long as a step brings them nearer. Beside a double root the damped step is
    /// short, so that where it does little the undamped one is tried too, and steps along the direction that is lost.
    pub(super) fn refined(
        &self,
        mut values: [T; 3],
        (free, side): (bool, Side),
        steps: usize,
    ) -> ([T; 3], Stance<T>) {
        let (mut stance, mut sought) = (self.stance(values, free), 0);
        // There what moves the point so little is lost to steps that move it at all.
        let beside_first = !free && self.is_beside_first();
        for _ in 0..steps {
            let miss = largest(stance.missed);
            if miss <= T::EPS {
                break;
            }
            let stepped = |[a, b, c]: [T; 3]| {
                let [v1, v2, v3] = values;
                let next = [v1 + a, v2 + b, v3 + c];
                (next, self.stance(next, free))
            };
            let mut best = stepped(stance.step(T::lit(STEADIED) * T::EPS));
            if largest(best.1.missed) > miss * T::lit(0.25) {
                let mut tried = |other: ([T; 3], Stance<T>)| {
                    let left = largest(other.1.missed);
                    if left < largest(best.1.missed) {
                        best = other;
                    }
                    left
                };
                if let Some(step) = stance.undamped() {
                    tried(stepped(step));
                }
                if beside_first {
                    tried(stepped([self.facing(values), T::lit(0.0), T::lit(0.0)]));
                }
                // Between two roots, where the determinant is nothing, either is as far as the root of what is missed.
                if sought < SOUGHT && miss > T::lit(ROUND_OFF) * T::EPS {
                    sought += 1;
                    let there = |step: [T; 3]| stepped(step).1;
                    stance.along_lost(side, there, |step| tried(stepped(step)));
                }
            }
            if largest(best.1.missed) < miss {
                (values, stance) = best;
            } else {
                break;
            }
        }
        (values, stance)
    }

    /// Where a way may begin anew that has come to values which are another's: for either side of axis 2, if the point is so near it that
    /// two ways pass it together, and beyond the root.
    pub(super) fn anew(
        &self,
        (way, side): (&Way<T>, Side),
        values @ [_, _, third_value]: [T; 3],
    ) -> [Option<(Way<T>, Side)>; 3] {
        let near = T::lit(SLACK) * math::sqrt(T::EPS);
        let beside = self.second_arm(third_value).is_some_and(|arm| arm <= near);
        let towards = |told| beside.then_some((*way, Side { told: Some(told), ..side }));
        let beyond = self.other_root(values, side.posture);
        let beyond = beyond.map(|[first, _, third]| (Way { first, third, ..*way }, side));
        [towards(Shoulder::Right), towards(Shoulder::Left), beyond]
    }

    /// The other of two roots that were one, or about where it is, from the one that was found; none if they still are one.
    fn other_root(&self, values: [T; 3], posture: ArmPosture) -> Option<[T; 3]> {
        let stance = self.stance(values, false);
        if self.is_beside_first() {
            return Some(self.across_first(values, &stance));
        }
        let lost = stance.lost(posture);
        let along = |by: T| plus(values, lost.along, by);
        let missed = |by: T| dot(&lost.blind, &self.stance(along(by), false).missed);
        let (middle, _) = parabola(dot(&lost.blind, &stance.missed), missed);
        let by = middle + middle;
        (math::abs(by) > tolerance() && math::abs(by) <= T::lit(FARTHEST)).then(|| along(by))
    }

    /// The point beside axis 1 is reached from two sides of the normal of the plane in which joints 2 and 3 move it: the values with joint 1
    /// on the other.
    fn across_first(&self, [v1, v2, v3]: [T; 3], stance: &Stance<T>) -> [T; 3] {
        let ([first, ..], [_, two, three]) = (&self.axes, stance.velocities);
        let (arm, normal) = (first.arm(first.moved(self.point, -v1)), cross(two, three));
        let along = dot(&first.direction, &normal);
        let normal = plus(normal, first.direction, -along);
        let turn = math::atan2(dot(&first.direction, &cross(arm, normal)), dot(&arm, &normal));
        [math::wrap(v1 - turn - turn), v2, v3]
    }

    pub(super) fn stance(&self, [v1, v2, v3]: [T; 3], free: bool) -> Stance<T> {
        let [first, second, third] = &self.axes;
        let lifted = third.moved(self.carried, v3);
        let placed = second.moved(lifted, v2);
        let still = [T::lit(0.0); 3];
        Stance {
            missed: less(first.moved(self.point, -v1), placed),
            velocities: [
                if free { still } else { first.velocity(placed) },
                second.velocity(placed),
                second.turned(third.velocity(lifted), v2),
            ],
        }
    }
}

/// Whose values are refined, and whether another way begins where this one does: of two roots each then takes the one on the side of
/// its label, else the one on the side on which it begins. Beside axis 2, where that is another's, the one on the right, or the left.
#[derive(Clone, Copy)]
pub(super) struct Side {
    pub(super) posture: ArmPosture,
    pub(super) shared: bool,
    pub(super) told: Option<Shoulder>,
}

impl Side {
    /// A root of square·x² + 2·slope·x + rest, or the middle of both where there is none: the one that is told, or the nearer one, but at
    /// first, between both, the one of the label.
    fn root<T: Float>(&self, square: T, slope: T, rest: T, at_first: bool) -> T {
        let half = math::sqrt_or_zero(slope * slope - square * rest);
        // Without cancellation: the one as a sum, the other from their product.
        let sum = if slope < T::lit(0.0) { half - slope } else { -half - slope };
        let (far, near) = (sum / square, if sum == T::lit(0.0) { T::lit(0.0) } else { rest / sum });
        let between = at_first && math::abs(slope) <= half * T::lit(MIDDLE);
        let own = self.told.or(between.then_some(self.posture.shoulder));
        let is_far = half == T::lit(0.0) || own.is_some_and(|own| (far < near) == (own == Shoulder::Right));
        if is_far && math::is_finite(far) && math::abs(far) <= T::lit(FARTHEST) { far } else { near }
    }
}

/// The direction in which the joints do not move the point, and the one in which the point is not moved; both of length one.
struct Lost<T> {
    along: [T; 3],
    blind: [T; 3],
}

/// The longest of three vectors, at a length of one.
fn longest<T: Float>([a, b, c]: [[T; 3]; 3]) -> [T; 3] {
    let longer = |a, b| if dot(&b, &b) > dot(&a, &a) { b } else { a };
    let longest = longer(longer(a, b), c);
    let unit = math::max(length(longest), T::EPS * T::EPS);
    longest.map(|c| c / unit)
}

/// A parabola through what is missed here and a little to either side: where its middle is, and how far from there its roots are, if it
/// has any.
pub(super) fn parabola<T: Float>(here: T, missed: impl Fn(T) -> T) -> (T, T) {
    let (two, probe) = (T::lit(2.0), math::sqrt(math::sqrt(T::EPS)));
    let (front, back) = (missed(probe), missed(-probe));
    let slope = (front - back) / (two * probe);
    let bend = (front + back - two * here) / (two * probe * probe);
    let square = slope * slope - T::lit(4.0) * bend * here;
    (-slope / (two * bend), math::sqrt_or_zero(square) / math::abs(two * bend))
}

impl<T: Float> Stance<T> {
    /// The smallest step of the joints that closes the gap to first order, but for what takes them far: Jᵀ(JJᵀ + μ)⁻¹·gap, the
    /// damping μ a part of the trace of JJᵀ.
    fn step(&self, damping: T) -> [T; 3] {
        let [a, b, c] = self.velocities;
        let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a, b, c);
        let (x, y, z) = ([ax, bx, cx], [ay, by, cy], [az, bz, cz]);
        let (xx, yy, zz) = (dot(&x, &x), dot(&y, &y), dot(&z, &z));
        let (xy, xz, yz) = (dot(&x, &y), dot(&x, &z), dot(&y, &z));
        let damping = (xx + yy + zz) * damping;
        let rows = [[xx + damping, xy, xz], [xy, yy + damping, yz], [xz, yz, zz + damping]];
        let Some(solved) = solved(rows, self.missed) else { return [T::lit(0.0); 3] };
        [dot(&a, &solved), dot(&b, &solved), dot(&c, &solved)]
    }

    /// The step that closes the gap as far as the joints can without moving along a direction, by least squares.
    fn closing(&self, along: [T; 3]) -> [T; 3] {
        let [a, b, c] = self.velocities;
        let one = across(along);
        let other = cross(along, one);
        let moved = |[x, y, z]: [T; 3]| plus(plus(a.map(|v| v * x), b, y), c, z);
        let (p, q) = (moved(one), moved(other));
        let damping = (dot(&p, &p) + dot(&q, &q)) * T::lit(STEADIED) * T::EPS;
        let (pp, qq, pq) = (dot(&p, &p) + damping, dot(&q, &q) + damping, dot(&p, &q));
        let determinant = pp * qq - pq * pq;
        if determinant <= T::lit(0.0) {
            return [T::lit(0.0); 3];
        }
        let (r, s) = (dot(&p, &self.missed), dot(&q, &self.missed));
        let (x, y) = ((r * qq - s * pq) / determinant, (s * pp - r * pq) / determinant);
        plus(one.map(|v| v * x), other, y)
    }

    /// Steps along what is lost, while the other joints close the gap: here, and again there, because a step along it misses by its
    /// square. To the root of a parabola, and if that does not take much back, where three roots meet and there is none, by steps each a
    /// quarter of the one before, until what is left grows again.
    fn along_lost(&self, side: Side, there: impl Fn([T; 3]) -> Stance<T>, mut left: impl FnMut([T; 3]) -> T) {
        let lost = self.lost(side.posture);
        let here = self.closing(lost.along);
        let along = |by: T| plus(here, lost.along, by);
        let seen = |by: T| dot(&lost.blind, &there(along(by)).missed);
        let (middle, half) = parabola(dot(&lost.blind, &self.missed), seen);
        let ahead = side.shared || middle < half * T::lit(MIDDLE);
        let by = middle + if ahead { half } else { -half };
        let closed = |by: T| plus(along(by), there(along(by)).closing(lost.along), T::lit(1.0));
        let miss = largest(self.missed);
        if math::abs(by) <= T::lit(FARTHEST) && left(closed(by)) <= miss * T::lit(0.25) {
            return;
        }
        let (mut by, mut before) = (T::lit(FARTHEST), miss);
        for _ in 0..SHORTER {
            let left = left(closed(by));
            if before < miss && left > before {
                break;
            }
            (by, before) = (by * T::lit(0.25), left);
        }
    }

    /// What is lost: the longest row and column of the adjugate. Along it joint 3 goes up or down with the elbow, so that each of two
    /// roots that were one has its own; where joint 3 stays, as it does for two sides of joint 1 that meet, joint 1 goes with the
    /// shoulder.
    fn lost(&self, ArmPosture { shoulder, elbow }: ArmPosture) -> Lost<T> {
        let [a, b, c] = self.velocities;
        let rows = [cross(b, c), cross(c, a), cross(a, b)];
        let [[x0, y0, z0], [x1, y1, z1], [x2, y2, z2]] = rows;
        let (along, blind) = (longest([[x0, x1, x2], [y0, y1, y2], [z0, z1, z2]]), longest(rows));
        let [one, _, third] = along;
        let up = if math::abs(third) > T::lit(SLACK) * math::sqrt(T::EPS) {
            (third > T::lit(0.0)) == (elbow == Elbow::Up)
        } else {
            ((one > T::lit(0.0)) == (shoulder == Shoulder::Left)) == (elbow == Elbow::Up)
        };
        Lost { along: along.map(|c| if up { c } else { -c }), blind }
    }

    /// The step that closes the gap to first order, J⁻¹·gap by Cramer's rule, if it is none that leaves the neighbourhood.
    fn undamped(&self) -> Option<[T; 3]> {
        let ([a, b, c], missed) = (self.velocities, self.missed);
        let (k0, k1, k2) = (cross(b, c), cross(c, a), cross(a, b));
        let determinant = dot(&a, &k0);
        let step = [k0, k1, k2].map(|k| dot(&k, &missed) / determinant);
        (largest(step) <= T::lit(0.25)).then_some(step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ik::general::{Axis, GeneralBase};
    use crate::sample::Random;
    use crate::solutions::Branch;

    fn vector(random: &mut Random) -> [f64; 3] {
        [(); 3].map(|()| random.within(-1.0, 1.0))
    }

    fn stance(random: &mut Random) -> Stance<f64> {
        Stance { missed: vector(random), velocities: [(); 3].map(|()| vector(random)) }
    }

    #[test]
    fn a_parabola_is_known_from_three_of_its_values() {
        let mut random = Random(81);
        for _ in 0..1_000 {
            let (bend, middle, half) =
                (random.within(0.5, 2.0), random.within(-0.1, 0.1), random.within(0.0, 0.1));
            let bend = if random.coin() { bend } else { -bend };
            let at = |x: f64| bend * ((x - middle) * (x - middle) - half * half);
            let (found, apart) = parabola(at(0.0), at);
            assert!((found - middle).abs() < 1e-7 && (apart - half).abs() < 1e-4, "{found} {apart}");
            assert!((apart * apart - half * half).abs() < 1e-7, "{apart} {half}");
            // Above its middle it has no roots.
            let (_, apart) = parabola(at(0.0) + bend, |x| at(x) + bend);
            assert_eq!(apart, 0.0);
        }
    }

    #[test]
    fn the_longest_is_found_wherever_it_stands() {
        let [short, long, middling] = [[1.0, 0.0, 0.0], [0.0, -3.0, 4.0], [0.0, 0.0, 2.0]];
        for vectors in [[long, short, middling], [short, long, middling], [middling, short, long]] {
            assert_eq!(longest(vectors), [0.0, -0.6, 0.8]);
        }
    }

    /// Along what is lost nothing moves; across it the gap is closed as far as two directions can.
    #[test]
    fn a_step_across_what_is_lost_is_the_best() {
        let mut random = Random(82);
        for _ in 0..1_000 {
            let (stance, along) = (stance(&mut random), vector(&mut random));
            let along = along.map(|c| c / length(along));
            let step = stance.closing(along);
            let [a, b, c] = stance.velocities;
            let moved = |[x, y, z]: [f64; 3]| plus(plus(a.map(|v| v * x), b, y), c, z);
            let left = less(stance.missed, moved(step));
            let one = across(along);
            assert!(dot(&step, &along).abs() < 1e-9 * (1.0 + length(step)), "{step:?}");
            for direction in [one, cross(along, one)] {
                assert!(dot(&left, &moved(direction)).abs() < 1e-7, "{left:?}");
            }
        }
        // One of the two directions may not move the point at all: then the other does what it can.
        let (x, none) = ([1.0, 0.0, 0.0], [0.0; 3]);
        for velocities in [[x, none, none], [none, x, none]] {
            let stance = Stance { missed: [0.25, 0.5, 0.0], velocities };
            let step = stance.closing([0.0, 0.0, 1.0]);
            assert!((length(step) - 0.25).abs() < 1e-12, "{step:?}");
        }
    }

    #[test]
    fn what_is_lost_goes_up_with_the_elbow() {
        let mut random = Random(83);
        for _ in 0..1_000 {
            let stance = stance(&mut random);
            for posture in ArmPosture::ALL {
                let Lost { along: [_, _, third], .. } = stance.lost(*posture);
                assert_eq!(third > 0.0, posture.elbow == Elbow::Up, "{third}");
            }
            // Joints 1 and 2 move the point along one line: what is lost is theirs alone.
            let [a, _, c] = stance.velocities;
            let stance = Stance { velocities: [a, a.map(|v| -2.0 * v), c], ..stance };
            for posture in ArmPosture::ALL {
                let Lost { along: [one, _, third], .. } = stance.lost(*posture);
                let is_left = (posture.shoulder == Shoulder::Left) == (posture.elbow == Elbow::Up);
                assert_eq!((third.abs() < 1e-12, one > 0.0), (true, is_left), "{one} {third}");
            }
        }
    }

    /// Joint 1 has two values at which a point beside its axis is as far along the normal of what joints 2 and 3 can do.
    #[test]
    fn across_the_first_axis_the_point_is_as_near_the_plane_of_the_others() {
        let mut random = Random(84);
        let mut apart = 0;
        for _ in 0..200 {
            let [v1, v2, v3] = [(); 3].map(|()| random.angle());
            let axis = |direction, point| Axis { slides: false, direction, point };
            let second = axis([0.0, 0.6, 0.8], [0.2, 0.1, 0.3]);
            let third = axis([0.48, -0.6, 0.64], [0.5, 0.2, 0.4]);
            let carried = [0.8, -0.1, 0.6];
            let placed = second.moved(third.moved(carried, v3), v2);
            let first = axis([0.0, 0.0, 1.0], plus(placed, [1.0, 0.0, 0.0], 1e-7));
            let base = GeneralBase { axes: [first, second, third], carried, offset: [0.0; 3], reach: 1.0 };
            let point = first.moved(placed, v1);
            let sized = base.sized(point, 1.0);
            assert!(sized.is_beside_first());
            let stance = sized.stance([v1, v2, v3], false);
            let [other, ..] = sized.across_first([v1, v2, v3], &stance);
            let [_, two, three] = stance.velocities;
            let (normal, seen) = (cross(two, three), |v1: f64| first.moved(point, -v1));
            let along = dot(&normal, &less(seen(other), seen(v1))) / length(normal);
            assert!(along.abs() < 1e-14, "{along}");
            apart += usize::from(math::abs(math::wrap(other - v1)) > 0.1);
        }
        assert!(apart > 150, "{apart}");
    }
}
