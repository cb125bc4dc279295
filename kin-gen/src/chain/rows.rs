//! The rows of a table to elementary transforms.

use super::eval::Allowed;
use super::factors::motion;
use super::lengths::{Lengths, Slot};
use super::names::Scope;
use super::value::Value;
use super::{AngleUnit, Axis, Element, Form, Joint, JointKind, suspect};
use crate::decl::{Cell, Column, Content, Expr, Node, Row, Table, is_joint_variable};
use crate::number::{Ratio, Scalar};
use crate::report::{Place, Report};

/// The four transforms of one row, the exact zeros left out.
#[derive(Clone, Debug, Default)]
pub(super) struct Parts {
    alpha: Option<Element>,
    a: Option<Element>,
    theta: Option<Element>,
    d: Option<Element>,
    /// Whether the row is a joint's own.
    joint: bool,
}

/// The elements of all rows in a convention's order, and the end of each joint's own row.
pub(super) fn assemble(rows: &[Parts], form: Form) -> (Vec<Element>, Vec<usize>) {
    let (mut elements, mut frames) = (Vec::new(), Vec::new());
    for row in rows {
        let in_order = match form {
            Form::Standard => [&row.theta, &row.d, &row.a, &row.alpha],
            Form::Modified | Form::Chain => [&row.alpha, &row.a, &row.theta, &row.d],
        };
        elements.extend(in_order.into_iter().flatten().cloned());
        if row.joint {
            frames.push(elements.len());
        }
    }
    (elements, frames)
}

/// Reads the rows of a table.
pub(super) struct Rows<'a, 'b> {
    pub(super) table: &'a Table,
    pub(super) form: Form,
    pub(super) scope: &'a mut Scope<'b>,
    pub(super) lengths: &'a mut Lengths,
    pub(super) joints: Vec<Joint>,
    pub(super) parts: Vec<Parts>,
}

impl Rows<'_, '_> {
    pub(super) fn read(&mut self, report: &mut Report) {
        for (i, row) in self.table.rows.iter().enumerate() {
            self.row(row, i + 1, report);
        }
    }

    fn row(&mut self, row: &Row, number: usize, report: &mut Report) {
        let cell = |column| cell(self.table, row, column);
        let has_q = |cell: Option<&Cell>| {
            let scope = &self.scope;
            mentions(cell, &|name| is_joint_variable(name) && !scope.refused(name))
        };
        let (revolute, prismatic) = (has_q(cell(Column::Theta)), has_q(cell(Column::D)));
        let misplaced =
            [Column::Alpha, Column::A].map(|column| (column, cell(column).filter(|c| has_q(Some(c)))));
        let misplaced = is_misplaced(misplaced, report);
        if revolute && prismatic {
            let place = cell(Column::D).map_or(row.place, |c| c.place);
            let help = "split the row: one row with q in theta, one with q in d";
            report.error_help(place, "q stands in theta and in d, but a row is one joint", help);
        }
        let named = cell(Column::Joint).is_some_and(|c| !matches!(c.content, Content::Empty));
        let readable = |column| {
            let refused = mentions(cell(column), &|name| self.scope.refused(name));
            cell(column).is_some_and(|c| !matches!(c.content, Content::Bad)) && !refused
        };
        let joint = if readable(Column::Theta) && readable(Column::D) {
            revolute || prismatic || misplaced
        } else {
            // The part that could not be read may have been the q.
            revolute || prismatic || misplaced || named
        };
        let own = joint.then_some(self.joints.len() + 1);
        let mut parts = Parts { joint, ..Parts::default() };
        for (column, axis, turn) in order(self.form) {
            let Some(cell) = cell(column) else { continue };
            let joint_column = matches!(column, Column::Theta | Column::D);
            if (!joint_column && mentions(Some(cell), &is_joint_variable))
                || (column == Column::D && revolute && prismatic)
            {
                continue;
            }
            let element = self.element(cell, column, axis, turn, own, report);
            match column {
                Column::Alpha => parts.alpha = element,
                Column::A => parts.a = element,
                Column::Theta => parts.theta = element,
                _ => parts.d = element,
            }
        }
        self.parts.push(parts);
        if joint {
            let kind = if prismatic && !revolute { JointKind::Prismatic } else { JointKind::Revolute };
            self.joint(row, kind, report);
        } else {
            fixed_row(cell(Column::Joint), cell(Column::Limits), number, report);
        }
    }

    /// One cell to its transform, if it is not an exact zero.
    fn element(
        &mut self,
        cell: &Cell,
        column: Column,
        axis: Axis,
        turn: bool,
        own: Option<usize>,
        report: &mut Report,
    ) -> Option<Element> {
        let label = format!("`{}`", column.header());
        let expr = match &cell.content {
            Content::Value(expr) => expr,
            Content::Empty => {
                report.error_help(
                    cell.place,
                    format!("the cell of {label} is empty"),
                    "write `0` for a zero",
                );
                return None;
            }
            _ => return None,
        };
        // A fixed row is on the way to the next joint and takes the previous one's number.
        let (number, letter) = match (own, self.joints.len()) {
            (Some(own), _) => (own, ""),
            (None, 0) => (0, ""),
            (None, previous) => (previous, "b"),
        };
        let atom = format!("{}{number}{letter}", column.header());
        let slot = Slot { label: &label, atom: &atom, place: cell.place };
        let allowed = Allowed { joint: own, params: true, what: &label };
        let motion = motion(expr, turn, slot, allowed, self.scope, self.lengths, report)?;
        Some(Element { axis, motion, place: cell.place })
    }

