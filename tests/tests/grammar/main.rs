//! The grammar: what a declaration means, that its printed form means the same, and that nothing makes it panic.

mod noise;

use kin_gen::chain::{self, Chain, Element, Motion};
use kin_gen::decl::{Token, lex, parse, render};
use kin_gen::report::{Place, Report};

/// The chain of a declaration without mistakes or warnings.
#[track_caller]
fn chain(text: &str) -> Chain {
    let (tokens, ranges, mut report) = lex(text);
    let chain = chain_of(&tokens, &mut report);
    assert!(report.is_empty(), "{}", render(text, &ranges, &report));
    chain.expect("a chain")
}

fn chain_of(tokens: &[Token], report: &mut Report) -> Option<Chain> {
    let decl = parse(tokens, report)?;
    chain::check(&decl, report)
}

/// The listing of `text` is `expected`, and the printed declaration reads as the same chain.
#[track_caller]
fn means(text: &str, expected: &str) {
    let first = chain(text);
    assert_eq!(first.to_string().trim(), expected.trim());
    let second = chain(&first.text);
    assert_eq!(without_places(second.clone()), without_places(first.clone()));
    assert_eq!(second.text, first.text, "printing twice changes nothing");
    for line in [0, 1] {
        let (mut tokens, _, mut report) = lex(text);
        tokens.iter_mut().for_each(|token| token.line = line);
        assert_eq!(chain_of(&tokens, &mut report).map(without_places), Some(without_places(first.clone())));
    }
}

fn without_places(mut chain: Chain) -> Chain {
    let nowhere = Place::default();
    chain.place = nowhere;
    chain.params.iter_mut().for_each(|p| p.place = nowhere);
    chain.joints.iter_mut().for_each(|j| j.place = nowhere);
    for list in [&mut chain.base, &mut chain.elements, &mut chain.tool] {
        list.iter_mut().for_each(|e| e.place = nowhere);
    }
    if let Some(family) = &mut chain.demanded {
        family.place = nowhere;
    }
    chain
}

const LAB_ARM: &str = "
/// The six-axis arm of the 2019 lab report (seed 000), modified D-H.
pub struct LabArm(modified, mm, deg);

let d1 = 47; let a1 = 30; let d2 = 45; let a2 = 120; let a4 = 20; let d5 = 130; let d6 = 29;

| joint | alpha |  a  |  d  | theta  | limits      |
|-------|-------|-----|-----|--------|-------------|
| J1    |   0   |  0  | d1  | q      | -170 .. 170 |
|       |   0   | -a1 | d2  | 0      |             |
| J2    |  90   |  0  | 0   | q      |             |
| J3    |   0   |  a2 | 0   | q + 90 |             |
| J4    | -90   |  a4 | 0   | q      |             |
|       |   0   |  0  | d5  | 0      |             |
| J5    |  90   |  0  | 0   | q      |             |
| J6    | -90   |  0  | d6  | q      |             |

check [0, 0, 0, 0, 0, 0] => (-69, 0, 112);
";

#[test]
fn the_lab_arm_of_seed_000() {
    means(
        LAB_ARM,
        "
LabArm (modified, mm, deg)
length d1 = 47
length a1 = 30
length d2 = 45
length a2 = 120
length a4 = 20
length d5 = 130
length d6 = 29
J1 Rz(q1) Tz(d1)  within -2.9670597283903604 .. 2.9670597283903604
J2 Tx(-a1) Tz(d2) Rx(90deg) Rz(q2)
J3 Tx(a2) Rz(q3 + 90deg)
J4 Rx(-90deg) Tx(a4) Rz(q4)
J5 Tz(d5) Rx(90deg) Rz(q5)
J6 Rx(-90deg) Rz(q6) Tz(d6)
",
    );
    assert_eq!(chain(LAB_ARM).reach().to_f64(), 421.0);
}

