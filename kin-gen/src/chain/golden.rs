//! Golden poses: each `check` evaluated by the plain product of elementary transforms, in 256 bits.

use super::names::Scope;
use super::rows::{Parts, assemble};
use super::suspect::short;
use super::{AngleUnit, Axis, Chain, Distance, Element, Form, JointKind, Motion};
use crate::decl::{Check, Expr};
use crate::number::{Angle, Real, Scalar};
use crate::report::Report;

/// A pose: the columns of the rotation, then the position.
#[derive(Clone, Copy, Debug)]
struct Pose {
    columns: [[Real; 3]; 3],
    position: [Real; 3],
}

/// What a check demands.
struct Wanted {
    /// Row values: angles in turns of π and radians, or distances.
    rows: Vec<Row>,
    position: [Real; 3],
    zyx: Option<[Angle; 3]>,
    near: Real,
    near_rotation: Real,
}

/// The value of one joint in its row, after the coupling.
#[derive(Clone, Copy)]
enum Row {
    Angle(Angle),
    Distance(Scalar),
}

/// How far a pose is from what was wanted.
struct Offset {
    distance: Real,
    angle: Real,
    near: bool,
}

/// Evaluates all checks; `rows` is the table, for reading it in the other convention.
pub(super) fn golden(
    chain: &Chain,
    rows: &[Parts],
    checks: &[Check],
    scope: &mut Scope<'_>,
    report: &mut Report,
) {
    for check in checks {
        let Some(wanted) = wanted(chain, check, scope, report) else { continue };
        let pose = pose(chain, &chain.elements, &wanted.rows);
        let offset = offset(&pose, &wanted);
        if offset.near {
            continue;
        }
        let unit = chain.length_unit.word();
        let mut message = format!("this pose is {}", shown(&pose, chain));
        let far =
            Some(offset.distance).filter(|x| !x.is_negligible()).map(|x| short(x.to_f64()) + " " + unit);
        let turned = Some(offset.angle).filter(|x| !x.is_negligible()).map(|x| short(degrees(x)) + " deg");
        let off: Vec<String> = far.into_iter().chain(turned).collect();
        message.push_str(&format!(", {} off", off.join(" and ")));
        let help = match other_reading(chain, rows, &wanted) {
            Some(form) => {
                format!("it passes if read as `{}`: change the header if the table is meant so", form.word())
            }
            None => "correct the table or the check; `within` sets the tolerance of both".to_string(),
        };
        report.error_help(check.place, message, help);
    }
}

/// The other convention, if the pose is right in it.
fn other_reading(chain: &Chain, rows: &[Parts], wanted: &Wanted) -> Option<Form> {
    let form = match chain.form {
        Form::Standard => Form::Modified,
        Form::Modified => Form::Standard,
        Form::Chain => return None,
    };
    let (elements, _) = assemble(rows, form);
    offset(&pose(chain, &elements, &wanted.rows), wanted).near.then_some(form)
}

fn wanted(chain: &Chain, check: &Check, scope: &mut Scope<'_>, report: &mut Report) -> Option<Wanted> {
    let (given, joints) = (check.joints.len(), chain.joints.len());
    if given != joints {
        let help = "write one value for each joint";
        report.error_help(
            check.joints_place,
            format!("there are {given} values for the joints, of which there are {joints}"),
            help,
        );
        return None;
    }
    let mut commanded = Vec::new();
    for (joint, expr) in chain.joints.iter().zip(&check.joints) {
        commanded.push(match joint.kind {
            JointKind::Revolute => angle(expr, scope, report).map(Row::Angle),
            JointKind::Prismatic => length(expr, scope, report).map(Row::Distance),
        });
    }
    let position = check.position.each_ref().map(|e| length(e, scope, report).map(Scalar::to_real));
    let zyx = check.zyx.as_ref().map(|zyx| zyx.each_ref().map(|e| angle(e, scope, report)));
    let within = check.within.as_ref().map(|e| tolerance(e, scope, report));
    let commanded = commanded.into_iter().collect::<Option<Vec<Row>>>()?;
    let zyx = match zyx {
        Some([Some(z), Some(y), Some(x)]) => Some([z, y, x]),
        None => None,
        _ => return None,
    };
    let [x, y, z] = position;
    let billion = Real::from_i64(1_000_000_000);
    let default = (chain.reach().to_real() / billion, Real::ONE / billion);
    let (near, near_rotation) = match within {
        None => default,
        Some((tolerance, bare)) => {
            let tolerance = tolerance?.to_real();
            (tolerance, if bare { tolerance } else { default.1 })
        }
    };
    Some(Wanted { rows: coupled(chain, &commanded), position: [x?, y?, z?], zyx, near, near_rotation })
}

