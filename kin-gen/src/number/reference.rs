//! The arithmetic against mpmath and Python: one test for each kind of line in `reference.txt`.

use super::{Angle, Ratio, Real, Scalar};
use std::cmp::Ordering;

/// The lines of one kind, split into words.
fn lines(kind: &str) -> impl Iterator<Item = Vec<&'static str>> {
    let prefix = format!("{kind} ");
    include_str!("reference.txt")
        .lines()
        .filter_map(move |line| line.strip_prefix(&prefix).map(|words| words.split(' ').collect()))
}

/// Reads `-<hex>p<exponent>`, exactly: limb by limb, each of which a real holds.
fn real(text: &str) -> Real {
    let (digits, exponent) = text.trim_start_matches('-').split_once('p').unwrap_or(("0", "0"));
    let two = |power: i32| (0..power.abs()).fold(Real::ONE, |value, _| value + value);
    let digits = format!("{digits:0<64}");
    let mut value = Real::ZERO;
    for at in (0..64).step_by(16) {
        let limb = i128::from_str_radix(&digits[at..at + 16], 16).unwrap();
        value = value * two(64) + Real::from_i128(limb);
    }
    let exponent = exponent.parse::<i32>().unwrap() - 256;
    let value = if exponent < 0 { value / two(exponent) } else { value * two(exponent) };
    if text.starts_with('-') { -value } else { value }
}

/// Whether the two agree to within `units` of the last of 256 bits.
#[track_caller]
fn assert_near(found: Real, right: Real, units: i64, what: &dyn std::fmt::Debug) {
    // The last bit's weight is between 2^-256 and 2^-255 of the value.
    let unit = (0..256).fold(right.abs(), |value, _| value / Real::from_i64(2));
    let off = (found - right).abs();
    assert!(off <= unit * Real::from_i64(units), "{what:?}\n{found:?} is not\n{right:?}");
}

fn double(bits: &str) -> f64 {
    f64::from_bits(u64::from_str_radix(bits, 16).unwrap())
}

fn ratio(num: &str, den: &str) -> Ratio {
    Ratio::new(num.parse().unwrap(), den.parse().unwrap()).unwrap()
}

#[test]
fn operations_are_correctly_rounded() {
    for words in lines("add") {
        let (a, b, right) = (real(words[0]), real(words[1]), real(words[2]));
        assert_eq!(a + b, right, "{words:?}");
        assert_eq!(-b - a, -right, "{words:?}");
    }
    for words in lines("mul") {
        assert_eq!(real(words[0]) * real(words[1]), real(words[2]), "{words:?}");
    }
    for words in lines("div") {
        assert_eq!(real(words[0]) / real(words[1]), real(words[2]), "{words:?}");
    }
    for words in lines("sqrt") {
        assert_eq!(real(words[0]).sqrt(), real(words[1]), "{words:?}");
    }
}

#[test]
fn sine_and_cosine_are_near() {
    for words in lines("sin_cos") {
        let (sine, cosine) = real(words[0]).sin_cos();
        assert_near(sine, real(words[1]), 4, &words);
        assert_near(cosine, real(words[2]), 4, &words);
    }
}

#[test]
fn arc_tangents_are_near() {
    for words in lines("atan2") {
        assert_near(Real::atan2(real(words[0]), real(words[1])), real(words[2]), 8, &words);
    }
}

#[test]
fn angles_keep_their_bits_when_their_parts_cancel() {
    for words in lines("angle") {
        let angle = Angle { pi: ratio(words[0], words[1]), rad: Scalar::Exact(ratio(words[2], words[3])) };
        assert_near(angle.to_real(), real(words[4]), 4, &words);
    }
}

#[test]
fn doubles_are_correctly_rounded() {
    for words in lines("double") {
        assert_eq!(real(words[0]).to_f64().to_bits(), double(words[1]).to_bits(), "{words:?}");
    }
    for words in lines("ratio") {
        let value = Scalar::Exact(ratio(words[0], words[1]));
        assert_eq!(value.to_f64().to_bits(), double(words[2]).to_bits(), "{words:?}");
    }
}

#[test]
fn a_double_goes_in_and_comes_out_unchanged() {
    for words in lines("double") {
        let value = double(words[1]);
        let back = Real::from_f64(value).map(Real::to_f64);
        assert_eq!(back, value.is_finite().then_some(value));
    }
}

#[test]
fn the_order_is_that_of_the_differences() {
    let values: Vec<Real> = lines("add").map(|words| real(words[0])).collect();
    for &a in &values {
        for &b in &values {
            let sign = (a - b).signum();
            let order = if sign < 0 {
                Ordering::Less
            } else if sign > 0 {
                Ordering::Greater
            } else {
                Ordering::Equal
            };
            assert_eq!(a.cmp(&b), order);
        }
    }
}
