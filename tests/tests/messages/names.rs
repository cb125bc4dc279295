//! Names: unknown, taken, unused.

use crate::check;

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