fn angle(expr: &Expr, scope: &mut Scope<'_>, report: &mut Report) -> Option<Angle> {
    let value = scope.constant(expr, "a check", report)?;
    scope.as_angle(&value).map_err(|fault| fault.report(expr.place, report)).ok()
}

fn length(expr: &Expr, scope: &mut Scope<'_>, report: &mut Report) -> Option<Scalar> {
    let value = scope.constant(expr, "a check", report)?;
    scope.as_length(&value).map_err(|fault| fault.report(expr.place, report)).ok()
}

/// A tolerance, and whether it is a bare number, which holds for the rotation's entries too.
fn tolerance(expr: &Expr, scope: &mut Scope<'_>, report: &mut Report) -> (Option<Scalar>, bool) {
    let Some(value) = scope.constant(expr, "a tolerance", report) else { return (None, false) };
    let bare = matches!(value.constant, super::value::Constant::Bare(_));
    match scope.as_length(&value) {
        Ok(x) if x.signum() < 0 => {
            report.error_help(
                expr.place,
                "a tolerance is not negative",
                "write a small number, such as `1e-6`",
            );
            (None, bare)
        }
        Ok(x) => (Some(x), bare),
        Err(fault) => {
            fault.report(expr.place, report);
            (None, bare)
        }
    }
}

/// Row values from commanded ones.
fn coupled(chain: &Chain, commanded: &[Row]) -> Vec<Row> {
    let mut rows = Vec::new();
    for (own, coefficients) in commanded.iter().zip(&chain.couple) {
        let mut sum = Angle::zero();
        for (row, k) in commanded.iter().zip(coefficients) {
            if let Row::Angle(angle) = row {
                sum = plus(sum, times(*angle, *k));
            }
        }
        rows.push(if let Row::Angle(_) = own { Row::Angle(sum) } else { *own });
    }
    rows
}

/// The product of base, `elements` and tool.
fn pose(chain: &Chain, elements: &[Element], rows: &[Row]) -> Pose {
    let (one, nil) = (Real::ONE, Real::ZERO);
    let mut pose = Pose { columns: [[one, nil, nil], [nil, one, nil], [nil, nil, one]], position: [nil; 3] };
    for element in chain.base.iter().chain(elements).chain(&chain.tool) {
        match &element.motion {
            Motion::Turn(sum) => pose.turn(element.axis, chain.nominal_angle(sum)),
            Motion::Shift(distance) => pose.shift(element.axis, chain.distance(distance).to_real()),
            Motion::Revolute { joint, reversed, offset } => {
                let Some(Row::Angle(row)) = rows.get(*joint) else { continue };
                let row = if *reversed { row.neg() } else { *row };
                pose.turn(element.axis, plus(chain.nominal_angle(offset), row));
            }
            Motion::Prismatic { joint, reversed, offset } => {
                let Some(Row::Distance(row)) = rows.get(*joint) else { continue };
                let row = if *reversed { row.neg() } else { *row };
                pose.shift(element.axis, distance_of(chain, offset) + row.to_real());
            }
        }
    }
    pose
}

fn distance_of(chain: &Chain, distance: &Distance) -> Real {
    chain.distance(distance).to_real()
}

/// A sum that falls back to 256 bits where the exact one would overflow.
fn plus(a: Angle, b: Angle) -> Angle {
    a.add(b).unwrap_or_else(|| Angle::from_rad((a.to_real() + b.to_real()).into()))
}

fn times(angle: Angle, k: i64) -> Angle {
    angle.times(k).unwrap_or_else(|| Angle::from_rad((angle.to_real() * Real::from_i64(k)).into()))
}

