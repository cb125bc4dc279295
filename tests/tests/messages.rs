//! Every message about a declaration: what is wrong, under which part of the text, and the remedy.
//!
//! A line of what is expected reads `line:column severity [underlined] message`, followed by its remedy.

use kin_gen::chain;
use kin_gen::decl::{lex, parse};
use kin_gen::report::{At, Severity};

/// All messages about `text` (its first line break belongs to the test, not to the text) are `expected`.
#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(said(text.trim_start_matches('\n')), expected.trim_matches('\n'));
}

fn said(text: &str) -> String {
    let (tokens, ranges, mut report) = lex(text);
    let decl = parse(&tokens, &mut report);
    let chain = decl.and_then(|decl| chain::check(&decl, &mut report));
    assert_eq!(chain.is_none(), report.has_errors(), "there is a chain exactly where there is no error");
    let lines = report.diagnostics().into_iter().map(|d| {
        let place = |at: At| ranges.get(at.0 as usize).cloned().unwrap_or(text.len()..text.len());
        let (start, end) = (place(d.place.first).start, place(d.place.last).end);
        let before = &text[..start];
        let (line, column) =
            (before.matches('\n').count() + 1, before.chars().rev().take_while(|c| *c != '\n').count() + 1);
        let severity = if d.severity == Severity::Error { "error" } else { "warning" };
        let underlined = text[start..end].split_whitespace().collect::<Vec<_>>().join(" ");
        let help = d.help.as_ref().map_or(String::new(), |help| format!("\n    {help}"));
        format!("{line}:{column} {severity} [{underlined}] {}{help}", d.message)
    });
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn units_in_the_wrong_column() {
    check(
        r#"
struct Arm(modified, mm, deg);
| joint | alpha | a     | d | theta |
| J1    | 47mm  | 90deg | 0 | q     |
| J2    | 0     | 0     | 1cm + 2deg | q |
| J3    | 0     | pi    | 0 | q + 3 in |
"#,
        r#"
3:11 error [47mm] this is a length, but `alpha` is an angle
    write an angle, such as `90` or `pi/2`, or move the length to `a` or `d`
3:19 error [90deg] this is an angle, but `a` is a length
    write a length, such as `90mm`, or move the angle to `alpha` or `theta`
4:33 error [2deg] an angle cannot be added to a length
    add values of one kind only
5:19 error [pi] this is an angle, but `a` is a length
    write a length, such as `90mm`, or move the angle to `alpha` or `theta`
5:31 error [q + 3 in] this is a length, but `theta` is an angle
    write an angle, such as `90` or `pi/2`, or move the length to `a` or `d`
"#,
    );
}

#[test]
fn wrong_number_of_cells() {
    check(
        r#"
struct Arm(modified, mm, deg);
| joint | alpha | a | d | theta | limits    |
|-------|-------|---|---|-------|-----------|
| J1    | 0     | 0 | 0 | q     | -90 .. 90 |
| J2    | 0     | 0 | q     | -90 .. 90 |
|       | 0     | 0 | 0 | 0     | 0 |       |
| J3    | 0     | 1 | 0 | q     |           |
| J4    | 0     | l | 0 | q     |
  J5    | 0     | 1 | 0 | q     |           |
| J6    | 0     | 1 | 0 | q     |
"#,
        r#"
5:1 error [| J2 | 0 | 0 | q | -90 .. 90 |] row J2 has 5 cells, the header has 6
    each row has the cells joint, alpha, a, d, theta, limits; write 0 for a zero, only joint and limits may be empty
6:1 error [| | 0 | 0 | 0 | 0 | 0 | |] row 3 has 7 cells, the header has 6
    each row has the cells joint, alpha, a, d, theta, limits; write 0 for a zero, only joint and limits may be empty
8:1 error [| J4 | 0 | l | 0 | q |] row J4 has 5 cells, the header has 6
    each row has the cells joint, alpha, a, d, theta, limits; write 0 for a zero, only joint and limits may be empty
9:3 error [J5 | 0 | 1 | 0 | q | |] row 6 does not begin with `|`
    every row begins and ends with `|`
10:1 error [| J6 | 0 | 1 | 0 | q |] row J6 has 5 cells, the header has 6
    each row has the cells joint, alpha, a, d, theta, limits; write 0 for a zero, only joint and limits may be empty
"#,
    );
}

#[test]
fn a_row_that_does_not_end_with_a_bar() {
    check(
        r#"
struct Arm(modified, mm, deg);
| joint | alpha | a | d | theta |
| J1    | 0     | 0 | 0 | q     |
| J2    | 0     | 0 | 0 | q
check [0, 0] => (0, 0, 0);
"#,
        r#"
4:1 error [| J2 | 0 | 0 | 0 | q] row J2 does not end with `|`
    every row begins and ends with `|`
"#,
    );
}

#[test]
fn two_wrong_rows_that_make_up_for_each_other() {
    check(
        r#"
struct Arm(modified, mm, deg);
| joint | alpha | a | d | theta | limits |
| J1    | 0     | 0 | 0 | q     |
|       | 0     | 0 | 0 | 0     | 0 |    |
| J2    | 0     | 0 | 0 | q     |        |
"#,
        r#"
3:1 error [| J1 | 0 | 0 | 0 | q |] row J1 has 5 cells, the header has 6
    each row has the cells joint, alpha, a, d, theta, limits; write 0 for a zero, only joint and limits may be empty
4:1 error [| | 0 | 0 | 0 | 0 | 0 | |] row 2 has 7 cells, the header has 6
    each row has the cells joint, alpha, a, d, theta, limits; write 0 for a zero, only joint and limits may be empty
"#,
    );
}

#[test]
fn an_empty_cell_in_the_header() {
    check(
        r#"
struct Arm(modified, mm, deg);
| joint | alpha | a | d |  | theta |
| J1    | 0     | 0 | 0 |  | q     |
"#,
        r#"
2:28 error [|] a cell of the header is empty
    the columns are joint, alpha, a, d, theta and limits
"#,
    );
}

#[test]
fn an_empty_cell_that_needs_a_value() {
    check(
        r#"
struct Arm(modified, mm, deg);
| joint | alpha | a | d | theta | limits |
| J1    |       | 0 | 0 | q     |        |
"#,
        r#"
3:17 error [|] the cell of `alpha` is empty
    write `0` for a zero
"#,
    );
}

#[test]
fn joint_variables_in_the_wrong_column() {
    check(
        r#"
struct Arm(standard, m, deg);
| i | a  | alpha | d     | theta |
| 1 | 0  | 0     | 0.168 | q1    |
| 2 | 0  | q2    | 0.1   | 0     |
| 3 | q3 | 0     | 0.1   | 0     |
| 4 | 0  | 0     | q     | q + 90 |
"#,
        r#"
4:12 error [q2] q stands in `alpha`, which is a constant of the link
    a joint variable belongs in theta (revolute) or in d (prismatic)
5:7 error [q3] q stands in `a`, which is a constant of the link
    a joint variable belongs in theta (revolute) or in d (prismatic)
6:20 error [q] q stands in theta and in d, but a row is one joint
    split the row: one row with q in theta, one with q in d
"#,
    );
}

#[test]
fn joint_variables_that_are_not_plain() {
    check(
        r#"
struct Arm(modified, m, deg);
let k = 3;
| joint | alpha | a | d       | theta     |
| J1    | 0     | 0 | 0       | 2*q       |
| J2    | 0     | 0 | 0       | q*q       |
| J3    | 0     | 0 | q/2     | 0         |
| J4    | 0     | 0 | 0       | sin(q)    |
| J5    | 0     | 0 | 0       | q - q     |
| J6    | 0     | 0 | 0       | 90/q      |
| J7    | 0     | 0 | 0       | sqrt(2)*q |
| J8    | 0     | 0 | 0       | q7        |
"#,
        r#"
4:33 error [2*q] q is multiplied by 2 here
    a joint is `q` or `-q`, plus a constant
5:35 error [q] this is a product of two variables
    a cell is linear in q and in parameters: bind a `param` to the product
6:23 error [q/2] q is multiplied by 1/2 here
    a joint is `q` or `-q`, plus a constant
7:36 error [(q)] an argument of a function is a constant, but `q` is a joint variable
    joint variables belong in theta, d or a factor of the chain
8:33 error [q - q] q cancels out here
    a joint is `q` or `-q`, plus a constant
9:36 error [q] this divides by a variable
    a cell is linear in q and in parameters: bind a `param` to the quotient
10:41 error [q] a variable cannot be multiplied by an irrational number
    a cell with q reduces to `q` or `-q` plus a constant; a parameter takes integer coefficients
11:33 error [q7] `q7` stands in joint 8
    write `q`, or `q8`
"#,
    );
}

#[test]
fn a_named_row_without_a_joint() {
    check(
        r#"
struct Arm(modified, m, deg);
| joint | alpha | a | d   | theta | limits    |
| J1    | 0     | 0 | 0   | q     |           |
| J2    | 0     | 0 | 0.1 | 0     |           |
|       | 0     | 0 | 0.1 | 0     | -90 .. 90 |
| J1    | 0     | 0 | 0   | q     |           |
"#,
        r#"
4:3 error [J2] the row of joint J2 has no q
    write q in theta (revolute) or in d (prismatic), or leave the joint's cell empty for a fixed row
5:37 error [-90 .. 90] row 3 is fixed and cannot have limits
    write q in theta or d, or leave the limits empty
6:3 error [J1] there are two joints `J1`
    give one of them another name
"#,
    );
}

#[test]
fn numbered_joints() {
    check(
        r#"
struct Arm(modified, m, deg);
| i | alpha | a | d | theta |
| 0 | 0     | 0 | 0 | q     |
| 2 | 0     | 0 | 0 | q     |
"#,
        r#"
3:3 error [0] row 0 holds joint 1
    number the joints from 1: write `1`, or a name
"#,
    );
}

#[test]
fn unknown_names() {
    check(
        r#"
struct Arm(modified, m, deg);
let upper = 0.4; let fore = 0.3;
| joint | alpha | a      | d     | theta     |
| J1    | 0     | uper   | 0     | q         |
| J2    | 0     | fore_  | elbow | q + ninty |
| J3    | 0     | l(3)   | 0     | tan(3) + q |
"#,
        r#"
4:19 error [uper] `uper` is not bound
    did you mean `upper`?
5:19 error [fore_] `fore_` is not bound
    did you mean `fore`?
5:28 error [elbow] `elbow` is not bound
    bind it with `let elbow = …;` or `param elbow = …;`
5:40 error [ninty] `ninty` is not bound
    bind it with `let ninty = …;` or `param ninty = …;`
6:19 error [l] `l` is not a function here
    the functions are `sqrt`, `sin` and `cos`; write `*` if a product is meant
6:36 error [tan] `tan` is not a function here
    the functions are `sqrt`, `sin` and `cos`; write `*` if a product is meant
"#,
    );
}

#[test]
fn names_that_cannot_be_bound() {
    check(
        r#"
struct Arm(modified, m, deg);
let a1 = 1; let a1 = 2; let pi = 3; let mm = 1; let q2 = 1; let fn = 1; let = 3; let x; let y = ;
let u = w; let w = 1; param p = 2; let v = p; param r = v;
| joint | alpha | a  | d | theta |
| J1    | 0     | a1 | u | q     |
"#,
        r#"
2:17 error [a1] `a1` is bound twice
    give one of them another name
2:29 error [pi] `pi` has its usual meaning
    choose another name
2:41 error [mm] `mm` is a unit
    choose another name
2:53 error [q2] `q2` stands for a joint variable
    choose another name
2:65 error [fn] `fn` is a word of the Rust language
    choose another name
2:77 error [=] a name is missing after `let`
2:86 error [x] a `=` is missing after `x`
2:95 error [=] a value is missing here
3:9 error [w] `w` is bound only further down
    move its `let` up
3:44 error [p] a `let` is a constant, but `p` is a `param`, known only at run time
    bind `p` with `let` if it never changes
"#,
    );
}

#[test]
fn names_that_nothing_uses() {
    check(
        r#"
struct Arm(modified, m, deg);
let a1 = 1; let a2 = 2; let _spare = 3; param p = 4;
| joint | alpha | a  | d | theta |
| J1    | 0     | a1 | 0 | q     |
"#,
        r#"
2:17 warning [a2] `a2` is never used
    remove it, or name it `_a2`
2:47 warning [p] `p` is never used
    remove it, or name it `_p`
"#,
    );
}

#[test]
fn columns() {
    check(
        r#"
struct Arm(modified, m, deg);
| joint | twist | a | d | tehta | a_i |
| J1    | 0     | 0 | 0 | q     | 0   |
"#,
        r#"
2:11 error [twist] `twist` is not a column
    did you mean `alpha`? the columns are joint, alpha, a, d, theta and limits
2:27 error [tehta] `tehta` is not a column
    did you mean `theta`? the columns are joint, alpha, a, d, theta and limits
2:35 error [a_i] the column `a` occurs twice, as `a` and as `a_i`
    the columns are joint, alpha, a, d, theta and limits
"#,
    );
}

#[test]
fn a_missing_column() {
    check(
        r#"
struct Arm(modified, m, deg);
| joint | alpha | a | theta |
| J1    | 0     | 0 | q     |
"#,
        r#"
2:1 error [| joint | alpha | a | theta |] the column `d` is missing
    the columns are joint, alpha, a, d, theta and limits
"#,
    );
}

#[test]
fn header() {
    check(
        r#"
struct Arm(craig, meter, degrees);
| joint | alpha | a | d | theta |
| J1    | 0     | 0 | 0 | q     |
"#,
        r#"
1:12 error [craig] `craig` is neither a convention nor a unit
    did you mean `modified`? the header is a convention (standard, modified or chain), a length unit (m, cm, mm or in) and an angle unit (deg or rad)
1:19 error [meter] `meter` is neither a convention nor a unit
    did you mean `m`? the header is a convention (standard, modified or chain), a length unit (m, cm, mm or in) and an angle unit (deg or rad)
1:26 error [degrees] `degrees` is neither a convention nor a unit
    did you mean `deg`? the header is a convention (standard, modified or chain), a length unit (m, cm, mm or in) and an angle unit (deg or rad)
"#,
    );
}

#[test]
fn an_incomplete_header() {
    check(
        r#"
struct Arm(m, m);
| joint | alpha | a | d | theta |
| J1    | 0     | 0 | 0 | q     |
"#,
        r#"
1:11 error [(m, m)] the convention is missing
    write `standard` (Denavit and Hartenberg, Paul), `modified` (Craig) or `chain` first: they give different arms
1:11 error [(m, m)] the unit of angle is missing
    add `deg` or `rad`
1:15 error [m] the unit of length is given twice
"#,
    );
}

#[test]
fn no_header() {
    check(
        r#"
pub struct Arm;
| joint | alpha | a | d | theta |
| J1    | 0     | 0 | 0 | q     |
"#,
        r#"
1:12 error [Arm] the convention and the units are missing after the name
    write `struct Name(modified, mm, deg);` with your convention and units
"#,
    );
}

#[test]
fn no_struct() {
    check(
        r#"
Arm(modified, m, deg);
let a = ;
"#,
        r#"
1:1 error [Arm] a declaration begins with `struct` and its name
    write `struct Name(modified, mm, deg);` with your convention and units
2:7 error [=] a value is missing here
"#,
    );
}

#[test]
fn almost_a_quarter_turn() {
    check(
        r#"
struct Arm(modified, m, rad);
| joint | alpha  | a | d | theta     | limits        |
| J1    | 1.5708 | 0 | 0 | q         |               |
| J2    | -1.571 | 0 | 0 | q + 3.1416 |              |
| J3    | 90     | 0 | 0 | q         | -180 .. 180   |
| J4    | 0.0001 | 0 | 0 | q         | -6.28 .. 6.28 |
"#,
        r#"
3:11 warning [1.5708] this is almost a quarter turn, but 3.7e-6 rad away from it
    write `pi/2` for the exact angle: it makes the arm's formulas far simpler
4:11 warning [-1.571] this is almost a quarter turn, but 2.0e-4 rad away from it
    write `-pi/2` for the exact angle: it makes the arm's formulas far simpler
4:28 warning [q + 3.1416] this is almost half a turn, but 7.3e-6 rad away from it
    write `pi` for the exact angle: it makes the arm's formulas far simpler
5:11 warning [90] 90 radians are more than a turn
    write `90deg` if degrees are meant, or change the header to `deg`
5:40 warning [-180] -180 radians are more than a turn
    write `-180deg` if degrees are meant, or change the header to `deg`
"#,
    );
}

#[test]
fn almost_a_quarter_turn_in_degrees() {
    check(
        r#"
struct Arm(modified, m, deg);
| joint | alpha  | a | d | theta     |
| J1    | 89.999 | 0 | 0 | q         |
| J2    | 1.5708 | 0 | 0 | q - 1.57  |
| J3    | 89.9   | 0 | 0 | q + 1.5   |
"#,
        r#"
3:11 warning [89.999] this is almost a quarter turn, but 1.7e-5 rad away from it
    write `90` for the exact angle: it makes the arm's formulas far simpler
4:11 warning [1.5708] 1.5708 degrees: in radians this would be almost a quarter turn
    write `90` if a quarter turn is meant, or change the header to `rad`
4:28 warning [q - 1.57] -1.57 degrees: in radians this would be almost a quarter turn
    write `-90` if a quarter turn is meant, or change the header to `rad`
"#,
    );
}

#[test]
fn limits() {
    check(
        r#"
struct Arm(modified, mm, deg);
| joint | alpha | a | d | theta | limits       |
| J1    | 0     | 0 | 0 | q     | 170 .. -170  |
| J2    | 0     | 0 | q | 0     | 100 .. 50    |
| J3    | 0     | 0 | 0 | q     | -90          |
| J4    | 0     | 0 | 0 | q     | 5mm .. 6mm   |
| J5    | 0     | 0 | 0 | q     | -q .. q      |
| J6    | 0     | 0 | 0 | q     | 170 .. 190   |
"#,
        r#"
3:35 error [170 .. -170] the limits 170 .. -170 are reversed, so that no value is within them
    write `-170 .. 170`, or `170 .. 190` for a range through 180
4:35 error [100 .. 50] the limits 100 .. 50 are reversed, so that no value is within them
    write `50 .. 100`
5:35 error [-90] limits are written `lowest .. highest`
    write `-170 .. 170`, or leave the cell empty
6:35 error [5mm] this is a length, not an angle
    write an angle, such as `90` or `pi/2`
6:42 error [6mm] this is a length, not an angle
    write an angle, such as `90` or `pi/2`
7:36 error [q] a limit is a constant, but `q` is a joint variable
    joint variables belong in theta, d or a factor of the chain
7:41 error [q] a limit is a constant, but `q` is a joint variable
    joint variables belong in theta, d or a factor of the chain
"#,
    );
}

#[test]
fn limits_in_radians() {
    check(
        r#"
struct Arm(modified, mm, rad);
| joint | alpha | a | d | theta | limits  |
| J1    | 0     | 0 | 0 | q     | 3 .. -3 |
"#,
        r#"
3:35 error [3 .. -3] the limits 3 .. -3 are reversed, so that no value is within them
    write `-3 .. 3`, or `3 .. -3 + 2*pi` for a range through half a turn
"#,
    );
}

#[test]
fn values_that_cannot_be() {
    check(
        r#"
struct Arm(modified, m, deg);
let zero = 1 - 1;
| joint | alpha | a | d | theta |
| J1 | 0 | 1/zero | sqrt(1 - 2) | q |
| J2 | 0 | 1/12345678901234567890123456789012345678901 | 1e-40 + 1/3 | q |
| J3 | 0 | 2mm*3mm | 2mm + 3 | q |
| J4 | 0 | 1/(2mm) | 90deg*2deg | q |
| J5 | 0 | 0x10 | 5ft | q |
| J6 | sqrt(30deg) | .5 | 1..2 | q |
"#,
        r#"
4:14 error [zero] this divides by zero
    write a divisor that is not zero
4:21 error [sqrt(1 - 2)] this is the square root of a negative number
    write a number that is not negative
5:14 error [12345678901234567890123456789012345678901] the exact value needs more than 127 bits
    write it with fewer digits
5:58 error [1e-40] the exact value needs more than 127 bits
    write it with fewer digits
6:12 error [2mm*3mm] this is an area, not a length
    write a length, such as `120` or `120m`
6:28 error [3] a bare number cannot be added to a length
    write the unit on both, or on none
7:12 error [1/(2mm)] this is a power of a length, not a length
    write a length, such as `120` or `120m`
7:28 error [2deg] an angle cannot be multiplied by an angle
    an angle can be multiplied by a bare number only
8:12 error [0x10] `x10` in `0x10` is not a unit
    the units are m, cm, mm, in, deg and rad; numbers are decimal
8:19 error [5ft] `ft` in `5ft` is not a unit
    the units are m, cm, mm, in, deg and rad; numbers are decimal
9:8 error [sqrt(30deg)] the square root of an angle is not a length
    take the root of a number or of a sum of squares of lengths
9:22 error [.] a number cannot begin with a point
    write a 0 before it, such as `0.5`
9:28 error [.] `.` has no meaning here
    a decimal point stands between digits, such as `0.5`; a range `-90 .. 90` belongs in limits
"#,
    );
}

#[test]
fn expressions() {
    check(
        r#"
struct Arm(modified, m, deg);
let l = 1;
| joint | alpha | a | d | theta |
| J1 | 2 pi | 2(3) | l 3 | q |
| J2 | 30 + | *3 | (1 + 2 | q |
| J3 | 30) | l^2 | (1)(2) | q |
| J4 | sin | [3] | 3 % 2 | q + é |
"#,
        r#"
4:10 error [pi] `pi` follows `2` without an operator
    write `2*pi` if a product is meant
4:16 error [(] `(` follows `2` without an operator
    write `2*(…)` if a product is meant
4:24 error [3] `3` follows `l` without an operator
    write `l*3` if a product is meant
5:8 error [30 +] a value is missing here
5:15 error [*] a value is missing before `*`
5:20 error [(] this `(` is never closed
6:10 error [)] this `)` was never opened
6:15 error [^] there is no power here
    write a product, such as `a*a`
6:23 error [(] `(` follows `1` without an operator
    write `1*(…)` if a product is meant
7:8 error [sin] `sin` needs its argument in parentheses
    write `sin(…)`
7:14 error [[] a value is missing before `[`
7:22 error [%] `%` has no meaning here
7:28 error [q +] a value is missing here
7:32 error [é] the character `é` has no meaning here
    write names in ASCII or Greek letters, numbers in decimal
"#,
    );
}

#[test]
fn params() {
    check(
        r#"
struct Arm(modified, m, deg);
param p = 0.3; param r = 90; param s = 3mm;
| joint | alpha | a     | d     | theta     |
| J1    | 0     | p     | p*p   | q + p     |
| J2    | 0     | p/2   | 1/p   | q + 2*r   |
| J3    | 0     | sqrt(p) | 0.5*p | q + s   |
"#,
        r#"
4:29 error [p] this is a product of two variables
    a cell is linear in q and in parameters: bind a `param` to the product
4:35 error [q + p] `p` is a length elsewhere and an angle here
    declare two parameters
5:19 error [p/2] the param `p` is multiplied by 1/2 here, which is not an integer
    declare a `param` for what the cell holds
5:29 error [p] this divides by a variable
    a cell is linear in q and in parameters: bind a `param` to the quotient
6:23 error [(p)] an argument of a function is a constant, but `p` is a `param`, known only at run time
    bind `p` with `let` if it never changes
6:29 error [0.5*p] the param `p` is multiplied by 1/2 here, which is not an integer
    declare a `param` for what the cell holds
6:37 error [q + s] this is a length, but `theta` is an angle
    write an angle, such as `90` or `pi/2`, or move the length to `a` or `d`
"#,
    );
}

#[test]
fn couplings() {
    check(
        r#"
struct Arm(modified, m, deg);
| joint | alpha | a | d | theta |
| J1    | 0     | 0 | 0 | q     |
| elbow | 0     | 0 | 0 | q     |
| J3    | 0     | 0 | q | 0     |
couple: elbow -= J9; couple: J1 -= J1; couple: J1 += J3; couple: elbow -= 0.5*J1;
couple: elbow = J1; couple: elbw += J1; couple elbow -= J1; couple: J2 -= 2*J1*J1;
"#,
        r#"
6:18 error [J9] `J9` is not a joint of this arm
    the joints are J1, elbow, J3
6:36 error [J1] `J1` is coupled to itself
    only other joints may stand on the right
6:54 error [J3] `J3` is prismatic
    only revolute joints can be coupled
6:75 error [0.5*J1] `0.5*J1` is not a joint with an integer coefficient of at most 1000
    write it like `couple: J3 -= 2*J2;`
7:15 error [=] `-=` or `+=` is missing here
    write it like `couple: J3 -= J2;`
7:29 error [elbw] `elbw` is not a joint of this arm
    did you mean `elbow`?
7:48 error [elbow] a `:` is missing after `couple`
7:75 error [2*J1*J1] `2*J1*J1` is not a joint with an integer coefficient of at most 1000
    write it like `couple: J3 -= 2*J2;`
"#,
    );
}

#[test]
fn checks() {
    check(
        r#"
struct Arm(modified, m, deg);
| joint | alpha | a   | d | theta |
| J1    | 0     | 0   | 0 | q     |
|       | 0     | 0.5 | 0 | 0     |
check [0] => (0.5, 0, 0);
check [90] => (0.5, 0, 0);
check [0] => (0.5, 0, 0) zyx(1, 0, 0);
check [0] => (0.5, 0, 0) zyx(1, 0, 0) within 0.1;
check [0, 0] => (0.5, 0, 0);
check [0mm] => (0.5, 0, 90deg) within -1;
check [q] => (0, 0, 0);
"#,
        r#"
6:1 error [check [90] => (0.5, 0, 0)] this pose is (0, 0.5, 0) zyx(90, 0, 0), 0.707106781 m off
    correct the table or the check; `within` sets the tolerance of both
7:1 error [check [0] => (0.5, 0, 0) zyx(1, 0, 0)] this pose is (0.5, 0, 0) zyx(0, 0, 0), 1 deg off
    correct the table or the check; `within` sets the tolerance of both
9:7 error [[0, 0]] there are 2 values for the joints, of which there are 1
    write one value for each joint
10:8 error [0mm] this is a length, not an angle
    write an angle, such as `90` or `pi/2`
10:25 error [90deg] this is an angle, not a length
    write a length, such as `120` or `120m`
10:39 error [-1] a tolerance is not negative
    write a small number, such as `1e-6`
11:8 error [q] a check is a constant, but `q` is a joint variable
    joint variables belong in theta, d or a factor of the chain
"#,
    );
}

#[test]
fn checks_that_cannot_be_read() {
    check(
        r#"
struct Arm(modified, m, deg);
| joint | alpha | a   | d | theta |
| J1    | 0     | 0   | 0 | q     |
check [0] => (0.5, 0);
check [0] (0.5, 0, 0);
check 0 => (0.5, 0, 0);
check [0] => (0, 0, 0) zyx 90;
check [0] => (0, 0, 0) xyz(0, 0, 0);
check [0 => (0, 0, 0);
"#,
        r#"
4:14 error [(0.5, 0)] the position (x, y, z) has 2 values instead of 3
    write it like `check [0, 0] => (x, y, z) zyx(0, 0, 90) within 1e-6;`
5:11 error [(] `=>` and the expected position are missing here
    write it like `check [0, 0] => (x, y, z) zyx(0, 0, 90) within 1e-6;`
6:7 error [0] the joint values are missing after `check`
    write it like `check [0, 0] => (x, y, z) zyx(0, 0, 90) within 1e-6;`
7:28 error [90] the orientation zyx(α, β, γ) is missing here
    write it like `check [0, 0] => (x, y, z) zyx(0, 0, 90) within 1e-6;`
8:24 error [xyz] `xyz` has no meaning here
9:7 error [[] this `[` is never closed
"#,
    );
}

#[test]
fn a_gimbal_locked_check() {
    check(
        r#"
struct Arm(chain, mm, rad);
Rz(q) Ry(pi/2) Rx(1) Tz(10) Tx(0.1);
check [0.5] => (0, 0, 0) zyx(0, pi/2, 0.5) within 20mm;
check [0.5] => (0, 0, 0) zyx(0, pi/2, 0.6) within 20mm;
"#,
        r#"
4:1 error [check [0.5] => (0, 0, 0) zyx(0, pi/2, 0.6) within 20mm] this pose is (8.77582562, -4.79425539, -0.1) zyx(0, 1.57079633, 0.5), 10.0005 mm and 5.72957795 deg off
    correct the table or the check; `within` sets the tolerance of both
"#,
    );
}

#[test]
fn a_check_of_the_other_convention() {
    check(
        r#"
struct Arm(modified, m, deg);
| joint | alpha | a   | d | theta |
| J1    | 90    | 0.2 | 0.5 | q     |
| J2    | 0     | 0.3 | 0 | q     |
check [0, 0] => (0.5, 0, 0.5);
check [90, 0] => (0, 0.5, 0.5) zyx(90, 0, 90);
"#,
        r#"
5:1 error [check [0, 0] => (0.5, 0, 0.5)] this pose is (0.5, -0.5, 0) zyx(0, 0, 90), 0.707106781 m off
    it passes if read as `standard`: change the header if the table is meant so
6:1 error [check [90, 0] => (0, 0.5, 0.5) zyx(90, 0, 90)] this pose is (0.2, -0.5, 0.3) zyx(0, -90, 90), 1.03923048 m and 120 deg off
    it passes if read as `standard`: change the header if the table is meant so
"#,
    );
}

#[test]
fn the_chain_form() {
    check(
        r#"
struct Arm(chain, m, deg);
Rz(q) Tz(0.3) Rw(90) Tx(90deg) Rx(3mm) Tz( Ry(30);
Rz(q2 + 90) Tx(q);
base: Tz(q); tool: ; base: Tz(1);
"#,
        r#"
2:15 error [Rw] `Rw` is not an elementary transform
    the transforms are Rx, Ry, Rz (rotations) and Tx, Ty, Tz (translations), such as `Rz(q)`
2:25 error [90deg] this is an angle, but the argument of a translation is a length
    write a length, such as `90m`
2:35 error [3mm] this is a length, but the argument of a rotation is an angle
    write an angle, such as `90` or `pi/2`
2:42 error [(] this `(` is never closed
4:10 error [q] `base` is a constant, but `q` is a joint variable
    joint variables belong in theta, d or a factor of the chain
4:14 error [tool] `tool:` is empty
    write transforms, such as `Rx(180) Tz(0.5)`
4:22 error [base] `base:` is given twice
    write all of it in one statement
"#,
    );
}

#[test]
fn the_wrong_form() {
    check(
        r#"
struct Arm(chain, m, deg);
| joint | alpha | a   | d | theta |
| J1    | 90    | 0.2 | 0 | q     |
"#,
        r#"
2:1 error [| joint | alpha | a | d | theta |] a table needs a convention
    write `standard` or `modified` instead of `chain` in the header
"#,
    );
}

#[test]
fn the_other_wrong_form() {
    check(
        r#"
struct Arm(standard, m, deg);
Rz(q) Tx(1);
"#,
        r#"
2:1 error [Rz(q)] factors are the chain form, but the header promises a table
    write `chain` instead of `standard` in the header
"#,
    );
}

#[test]
fn both_forms() {
    check(
        r#"
struct Arm(standard, m, deg);
| joint | alpha | a   | d | theta |
| J1    | 90    | 0.2 | 0 | q     |
Rz(30) Tx(1);
"#,
        r#"
4:1 error [Rz(30)] an arm is written as a table or as factors, not as both
    fixed transforms before the first row go to `base:`, those after the last to `tool:`
"#,
    );
}

#[test]
fn two_tables() {
    check(
        r#"
struct Arm(standard, m, deg);
| joint | alpha | a   | d | theta |
| J1    | 90    | 0.2 | 0 | q     |
let a = 3;
| joint | alpha | a   | d | theta |
| J2    | 90    | a   | 0 | q     |
"#,
        r#"
5:1 error [|] this is the second table; an arm has one
"#,
    );
}

#[test]
fn no_joints() {
    check(
        r#"
struct Arm(standard, m, deg);
| alpha | a   | d | theta |
| 90    | 0.2 | 0 | 0     |
"#,
        r#"
1:8 error [Arm] `Arm` has no joints
    write a table with q in theta (revolute) or d (prismatic)
"#,
    );
}

#[test]
fn nothing_but_a_header() {
    check(
        r#"
struct Arm(chain, m, deg);
"#,
        r#"
1:8 error [Arm] `Arm` has no joints
    write factors with q, such as `Rz(q) Tx(0.3)`
"#,
    );
}

#[test]
fn statements() {
    check(
        r#"
struct Arm(standard, m, deg)
lte a = 3; tool Tx(1); ik: ; ik: a; ik: b; 5; Foo(3); let b = 1, c = 2;
check [1] => (1, 2, 3) let d = 3;
let e = 1 2 let f = 3
| joint | alpha | a   | d | theta |
| J1    | 90    | f   | d | q     |
let g = 1
"#,
        r#"
1:28 error [)] a `;` is missing after the header
2:1 error [lte] `lte` does not begin a statement
    did you mean `let`?
2:17 error [Tx] a `:` is missing after `tool`
2:26 error [:] the family is missing after `ik:`
    write `ik: spherical_wrist;`
2:41 error [b] `ik:` is given twice
2:44 error [5] `5` does not begin a statement
    write a table, transforms, `let`, `param`, `base:`, `tool:`, `couple:`, `check` or `ik:`
2:47 error [Foo] `Foo` is not an elementary transform
    the transforms are Rx, Ry, Rz (rotations) and Tx, Ty, Tz (translations), such as `Rz(q)`
2:64 error [,] `,` has no meaning here
3:24 error [let] a `;` is missing before `let`
4:11 error [2] `2` follows `1` without an operator
    write `1*2` if a product is meant
5:1 error [|] a `;` is missing before `|`
7:9 error [1] a `;` is missing at the end
"#,
    );
}

#[test]
fn what_text_cannot_hold() {
    check(
        r#"
struct Arm(standard, m, deg);
/* Two /* nested */ comments */ let a = 3€; // and a line
let b = 3m; "text";
| joint | alpha | a   | d | theta |
| J1    | 90°   | b − a   | d | θ₁ |
/* not closed
"#,
        r#"
2:42 error [€] the character `€` has no meaning here
    write names in ASCII or Greek letters, numbers in decimal
3:13 error ["text"] `"text"` does not begin a statement
    write a table, transforms, `let`, `param`, `base:`, `tool:`, `couple:`, `check` or `ik:`
5:23 error [a] a bare number cannot be added to a length
    write the unit on both, or on none
5:29 error [d] `d` is not bound
    bind it with `let d = …;` or `param d = …;`
6:1 error [/* not closed] this comment is never closed with `*/`
"#,
    );
}

#[test]
fn a_joint_variable_that_is_bound() {
    check(
        r#"
struct Arm(modified, m, deg);
let q1 = 0.4; let theta_2 = 30;
| joint | alpha   | a  | d  | theta       |
| J1    | 0       | 0  | 0  | q1          |
| J2    | 90      | q1 | 0  | q + theta_2 |
| J3    | theta_2 | 0  | q1 | q           |
check [0, 0, 0] => (0, 0, 0);
"#,
        r#"
2:5 error [q1] `q1` stands for a joint variable
    choose another name
2:19 error [theta_2] `theta_2` stands for a joint variable
    choose another name
"#,
    );
    check(
        r#"
struct Arm(chain, m, deg);
let q1 = 0.4;
Rz(q1) Tx(q1) Ry(q) Tx(1);
check [0, 0] => (1.4, 0, 0);
"#,
        r#"
2:5 error [q1] `q1` stands for a joint variable
    choose another name
"#,
    );
}

#[test]
fn the_header_twice() {
    check(
        r#"
struct Arm(modified, m, deg);
| joint | alpha | a | d | theta | limits |
|-------|-------|---|---|-------|--------|
| Joint | alpha | a | d | theta | limits |
|-------|-------|---|---|-------|--------|
| J1    | 0     | 0 | 0 | q     |        |
"#,
        r#"
4:1 error [| Joint | alpha | a | d | theta | limits |] the header of the table occurs twice
    remove this row
"#,
    );
}

#[test]
fn limits_of_degrees_under_radians_are_one_mistake() {
    check(
        r#"
struct Arm(modified, m, rad);
| joint | alpha | a | d | theta | limits      |
| J1    | 0     | 0 | 0 | q     | -170 .. 170 |
| J2    | 0     | 1 | 0 | q     | -3 .. 170   |
"#,
        r#"
3:35 warning [-170] -170 radians are more than a turn
    write `-170deg` if degrees are meant, or change the header to `deg`
4:41 warning [170] 170 radians are more than a turn
    write `170deg` if degrees are meant, or change the header to `deg`
"#,
    );
}

#[test]
fn what_is_no_value_has_its_remedy() {
    check(
        r#"
struct Arm(modified, m, deg);
| joint | alfa | a     | d     | theta |
| J1    | 0    | 0     | 0     | q     |
"#,
        r#"
2:11 error [alfa] `alfa` is not a column
    did you mean `alpha`? the columns are joint, alpha, a, d, theta and limits
"#,
    );
    check(
        r#"
struct Arm(modified, m, deg);
| joint | alpha | a     | d    | theta  |
| J1    | "90"  | 0.1_m | 0.2_ | q      |
| J2    | 'c'   | 1_0m  | 0.   | q "90" |
| J3    | 90 .  | 1.    | 0.1  | q      |
"#,
        r#"
3:11 error ["90"] `"90"` is not a value
    write names and numbers without quotes
3:19 error [0.1_m] `_m` in `0.1_m` is not a unit
    the units are m, cm, mm, in, deg and rad; numbers are decimal
3:27 error [0.2_] `_` in `0.2_` is not a unit
    the units are m, cm, mm, in, deg and rad; numbers are decimal
4:11 error ['] `'` is not a value
    write names and numbers without quotes
4:36 error ["90"] `"90"` has no meaning here
    write names and numbers without quotes
5:14 error [.] `.` has no meaning here
    a decimal point stands between digits, such as `0.5`; a range `-90 .. 90` belongs in limits
"#,
    );
}
