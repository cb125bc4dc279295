//! Elementary transforms: the chain form, `base:` and `tool:`, and what one cell or factor does.

use super::eval::Allowed;
use super::lengths::{Lengths, Slot, angle_sum, joint_sign};
use super::names::Scope;
use super::{AngleSum, Axis, Distance, Element, Joint, JointKind, Motion, suspect};
use crate::decl::{Expr, Factor, is_joint_variable};
use crate::report::Report;

/// What a cell or a factor does; `None` if nothing, or after a message.
pub(super) fn motion(
    expr: &Expr,
    turn: bool,
    slot: Slot<'_>,
    allowed: Allowed<'_>,
    scope: &mut Scope<'_>,
    lengths: &mut Lengths,
    report: &mut Report,
) -> Option<Motion> {
    let value = scope.value(expr, allowed, report)?;
    let joint =
        allowed.joint.filter(|_| expr.mentions(&is_joint_variable)).and_then(|own| own.checked_sub(1));
    let reversed = match joint {
        Some(_) => joint_sign(&value, slot, report)?,
        None => false,
    };
    if turn {
        let offset = angle_sum(&value, slot, scope, report)?;
        suspect::angle(&value, offset.constant, scope.angle_unit, slot.place, report);
        return match joint {
            Some(joint) => Some(Motion::Revolute { joint, reversed, offset }),
            None => (!is_identity(&offset)).then_some(Motion::Turn(offset)),
        };
    }
    let offset = lengths.distance(&value, slot, scope, report)?;
    match joint {
        Some(joint) => Some(Motion::Prismatic { joint, reversed, offset }),
        None => (offset != Distance::default()).then_some(Motion::Shift(offset)),
    }
}

/// No turn, or whole turns.
fn is_identity(sum: &AngleSum) -> bool {
    sum.params.is_empty() && (sum.constant.is_zero() || sum.constant.quarters() == Some(0))
}

/// The factors of the chain form: the elements, the joints, and the end of each joint's frame.
pub(super) fn chain(
    factors: &[Factor],
    scope: &mut Scope<'_>,
    lengths: &mut Lengths,
    report: &mut Report,
) -> (Vec<Element>, Vec<Joint>, Vec<usize>) {
    let (mut elements, mut joints, mut frames): (Vec<Element>, Vec<Joint>, Vec<usize>) = Default::default();
    for factor in factors {
        let joint = factor.argument.as_ref().is_some_and(|e| e.mentions(&is_joint_variable));
        let own = joint.then_some(joints.len() + 1);
        if joint {
            // Frame i ends just before the factor of joint i + 1.
            if !joints.is_empty() {
                frames.push(elements.len());
            }
            let kind = if factor.turn { JointKind::Revolute } else { JointKind::Prismatic };
            let name = format!("J{}", joints.len() + 1);
            joints.push(Joint { name, kind, limits: None, place: factor.place });
        }
        let letter = match factor.axis {
            Axis::X => 'a',
            Axis::Y => 'b',
            Axis::Z => 'd',
        };
        let atom = format!("{letter}{}", joints.len());
        elements.extend(element(factor, &atom, own, "a factor", scope, lengths, report));
    }
    if !joints.is_empty() {
        frames.push(elements.len());
    }
    (elements, joints, frames)
}

/// `base:` or `tool:`.
pub(super) fn fixed(
    factors: &[Factor],
    word: &str,
    scope: &mut Scope<'_>,
    lengths: &mut Lengths,
    report: &mut Report,
) -> Vec<Element> {
    let mut elements = Vec::new();
    for factor in factors {
        let atom = format!("{word}_{}", format!("{:?}", factor.axis).to_lowercase());
        let what = format!("`{word}`");
        elements.extend(element(factor, &atom, None, &what, scope, lengths, report));
    }
    elements
}

fn element(
    factor: &Factor,
    atom: &str,
    own: Option<usize>,
    what: &str,
    scope: &mut Scope<'_>,
    lengths: &mut Lengths,
    report: &mut Report,
) -> Option<Element> {
    let expr = factor.argument.as_ref()?;
    let label = if factor.turn { "the argument of a rotation" } else { "the argument of a translation" };
    let slot = Slot { label, atom, place: expr.place };
    let allowed = Allowed { joint: own, params: true, what };
    let motion = motion(expr, factor.turn, slot, allowed, scope, lengths, report)?;
    Some(Element { axis: factor.axis, motion, place: factor.place })
}