#[test]
fn the_printed_table_is_aligned() {
    let expected = "
struct LabArm(modified, mm, deg);

let d1 = 47; let a1 = 30; let d2 = 45; let a2 = 120; let a4 = 20; let d5 = 130; let d6 = 29;

| joint | alpha | a   | d  | theta  | limits      |
|-------|-------|-----|----|--------|-------------|
| J1    | 0     | 0   | d1 | q      | -170 .. 170 |
|       | 0     | -a1 | d2 | 0      |             |
| J2    | 90    | 0   | 0  | q      |             |
| J3    | 0     | a2  | 0  | q + 90 |             |
| J4    | -90   | a4  | 0  | q      |             |
|       | 0     | 0   | d5 | 0      |             |
| J5    | 90    | 0   | 0  | q      |             |
| J6    | -90   | 0   | d6 | q      |             |

check [0, 0, 0, 0, 0, 0] => (-69, 0, 112);
";
    assert_eq!(chain(LAB_ARM).text.trim(), expected.trim());
}

#[test]
fn the_chain_of_seed_003() {
    means(
        "struct ElbowWrist(chain, m, deg);
         let l1 = 0.3; let l2 = 1; let l3 = 0.5; let l4 = 0.3;
         Rz(q) Tz(l1) Rz(90) Rx(90)  Rz(q) Tx(l2)  Rz(q) Tx(l3)
         Ry(90) Rz(90)  Rz(q) Tz(l4) Rx(-90) Rz(-180)  Rz(q) Rx(-90)  Rz(q);
         check [0, 0, 0, 0, 0, 0] => (0, 1.8, 0.3);",
        "
ElbowWrist (chain, m, deg)
length l1 = 3/10
length l2 = 1
length l3 = 1/2
length l4 = 3/10
J1 Rz(q1) Tz(l1) Rz(90deg) Rx(90deg)
J2 Rz(q2) Tx(l2)
J3 Rz(q3) Tx(l3) Ry(90deg) Rz(90deg)
J4 Rz(q4) Tz(l4) Rx(-90deg) Rz(-180deg)
J5 Rz(q5) Rx(-90deg)
J6 Rz(q6)
",
    );
}

#[test]
fn the_chain_of_seed_001_with_joints_about_every_axis() {
    means(
        "struct Anthropomorphic(chain, m, rad);
         let d1 = 1; let d2 = 3; let d3 = 1; let d4 = 1; let d5 = 1;
         Rz(q1) * Tz(d1) * Rx(q2) * Ty(d2) * Rx(q3) * Ty(d3) * Ry(q4) * Ty(d4) * Rz(q5) * Ty(d5) * Ry(q6);",
        "
Anthropomorphic (chain, m, rad)
length d1 = 1
length d2 = 3
length d3 = 1
length d4 = 1
length d5 = 1
J1 Rz(q1) Tz(d1)
J2 Rx(q2) Ty(d2)
J3 Rx(q3) Ty(d3)
J4 Ry(q4) Ty(d4)
J5 Rz(q5) Ty(d5)
J6 Ry(q6)
",
    );
}

#[test]
fn the_table_of_seed_004_in_its_own_letters() {
    means(
        "struct LabRrr(standard, m, rad);
         let d = 0.168; let l = 0.13335;
         | i | a_i | α_i | d_i | θ_i |
         | 1 | 0   | π/2 | d   | θ₁  |
         | 2 | l   | 0   | 0   | θ₂  |
         | 3 | l   | 0   | 0   | q_3 |
         check [0.5, 0.5, −0.5] => (0.21973, 0.12004, 0.23193) within 1e-5;",
        "
LabRrr (standard, m, rad)
length d = 21/125
length l = 2667/20000
J1 Rz(q1) Tz(d) Rx(90deg)
J2 Rz(q2) Tx(l)
J3 Rz(q3) Tx(l)
",
    );
}

