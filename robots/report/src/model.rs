//! A declared arm as the pages need it: its chain walked element by element, in doubles for pictures and with 256 bits
//! for what is printed as true.

use std::fmt;

use kin_gen::chain::{Chain, Distance, Element, LengthAtom, Motion};
use kin_gen::decl::Axis;
use kin_gen::model::Arm;
use kin_gen::number::{Real, Scalar};
use kin_gen::textbook::{self, Textbook};

/// A table and what follows from it.
#[derive(Clone, Debug)]
pub struct Model {
    /// The exact chain.
    pub chain: Chain,
    /// The derived programs.
    pub arm: Arm,
    /// The formulas.
    pub textbook: Textbook,
}

/// Why there is no model.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ModelError(String);

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for ModelError {}

/// The numbers in which a chain is walked.
pub trait Number: Copy {
    /// The nearest one.
    fn of(value: Real) -> Self;
    /// Sine and cosine.
    fn sin_cos(self) -> (Self, Self);
    /// The sum.
    fn plus(self, other: Self) -> Self;
    /// The product.
    fn times(self, other: Self) -> Self;
    /// The negative.
    fn minus(self) -> Self;
}

impl Number for f64 {
    fn of(value: Real) -> f64 {
        value.to_f64()
    }
    fn sin_cos(self) -> (f64, f64) {
        f64::sin_cos(self)
    }
    fn plus(self, other: f64) -> f64 {
        self + other
    }
    fn times(self, other: f64) -> f64 {
        self * other
    }
    fn minus(self) -> f64 {
        -self
    }
}

impl Number for Real {
    fn of(value: Real) -> Real {
        value
    }
    fn sin_cos(self) -> (Real, Real) {
        Real::sin_cos(self)
    }
    fn plus(self, other: Real) -> Real {
        self + other
    }
    fn times(self, other: Real) -> Real {
        self * other
    }
    fn minus(self) -> Real {
        -self
    }
}

/// A frame: its orientation by rows and its origin, in the base frame.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Frame<T> {
    /// The rotation, by rows.
    pub rotation: [[T; 3]; 3],
    /// The origin.
    pub origin: [T; 3],
}

impl<T: Number> Frame<T> {
    /// The base frame.
    pub fn base() -> Frame<T> {
        let entry = |i: usize, j: usize| if i == j { T::of(Real::ONE) } else { T::of(Real::ZERO) };
        Frame { rotation: [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j))), origin: [T::of(Real::ZERO); 3] }
    }

    /// The direction of one of its axes.
    pub fn axis(&self, index: usize) -> [T; 3] {
        self.rotation.map(|row| row[index])
    }

    fn shifted(&mut self, axis: usize, by: T) {
        let direction = self.axis(axis);
        for (x, d) in self.origin.iter_mut().zip(direction) {
            *x = x.plus(by.times(d));
        }
    }

    fn turned(&mut self, axis: usize, (sin, cos): (T, T)) {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        for row in &mut self.rotation {
            let (a, b) = (row[next], row[last]);
            row[next] = a.times(cos).plus(b.times(sin));
            row[last] = b.times(cos).plus(a.times(sin.minus()));
        }
    }
}

/// The arm in one configuration.
#[derive(Clone, PartialEq, Debug)]
pub struct Body<T> {
    /// For each link, the base first, the corners of its course from one joint to the next.
    pub links: Vec<Vec<[T; 3]>>,
    /// For each joint a point on its axis, the axis, and whether it slides.
    pub joints: Vec<([T; 3], [T; 3], bool)>,
    /// The frame at the end of each joint's row.
    pub frames: Vec<Frame<T>>,
    /// The tool.
    pub tip: Frame<T>,
}

fn axis_index(axis: Axis) -> usize {
    match axis {
        Axis::X => 0,
        Axis::Y => 1,
        Axis::Z => 2,
    }
}

fn nominal(value: &Scalar) -> Real {
    value.to_real()
}

impl Model {
    /// Of a declaration's text.
    ///
    /// # Errors
    /// The messages of the compiler, or why there are no formulas.
    pub fn of(table: &str) -> Result<Model, ModelError> {
        let chain = kin_gen::check_text(table).map_err(ModelError)?;
        let arm = kin_gen::model::derive(&chain).map_err(|mismatch| ModelError(mismatch.to_string()))?;
        let textbook = textbook::of(&chain, &arm)
            .ok_or_else(|| ModelError(format!("the formulas of {} are too large", chain.name)))?;
        Ok(Model { chain, arm, textbook })
    }

    /// The exact value of a constant length, in the declared unit.
    pub fn length(&self, name: &str) -> Option<Real> {
        self.chain.lengths.iter().find(|l| l.name == name).map(|l| nominal(&l.value))
    }

    /// The sum of all lengths of the arm, in the declared unit.
    pub fn reach(&self) -> f64 {
        self.arm.reach.as_f64().unwrap_or(1.0)
    }

    fn distance<T: Number>(&self, distance: &Distance) -> T {
        let term = |&(coefficient, atom): &(i64, LengthAtom)| {
            let value = match atom {
                LengthAtom::Constant(index) => self.chain.lengths.get(index).map(|l| nominal(&l.value)),
                LengthAtom::Param(index) => self.chain.params.get(index).map(|p| nominal(&p.nominal)),
            };
            value.unwrap_or(Real::ZERO) * Real::from_i64(coefficient)
        };
        T::of(distance.0.iter().fold(Real::ZERO, |sum, t| sum + term(t)))
    }

