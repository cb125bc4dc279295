//! What is tried: joint values, most of them aimed at singular sets from every distance.
//!
//! A singular set is where a figure of the solver collapses, so its place is known from the figure's constants alone:
//! the links stretched or folded, the wrist centre in the plane through axis 1 in which both shoulders are one, axes 4,
//! 5 and 6 in one plane. Aiming is not judging: a shot that goes wide is tried all the same.

use std::f64::consts::PI;

use kin_runtime::Base;

use crate::sample::Sampler;

/// The last power of ten; the step after it is the singular set itself.
const LAST_POWER: usize = 17;

/// The constants of an arm that aiming needs, in row values.
#[derive(Clone, Copy, Debug)]
pub struct Sights {
    base: Base<f64>,
    /// The bend at which the three wrist axes lie in one plane; half a turn from there they do so again.
    straight: Option<f64>,
    /// The range of each row value.
    ranges: [(f64, f64); 6],
}

/// The first three joints as a vector from axis 2 and the way joint 2 turns it.
struct Figure {
    a1: f64,
    offset: [f64; 3],
    reversed: [bool; 3],
}

impl Sights {
    /// For an arm with these figures.
    pub fn new(base: Base<f64>, straight: Option<f64>, ranges: [(f64, f64); 6]) -> Sights {
        Sights { base, straight, ranges }
    }

    /// The row values of one try: a quarter of them anywhere, the others at singular sets.
    pub fn row_values(&self, random: &mut Sampler) -> [f64; 6] {
        let mut rows = self.ranges.map(|(low, high)| random.between(low, high));
        if random.below(4) == 0 {
            return rows;
        }
        // Any of the sets, in any company, at distances of their own or at one distance.
        let sets = 1 + random.below(7);
        let common = (random.below(2) == 0).then(|| random.below(LAST_POWER + 2));
        let mut off = || distance(common, random);
        let (wrist, elbow, shoulder) = (off(), off(), off());
        if let Some(straight) = self.straight
            && sets & 1 != 0
        {
            rows[4] = straight + if random.below(2) == 0 { 0.0 } else { PI } + wrist;
        }
        if sets & 2 != 0 {
            self.close_elbow(&mut rows, elbow, random.below(2) == 0);
        }
        if sets & 4 != 0 {
            self.close_shoulder(&mut rows, shoulder, random.below(2) == 0);
        }
        rows
    }

    /// How far row values are from the shoulder's, the elbow's and the wrist's singular set, as the library measures its
    /// own solutions; from the constants alone, so that the two can be compared.
    pub fn margins(&self, rows: &[f64; 6]) -> [Option<f64>; 3] {
        let from_straight = |angle: f64| {
            let bend = ((angle + PI).rem_euclid(2.0 * PI) - PI).abs();
            bend.min(PI - bend)
        };
        let wrist = self.straight.map(|straight| from_straight(rows[4] - straight));
        let Some(figure) = self.figure() else { return [None, None, wrist] };
        let (psi2, psi3) = (figure.angle(1, rows[1]), figure.angle(2, rows[2]));
        let slides = matches!(self.base, Base::Telescope(_));
        let elbow = if slides { psi3.abs() } else { from_straight(psi3) };
        let shoulder = self
            .centre(psi3)
            .map(|[along, across]| (along * psi2.cos() - across * psi2.sin() + figure.a1).abs());
        [shoulder, Some(elbow), wrist]
    }

    /// The wrist centre in the arm's plane, before joint 2 turns it.
    fn centre(&self, psi3: f64) -> Option<[f64; 2]> {
        if let Base::Elbow(b) = &self.base {
            Some([b.upper + b.fore * psi3.cos(), b.fore * psi3.sin()])
        } else if let Base::Telescope(b) = &self.base {
            Some([b.arm, psi3])
        } else {
            None
        }
    }

    fn figure(&self) -> Option<Figure> {
        if let Base::Elbow(b) = &self.base {
            Some(Figure { a1: b.a1, offset: b.offset, reversed: b.reversed })
        } else if let Base::Telescope(b) = &self.base {
            Some(Figure { a1: b.a1, offset: b.offset, reversed: b.reversed })
        } else {
            None
        }
    }

    /// Joint 3 to where the links are stretched or folded, or the slide is at its nearest.
    fn close_elbow(&self, rows: &mut [f64; 6], off: f64, folded: bool) {
        let Some(figure) = self.figure() else { return };
        let slides = matches!(self.base, Base::Telescope(_));
        rows[2] = figure.row(2, if folded && !slides { PI } else { 0.0 } + off);
    }

    /// Joint 2 to where the wrist centre lies in the plane that both shoulders share, if it comes there at all.
    fn close_shoulder(&self, rows: &mut [f64; 6], off: f64, front: bool) {
        let Some(figure) = self.figure() else { return };
        let Some([along, across]) = self.centre(figure.angle(2, rows[2])) else { return };
        let length = along.hypot(across);
        if length > figure.a1.abs() {
            let turn = (-figure.a1 / length).acos();
            rows[1] = figure.row(1, if front { turn } else { -turn } - across.atan2(along) + off);
        }
    }
}

impl Figure {
    fn row(&self, joint: usize, figure: f64) -> f64 {
        if self.reversed[joint] { self.offset[joint] - figure } else { figure - self.offset[joint] }
    }

    fn angle(&self, joint: usize, row: f64) -> f64 {
        if self.reversed[joint] { self.offset[joint] - row } else { row + self.offset[joint] }
    }
}

/// ±10^-k, as it is or somewhere around it, or nothing.
fn distance(common: Option<usize>, random: &mut Sampler) -> f64 {
    let power = common.unwrap_or_else(|| random.below(LAST_POWER + 2));
    let side = if random.below(2) == 0 { 1.0 } else { -1.0 };
    let around = if random.below(2) == 0 { 1.0 } else { random.between(0.3, 3.0) };
    POWERS.get(power).map_or(0.0, |size| side * around * size)
}

/// 10^-k, k = 0 … 17, as the compiler rounds them: the same on every machine.
const POWERS: [f64; LAST_POWER + 1] = [
    1e0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15,
    1e-16, 1e-17,
];
