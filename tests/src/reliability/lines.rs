//! Where three joints of any kind, or two, lose a direction: from their axes as lines, in reaches.
//!
//! Let j₁, j₂, j₃ be how the joints move the carried point. Their determinant does not depend on joint 1; in the value of joint 2
//! it is A + B·cos + C·sin, or linear where that joint slides, so that three values tell its zeros. Along joint 3 they are found by
//! halving. And there are single points: where the carried point lies on axis 1 or on axis 2, so that the joint is free; where the
//! singular set crosses itself; and the cusps, where the direction that is lost lies along the set and three solutions are one.

use std::f64::consts::{FRAC_PI_2, PI};

use kin_runtime::ik::{Axis, GeneralBase};
use kin_runtime::{PairBase, math};
use nalgebra::{Matrix2, Matrix3, Unit, Vector2, Vector3};

use super::aim::arc_cosine;
use crate::sample::Sampler;

/// The carried point must miss an axis, or the determinant zero, by no more than this for a place to be singular.
const ZERO: f64 = 1e-10;

/// A turning joint has this many starts of the search for single points, all round.
const STARTS: usize = 9;

/// An axis with its lengths in reaches.
#[derive(Clone, Debug)]
struct Line {
    slides: bool,
    direction: Unit<Vector3<f64>>,
    point: Vector3<f64>,
}

/// The axes and the point that they carry.
#[derive(Clone, Debug)]
pub struct Lines {
    reach: f64,
    /// Without an axis 1 for two joints, which are then called 2 and 3.
    first: Option<Line>,
    second: Line,
    third: Line,
    carried: Vector3<f64>,
    /// The figure values of joints 2 and 3 where the row values are 0.
    offset: [f64; 2],
    /// Single points, with what they are: figure values of joints 2 and 3, of which one may not matter.
    points: Vec<(&'static str, [Option<f64>; 2])>,
}

/// A figure that vanishes at single points, and what these are.
type Search = (&'static str, fn(&Lines, [f64; 2]) -> Vector3<f64>);

impl Line {
    fn new(axis: &Axis<f64>, reach: f64) -> Line {
        Line {
            slides: axis.slides,
            direction: Unit::new_normalize(Vector3::from(axis.direction)),
            point: Vector3::from(axis.point) / reach,
        }
    }

    fn turned(&self, v: Vector3<f64>, value: f64) -> Vector3<f64> {
        if self.slides {
            return v;
        }
        let ((sine, cosine), along) = (math::sin_cos(value), self.direction.into_inner());
        v * cosine + along.cross(&v) * sine + along * (along.dot(&v) * (1.0 - cosine))
    }

    fn moved(&self, point: Vector3<f64>, value: f64) -> Vector3<f64> {
        if self.slides {
            point + self.direction.into_inner() * value
        } else {
            self.turned(point - self.point, value) + self.point
        }
    }

    fn velocity(&self, point: Vector3<f64>) -> Vector3<f64> {
        if self.slides { self.direction.into_inner() } else { self.direction.cross(&(point - self.point)) }
    }
}

impl Lines {
    /// Of three joints.
    pub fn of_three(base: &GeneralBase<f64>) -> Lines {
        let [first, second, third] = &base.axes;
        let [_, second_offset, third_offset] = base.offset;
        let reach = base.reach;
        Lines {
            reach,
            first: Some(Line::new(first, reach)),
            second: Line::new(second, reach),
            third: Line::new(third, reach),
            carried: Vector3::from(base.carried) / reach,
            offset: [second_offset, third_offset],
            points: Vec::new(),
        }
        .searched()
    }

    /// Of two.
    pub fn of_two(base: &PairBase<f64>) -> Lines {
        let ([second, third], reach) = (&base.axes, base.reach);
        Lines {
            reach,
            first: None,
            second: Line::new(second, reach),
            third: Line::new(third, reach),
            carried: Vector3::from(base.carried) / reach,
            offset: base.offset,
            points: Vec::new(),
        }
        .searched()
    }

    /// Which of three joints that turn is parallel to its neighbour, or meets it.
    pub fn structure(base: &GeneralBase<f64>) -> &'static str {
        let [first, second, third] = base.axes.each_ref().map(|axis| Line::new(axis, base.reach));
        let parallel =
            |a: &Line, b: &Line| a.direction.cross(&b.direction).norm() < ZERO && !a.slides && !b.slides;
        let meet = |a: &Line, b: &Line| {
            (b.point - a.point).dot(&a.direction.cross(&b.direction)).abs() < ZERO && !a.slides && !b.slides
        };
        if base.axes.iter().any(|axis| axis.slides) {
            "sliding"
        } else if parallel(&first, &second) {
            "parallel"
        } else if meet(&first, &second) {
            "meeting"
        } else if meet(&second, &third) {
            "crossing"
        } else {
            "general"
        }
    }

    /// What can be aimed at.
    pub fn kinds(&self) -> Vec<&'static str> {
        let determinant = self.first.is_some().then_some("determinant 0");
        let mut kinds: Vec<&str> = determinant.into_iter().collect();
        self.points.iter().for_each(|(what, _)| kinds.push(what));
        kinds.sort_unstable();
        kinds.dedup();
        kinds
    }

