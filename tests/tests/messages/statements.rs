//! Parameters, couplings, checks and the other statements behind a table.

use crate::check;

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