#[test]
fn everything_else_at_once() {
    means(
        "#[derive(Debug)] pub(crate) struct All(standard, cm, deg);
         param tip = 2.5; param phi = 0;
         | name     | r      | d             | alpha_i | theta            | limits       |
         |:---------|:------:|--------------:|---------|------------------|--------------|
         | shoulder | 30mm   | 1in           | -pi/2   | -(q - 45)        | 170 .. 190   |
         | elbow    | tip    | 0             | 0       | q + 2*phi - 90   | -pi .. 1rad  |
         |          | 0      | 2*(tip + 1)   | 3*phi   | 360              |              |
         | slide    | 0      | 3 - q         | 45deg   | 0                | 1cm .. 2     |
         base: Rx(180) Ty(1); tool: Tz(1) Tz(2) Tz(0) Rz(30 - 15*2);
         couple: elbow -= 2*shoulder, J1 += J2;
         ik: spherical_wrist;",
        "
All (standard, cm, deg)
length base_y = 1
length d1 = 127/50
length a1 = 3
length d2b = 2
length d3 = 3
length tool_z = 1
length tool_z2 = 2
param tip = 5/2 (length)
param phi = 0 (angle)
base Rx(180deg) Ty(base_y)
shoulder Rz(-q1 + 45deg) Tz(d1) Tx(a1) Rx(-90deg)  within 2.9670597283903604 .. 3.3161255787892263
elbow Rz(q2 + 2*phi - 90deg) Tx(tip)  within -3.141592653589793 .. 1
slide (slides) Tz(d2b + 2*tip) Rx(3*phi) Tz(-q3 + d3) Rx(45deg)  within 1 .. 2
tool Tz(tool_z) Tz(tool_z2)
couple [[-1, 1, 0], [-2, 1, 0], [0, 0, 1]]
uncouple [[1, -1, 0], [2, -1, 0], [0, 0, 1]]
ik spherical_wrist
",
    );
}

#[test]
fn lengths_are_atoms() {
    means(
        "struct Atoms(chain, m, deg);
         let a = 0.1; let b = 0.2; let c = a + b; let zero = 0; let n = 2; let e = 0.2;
         Rz(q) Tx(-a) Tx(2*b - (a - b)*3) Tx(c) Tx(zero) Tx(a - zero) Tx(b - e) Tx(a/-1)
         Rz(q) Tx(a/2) Tx(n*a) Tx(a + 0.5) Tx(0.5) Tx(a*b) Tx(sqrt(a*a + b*b)) Ty(7) Tz(7) Tz(7);",
        "
Atoms (chain, m, deg)
length a = 1/10
length b = 1/5
length c = 3/10
length a2 = 1/20
length a2b = 1/5
length a2c = 3/5
length a2d = 1/2
length a2e = 1/50
length a2f = 0.22360679774997896
length b2 = 7
length d2 = 7
length d2b = 7
J1 Rz(q1) Tx(-a) Tx(-3*a + 5*b) Tx(c) Tx(a) Tx(-a)
J2 Rz(q2) Tx(a2) Tx(a2b) Tx(a2c) Tx(a2d) Tx(a2e) Tx(a2f) Ty(b2) Tz(d2) Tz(d2b)
",
    );
}

#[test]
fn fixed_rows_before_and_between_joints() {
    means(
        "struct Fixed(modified, m, deg);
         let d1 = 9; let d0 = d1;
         | alpha | a | d   | theta |
         | 0     | 1 | 2   | 0     |
         | 0     | 1 | d0  | 30    |
         | 0     | 1 | d1  | q     |
         | 0     | 1 | 2   | 0     |
         | 0     | 1 | 2   | 0     |",
        "
Fixed (modified, m, deg)
length a0 = 1
length d0b = 2
length a0b = 1
length d0 = 9
length a1 = 1
length d1 = 9
length a1b = 1
length d1b = 2
length a1c = 1
length d1c = 2
J1 Tx(a0) Tz(d0b) Tx(a0b) Rz(30deg) Tz(d0) Tx(a1) Rz(q1) Tz(d1)
end Tx(a1b) Tz(d1b) Tx(a1c) Tz(d1c)
",
    );
}

#[test]
fn units_fold_into_the_declared_one() {
    means(
        "struct Units(chain, in, rad);
         let x = 25.4mm; let y = 2.54 cm; let z = 0.0254m; let w = 1;
         Rz(q + 90deg) Tx(x - y) Tx(x) Tx(z*3) Tx(w) Rz(0.5) Rz(1/2*pi) Rz(30 deg) Rx(sin(pi/6)*pi) Rx(cos(pi/3) - 1/2);",
        "
Units (chain, in, rad)
length x = 1
length z = 1
length w = 1
J1 Rz(q1 + 90deg) Tx(x) Tx(3*z) Tx(w) Rz(1/2rad) Rz(90deg) Rz(30deg) Rx(90deg)
",
    );
}

