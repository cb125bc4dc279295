//! What is tried: joint values, most of them aimed at singular sets from every distance.
//!
//! A singular set is where a figure of the solver collapses, so its place is known from the figure's constants alone:
//! the links stretched or folded, the wrist centre in the plane through axis 1 in which both shoulders are one, axes 4,
//! 5 and 6 in one plane; for joints whose figures are none of these, [`Lines`] knows. Arms without a wrist are aimed at whole
//! quarter turns too, where axes become parallel. Aiming is not judging: a shot that goes wide is tried all the same.

use std::f64::consts::{FRAC_PI_2, PI};

use kin_runtime::prelude::*;
use kin_runtime::{Base, JointKind, math};

use super::lines::Lines;
use crate::sample::Sampler;

/// The last power of ten; the step after it is the singular set itself.
const LAST_POWER: usize = 17;

/// The constants of an arm that aiming needs, in row values.
#[derive(Clone, Debug)]
pub struct Sights {
    figures: Figures,
    /// The rows of the base's joints, from its foot: the last three of an arm that is solved from its tool.
    base: [usize; 3],
    /// The row of the middle joint of a spherical wrist, or shoulder, and its value where the three axes lie in one plane; half a
    /// turn from there they do so again.
    straight: Option<(usize, f64)>,
    /// The range of each row value; none for an angle, which may be any.
    ranges: Vec<Option<(f64, f64)>>,
    /// The arm's reach.
    reach: f64,
}

/// What collapses.
#[derive(Clone, Debug)]
pub enum Figures {
    /// Links, or a link and a slide, in a plane.
    Planar(Base<f64>),
    /// Anything else; two joints are the second and the third of a base.
    Lines(Lines),
}

/// The first three joints as a vector from axis 2 and the way joint 2 turns it.
struct Figure {
    a1: f64,
    offset: [f64; 3],
    reversed: [bool; 3],
}

impl Figures {
    /// Of three joints.
    pub fn of(base: Base<f64>) -> Figures {
        match base {
            Base::General(base) => Figures::Lines(Lines::of_three(&base)),
            planar => Figures::Planar(planar),
        }
    }
}

impl Sights {
    /// For an arm with these figures, the rows of whose joints are these.
    pub fn new<const N: usize, A: Arm<N>>(
        figures: Figures,
        base: [usize; 3],
        straight: Option<(usize, f64)>,
        arm: &A,
    ) -> Sights {
        Sights { figures, base, straight, ranges: ranges(arm), reach: arm.reach() }
    }

