//! A reference arm as `.dh` text: the front door for arms that `robots` does not declare.

use std::fmt::Write;

use crate::reference::{Frame, Record};

/// The declaration of the arm, every cell with the expression that the data has.
pub fn text(arm: &Record) -> String {
    let mut text = format!("struct {}({}, m, rad);\n", type_name(&arm.name), arm.convention);
    text.push_str("| joint | alpha | a | d | theta | limits |\n|---|---|---|---|---|---|\n");
    let mut joint = 0;
    for row in &arm.rows {
        let (mut name, mut limits) = (String::new(), String::new());
        if row.kind != 'F' {
            name = format!("J{}", joint + 1);
            if let Some([low, high]) = arm.limits.as_ref().and_then(|all| all[joint].as_ref()) {
                limits = format!("{low} .. {high}");
            }
            joint += 1;
        }
        let theta = moving(&row.theta, row.kind == 'R');
        let d = moving(&row.d, row.kind == 'P');
        let _ = writeln!(text, "| {name} | {} | {} | {d} | {theta} | {limits} |", row.alpha, row.a);
    }
    statement(&mut text, "base", &arm.base);
    statement(&mut text, "tool", &arm.tool);
    text
}

/// `q` plus the constant, where the row moves.
fn moving(constant: &str, moves: bool) -> String {
    match (moves, constant) {
        (true, "0") => "q".into(),
        (true, _) => format!("q + ({constant})"),
        (false, _) => constant.into(),
    }
}

fn statement(text: &mut String, word: &str, frame: &Frame) {
    let shifts = ["Tx", "Ty", "Tz"].into_iter().zip(&frame.xyz);
    let turns = ["Rx", "Ry", "Rz"].into_iter().zip(&frame.rpy).rev();
    let factors: Vec<String> =
        shifts.chain(turns).filter(|(_, x)| *x != "0").map(|(what, x)| format!("{what}({x})")).collect();
    if !factors.is_empty() {
        let _ = writeln!(text, "{word}: {};", factors.join(" "));
    }
}

/// `kuka_kr16_2` as `KukaKr16_2`: the words joined, a number kept apart from a number.
fn type_name(name: &str) -> String {
    let mut out = String::new();
    for word in name.split('_') {
        let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        if digit(out.chars().last()) && digit(word.chars().next()) {
            out.push('_');
        }
        let mut letters = word.chars();
        out.extend(letters.next().map(|c| c.to_ascii_uppercase()));
        out.extend(letters);
    }
    out
}

#[test]
fn a_table_with_everything() {
    let text = text(&crate::reference::arm("kinova_gen3lite_tooled"));
    assert!(text.starts_with("struct KinovaGen3liteTooled(standard, m, rad);"), "{text}");
    assert!(text.contains("| J2 | pi | 0.28 | 0 | q + (pi/2) | -2.61 .. 2.61 |"), "{text}");
    assert!(text.contains("tool: Tx(0.1) Ty(0.02) Tz(0.05) Rz(pi/3) Ry(-0.25) Rx(0.4);"), "{text}");
}