    /// Row values of joints 2 and 3 at a singular place, near given ones as far as it lets them be; `None` if there is none.
    pub fn singular(&self, rows: [f64; 2], random: &mut Sampler) -> Option<[f64; 2]> {
        let [low, high] = self.figures(rows);
        let found = match random.below(4) {
            kind @ (0 | 1) if !self.points.is_empty() => {
                let (_, [second, third]) = self.points[random.below(self.points.len())];
                // The same point again, or one of its neighbours on the same set.
                let third = if kind == 0 {
                    third
                } else {
                    third.map(|value| value + 1e-3 * random.between(-1.0, 1.0))
                };
                [second.unwrap_or(low), third.unwrap_or(high)]
            }
            3 => [low, self.along_third(low, random)?],
            _ => [self.along_second(high, random)?, high],
        };
        Some(self.rows(found))
    }

    /// The distance of the carried point from axis 1, seen along the motion of joint 2, and the angle between joint 3's motion and the
    /// plane of the other two: the margins of a general base.
    pub fn margins(&self, rows: [f64; 2]) -> [f64; 2] {
        let [first, second, third] = self.motions(self.figures(rows));
        let pair = first.cross(&second);
        [
            pair.norm() / second.norm() * self.reach,
            math::atan2(pair.dot(&third).abs(), pair.cross(&third).norm()),
        ]
    }

    fn figures(&self, [second, third]: [f64; 2]) -> [f64; 2] {
        let unit = |line: &Line| if line.slides { self.reach } else { 1.0 };
        let [a, b] = self.offset;
        [(second + a) / unit(&self.second), (third + b) / unit(&self.third)]
    }

    fn rows(&self, [second, third]: [f64; 2]) -> [f64; 2] {
        let unit = |line: &Line| if line.slides { self.reach } else { 1.0 };
        let [a, b] = self.offset;
        [second * unit(&self.second) - a, third * unit(&self.third) - b]
    }

    /// How the joints move the point; joint 1 of two does not.
    fn motions(&self, [second, third]: [f64; 2]) -> [Vector3<f64>; 3] {
        let lifted = self.third.moved(self.carried, third);
        let placed = self.second.moved(lifted, second);
        [
            self.first.as_ref().map_or_else(Vector3::zeros, |first| first.velocity(placed)),
            self.second.velocity(placed),
            self.second.turned(self.third.velocity(lifted), second),
        ]
    }

    fn determinant(&self, values: [f64; 2]) -> f64 {
        let [a, b, c] = self.motions(values);
        a.dot(&b.cross(&c))
    }

    /// The value of joint 2 at which the determinant vanishes.
    fn along_second(&self, third: f64, random: &mut Sampler) -> Option<f64> {
        let at = |second: f64| self.determinant([second, third]);
        if self.second.slides {
            let (zero, one) = (at(0.0), at(1.0));
            return Some(-zero / (one - zero)).filter(|value| value.abs() < 2.0);
        }
        let (ahead, aside, behind) = (at(0.0), at(FRAC_PI_2), at(PI));
        let (mean, cosine) = (0.5 * (ahead + behind), 0.5 * (ahead - behind));
        let sine = aside - mean;
        let cosine_of_turn = -mean / math::hypot(cosine, sine);
        let turn = (cosine_of_turn.abs() <= 1.0).then(|| arc_cosine(cosine_of_turn))?;
        let middle = math::atan2(sine, cosine);
        Some(if random.below(2) == 0 { middle + turn } else { middle - turn })
    }

    /// A value of joint 3 at which it does, found by halving.
    fn along_third(&self, second: f64, random: &mut Sampler) -> Option<f64> {
        let at = |third: f64| self.determinant([second, third]);
        let (start, step) = if self.third.slides { (-1.0, 0.2) } else { (random.between(-PI, PI), PI / 8.0) };
        let (mut low, mut at_low) = (start, at(start));
        for _ in 0..16 {
            let (mut high, at_high) = (low + step, at(low + step));
            if at_low * at_high < 0.0 {
                for _ in 0..54 {
                    let middle = 0.5 * (low + high);
                    if at(middle) * at_low > 0.0 { low = middle } else { high = middle }
                }
                return Some(low);
            }
            (low, at_low) = (high, at_high);
        }
        None
    }

