//! True values: joint values refined with 256 bits until forward kinematics agrees to 45 digits.
//!
//! A solver that works in doubles cannot say the last digits of a solution near a singular pose; a report that prints
//! fifteen of them should. Newton's method starts at the solver's own answer: the residual is taken in 256 bits, the
//! step in doubles, so that each round adds about as many digits as the Jacobian allows.

use kin_gen::number::{Ratio, Real};

use crate::model::{Frame, Model};

/// A decimal as it is written, exactly.
///
/// # Panics
/// On what is no decimal: the texts are part of this crate.
pub fn decimal(text: &str) -> Real {
    Real::from_ratio(Ratio::parse_decimal(text).unwrap_or_else(|| panic!("{text} is a decimal")))
}

/// A fraction of π.
pub fn pi_over(divisor: i64) -> Real {
    Real::pi() / Real::from_i64(divisor)
}

/// The pose Rz(z)·Ry(y)·Rx(x) at a position, as reports print it.
pub fn zyx(position: [Real; 3], angles: [Real; 3]) -> Frame<Real> {
    let [z, y, x] = angles.map(Real::sin_cos);
    let ((sz, cz), (sy, cy), (sx, cx)) = (z, y, x);
    let rotation = [
        [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
        [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
        [-sy, cy * sx, cy * cx],
    ];
    Frame { rotation, origin: position }
}

/// How far a frame misses another: position, then rotation vector, both in base axes, for small misses.
pub fn miss(wanted: &Frame<Real>, found: &Frame<Real>) -> [Real; 6] {
    let mut turn = [Real::ZERO; 3];
    for column in 0..3 {
        let (a, b) = (found.axis(column), wanted.axis(column));
        let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        turn = [turn[0] + cross[0], turn[1] + cross[1], turn[2] + cross[2]];
    }
    let half = Real::ONE / Real::from_i64(2);
    let [x, y, z] = [0, 1, 2].map(|i| wanted.origin[i] - found.origin[i]);
    [x, y, z, turn[0] * half, turn[1] * half, turn[2] * half]
}

/// What joint values are refined for.
#[derive(Clone, Copy, Debug)]
pub enum Goal<'a> {
    /// A pose of the tool.
    Pose(&'a Frame<Real>),
    /// A position of the tool point.
    Point([Real; 3]),
}

/// The joint values near `q` that meet the goal; joints in `held` keep their value. `None` if they do not settle.
pub fn refined(model: &Model, goal: Goal<'_>, q: &[f64], held: &[usize]) -> Option<Vec<Real>> {
    let mut values: Vec<Real> = q.iter().map(|x| Real::from_f64(*x)).collect::<Option<_>>()?;
    let reach = model.reach();
    let free: Vec<usize> = (0..q.len()).filter(|joint| !held.contains(joint)).collect();
    for _ in 0..60 {
        let tip = model.body(&values).tip;
        let rows = match goal {
            Goal::Pose(pose) => miss(pose, &tip).map(Real::to_f64).to_vec(),
            Goal::Point(point) => (0..3).map(|i| (point[i] - tip.origin[i]).to_f64()).collect(),
        };
        // Lengths are divided by the reach, so that both kinds of row weigh alike.
        let size = |(row, value): (usize, &f64)| if row < 3 { value / reach } else { *value };
        let misses: Vec<f64> = rows.iter().enumerate().map(size).collect();
        if misses.iter().all(|m| m.abs() < 1e-45) {
            return Some(values);
        }
        let at: Vec<f64> = values.iter().map(|v| v.to_f64()).collect();
        let columns = model.arm.eval_jacobian(&at);
        let column = |joint: &usize| -> Vec<f64> {
            let column = columns.get(*joint).copied().unwrap_or_default();
            column.iter().take(rows.len()).enumerate().map(size).collect()
        };
        let step = least_squares(&free.iter().map(column).collect::<Vec<_>>(), &misses)?;
        for (joint, by) in free.iter().zip(step) {
            values[*joint] = values[*joint] + Real::from_f64(by)?;
        }
    }
    None
}

/// Solves for the combination of columns nearest to `b`, by orthogonalising them twice over.
fn least_squares(columns: &[Vec<f64>], b: &[f64]) -> Option<Vec<f64>> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let count = columns.len();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let mut upper = vec![vec![0.0; count]; count];
    for (j, column) in columns.iter().enumerate() {
        let mut rest = column.clone();
        for _ in 0..2 {
            for (i, direction) in basis.iter().enumerate() {
                let share = dot(direction, &rest);
                upper[i][j] += share;
                rest.iter_mut().zip(direction).for_each(|(x, d)| *x -= share * d);
            }
        }
        let length = dot(&rest, &rest).sqrt();
        if length < 1e-14 {
            return None;
        }
        upper[j][j] = length;
        basis.push(rest.into_iter().map(|x| x / length).collect());
    }
    let mut solution = vec![0.0; count];
    for i in (0..count).rev() {
        let known: f64 = (i + 1..count).map(|j| upper[i][j] * solution[j]).sum();
        solution[i] = (dot(&basis[i], b) - known) / upper[i][i];
    }
    Some(solution)
}

/// A real number with that many decimals, correctly rounded but for ties.
pub fn decimals(value: Real, count: usize) -> String {
    let ten = Real::from_i64(10);
    let mut rest = value.abs();
    let mut ulp = Real::ONE;
    (0..count).for_each(|_| ulp = ulp / ten);
    rest = rest + ulp / Real::from_i64(2);
    let whole = rest.to_f64().floor();
    // `to_f64` may round up to the next integer.
    let mut whole = Real::from_f64(whole).unwrap_or(Real::ZERO);
    if whole > rest {
        whole = whole - Real::ONE;
    }
    rest = rest - whole;
    let mut digits = String::new();
    for _ in 0..count {
        rest = rest * ten;
        let digit = (0..=9).rev().find(|d| Real::from_i64(*d) <= rest).unwrap_or(0);
        digits.push_str(&digit.to_string());
        rest = rest - Real::from_i64(digit);
    }
    let nothing = whole.is_zero() && digits.bytes().all(|b| b == b'0');
    let sign = if value.signum() < 0 && !nothing { "-" } else { "" };
    let whole = whole.to_f64();
    if count == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{digits}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_those_of_pi() {
        assert_eq!(decimals(Real::pi(), 30), "3.141592653589793238462643383280");
        assert_eq!(decimals(-Real::pi(), 4), "-3.1416");
        assert_eq!(decimals(decimal("0.99996"), 4), "1.0000");
        assert_eq!(decimals(decimal("-0.00001"), 3), "0.000");
        assert_eq!(decimals(decimal("372.5"), 0), "373");
    }

    #[test]
    fn refined_values_bring_the_tool_back() {
        let model =
            Model::of(<robots::LabArm as kin_runtime::Arm<6>>::TABLE).unwrap_or_else(|e| panic!("{e}"));
        let wanted = ["0.1", "0.4", "-0.2", "0.3", "0.9", "-0.5"].map(decimal);
        let pose = model.body(&wanted).tip;
        let off = [0.1001, 0.3999, -0.2002, 0.3003, 0.9, -0.5004];
        let found = refined(&model, Goal::Pose(&pose), &off, &[]).expect("a regular pose");
        assert!(found.iter().zip(wanted).all(|(a, b)| (*a - b).abs().to_f64() < 1e-40));
        assert!(miss(&pose, &model.body(&found).tip).iter().all(|m| m.abs().to_f64() < 1e-40));
    }
}
