//! [`dh!`]: a Denavit-Hartenberg table in Rust source, its kinematics out.
//!
//! A door, not a room: `tokens` turns the compiler's tokens into the grammar's, `shell` reads the item shell,
//! [`kin_gen::expand`] does the work and knows nothing of the compiler, `report` says what it found under the right
//! tokens, `fallback` keeps a mistake from becoming twenty. Programs get the macro from `kin-runtime`, which also holds what the generated code calls.

extern crate proc_macro;

mod fallback;
mod report;
mod shell;
mod tokens;

use kin_gen::chain::ParamKind;
use kin_gen::model::ParamFacts;
use proc_macro2::TokenStream;

use crate::fallback::Outline;
use crate::shell::{Field, Shell};
use crate::tokens::Tokens;

/// Declares an arm; the compiler derives its kinematics.
///
/// ```ignore
/// use kin_runtime::prelude::*;
///
/// dh! {
///     /// Unimation Puma 560.
///     pub struct Puma560(standard, m, deg);
///
///     | joint | alpha |   a    |    d    | theta | limits      |
///     |-------|-------|--------|---------|-------|-------------|
///     | J1    |  90   | 0      | 26.45in | q     | -160 .. 160 |
///     | J2    |   0   | 0.4318 | 0       | q     |  -45 .. 225 |
///     | J3    | -90   | 0.0203 | 0.15005 | q     | -225 ..  45 |
///     | J4    |  90   | 0      | 0.4318  | q     | -110 .. 170 |
///     | J5    | -90   | 0      | 0       | q     | -100 .. 100 |
///     | J6    |   0   | 0      | 0       | q     | -266 .. 266 |
/// }
///
/// let pose = Puma560.fk(&joints![0.1, -0.4, 0.2, 0.3, 0.9, -0.5]);
/// for solution in Puma560.ik(&pose).iter() {
///     println!("{}: {:?}", solution.branch, solution.q);
/// }
/// ```
///
/// # The item
///
/// Attributes, visibility and name are Rust's. The struct derives `Clone`, `Copy`, `Debug` and `PartialEq`, whether or
/// not that is written out, and whatever else its author asks for; `Default` is the nominal arm.
///
/// `#[dh(crate = path)]` says where the runtime is when it is not `::kin_runtime`; a `macro_rules` macro that wraps
/// `dh!` writes `#[dh(crate = $crate::kin_runtime)]`.
///
/// The header names how the arm is written, its unit of length and its unit of angle; all three are needed, since they
/// give different arms:
///
/// | | written | meaning |
/// |---|---|---|
/// | form | `standard` | each row is Rz(theta) Tz(d) Tx(a) Rx(alpha) (Denavit and Hartenberg 1955) |
/// | | `modified` | each row is Rx(alpha) Tx(a) Rz(theta) Tz(d), with the row's own alpha and a (Craig 1986) |
/// | | `chain` | elementary transforms, one after the other |
/// | length | `m` `cm` `mm` `in` | of every length that has no unit of its own, and of every length at run time |
/// | angle | `deg` `rad` | of every angle that has no unit of its own; at run time angles are radians |
///
/// # Values
///
/// A value is a number, a length or an angle, and it is exact: `0.4318` is 4318/10000. A bare number, also one that
/// came through a `let`, takes the header's unit where it is used. A suffix (`90deg`, `0.5rad`, `47mm`, `2in`) or
/// `pi` gives it a kind of its own; kinds do not mix, so a length under `alpha` is an error under that cell.
/// Quarter turns are exact, `90` and `pi/2` alike; `1.5708rad` is not one, and gets a warning.
///
/// # Grammar
///
/// ```text
/// arm       = attribute* [visibility] "struct" name "(" word "," word "," word ")" ";" statement*
/// statement = table                                                 it ends by itself
///           | factor+ ";"                                           the chain form
///           | ("let" | "param") name "=" expr ";"
///           | ("base" | "tool") ":" factor+ ";"
///           | "couple" ":" joint ("+" | "-") "=" expr {"," joint ("+" | "-") "=" expr} ";"
///           | "check" "[" exprs "]" "=" ">" "(" expr "," expr "," expr ")"
///                     ["zyx" "(" expr "," expr "," expr ")"] ["within" expr] ";"
///           | "ik" ":" family ";"
/// table     = row+                                                  the first one names the columns
/// row       = "|" {cell "|"}
/// cell      = [name | expr | expr "." "." expr]
/// factor    = ("Rx" | "Ry" | "Rz" | "Tx" | "Ty" | "Tz") "(" expr ")"
/// expr      = product {("+" | "-") product}
/// product   = signed {("*" | "/") signed}
/// signed    = {"+" | "-"} atom
/// atom      = number [unit] | "pi" | name | ("sqrt" | "sin" | "cos") "(" expr ")" | "(" expr ")"
/// unit      = "m" | "cm" | "mm" | "in" | "deg" | "rad"
/// ```
///
/// The same text, in a `.dh` file, is what the command line and build scripts read.
///
/// # The table
///
/// A Markdown table, which `rustfmt` leaves alone. Columns come in any order; `joint` and `limits` may be absent. A row
/// of dashes is skipped.
///
/// | column | also | what it holds |
/// |---|---|---|
/// | `joint` | `i` `frame` `link` `name` | the joint's name; empty in a fixed row |
/// | `alpha` | `alpha_i` | the twist, an angle |
/// | `a` | `a_i` `r` `r_i` | the length of the common normal |
/// | `d` | `d_i` | the offset along z, a length; with `q`, the joint slides |
/// | `theta` | `theta_i` | the angle about z; with `q`, the joint turns |
/// | `limits` | | `-170 .. 170`, inclusive; `170 .. 190` goes through the half turn |
///
/// A cell with `q` is `q`, `-q`, or one of these plus a constant: `q + 90`. In the row of joint 3, `q3` and
/// `theta3` are accepted for `q`. A row without `q` is fixed: a bend or an offset between two joints.
///
/// The `chain` form is how reports print an arm: `Rz(q) Tz(l1) Rz(90) Rx(90)  Rz(q) Tx(l2) …`.
///
/// # Statements
///
/// - `let l1 = 0.3;` names an exact constant; generated code calls it by that name.
/// - `param tcp = 120;` is a field of the struct, `pub tcp: f64`, with that nominal value (`NOMINAL` has them all).
///   At run time it is in the declared unit of length, or in radians, as its use decides. A nominal 0 is not an exact
///   zero: what holds for the arm must hold for every value.
/// - `base: Tz(0.67);` stands before the first row, `tool: Tz(0.1) Rz(45);` after the last.
/// - `couple: J3 -= J2;` says what the drives do: the third row turns by q3 - q2. `q` is always what the caller
///   commands; Jacobians and limits are with respect to it, and the inverse returns it.
/// - `check [0, 0, 0, 0, 0, 0] => (-69, 0, 112);` is a pose the arm must reach, in the header's units, base and tool
///   included. The compiler evaluates it; a wrong table does not compile. `zyx(α, β, γ)` adds the orientation
///   Rz(α) Ry(β) Rx(γ), and `within 1e-3` the tolerance with which the pose was printed.
/// - `ik: spherical_wrist;` demands that family, as `spherical_shoulder` (the first three axes meet), `position` and `short`
///   (a pose of two to five joints) do; otherwise it is recognised, or there is no `ik`.
///
/// # What is generated
///
/// The struct, and for an arm of N joints:
///
/// - `Arm<N>`: `fk`, `frames`, `jacobian`, `fk_jacobian`, `limits`, `reach`, and the declaration's text as `TABLE`;
/// - where the last three axes meet, `SphericalWrist<N>`: `r36`, `r03` and `wrist_angles`;
/// - where the family has a closed form, `InverseKinematics<N>`: `ik`, every solution, each with its posture;
/// - for arms of two or three joints, `PositionInverse<N>`: `ik_position`; for arms of two to five, `ik` of the poses that they
///   reach. A planar arm of three joints has `ik` alone: a position would leave one of them free.
///
/// Calling `ik` on an arm that has none is an error that names the axes and the distance by which they miss.
///
/// The code is straight lines: no loop, no allocation, no panic, generic over `f32`, `f64` and lanes. It was compared
/// with the product of the table's matrices, as polynomials, before it was written out.
///
/// # Frames
///
/// Of a table, frame i is the end of joint i's own row; fixed rows after it belong to the way to i + 1. Of a chain,
/// frame i is just before joint i + 1, and what trails belongs to the last. `base` enters `fk` and `frames`; `tool`
/// enters `fk` and the point whose velocity the Jacobian gives; neither enters ³R₆.
///
/// # Mistakes
///
/// All of them are reported at once, each under its own cell, with the remedy. A mistake leaves the struct and its
/// traits in place, so that the rest of the program does not complain as well.
#[proc_macro]
pub fn dh(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    expand(input.into()).unwrap_or_else(syn::Error::into_compile_error).into()
}