    /// With its single points.
    fn searched(mut self) -> Lines {
        let starts = |line: &Line, at: usize| {
            let part = at as f64 / STARTS as f64;
            if line.slides { 2.0 * part - 1.0 } else { PI * (2.0 * part - 1.0) }
        };
        let figures: [Search; 3] = [
            ("on axis 1", Lines::on_first),
            ("on axis 2", Lines::on_second),
            ("cusp, crossing", Lines::cusp),
        ];
        let mut points: Vec<(&str, [Option<f64>; 2])> = Vec::new();
        for start in 0..STARTS * STARTS {
            let from = [starts(&self.second, start % STARTS), starts(&self.third, start / STARTS)];
            for (what, figure) in figures {
                let Some(point) = self.zero_of(figure, from) else { continue };
                let same = |a: Option<f64>, b: Option<f64>| match (a, b) {
                    (Some(a), Some(b)) => (a - b).abs() < 1e-4,
                    (a, b) => a == b,
                };
                if points.iter().all(|(_, [a, b])| !(same(*a, point[0]) && same(*b, point[1]))) {
                    points.push((what, point));
                }
            }
        }
        self.points = points;
        self
    }

    /// Zero where the point lies on axis 1; for two joints, where both move it alike or the first does not.
    fn on_first(&self, values: [f64; 2]) -> Vector3<f64> {
        let [first, second, third] = self.motions(values);
        match &self.first {
            Some(line) if line.slides => Vector3::repeat(1.0),
            Some(_) => first,
            None => second.cross(&third),
        }
    }

    /// Zero where it lies on axis 2.
    fn on_second(&self, values: [f64; 2]) -> Vector3<f64> {
        if self.second.slides { Vector3::repeat(1.0) } else { self.motions(values)[1] }
    }

    /// Zero where the determinant vanishes and, along the direction that is lost, does not change either.
    fn cusp(&self, values @ [second, third]: [f64; 2]) -> Vector3<f64> {
        if self.first.is_none() {
            return Vector3::repeat(1.0);
        }
        let motions = Matrix3::from_columns(&self.motions(values));
        let rows = [motions.row(0), motions.row(1), motions.row(2)].map(|row| row.transpose());
        let lost = [rows[0].cross(&rows[1]), rows[1].cross(&rows[2]), rows[2].cross(&rows[0])];
        let lost = lost.into_iter().max_by(|a, b| a.norm().total_cmp(&b.norm())).unwrap_or_default();
        let step = 1e-5;
        let slope = |a: [f64; 2], b: [f64; 2]| (self.determinant(a) - self.determinant(b)) / (2.0 * step);
        let along = [
            slope([second + step, third], [second - step, third]),
            slope([second, third + step], [second, third - step]),
        ];
        let change = lost.y * along[0] + lost.z * along[1];
        Vector3::new(motions.determinant(), change / lost.norm().max(ZERO), 0.0)
    }

    /// Damped Gauss-Newton steps to where a figure vanishes. A value on which the figure does not depend does not matter.
    fn zero_of(
        &self,
        figure: fn(&Lines, [f64; 2]) -> Vector3<f64>,
        [mut a, mut b]: [f64; 2],
    ) -> Option<[Option<f64>; 2]> {
        let mut matters = [true; 2];
        for _ in 0..40 {
            let here = figure(self, [a, b]);
            let step = 1e-6;
            let by_a = (figure(self, [a + step, b]) - figure(self, [a - step, b])) / (2.0 * step);
            let by_b = (figure(self, [a, b + step]) - figure(self, [a, b - step])) / (2.0 * step);
            matters = [by_a, by_b].map(|slope| slope.norm() > 1e-7);
            let normal = Matrix2::new(by_a.dot(&by_a), by_a.dot(&by_b), by_a.dot(&by_b), by_b.dot(&by_b));
            let damped = normal + Matrix2::identity() * (1e-12 + here.norm_squared() * 1e-2);
            let by = damped.try_inverse()? * Vector2::new(by_a.dot(&here), by_b.dot(&here));
            let most = by.amax().max(0.3);
            (a, b) = (a - by.x * 0.3 / most, b - by.y * 0.3 / most);
        }
        let wrapped = |line: &Line, value: f64| {
            if line.slides { value } else { (value + PI).rem_euclid(2.0 * PI) - PI }
        };
        let inside = |line: &Line, value: f64| !line.slides || value.abs() < 1.0;
        let found = figure(self, [a, b]).norm() < ZERO && inside(&self.second, a) && inside(&self.third, b);
        let (a, b) = (wrapped(&self.second, a), wrapped(&self.third, b));
        found.then_some([matters[0].then_some(a), matters[1].then_some(b)])
    }
}
