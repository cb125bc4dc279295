//! Where two conics meet: what remains of any three-joint base once its middle joint is left out.
//!
//! Turning joint 3 moves the carried point on a circle, sliding it moves it on a line; seen from the other end, joint 1
//! does the same with the point to be reached. Joint 2 joins the two where both agree in what joint 2 cannot change:
//!
//! * a turning joint 2 keeps the height along its axis and the distance from a point on it. A circle, drawn in the plane of
//!   height and half the squared distance, is an ellipse; a line is a parabola (Pieper 1968, here as a picture);
//! * a sliding joint 2 keeps both coordinates across its direction: circles become ellipses, lines stay lines.
//!
//! So every base is solved by finding where two curves of this plane meet, in at most four points. A curve may be *flat*, run
//! through forth and back on a segment: the ellipse of joint 1 is flat where axes 1 and 2 meet or are parallel, that of joint 3
//! where axes 2 and 3 do. Then one joint follows from a single linear equation and the other from the second: two chords.
//! If neither is flat they meet where a [quartic](crate::ik::quartic) says.

use crate::ik::sheaf::Sheaf;
use crate::math::{self, Float};

/// A curve of the plane, run through by one joint.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Path<T> {
    /// centre + radius·(x·cos φ + y·sin φ).
    Circle {
        /// At its middle.
        centre: [T; 2],
        /// Where φ = 0 points.
        x: [T; 2],
        /// Where φ = 90° points.
        y: [T; 2],
        /// Not negative.
        radius: T,
    },
    /// start + along·s + square·s².
    Line {
        /// At s = 0.
        start: [T; 2],
        /// Times s.
        along: [T; 2],
        /// Times s².
        square: [T; 2],
    },
}

/// Parameters at which the two curves meet.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Way<T> {
    /// Of the first curve.
    pub first: T,
    /// Of the third.
    pub third: T,
    /// The first curve is a point: its parameter is free.
    pub free: bool,
    /// The curves pass each other here; the parameters are those of their nearest approach, or near it.
    pub open: bool,
}

/// Two ways within so many √ε begin at one place: much less than two roots are apart that were one until round-off parted them.
const ONE: f64 = 0.01;

impl<T: Float> Way<T> {
    /// Whether another way begins where this one does.
    pub(super) fn is_beside(&self, other: &Way<T>) -> bool {
        let near = |a: T, b: T| math::abs(a - b) <= T::lit(ONE) * math::sqrt(T::EPS);
        near(self.first, other.first) && near(self.third, other.third)
    }
}

/// The ways in the order of [`ArmPosture`](crate::ArmPosture): the first joint's side, then the third's. An empty place has
/// no way at all, not even a near one.
pub type Ways<T> = [Option<Way<T>>; 4];

/// A linear equation on a path: its solutions on either side, and whether they are only the nearest approach.
pub(super) struct Sides<T> {
    pub(super) values: [Option<T>; 2],
    open: bool,
    free: bool,
}

impl<T: Float> Sides<T> {
    /// The solutions, the one on either side if there is no other.
    fn both(&self) -> [Option<T>; 2] {
        let [up, down] = self.values;
        [up, down.or(up)]
    }
}

pub(super) fn cross<T: Float>([a, b]: [T; 2], [x, y]: [T; 2]) -> T {
    a * y - b * x
}

pub(super) fn dot<T: Float>([a, b]: [T; 2], [x, y]: [T; 2]) -> T {
    a * x + b * y
}

pub(super) fn less<T: Float>([a, b]: [T; 2], [x, y]: [T; 2]) -> [T; 2] {
    [a - x, b - y]
}

fn longer<T: Float>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    if dot(a, a) >= dot(b, b) { a } else { b }
}

/// Within this many ε two directions count as one: the same as kin-gen's for what a declaration fixes.
const FLAT: f64 = 64.0;

impl<T: Float> Path<T> {
    /// The point of the path at a parameter.
    pub fn at(&self, parameter: T) -> [T; 2] {
        match *self {
            Path::Circle { centre: [a, b], x: [xa, xb], y: [ya, yb], radius } => {
                let (s, c) = math::sin_cos(parameter);
                [a + radius * (xa * c + ya * s), b + radius * (xb * c + yb * s)]
            }
            Path::Line { start: [a, b], along: [u, v], square: [p, q] } => {
                [a + parameter * (u + parameter * p), b + parameter * (v + parameter * q)]
            }
        }
    }

    /// Where it is, if it is a point but for round-off.
    fn point(&self, window: T) -> Option<[T; 2]> {
        match *self {
            Path::Circle { centre, radius, .. } if radius <= window => Some(centre),
            _ => None,
        }
    }

    pub(super) fn start(&self) -> [T; 2] {
        match *self {
            Path::Circle { centre, .. } => centre,
            Path::Line { start, .. } => start,
        }
    }

    /// The two vectors that span it.
    pub(super) fn spanned(&self) -> ([T; 2], [T; 2]) {
        match *self {
            Path::Circle { x, y, .. } => (x, y),
            Path::Line { along, square, .. } => (along, square),
        }
    }

