//! Where two conics meet, neither of them flat: in the roots of a quartic.
//!
//! The implicit equation of the first, on the points of the third, is a trigonometric polynomial of degree two; in the tangent of
//! half an angle a quartic. Two charts of [-1, 1] cover the circle, their seams laid where the quartic is far from zero; a line is
//! covered by a chart for small values and one for their reciprocals.
//!
//! The signs that separate [roots](crate::ik::quartic) are asked of the equation before it is squared: the distance of the point
//! from the ellipse, which near a double root, or on a first ellipse that has almost shrunk to a point, keeps its digits.

use crate::ik::conic::{Path, Way, Ways, cross, dot, less};
use crate::ik::quartic::{self, Quartic, Root};
use crate::math::{self, Float};

/// The first path by its equation, the third by its parameter, neither flat.
pub(super) struct Sheaf<'a, T> {
    first: &'a Path<T>,
    third: &'a Path<T>,
    /// The start of the third less that of the first.
    between: [T; 2],
}

/// A piece of the third path on [-1, 1]: its points are (u₀ + u₁t + u₂t²)/(w₀ + w₂t²), measured from the start of the first.
struct Chart<T> {
    points: [[T; 2]; 3],
    weight: [T; 3],
    place: Place<T>,
}

/// What t stands for.
#[derive(Clone, Copy)]
enum Place<T> {
    /// φ = middle + 2·atan t.
    Angle(T),
    /// s = t·unit.
    Near(T),
    /// s = -unit/t: it grows with t, so that a figure that rises along the path rises here too.
    Far(T),
}

impl<T: Float> Chart<T> {
    /// The parameter of the third path; none at infinity.
    fn parameter(&self, t: T) -> Option<T> {
        match self.place {
            Place::Angle(middle) => Some(math::wrap(middle + T::lit(2.0) * math::atan2(t, T::lit(1.0)))),
            Place::Near(unit) => Some(t * unit),
            Place::Far(unit) => (math::abs(t) > math::sqrt(T::EPS)).then(|| -unit / t),
        }
    }

    fn point(&self, t: T) -> ([T; 2], T) {
        let ([[a, d], [b, e], [c, f]], [w0, w1, w2]) = (self.points, self.weight);
        ([a + t * (b + t * c), d + t * (e + t * f)], w0 + t * (w1 + t * w2))
    }

    /// The coefficients of a linear form of the points.
    fn form(&self, of: impl Fn([T; 2]) -> T) -> [T; 3] {
        self.points.map(of)
    }
}

impl<'a, T: Float> Sheaf<'a, T> {
    pub(super) fn of(first: &'a Path<T>, third: &'a Path<T>) -> Self {
        Sheaf { first, third, between: less(third.start(), first.start()) }
    }

    /// Two charts that cover the third path; `turn` in 0..8 moves their seams.
    fn charts(&self, turn: u8) -> [Chart<T>; 2] {
        let ([ca, cb], one, zero) = (self.between, T::lit(1.0), T::lit(0.0));
        match *self.third {
            Path::Circle { x: [xa, xb], y: [ya, yb], radius, .. } => {
                let middle = math::half_turn::<T>() * T::lit(0.125 * f64::from(turn));
                let (s, c) = math::sin_cos(middle);
                let (c, s) = (radius * c, radius * s);
                let ([ua, ub], [va, vb]) =
                    ([xa * c + ya * s, xb * c + yb * s], [ya * c - xa * s, yb * c - xb * s]);
                let two = T::lit(2.0);
                let piece = |[ua, ub]: [T; 2], [va, vb]: [T; 2], middle| Chart {
                    points: [[ca + ua, cb + ub], [two * va, two * vb], [ca - ua, cb - ub]],
                    weight: [one, zero, one],
                    place: Place::Angle(middle),
                };
                [piece([ua, ub], [va, vb], middle), piece([-ua, -ub], [-va, -vb], middle + math::half_turn())]
            }
            Path::Line { along: [u, v], square: [p, q], .. } => {
                let unit = one + T::lit(0.125 * f64::from(turn));
                let points = [[ca, cb], [u * unit, v * unit], [p * unit * unit, q * unit * unit]];
                let [low, middle, high] = points;
                [
                    Chart { points, weight: [one, zero, zero], place: Place::Near(unit) },
                    Chart {
                        points: [high, middle.map(|c| -c), low],
                        weight: [zero, zero, one],
                        place: Place::Far(unit),
                    },
                ]
            }
        }
    }