#[test]
fn a_golden_pose_includes_base_tool_coupling_and_params() {
    chain(
        "struct Golden(modified, mm, deg);
         param l = 100;
         | joint | alpha | a | d      | theta |
         | J1    | 0     | 0 | 50     | q     |
         | J2    | 90    | 0 | 0      | q     |
         | J3    | 0     | l | 0      | q     |
         | J4    | 90    | 0 | q + 10 | 0     |
         base: Tz(1m) Rx(180); tool: Tx(2cm);
         couple: J3 -= J2;
         check [0, 0, 0, 0] => (120, 0, 950 + 10) zyx(0, 0, 0);
         check [0, 90, pi/2, 0.5cm] => (15, 0, 830) zyx(0, 90, 0);",
    );
}

#[test]
fn nesting_and_length_are_bounded() {
    let arm = |cell: String| format!("struct A(chain, m, deg); Rz(q) Tx({cell});");
    let nested = |depth: usize| arm("(".repeat(depth) + "1" + &")".repeat(depth));
    let mixed = |depth: usize| arm("-(1 + 2*".repeat(depth) + "sqrt(4)" + &")".repeat(depth));
    assert!(said(&nested(64)).is_empty());
    assert!(said(&mixed(63)).is_empty());
    assert!(said(&nested(65)).contains("more than 64 parentheses"));
    assert!(said(&mixed(20_000)).contains("longer than 16384 tokens"));
    assert!(said(&mixed(1_000)).contains("more than 64 parentheses"));
    assert!(said(&arm("-".repeat(9_001) + "1")).is_empty());
    assert!(said(&arm("1 + ".repeat(4_000) + "1")).is_empty());
    let rows = |n: usize| {
        "struct A(modified, m, deg); | alpha | a | d | theta |".to_string() + &"| 0 | 0 | 0 | q |".repeat(n)
    };
    assert!(said(&rows(16)).is_empty());
    assert!(said(&rows(17)).contains("joint 17 of at most 16"));
    assert!(said(&rows(200)).contains("more than 128 rows"));
}

fn said(text: &str) -> String {
    let (tokens, ranges, mut report) = lex(text);
    chain_of(&tokens, &mut report);
    render(text, &ranges, &report)
}

#[test]
fn without_lines_a_wrong_table_still_gets_one_message() {
    let text = LAB_ARM.replace("| d5  | 0 ", "| d5  ");
    let (mut tokens, ranges, mut report) = lex(&text);
    tokens.iter_mut().for_each(|token| token.line = 0);
    assert!(chain_of(&tokens, &mut report).is_none());
    let said = render(&text, &ranges, &report);
    assert_eq!(report.diagnostics().len(), 1, "{said}");
    assert!(said.contains("a row does not have the header's 6 cells"), "{said}");
}

#[test]
fn rendered_messages_underline_the_text() {
    let text = "struct Ärm(modified, m, deg);\n\t| alpha | a | d | theta |\n\t| 0     | x | 0 | q     |\n";
    let expected = "\
error: the character `Ä` has no meaning here
 --> 1:8
1 | struct Ärm(modified, m, deg);
  |        ^
  = help: write names in ASCII or Greek letters, numbers in decimal

error: `x` is not bound
 --> 3:12
3 |  | 0     | x | 0 | q     |
  |            ^
  = help: bind it with `let x = …;` or `param x = …;`
";
    assert_eq!(said(text), expected);
}

#[test]
fn frames_end_where_the_design_says() {
    let table = chain(LAB_ARM);
    // J1's own row ends before the fixed row that follows it.
    assert_eq!(table.frames, [2, 6, 8, 11, 14, 17]);
    let chain = chain("struct A(chain, m, deg); Tz(1) Rz(q) Tx(1) Rx(90) Rz(q) Tx(1);");
    assert_eq!(chain.frames, [4, 6]);
    assert!(matches!(&chain.elements[1], Element { motion: Motion::Revolute { joint: 0, .. }, .. }));
}