    /// The direction of a flat path.
    fn flat(&self) -> Option<[T; 2]> {
        let (a, b) = self.spanned();
        let flat = math::abs(cross(a, b)) <= T::lit(FLAT) * T::EPS * (dot(a, a) + dot(b, b));
        flat.then(|| {
            let direction = longer(a, b);
            let length = math::max(math::sqrt(dot(direction, direction)), T::EPS);
            direction.map(|x| x / length)
        })
    }

    /// Where the path has the given coordinate along a direction.
    fn where_it_is(&self, direction: [T; 2], wanted: T, window: T, slack: T) -> Sides<T> {
        let rest = wanted - dot(direction, self.start());
        match *self {
            Path::Circle { x, y, radius, .. } => {
                let (c, s) = (radius * dot(direction, x), radius * dot(direction, y));
                let (amplitude, phase, far) = (math::hypot(c, s), math::atan2(s, c), math::abs(rest));
                let half = math::sqrt_or_zero((amplitude - far) * (amplitude + far));
                let swing = math::atan2(half, rest);
                Sides {
                    values: [Some(phase + swing), Some(phase - swing)],
                    open: far - amplitude > slack,
                    free: amplitude <= window,
                }
            }
            Path::Line { along, square, .. } => {
                quadratic(dot(direction, square), dot(direction, along), rest, slack)
            }
        }
    }

    /// The parameters at which the path comes to a point, or nearest to it.
    pub(super) fn through(&self, point: [T; 2], window: T, slack: T) -> Sides<T> {
        if let Some(direction @ [x, y]) = self.flat() {
            let normal = [-y, x];
            let off = math::abs(dot(normal, less(point, self.start())));
            let sides = self.where_it_is(direction, dot(direction, point), window, slack);
            return Sides { open: sides.open || off > slack, ..sides };
        }
        let ((a, b), rest) = (self.spanned(), less(point, self.start()));
        let (u, v, unit) = (cross(rest, b), cross(a, rest), cross(a, b));
        let parameter = match self {
            Path::Circle { .. } if unit < T::lit(0.0) => math::atan2(-v, -u),
            Path::Circle { .. } => math::atan2(v, u),
            Path::Line { .. } => u / unit,
        };
        let [x, y] = less(point, self.at(parameter));
        Sides { values: [Some(parameter), None], open: math::hypot(x, y) > slack, free: false }
    }
}

/// a·s² + b·s = c. The sides are those of the slope, so that they stay where one solution goes to infinity.
fn quadratic<T: Float>(a: T, b: T, c: T, slack: T) -> Sides<T> {
    let (zero, two) = (T::lit(0.0), T::lit(2.0));
    let square = b * b + T::lit(4.0) * a * c;
    let root = math::sqrt_or_zero(square);
    let far = T::lit(1.0) / math::sqrt(T::EPS);
    let kept = |s: T| (math::abs(s) <= far).then_some(s);
    // Of (-b ± root)/2a the one without cancellation, and the other by their product -c/a.
    let safe = if b < zero { b - root } else { b + root };
    let values = if safe == zero {
        [(a != zero).then_some(zero); 2]
    } else {
        let direct = kept(-safe / (two * a));
        // Without a root both are where it comes nearest to having one.
        let other = if square < zero { direct } else { kept(two * c / safe) };
        if b < zero { [direct, other] } else { [other, direct] }
    };
    let open = if a == zero { false } else { -square > T::lit(4.0) * math::abs(a) * slack };
    Sides { values, open, free: false }
}

/// All ways in which the two paths meet. What is less than `window` is round-off; a flat figure that stays open by no more
/// than `slack` is closed, to be judged by whoever refines it. `zero` is the third parameter from which ways are
/// ordered, and the one where the third path is a point.
pub fn meet<T: Float>(first: &Path<T>, third: &Path<T>, window: T, slack: T, zero: T) -> Ways<T> {
    if let Some(point) = first.point(window) {
        let sides = third.through(point, window, slack);
        let way = |third| Way { first: zero, third, free: true, open: sides.open };
        let [up, down] = sides.both().map(|value| value.map(way));
        return [up, down, up, down];
    }
    if let Some(point) = third.point(window) {
        let sides = first.through(point, window, slack);
        let way = |first| Way { first, third: zero, free: sides.free, open: sides.open };
        let [right, left] = sides.both().map(|value| value.map(way));
        return [right, right, left, left];
    }
    if let Some(direction) = first.flat() {
        return chords(first, third, direction, [window, slack], false);
    }
    if let Some(direction) = third.flat() {
        let [a, b, c, d] = chords(third, first, direction, [window, slack], true);
        return [a, c, b, d];
    }
    Sheaf::of(first, third).ways(window, zero)
}

