//! The form of a declaration: header, table or chain, and what is no declaration at all.

use crate::check;

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