    /// The first path's equation at a point with its weight: zero on the path.
    fn figure(&self, (point, weight): ([T; 2], T)) -> T {
        let (a, b) = self.first.spanned();
        let unit = cross(a, b);
        match self.first {
            Path::Circle { radius, .. } => {
                math::hypot(cross(point, b), cross(a, point)) - math::abs(unit) * *radius * weight
            }
            Path::Line { .. } => {
                let s = cross(point, b);
                cross(a, point) * unit * weight - s * s
            }
        }
    }

    /// The same, squared where it has a root, as a quartic.
    fn quartic(&self, chart: &Chart<T>) -> Quartic<T> {
        let (a, b) = self.first.spanned();
        let unit = cross(a, b);
        let (u, v) = (chart.form(|p| cross(p, b)), chart.form(|p| cross(a, p)));
        let mut sum = quartic::product(u, u);
        match self.first {
            Path::Circle { radius, .. } => {
                let rim = chart.weight.map(|w| w * unit * *radius);
                let parts = quartic::product(v, v).into_iter().zip(quartic::product(rim, rim));
                for (sum, (plus, minus)) in sum.iter_mut().zip(parts) {
                    *sum += plus - minus;
                }
            }
            Path::Line { .. } => {
                for (sum, plus) in sum.iter_mut().zip(quartic::product(v, chart.weight.map(|w| w * unit))) {
                    *sum = plus - *sum;
                }
            }
        }
        sum
    }

    /// The charts whose seams are farthest from a root, of eight: four roots spoil at most four of them.
    fn best_charts(&self) -> [Chart<T>; 2] {
        let (mut best, mut most) = (self.charts(0), T::lit(-1.0));
        for turn in 0..8 {
            let charts = self.charts(turn);
            let [chart, _] = &charts;
            let seam = |t: f64| math::abs(self.figure(chart.point(T::lit(t))));
            let least = math::min(seam(1.0), seam(-1.0));
            if least > most {
                (best, most) = (charts, least);
            }
        }
        best
    }

    pub(super) fn ways(&self, window: T, zero: T) -> Ways<T> {
        let (a, b) = self.first.spanned();
        let window = window * T::lit(32.0) * (math::sqrt(dot(a, a)) + math::sqrt(dot(b, b)));
        let turning = matches!(self.third, Path::Circle { .. });
        let lines = !turning && matches!(self.first, Path::Line { .. });
        let mut labelled = Labelled { ways: [None; 4], nearest: None, zero: turning.then_some(zero), lines };
        for chart in &self.best_charts() {
            let places = quartic::extrema(&self.quartic(chart));
            quartic::roots(&places, &|t| self.figure(chart.point(t)), window, |root| {
                let (Root::Rising(t) | Root::Falling(t) | Root::Double(t) | Root::Missed(t, _)) = root;
                let Some(third) = chart.parameter(t) else { return };
                let [first, _] = self.first.through(self.third.at(third), window, window).values;
                let Some(first) = first else { return };
                labelled
                    .take(root, Way { first, third, free: false, open: matches!(root, Root::Missed(..)) });
            });
        }
        labelled.finished()
    }
}

/// The ways of the quartic in their places: up where the figure rises, down where it falls, a sign that cannot change without
/// a double root; right the one that comes first on the third path, left the second.
struct Labelled<T> {
    ways: Ways<T>,
    nearest: Option<(T, Way<T>)>,
    /// The angle from which an angle is counted.
    zero: Option<T>,
    /// Whether both paths are lines: two of the four roots are then at infinity, one of either sign.
    lines: bool,
}