    /// Notes the joint of a row: its name and limits.
    fn joint(&mut self, row: &Row, kind: JointKind, report: &mut Report) {
        let own = self.joints.len() + 1;
        let mut name = format!("J{own}");
        if let Some(cell) = cell(self.table, row, Column::Joint) {
            if let Content::Name(written) = &cell.content {
                if !written.starts_with(|c: char| c.is_ascii_digit()) {
                    name = written.clone();
                } else if *written != own.to_string() {
                    let help = format!("number the joints from 1: write `{own}`, or a name");
                    report.error_help(cell.place, format!("row {written} holds joint {own}"), help);
                }
            }
            if self.joints.iter().any(|j| j.name == name) {
                report.error_help(
                    cell.place,
                    format!("there are two joints `{name}`"),
                    "give one of them another name",
                );
            }
        }
        let limits = cell(self.table, row, Column::Limits).and_then(|cell| match &cell.content {
            Content::Range(low, high) => self.limits(low, high, kind, cell.place, report),
            _ => None,
        });
        self.joints.push(Joint { name, kind, limits, place: row.place });
    }

    fn limits(
        &mut self,
        low: &Expr,
        high: &Expr,
        kind: JointKind,
        place: Place,
        report: &mut Report,
    ) -> Option<(Scalar, Scalar)> {
        let low_value = self.limit(low, kind, report);
        let high_value = self.limit(high, kind, report);
        let ((low_value, from), (high_value, to)) = (low_value?, high_value?);
        if kind == JointKind::Revolute {
            suspect::limits([(&from, low.place), (&to, high.place)], self.scope.angle_unit, report);
        }
        if low_value > high_value {
            let message = format!("the limits {low} .. {high} are reversed, so that no value is within them");
            let help = match (kind, self.scope.angle_unit) {
                (JointKind::Prismatic, _) => format!("write `{high} .. {low}`"),
                (_, AngleUnit::Radian) => {
                    format!(
                        "write `{high} .. {low}`, or `{low} .. {high} + 2*pi` for a range through half a turn"
                    )
                }
                (_, AngleUnit::Degree) => match degrees_later(high) {
                    Some(later) => {
                        format!("write `{high} .. {low}`, or `{low} .. {later}` for a range through 180")
                    }
                    None => format!(
                        "write `{high} .. {low}`, or add 360deg to the second for a range through 180"
                    ),
                },
            };
            report.error_help(place, message, help);
            return None;
        }
        Some((low_value, high_value))
    }

    fn limit(&mut self, expr: &Expr, kind: JointKind, report: &mut Report) -> Option<(Scalar, Value)> {
        let value = self.scope.constant(expr, "a limit", report)?;
        let limit = match kind {
            JointKind::Prismatic => self.scope.as_length(&value),
            JointKind::Revolute => self.scope.as_angle(&value).map(super::measure::radians),
        };
        Some((limit.map_err(|fault| fault.report(expr.place, report)).ok()?, value))
    }
}

/// The cells of a row in the order of the convention's transforms: column, axis, whether it turns.
fn order(form: Form) -> [(Column, Axis, bool); 4] {
    let (theta, d) = ((Column::Theta, Axis::Z, true), (Column::D, Axis::Z, false));
    let (alpha, a) = ((Column::Alpha, Axis::X, true), (Column::A, Axis::X, false));
    match form {
        Form::Standard => [theta, d, a, alpha],
        Form::Modified | Form::Chain => [alpha, a, theta, d],
    }
}

fn cell<'a>(table: &Table, row: &'a Row, column: Column) -> Option<&'a Cell> {
    let index = table.columns.iter().position(|(c, _)| *c == column)?;
    row.cells.get(index)
}

/// Whether a name that satisfies `wanted` occurs in a cell.
fn mentions(cell: Option<&Cell>, wanted: &dyn Fn(&str) -> bool) -> bool {
    cell.is_some_and(|c| matches!(&c.content, Content::Value(e) if e.mentions(wanted)))
}

/// Whether q stands in a column of constants, which is said.
fn is_misplaced(cells: [(Column, Option<&Cell>); 2], report: &mut Report) -> bool {
    let mut found = false;
    for (column, cell) in cells {
        let Some(cell) = cell else { continue };
        found = true;
        let message = format!("q stands in `{}`, which is a constant of the link", column.header());
        let help = "a joint variable belongs in theta (revolute) or in d (prismatic)";
        report.error_help(cell.place, message, help);
    }
    found
}

/// A row without q has neither a name nor limits.
fn fixed_row(joint: Option<&Cell>, limits: Option<&Cell>, number: usize, report: &mut Report) {
    let filled = |cell: Option<&Cell>| {
        cell.is_some_and(|c| matches!(c.content, Content::Name(_) | Content::Range(..)))
    };
    if let Some(cell) = joint.filter(|_| filled(joint)) {
        let help = "write q in theta (revolute) or in d (prismatic), or leave the joint's cell empty for a fixed row";
        report.error_help(cell.place, format!("the row of joint {cell} has no q"), help);
    } else if let Some(cell) = limits.filter(|_| filled(limits)) {
        let help = "write q in theta or d, or leave the limits empty";
        report.error_help(cell.place, format!("row {number} is fixed and cannot have limits"), help);
    }
}

/// A whole turn more than a plain number of degrees.
fn degrees_later(expr: &Expr) -> Option<Ratio> {
    let (digits, negative) = match &expr.node {
        Node::Number(digits, None) => (digits, false),
        Node::Neg(inner) => match &inner.node {
            Node::Number(digits, None) => (digits, true),
            _ => return None,
        },
        _ => return None,
    };
    let value = Ratio::parse_decimal(digits)?;
    let sum = Ratio::integer(360).checked_add(if negative { value.neg() } else { value })?;
    sum.is_integer().then_some(sum)
}