    /// What it is aimed at.
    pub fn kinds(&self) -> Vec<&'static str> {
        let mut kinds = match &self.figures {
            Figures::Planar(_) => vec!["elbow", "both shoulders"],
            Figures::Lines(lines) => lines.kinds(),
        };
        kinds.push(if self.straight.is_some() { "wrist" } else { "quarter turns" });
        kinds
    }

    /// The row values of one try: a quarter of them anywhere, the others at singular sets.
    pub fn row_values(&self, random: &mut Sampler) -> [f64; 6] {
        let mut rows = [0.0; 6];
        for (row, range) in rows.iter_mut().zip(&self.ranges) {
            let (low, high) = range.unwrap_or((-PI, PI));
            *row = random.between(low, high);
        }
        if random.below(4) == 0 {
            return rows;
        }
        // Any of the sets, in any company, at distances of their own or at one distance.
        let sets = 1 + random.below(7);
        let common = (random.below(2) == 0).then(|| random.below(LAST_POWER + 2));
        let mut off = || distance(common, random);
        let (wrist, elbow, shoulder) = (off(), off(), off());
        match self.straight {
            Some((row, straight)) if sets & 1 != 0 => {
                rows[row] = straight + if random.below(2) == 0 { 0.0 } else { PI } + wrist;
            }
            None if sets & 1 != 0 => {
                let row = random.below(self.ranges.len());
                let quarter = FRAC_PI_2 * (random.below(4) as f64 - 1.0) + wrist;
                // As a length it would be several times the reach of a small arm.
                if self.ranges[row].is_none() {
                    rows[row] = quarter;
                }
            }
            _ => {}
        }
        let [_, second, third] = self.base;
        match &self.figures {
            Figures::Planar(_) => {
                if sets & 2 != 0 {
                    self.close_elbow(&mut rows, elbow, random.below(2) == 0);
                }
                if sets & 4 != 0 {
                    self.close_shoulder(&mut rows, shoulder, random.below(2) == 0);
                }
            }
            Figures::Lines(lines) if sets & 6 != 0 => {
                if let Some([at_second, at_third]) = lines.singular([rows[second], rows[third]], random) {
                    self.set(&mut rows, second, at_second, if sets & 4 != 0 { shoulder } else { 0.0 });
                    self.set(&mut rows, third, at_third, if sets & 2 != 0 { elbow } else { 0.0 });
                }
            }
            Figures::Lines(_) => {}
        }
        rows
    }

    /// A row to a value, or so far from it, in radians and reaches. A slide that would then be out of its range, and more than half a
    /// reach out, stays where it is.
    fn set(&self, rows: &mut [f64; 6], row: usize, value: f64, off: f64) {
        let Some((low, high)) = self.ranges[row] else {
            rows[row] = value + off;
            return;
        };
        let there = value + off * self.reach;
        if there.abs() <= 0.5 * self.reach || (low..=high).contains(&there) {
            rows[row] = there;
        }
    }

    /// How far row values are from the shoulder's, the elbow's and the wrist's singular set, as the library measures its
    /// own solutions; from the constants alone, so that the two can be compared.
    pub fn margins(&self, rows: &[f64; 6]) -> [Option<f64>; 3] {
        let from_straight = |angle: f64| {
            let bend = ((angle + PI).rem_euclid(2.0 * PI) - PI).abs();
            bend.min(PI - bend)
        };
        let wrist = self.straight.map(|(row, straight)| from_straight(rows[row] - straight));
        let [_, second, third] = self.base;
        if let Figures::Lines(lines) = &self.figures {
            let [shoulder, elbow] = lines.margins([rows[second], rows[third]]);
            return [Some(shoulder), Some(elbow), wrist];
        }
        let Some(figure) = self.figure() else { return [None, None, wrist] };
        let (psi2, psi3) = (figure.angle(1, rows[second]), figure.angle(2, rows[third]));
        let elbow = if self.slides() { psi3.abs() } else { from_straight(psi3) };
        let (sine, cosine) = math::sin_cos(psi2);
        let from_plane = |[along, across]: [f64; 2]| (along * cosine - across * sine + figure.a1).abs();
        let shoulder = self.centre(psi3).map(from_plane);
        [shoulder, Some(elbow), wrist]
    }

    /// The wrist centre in the arm's plane, before joint 2 turns it.
    fn centre(&self, psi3: f64) -> Option<[f64; 2]> {
        match &self.figures {
            Figures::Planar(Base::Elbow(b)) => {
                let (sine, cosine) = math::sin_cos(psi3);
                Some([b.upper + b.fore * cosine, b.fore * sine])
            }
            Figures::Planar(Base::Telescope(b)) => Some([b.arm, psi3]),
            _ => None,
        }
    }

    fn figure(&self) -> Option<Figure> {
        match &self.figures {
            Figures::Planar(Base::Elbow(b)) => {
                Some(Figure { a1: b.a1, offset: b.offset, reversed: b.reversed })
            }
            Figures::Planar(Base::Telescope(b)) => {
                Some(Figure { a1: b.a1, offset: b.offset, reversed: b.reversed })
            }
            _ => None,
        }
    }

    fn slides(&self) -> bool {
        matches!(self.figures, Figures::Planar(Base::Telescope(_)))
    }

    /// Joint 3 to where the links are stretched or folded, or the slide is at its nearest.
    fn close_elbow(&self, rows: &mut [f64; 6], off: f64, folded: bool) {
        let Some(figure) = self.figure() else { return };
        self.set(rows, self.base[2], figure.row(2, if folded && !self.slides() { PI } else { 0.0 }), off);
    }

    /// Joint 2 to where the wrist centre lies in the plane that both shoulders share, if it comes there at all.
    fn close_shoulder(&self, rows: &mut [f64; 6], off: f64, front: bool) {
        let [_, second, third] = self.base;
        let Some(figure) = self.figure() else { return };
        let Some([along, across]) = self.centre(figure.angle(2, rows[third])) else { return };
        let length = math::hypot(along, across);
        if length > figure.a1.abs() {
            let turn = arc_cosine(-figure.a1 / length);
            let row = figure.row(1, if front { turn } else { -turn } - math::atan2(across, along));
            self.set(rows, second, row, off);
        }
    }
}

/// Of a sliding joint its range, or half the reach to either side; none of a turning one.
fn ranges<const N: usize, A: Arm<N>>(arm: &A) -> Vec<Option<(f64, f64)>> {
    let half = 0.5 * arm.reach();
    let range = |joint: usize| match A::JOINTS[joint].kind {
        JointKind::Prismatic => Some(arm.limits().range(joint).unwrap_or((-half, half))),
        JointKind::Revolute => None,
    };
    (0..N).map(range).collect()
}

impl Figure {
    fn row(&self, joint: usize, figure: f64) -> f64 {
        if self.reversed[joint] { self.offset[joint] - figure } else { figure - self.offset[joint] }
    }

    fn angle(&self, joint: usize, row: f64) -> f64 {
        if self.reversed[joint] { self.offset[joint] - row } else { row + self.offset[joint] }
    }
}

/// In [0, π], by the functions of the library as everything here: those of `std` are not the same on every machine.
pub(super) fn arc_cosine(cosine: f64) -> f64 {
    math::atan2(((1.0 - cosine) * (1.0 + cosine)).sqrt(), cosine)
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