impl<T: Float> Labelled<T> {
    fn take(&mut self, root: Root<T>, way: Way<T>) {
        match root {
            Root::Rising(_) => self.put(true, way),
            Root::Falling(_) => self.put(false, way),
            Root::Double(_) => {
                self.put(true, way);
                self.put(false, way);
            }
            Root::Missed(_, gap) => {
                if self.nearest.is_none_or(|(least, _)| gap < least) {
                    self.nearest = Some((gap, way));
                }
            }
        }
    }

    fn put(&mut self, up: bool, way: Way<T>) {
        let order = |way: &Way<T>| self.zero.map_or(way.third, |zero| math::wrap(way.third - zero));
        let [ru, rd, lu, ld] = &mut self.ways;
        let (right, left) = if up { (ru, lu) } else { (rd, ld) };
        let far = |way: &Way<T>| math::abs(way.third);
        if self.lines {
            *right = Some(right.filter(|one| far(one) <= far(&way)).unwrap_or(way));
            return;
        }
        // On a line a third of the same sign is round-off of roots at infinity: the farthest of the three gives way.
        if let (None, Some(one), Some(other)) = (self.zero, *right, *left) {
            let kept = match (far(&way) >= far(&one), far(&way) >= far(&other), far(&one) > far(&other)) {
                (true, true, _) => return,
                (_, _, true) => other,
                (_, _, false) => one,
            };
            (*right, *left) = (Some(kept), None);
        }
        match right {
            None => *right = Some(way),
            Some(earlier) if order(&way) < order(earlier) => *left = right.replace(way),
            Some(_) => *left = Some(way),
        }
    }

    /// Places without a way show the nearest approach.
    fn finished(self) -> Ways<T> {
        let [rising, falling, ..] = &self.ways;
        let all = self.lines && rising.is_some() && falling.is_some();
        let nearest = self.nearest.filter(|_| !all).map(|(_, way)| way);
        self.ways.map(|way| way.or(nearest))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever comes first, of three ways of one side the farthest is let go, and the others are in order.
    #[test]
    fn of_three_ways_along_a_line_the_two_nearest_are_kept() {
        for [a, b, c] in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            for far in [1e7, -1e7] {
                let thirds = [-0.5, 2.0, far];
                let mut labelled = Labelled { ways: [None; 4], nearest: None, zero: None, lines: false };
                for third in [thirds[a], thirds[b], thirds[c]] {
                    let way = Way { first: 0.1, third, free: false, open: false };
                    labelled.take(Root::Rising(0.3), way);
                }
                let [right, down, left, other] = labelled.finished().map(|way| way.map(|way| way.third));
                assert_eq!((right, left), (Some(-0.5), Some(2.0)), "{thirds:?} as {a}, {b}, {c}");
                assert_eq!((down, other), (None, None));
            }
        }
    }

    /// Two lines meet twice at most: of each side the nearest way is kept, and what they pass closely elsewhere is none.
    #[test]
    fn of_two_lines_one_way_of_each_side_is_kept() {
        let way = |third: f64| Way { first: 0.1, third, free: false, open: false };
        let mut labelled = Labelled { ways: [None; 4], nearest: None, zero: None, lines: true };
        for (root, third) in [
            (Root::Rising(0.3), 1e7),
            (Root::Rising(0.2), -0.5),
            (Root::Falling(0.1), 0.7),
            (Root::Missed(0.4, 1e-9), 2.0),
            (Root::Rising(0.5), -0.6),
        ] {
            labelled.take(root, way(third));
        }
        let kept = labelled.finished().map(|way| way.map(|way| way.third));
        assert_eq!(kept, [Some(-0.5), Some(0.7), None, None]);
        let mut labelled = Labelled { ways: [None; 4], nearest: None, zero: None, lines: true };
        labelled.take(Root::Missed(0.4, 1e-9), way(2.0));
        assert_eq!(labelled.finished().map(|way| way.map(|way| way.third)), [Some(2.0); 4]);
    }
}
