//! A declaration as its reader wants to see it: normal spacing, aligned columns, and the same meaning when read again.

use super::{Cell, Check, Content, Decl, Expr, Factor, Node, Row, Sign, Table};
use std::fmt::{self, Display, Formatter, Write};

/// The longest line that several `let`s may share.
const WIDTH: usize = 100;

impl Display for Decl {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let words = [
            self.form.map(|form| form.word()),
            self.length_unit.map(|unit| unit.word()),
            self.angle_unit.map(|unit| unit.word()),
        ];
        let header: Vec<&str> = words.into_iter().flatten().collect();
        writeln!(f, "struct {}({});", self.name.value, header.join(", "))?;
        bindings(self, f)?;
        if let Some(table) = &self.table {
            writeln!(f, "\n{table}")?;
        }
        if !self.factors.is_empty() {
            writeln!(f, "\n{};", chain(&self.factors))?;
        }
        let mut rest = String::new();
        for (word, list) in [("base", &self.base), ("tool", &self.tool)] {
            if !list.is_empty() {
                writeln!(rest, "{word}: {};", factors(list))?;
            }
        }
        for couple in &self.couples {
            let sign = if couple.subtract { '-' } else { '+' };
            writeln!(rest, "couple: {} {sign}= {};", couple.target.value, couple.value)?;
        }
        for check in &self.checks {
            writeln!(rest, "{check}")?;
        }
        if let Some(family) = &self.demanded {
            writeln!(rest, "ik: {};", family.value)?;
        }
        if rest.is_empty() { Ok(()) } else { write!(f, "\n{rest}") }
    }
}

fn bindings(decl: &Decl, f: &mut Formatter<'_>) -> fmt::Result {
    let mut line = String::new();
    for binding in decl.bindings.iter() {
        let Some(value) = &binding.value else { continue };
        let keyword = if binding.param { "param" } else { "let" };
        let statement = format!("{keyword} {} = {value};", binding.name.value);
        if line.is_empty() {
            writeln!(f)?;
        } else if line.len() + 1 + statement.len() > WIDTH {
            writeln!(f, "{line}")?;
            line.clear();
        } else {
            line.push(' ');
        }
        line.push_str(&statement);
        if binding.param {
            writeln!(f, "{line}")?;
            line.clear();
        }
    }
    if line.is_empty() { Ok(()) } else { writeln!(f, "{line}") }
}

impl Display for Table {
    /// Without a final line break.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let header: Vec<String> =
            self.columns.iter().map(|(column, text)| header_cell(*column, text)).collect();
        let rows: Vec<Vec<String>> = self.rows.iter().map(Row::texts).collect();
        let width = |i: usize| {
            let cells = rows.iter().chain([&header]).filter_map(|row| row.get(i));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..header.len()).map(width).collect();
        line(f, &header, &widths)?;
        f.write_str("\n|")?;
        for width in &widths {
            write!(f, "{}|", "-".repeat(width + 2))?;
        }
        for row in &rows {
            f.write_char('\n')?;
            line(f, row, &widths)?;
        }
        Ok(())
    }
}

fn header_cell(column: super::Column, text: &str) -> String {
    if text.is_empty() { column.header().to_string() } else { text.to_string() }
}

fn line(f: &mut Formatter<'_>, cells: &[String], widths: &[usize]) -> fmt::Result {
    f.write_char('|')?;
    for (cell, width) in cells.iter().zip(widths) {
        write!(f, " {cell:width$} |")?;
    }
    Ok(())
}

impl Row {
    fn texts(&self) -> Vec<String> {
        self.cells.iter().map(|cell| cell.to_string()).collect()
    }
}

impl Display for Cell {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.content {
            Content::Empty => Ok(()),
            Content::Name(name) => f.write_str(name),
            Content::Value(value) => write!(f, "{value}"),
            Content::Range(low, high) => write!(f, "{low} .. {high}"),
            Content::Bad => f.write_char('?'),
        }
    }
}

impl Display for Factor {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let letter = if self.turn { 'R' } else { 'T' };
        write!(f, "{letter}{}(", format!("{:?}", self.axis).to_lowercase())?;
        match &self.argument {
            Some(argument) => write!(f, "{argument})"),
            None => f.write_str("?)"),
        }
    }
}

fn factors(list: &[Factor]) -> String {
    list.iter().map(Factor::to_string).collect::<Vec<_>>().join(" ")
}

/// The chain form, a line for each joint.
fn chain(list: &[Factor]) -> String {
    let mut text = String::new();
    let mut joints = 0;
    for factor in list {
        let joint = factor.argument.as_ref().is_some_and(|e| e.mentions(&super::is_joint_variable));
        if !text.is_empty() {
            text.push(if joint && joints > 0 { '\n' } else { ' ' });
        }
        joints += usize::from(joint);
        text.push_str(&factor.to_string());
    }
    text
}

impl Display for Check {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "check [{}] => ({})", list(&self.joints), list(&self.position))?;
        if let Some(zyx) = &self.zyx {
            write!(f, " zyx({})", list(zyx))?;
        }
        if let Some(within) = &self.within {
            write!(f, " within {within}")?;
        }
        f.write_char(';')
    }
}

fn list(values: &[Expr]) -> String {
    values.iter().map(Expr::to_string).collect::<Vec<_>>().join(", ")
}

/// How tightly an expression holds together: a sum, a product or negative, an atom.
fn strength(expr: &Expr) -> u8 {
    match &expr.node {
        Node::Sum(_) => 0,
        Node::Product(_) | Node::Neg(_) => 1,
        _ => 2,
    }
}

/// Prints an operand in parentheses if it is weaker than `least`.
fn operand(f: &mut Formatter<'_>, expr: &Expr, least: u8) -> fmt::Result {
    if strength(expr) < least { write!(f, "({expr})") } else { write!(f, "{expr}") }
}

impl Display for Expr {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.node {
            Node::Number(digits, None) => f.write_str(digits),
            Node::Number(digits, Some(unit)) => write!(f, "{digits}{}", unit.word()),
            Node::Pi => f.write_str("pi"),
            Node::Name(name) => f.write_str(name),
            Node::Call(function, argument) => write!(f, "{}({argument})", function.word()),
            Node::Neg(inner) => {
                f.write_char('-')?;
                operand(f, inner, 2)
            }
            Node::Sum(terms) => {
                for (i, (sign, term)) in terms.iter().enumerate() {
                    match (i, sign) {
                        (0, _) => {}
                        (_, Sign::Plus) => f.write_str(" + ")?,
                        (_, Sign::Minus) => f.write_str(" - ")?,
                    }
                    // Only the first term may begin with its own sign.
                    let signed = i > 0 && matches!(term.node, Node::Neg(_));
                    operand(f, term, if signed { 2 } else { 1 })?;
                }
                Ok(())
            }
            Node::Product(factors) => {
                for (i, (divide, factor)) in factors.iter().enumerate() {
                    if i > 0 {
                        f.write_char(if *divide { '/' } else { '*' })?;
                    }
                    // A leading negative may stand bare; after an operator it is easier to read in parentheses.
                    let bare = i == 0 && matches!(factor.node, Node::Neg(_));
                    operand(f, factor, if bare { 1 } else { 2 })?;
                }
                Ok(())
            }
        }
    }
}