impl Pose {
    fn turn(&mut self, axis: Axis, angle: Angle) {
        let (s, c) = angle.sin_cos();
        // The axis stays; the next one turns towards the one after it.
        let (i, j) = match axis {
            Axis::X => (1, 2),
            Axis::Y => (2, 0),
            Axis::Z => (0, 1),
        };
        let (u, v) = (self.columns[i], self.columns[j]);
        self.columns[i] = [0, 1, 2].map(|k| u[k] * c + v[k] * s);
        self.columns[j] = [0, 1, 2].map(|k| v[k] * c - u[k] * s);
    }

    fn shift(&mut self, axis: Axis, distance: Real) {
        let column = match axis {
            Axis::X => self.columns[0],
            Axis::Y => self.columns[1],
            Axis::Z => self.columns[2],
        };
        self.position = [0, 1, 2].map(|k| self.position[k] + column[k] * distance);
    }

    /// Rz(z)·Ry(y)·Rx(x).
    fn from_zyx([z, y, x]: [Angle; 3]) -> Pose {
        let (one, nil) = (Real::ONE, Real::ZERO);
        let mut pose =
            Pose { columns: [[one, nil, nil], [nil, one, nil], [nil, nil, one]], position: [nil; 3] };
        pose.turn(Axis::Z, z);
        pose.turn(Axis::Y, y);
        pose.turn(Axis::X, x);
        pose
    }

    /// The angles of [`Pose::from_zyx`]; z is 0 in gimbal lock.
    fn zyx(&self) -> [Real; 3] {
        let [x, y, z] = self.columns;
        let flat = (x[0] * x[0] + x[1] * x[1]).sqrt();
        let tilt = Real::atan2(-x[2], flat);
        if flat.is_negligible() {
            return [Real::ZERO, tilt, Real::atan2(-z[1], y[1])];
        }
        [Real::atan2(x[1], x[0]), tilt, Real::atan2(y[2], z[2])]
    }
}

fn offset(pose: &Pose, wanted: &Wanted) -> Offset {
    let squares = |terms: &[Real]| terms.iter().fold(Real::ZERO, |sum, x| sum + *x * *x).sqrt();
    let difference = [0, 1, 2].map(|k| pose.position[k] - wanted.position[k]);
    let distance = squares(&difference);
    let mut near = (distance - wanted.near).is_negligible() || distance < wanted.near;
    let mut angle = Real::ZERO;
    if let Some(zyx) = wanted.zyx {
        let other = Pose::from_zyx(zyx);
        let entries: Vec<Real> =
            (0..9).map(|n| pose.columns[n / 3][n % 3] - other.columns[n / 3][n % 3]).collect();
        near &= entries.iter().all(|x| x.abs() <= wanted.near_rotation);
        // ‖R − S‖² = 8 sin²(angle / 2).
        let half_sine = squares(&entries) / Real::from_i64(8).sqrt();
        let square = Real::ONE - half_sine * half_sine;
        let half_cosine = if square > Real::ZERO { square.sqrt() } else { Real::ZERO };
        angle = Real::atan2(half_sine, half_cosine) * Real::from_i64(2);
    }
    Offset { distance, angle, near }
}

fn degrees(radians: Real) -> f64 {
    (radians * Real::from_i64(180) / Real::pi()).to_f64()
}

/// `(x, y, z) zyx(α, β, γ)` in the header's units, as a check would be written.
fn shown(pose: &Pose, chain: &Chain) -> String {
    let scale = chain.reach().to_f64();
    let length = |x: Real| {
        let x = x.to_f64();
        // What remains of cancelled terms is no coordinate.
        if x.abs() < 1e-30 * scale { "0".to_string() } else { short(x) }
    };
    let angle = |x: Real| match chain.angle_unit {
        _ if x.is_negligible() => "0".to_string(),
        AngleUnit::Degree => short(degrees(x)),
        AngleUnit::Radian => short(x.to_f64()),
    };
    let [x, y, z] = pose.position.map(length);
    let [a, b, c] = pose.zyx().map(angle);
    format!("({x}, {y}, {z}) zyx({a}, {b}, {c})")
}
