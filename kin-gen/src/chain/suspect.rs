//! Angles that are right as they stand and probably not what was meant.

use super::AngleUnit;
use super::value::{Constant, Value};
use crate::number::{Angle, Real, Scalar};
use crate::report::{Place, Report};

/// How near a decimal must be to a quarter turn to be taken for one, in radians.
const NEAR: f64 = 1e-3;
/// The same for a decimal of degrees: 0.01°.
const NEAR_DEGREES: f64 = 1.75e-4;
/// More than a turn: nobody writes that in a table.
const TURN: f64 = 6.3;

/// Wrists do turn several times, but not that often.
const LIMIT: f64 = 40.0;

/// Warns of an angle that is almost a quarter turn, or that looks as if it were in the other unit.
pub(super) fn angle(value: &Value, angle: Angle, unit: AngleUnit, place: Place, report: &mut Report) {
    if angle.quarters().is_some() {
        return;
    }
    let radians = angle.to_real();
    if let Constant::Bare(Scalar::Exact(bare)) = value.constant {
        let number = Real::from_ratio(bare);
        let float = number.to_f64();
        match unit {
            AngleUnit::Degree if !bare.is_integer() && float.abs() < TURN + NEAR => {
                if let Some((k, _)) = quarter(number, NEAR) {
                    let message =
                        format!("{} degrees: in radians this would be almost {}", short(float), turns(k));
                    let help = format!(
                        "write `{}` if a quarter turn is meant, or change the header to `rad`",
                        90 * k
                    );
                    return report.warn(place, message, help);
                }
            }
            AngleUnit::Radian if bare.is_integer() && float.abs() > TURN => {
                let message = format!("{} radians are more than a turn", short(float));
                let help = format!(
                    "write `{}deg` if degrees are meant, or change the header to `deg`",
                    short(float)
                );
                return report.warn(place, message, help);
            }
            _ => {}
        }
    }
    let near = if angle.rad.is_zero() { NEAR_DEGREES } else { NEAR };
    let Some((k, off)) = quarter(radians, near) else { return };
    let exact = match unit {
        AngleUnit::Degree => (90 * k).to_string(),
        AngleUnit::Radian => in_pi(k),
    };
    let message = format!("this is almost {}, but {off:.1e} rad away from it", turns(k));
    report.warn(
        place,
        message,
        format!("write `{exact}` for the exact angle: it makes the arm's formulas far simpler"),
    );
}

/// Warns of limits that look as if they were in degrees: of the first that does, because both are one mistake.
pub(super) fn limits(ends: [(&Value, Place); 2], unit: AngleUnit, report: &mut Report) {
    for (value, place) in ends {
        if let (AngleUnit::Radian, Constant::Bare(Scalar::Exact(bare))) = (unit, &value.constant) {
            let float = Real::from_ratio(*bare).to_f64();
            if bare.is_integer() && float.abs() > LIMIT {
                return turned(float, place, report);
            }
        }
    }
}

fn turned(float: f64, place: Place, report: &mut Report) {
    let message = format!("{} radians are more than a turn", short(float));
    let help = format!("write `{}deg` if degrees are meant, or change the header to `deg`", short(float));
    report.warn(place, message, help);
}

/// The number of quarter turns that an angle almost is, if not 0, and the difference.
fn quarter(radians: Real, near: f64) -> Option<(i64, f64)> {
    let half_pi = Real::pi() / Real::from_i64(2);
    let ratio = (radians / half_pi).to_f64().round();
    if ratio == 0.0 || ratio.abs() > 64.0 {
        return None;
    }
    // Exact: the ratio is a whole number of at most 64.
    let k = ratio as i64;
    let off = (radians - half_pi * Real::from_i64(k)).to_f64().abs();
    (off < near).then_some((k, off))
}

fn turns(k: i64) -> String {
    match k.abs() {
        1 => "a quarter turn".into(),
        2 => "half a turn".into(),
        4 => "a whole turn".into(),
        k => format!("{k} quarter turns"),
    }
}

fn in_pi(k: i64) -> String {
    let sign = if k < 0 { "-" } else { "" };
    match k.abs() {
        1 => format!("{sign}pi/2"),
        2 => format!("{sign}pi"),
        k if k % 2 == 0 => format!("{sign}{}*pi", k / 2),
        k => format!("{sign}{k}*pi/2"),
    }
}

/// A number to nine significant digits, without trailing zeros.
pub(super) fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.8e}").parse().unwrap_or(x);
    // −0 is printed as 0.
    format!("{}", rounded + 0.0)
}
