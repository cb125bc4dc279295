//! Numbers, units, limits and expressions.

use crate::check;

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