    /// Carries a frame over one element.
    fn step<T: Number>(&self, frame: &mut Frame<T>, element: &Element, rows: &[T]) {
        let axis = axis_index(element.axis);
        let value = |joint: usize, reversed: bool| {
            let value = rows.get(joint).copied().unwrap_or(T::of(Real::ZERO));
            if reversed { value.minus() } else { value }
        };
        let constant = |rest: &kin_gen::chain::AngleSum| {
            let params = rest.params.iter().fold(Real::ZERO, |sum, (coefficient, index)| {
                let nominal = self.chain.params.get(*index).map_or(Real::ZERO, |p| nominal(&p.nominal));
                sum + nominal * Real::from_i64(*coefficient)
            });
            let (sin, cos) = rest.constant.sin_cos();
            (T::of(sin), T::of(cos), T::of(params))
        };
        match &element.motion {
            Motion::Turn(rest) => {
                let (sin, cos, params) = constant(rest);
                frame.turned(axis, (sin, cos));
                frame.turned(axis, params.sin_cos());
            }
            Motion::Revolute { joint, reversed, offset } => {
                let (sin, cos, params) = constant(offset);
                frame.turned(axis, (sin, cos));
                frame.turned(axis, params.plus(value(*joint, *reversed)).sin_cos());
            }
            Motion::Shift(distance) => frame.shifted(axis, self.distance(distance)),
            Motion::Prismatic { joint, reversed, offset } => {
                frame.shifted(axis, self.distance::<T>(offset).plus(value(*joint, *reversed)));
            }
        }
    }

    /// The arm with these commanded joint values.
    pub fn body<T: Number>(&self, q: &[T]) -> Body<T> {
        let zero = T::of(Real::ZERO);
        let row = |coefficients: &Vec<i64>| {
            let terms = coefficients.iter().zip(q);
            terms.fold(zero, |sum, (c, q)| sum.plus(T::of(Real::from_i64(*c)).times(*q)))
        };
        let rows: Vec<T> = self.chain.couple.iter().map(row).collect();
        let mut frame = Frame::base();
        let mut body = Body { links: Vec::new(), joints: Vec::new(), frames: Vec::new(), tip: frame };
        let mut course = vec![frame.origin];
        let elements = self.chain.base.iter().map(|e| (e, None));
        let elements = elements
            .chain(self.chain.elements.iter().enumerate().map(|(index, e)| (e, Some(index))))
            .chain(self.chain.tool.iter().map(|e| (e, None)));
        for (element, index) in elements {
            let reversed = match element.motion {
                Motion::Revolute { reversed, .. } | Motion::Prismatic { reversed, .. } => Some(reversed),
                _ => None,
            };
            if let Some(reversed) = reversed {
                let axis = frame.axis(axis_index(element.axis));
                let axis = if reversed { axis.map(T::minus) } else { axis };
                let slides = matches!(element.motion, Motion::Prismatic { .. });
                body.joints.push((frame.origin, axis, slides));
                body.links.push(std::mem::replace(&mut course, vec![frame.origin]));
            }
            self.step(&mut frame, element, &rows);
            if matches!(element.motion, Motion::Shift(_) | Motion::Prismatic { .. }) {
                course.push(frame.origin);
            }
            if let Some(index) = index {
                let ends = self.chain.frames.iter().filter(|end| **end == index + 1);
                body.frames.extend(ends.map(|_| frame));
            }
        }
        body.links.push(course);
        body.tip = frame;
        body
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kin_runtime::Pose;

    /// How far a frame is from a pose, entry by entry.
    fn apart(frame: &Frame<f64>, pose: &Pose<f64>) -> f64 {
        let turned =
            (0..9).map(|k| (frame.rotation[k / 3][k % 3] - pose.rotation.matrix()[(k / 3, k % 3)]).abs());
        let moved = (0..3).map(|i| (frame.origin[i] - pose.translation.vector[i]).abs());
        turned.chain(moved).fold(0.0, f64::max)
    }

    #[test]
    fn bodies_are_where_the_compiled_arms_are() {
        for arm in robots::ALL {
            let model = Model::of(arm.table()).unwrap_or_else(|e| panic!("{}: {e}", arm.name()));
            let joints = arm.joints().len();
            for round in 0..5 {
                let q: Vec<f64> = (0..joints).map(|i| 2.7 * f64::sin((7 * round + 3 * i) as f64)).collect();
                let body = model.body(&q);
                let tolerance = 1e-13 * (1.0 + arm.size());
                let tip = arm.pose_at(&q).unwrap_or_else(|e| panic!("{e}"));
                assert!(apart(&body.tip, &tip) < tolerance, "{}", arm.name());
                let mut frames = vec![Pose::identity(); joints];
                arm.frames_at(&q, &mut frames).unwrap_or_else(|e| panic!("{e}"));
                assert_eq!(
                    (body.frames.len(), body.joints.len(), body.links.len()),
                    (joints, joints, joints + 1)
                );
                assert!(
                    body.frames.iter().zip(&frames).all(|(a, b)| apart(a, b) < tolerance),
                    "{}",
                    arm.name()
                );
                // Links hang together, from the base to the tool.
                let ends = body.links.windows(2).all(|pair| pair[0].last() == pair[1].first());
                assert!(
                    ends && body.links.last().and_then(|l| l.last()) == Some(&body.tip.origin),
                    "{}",
                    arm.name()
                );
            }
        }
    }
}
