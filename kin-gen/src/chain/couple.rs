//! `couple:` statements to an integer matrix and its inverse.

use super::Joint;
use super::JointKind;
use crate::decl::nearest::nearest;
use crate::decl::{Couple, Expr, Node, Sign, joint_number};
use crate::number::Ratio;
use crate::report::{Place, Report};

/// A square matrix of integers, by rows.
type Matrix = Vec<Vec<i64>>;

/// The largest coefficient: no gear train couples joints by more.
const LARGEST: i64 = 1000;

fn identity(n: usize) -> Matrix {
    (0..n).map(|i| (0..n).map(|j| i64::from(i == j)).collect()).collect()
}

/// `couple` (row values from commanded ones) and `uncouple` (its inverse).
pub(super) fn couple(couples: &[Couple], joints: &[Joint], report: &mut Report) -> (Matrix, Matrix) {
    let mut forth = identity(joints.len());
    let mut back = identity(joints.len());
    for couple in couples {
        let Some(target) = joint(&couple.target.value, couple.target.place, joints, report) else { continue };
        let mut terms = Vec::new();
        if !linear(&couple.value, 1, joints, &mut terms, report) {
            continue;
        }
        for (coefficient, source, place) in terms {
            let k = if couple.subtract { -coefficient } else { coefficient };
            if source == target {
                let name = &couple.target.value;
                let message = format!("`{name}` is coupled to itself");
                report.error_help(place, message, "only other joints may stand on the right");
            } else if add_row(&mut forth, target, source, k)
                .and(add_column(&mut back, target, source, k))
                .is_none()
            {
                report.error_help(couple.place, "the coupling outgrows 64 bits", "use smaller coefficients");
            }
        }
    }
    (forth, back)
}

/// Row `target` += k · row `source`.
fn add_row(matrix: &mut Matrix, target: usize, source: usize, k: i64) -> Option<()> {
    let row = matrix.get(source)?.clone();
    for (entry, other) in matrix.get_mut(target)?.iter_mut().zip(row) {
        *entry = entry.checked_add(other.checked_mul(k)?)?;
    }
    Some(())
}

/// Column `source` −= k · column `target`: the inverse step, multiplied from the right.
fn add_column(matrix: &mut Matrix, target: usize, source: usize, k: i64) -> Option<()> {
    for row in matrix.iter_mut() {
        let other = *row.get(target)?;
        let entry = row.get_mut(source)?;
        *entry = entry.checked_sub(other.checked_mul(k)?)?;
    }
    Some(())
}

/// The joint of that name; the table's names go before `J1`, `J2`, ….
fn joint(name: &str, place: Place, joints: &[Joint], report: &mut Report) -> Option<usize> {
    let numbered = || {
        let digits = name.strip_prefix(['J', 'j']).map(|digits| format!("q{digits}"))?;
        let number = usize::try_from(joint_number(&digits)?).ok()?;
        number.checked_sub(1).filter(|i| *i < joints.len())
    };
    let found = joints.iter().position(|j| j.name == name).or_else(numbered);
    let Some(index) = found else {
        let help = match nearest(name, joints.iter().map(|j| j.name.as_str())) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!(
                "the joints are {}",
                joints.iter().map(|j| j.name.as_str()).collect::<Vec<_>>().join(", ")
            ),
        };
        report.error_help(place, format!("`{name}` is not a joint of this arm"), help);
        return None;
    };
    if joints.get(index).is_some_and(|j| j.kind == JointKind::Prismatic) {
        report.error_help(place, format!("`{name}` is prismatic"), "only revolute joints can be coupled");
        return None;
    }
    Some(index)
}

/// Collects `J2`, `2*J2`, `-J2 + J4`; `false` after a message.
fn linear(
    expr: &Expr,
    sign: i64,
    joints: &[Joint],
    terms: &mut Vec<(i64, usize, Place)>,
    report: &mut Report,
) -> bool {
    match &expr.node {
        Node::Name(name) => match joint(name, expr.place, joints, report) {
            Some(index) => terms.push((sign, index, expr.place)),
            None => return false,
        },
        Node::Neg(inner) => return linear(inner, -sign, joints, terms, report),
        Node::Sum(parts) => {
            let mut read = true;
            for (s, part) in parts {
                read &= linear(part, if *s == Sign::Minus { -sign } else { sign }, joints, terms, report);
            }
            return read;
        }
        Node::Product(factors) => {
            if let [(false, a), (false, b)] = factors.as_slice() {
                let (number, other) = if integer(a).is_some() { (integer(a), b) } else { (integer(b), a) };
                if let (Some(k), Node::Name(_)) = (number, &other.node) {
                    return linear(other, sign * k, joints, terms, report);
                }
            }
            return refuse(expr, report);
        }
        _ => return refuse(expr, report),
    }
    true
}

fn refuse(expr: &Expr, report: &mut Report) -> bool {
    let message = format!("`{expr}` is not a joint with an integer coefficient of at most {LARGEST}");
    report.error_help(expr.place, message, "write it like `couple: J3 -= 2*J2;`");
    false
}

fn integer(expr: &Expr) -> Option<i64> {
    match &expr.node {
        Node::Number(digits, None) => {
            let ratio = Ratio::parse_decimal(digits).filter(|r| r.is_integer())?;
            i64::try_from(ratio.num()).ok().filter(|k| (1..=LARGEST).contains(k))
        }
        Node::Neg(inner) => integer(inner).map(|k| -k),
        _ => None,
    }
}