/// One path is flat: the other crosses its line, then the flat one reaches each crossing. The outer index of the result is the
/// side on the flat path.
fn chords<T: Float>(
    flat: &Path<T>,
    other: &Path<T>,
    direction @ [x, y]: [T; 2],
    [window, slack]: [T; 2],
    swapped: bool,
) -> Ways<T> {
    let normal = [-y, x];
    let crossing = other.where_it_is(normal, dot(normal, flat.start()), window, slack);
    let [up, down] = crossing.values.map(|value| {
        value
            .map(|value| (value, flat.where_it_is(direction, dot(direction, other.at(value)), window, slack)))
    });
    let way = |at: &Option<(T, Sides<T>)>, left: bool| {
        let (value, sides) = at.as_ref()?;
        let [one, two] = sides.values;
        let reached = if left { two } else { one }?;
        let (first, third) = if swapped { (*value, reached) } else { (reached, *value) };
        let free = if swapped { crossing.free } else { sides.free };
        Some(Way { first, third, free, open: crossing.open || sides.open })
    };
    [way(&up, false), way(&down, false), way(&up, true), way(&down, true)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::Random;

    #[test]
    fn ways_that_begin_at_one_place_are_beside_each_other() {
        let at = |first: f64, third: f64| Way { first, third, free: false, open: false };
        let (way, little) = (at(0.3, -0.4), 1e-3 * math::sqrt(f64::EPSILON));
        assert!(way.is_beside(&way) && way.is_beside(&at(0.3 + little, -0.4 - little)));
        assert!(!way.is_beside(&at(0.3 + 1e-6, -0.4)) && !way.is_beside(&at(0.3, -0.4 + 1e-6)));
        assert!(at(0.0, 0.0).is_beside(&at(little, -little)));
    }

    #[test]
    fn a_quadratic_has_its_roots_on_the_sides_of_its_slope() {
        let mut random = Random(71);
        for _ in 0..20_000 {
            // Any of them may be nothing, where formulas divide.
            let [a, b, c] = [(); 3].map(|()| random.sometimes(-2.0, 2.0));
            let sides = quadratic(a, b, c, 1e-9);
            let square = b * b + 4.0 * a * c;
            for (side, value) in [1.0, -1.0].into_iter().zip(sides.values) {
                let Some(s) = value else {
                    // A line has one root, on the side of its slope; what is constant has none.
                    assert!(a == 0.0 && side * b <= 0.0, "{a} {b} {c}");
                    continue;
                };
                assert!(side * (2.0 * a * s + b) >= -1e-12, "{a} {b} {c}: {s}");
                if square >= 0.0 {
                    let size = (a * s * s).abs() + (b * s).abs() + c.abs();
                    assert!((a * s * s + b * s - c).abs() <= 1e-12 * size, "{a} {b} {c}: {s}");
                } else {
                    assert!((2.0 * a * s + b).abs() <= 1e-12, "the extremum of {a} {b} {c}: {s}");
                }
            }
            assert!(square != 0.0 || !sides.open);
        }
    }

    #[test]
    fn a_quadratic_is_open_where_its_extremum_falls_short_by_more_than_the_slack() {
        let mut random = Random(72);
        for _ in 0..2_000 {
            let (a, b) = (random.within(0.1, 3.0), random.sometimes(-2.0, 2.0));
            for (sign, short) in [1.0, -1.0].into_iter().flat_map(|sign| [0.5, 2.0].map(|by| (sign, by))) {
                let (a, slack) = (sign * a, 1e-3);
                let c = -b * b / (4.0 * a) - sign * short * slack;
                assert_eq!(quadratic(a, b, c, slack).open, short > 1.0, "{a} {b} {c}");
            }
        }
    }

    fn vector(random: &mut Random) -> [f64; 2] {
        [(); 2].map(|()| random.within(-1.0, 1.0))
    }

    /// Ellipses and parabolas, and what becomes of them where they are flat.
    fn path(random: &mut Random, flat: bool) -> Path<f64> {
        let (a, b) = (vector(random), vector(random));
        let times = random.sometimes(-1.0, 1.0);
        let b = if flat { a.map(|x| x * times) } else { b };
        if random.coin() {
            Path::Circle { centre: vector(random), x: a, y: b, radius: random.within(0.2, 2.0) }
        } else {
            Path::Line { start: vector(random), along: a, square: b }
        }
    }

    #[test]
    fn a_path_leads_through_its_points_and_through_no_others() {
        let mut random = Random(73);
        for round in 0..4_000 {
            let path = path(&mut random, round % 2 == 0);
            let (a, b) = path.spanned();
            let size = dot(a, a).max(dot(b, b)).sqrt();
            let (slack, parameter) = (1e-7 * size, random.within(-3.0, 3.0));
            let point = path.at(parameter);
            let sides = path.through(point, 1e-14 * size, slack);
            let off = |s: f64| {
                let [x, y] = less(path.at(s), point);
                x.hypot(y)
            };
            let least = sides.values.into_iter().flatten().map(off).fold(f64::INFINITY, f64::min);
            assert!(!sides.open && least <= 1e-6 * size, "{path:?} at {parameter}: off by {least:e}");
            // Beside a flat path, across it; beside another it need not be near.
            let Some([x, y]) = path.flat() else { continue };
            for by in [3.0, -3.0, 1e4] {
                let aside = [point[0] - by * slack * y, point[1] + by * slack * x];
                assert!(path.through(aside, 1e-14 * size, slack).open, "{path:?} at {parameter}");
            }
        }
    }
}