/// The whole way: tokens, shell, kinematics, messages, items.
fn expand(input: TokenStream) -> syn::Result<TokenStream> {
    let tokens = Tokens::read(input.clone())?;
    let shell = Shell::read(input)?;
    let krate = shell.as_ref().map_or_else(String::new, Shell::krate_text);
    let expansion = kin_gen::expand(&tokens.list, &krate);
    let mut output = report::render(&expansion.report, &tokens);
    let Some(shell) = shell else { return Ok(output) };
    output.extend(shell.mistakes.iter().map(syn::Error::to_compile_error));
    if let Some(shape) = &expansion.shape {
        let fields: Vec<Field> = shape.params.iter().map(|param| field(param, &tokens)).collect();
        output.extend([shell.item(&fields), shell.items(&expansion.items)?]);
    } else {
        let outline = Outline::of(&tokens);
        output.extend([shell.item(&outline.fields), outline.items(&shell.name, &shell.krate())]);
    }
    Ok(output)
}

fn field(param: &ParamFacts, tokens: &Tokens) -> Field {
    let kind = match param.kind {
        ParamKind::Length => "A length in the declared unit",
        ParamKind::Angle => "An angle in radians",
    };
    Field { name: tokens.param(&param.name), doc: format!("{kind}, nominally {}.", param.nominal) }
}
