//! Rows, cells and columns.

use crate::check;

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
