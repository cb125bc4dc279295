//! What must be true of numbers, case by case; `reference.rs` compares at length.

use super::{Angle, Ratio, Real, Scalar};

fn whole(value: i64) -> Real {
    Real::from_i64(value)
}

fn ratio(num: i128, den: i128) -> Ratio {
    Ratio::new(num, den).unwrap()
}

fn exact(num: i128, den: i128) -> Scalar {
    Scalar::Exact(ratio(num, den))
}

/// A decimal of up to 77 digits, with one rounding.
fn decimal(text: &str) -> Real {
    let negative = text.starts_with('-');
    let (before, after) = text.trim_start_matches('-').split_once('.').unwrap();
    let mut value = Real::ZERO;
    let mut scale = Real::ONE;
    for digit in before.chars().chain(after.chars()) {
        value = value * whole(10) + whole(digit.to_digit(10).unwrap() as i64);
    }
    for _ in 0..after.len() {
        scale = scale * whole(10);
    }
    if negative { -value / scale } else { value / scale }
}

#[track_caller]
fn assert_is(found: Real, text: &str) {
    let off = (found - decimal(text)).abs();
    // Half a unit of the 74th place, the numerals below having 75 or more.
    assert!(off < decimal(&format!("0.{}5", "0".repeat(74))), "{found:?} is not {text}");
}

/// Reals of every kind: the ends of the range, the neighbours of one, dense and sparse mantissas.
fn samples() -> Vec<Real> {
    let mut large = whole(3);
    for _ in 0..31 {
        large = large * large;
    }
    let tiny = Real::ONE / large;
    let odd = (whole(2).sqrt() + Real::pi()) / whole(7);
    let close = Real::ONE - tiny_step();
    let mut samples = vec![Real::ZERO, Real::ONE, whole(i64::MIN), large, tiny, tiny * tiny, odd, close];
    samples.extend([
        Real::pi(),
        large / odd,
        tiny * odd,
        odd * whole(1 << 62) * whole(1 << 62) * whole(1 << 62),
    ]);
    let opposite: Vec<Real> = samples.iter().map(|&value| -value).collect();
    samples.extend(opposite);
    samples
}

/// 2^-255: the last bit of one.
fn tiny_step() -> Real {
    (0..255).fold(Real::ONE, |value, _| value / whole(2))
}

#[test]
fn known_constants() {
    assert_is(Real::pi(), "3.141592653589793238462643383279502884197169399375105820974944592307816406286");
    assert_is(
        whole(2).sqrt(),
        "1.414213562373095048801688724209698078569671875376948073176679737990732478462",
    );
    assert_is(
        whole(3).sqrt(),
        "1.732050807568877293527446341505872366942805253810380628055806979451933016908",
    );
    let (sine, cosine) = Real::ONE.sin_cos();
    assert_is(sine, "0.841470984807896506652502321630298999622563060798371065672751709991910404391");
    assert_is(cosine, "0.540302305868139717400936607442976603732310420617922227670097255381100394774");
    let half = Real::atan2(whole(1), whole(2));
    assert_is(half, "0.463647609000806116214256231461214402028537054286120263810933088720197864165");
    let obtuse = Real::atan2(whole(2), whole(-3));
    assert_is(obtuse, "2.553590050042225687217032302654417456595462153319181467248897384471896274692");
    // The classical test of range reduction.
    let (sine, cosine) = Real::from_i128(10_i128.pow(22)).sin_cos();
    assert_is(sine, "-0.852200849767188801772705893753029368261762150410043656256509326025910311992");
    assert_is(cosine, "0.523214785395138945497594473384709492140919972439387953527211392104298247376");
    let (sine, _) = Angle::from_degrees(Ratio::integer(18)).sin_cos();
    assert_is(sine, "0.309016994374947424102293417182819058860154589902881431067724311352630231409");
    let (sine, _) = Angle::from_degrees(Ratio::integer(15)).sin_cos();
    assert_is(sine, "0.258819045102520762348898837624048328349068901319930513814003207315056974748");
    let degree = Angle::from_degrees(Ratio::ONE).to_real();
    assert_is(degree, "0.017453292519943295769236907684886127134428718885417254560971914401710091146");
}

#[test]
fn numerals() {
    let parse = Ratio::parse_decimal;
    for (text, num, den) in [
        ("12", 12, 1),
        ("0.4318", 2159, 5000),
        ("1e-3", 1, 1000),
        ("1E+3", 1000, 1),
        ("1_000", 1000, 1),
        ("1_0.2_5_", 41, 4),
        ("1e1_0", 10_000_000_000, 1),
        ("-3", -3, 1),
        ("+3", 3, 1),
        (".5", 1, 2),
        ("5.", 5, 1),
        ("170.", 170, 1),
        ("-0", 0, 1),
        ("0e400", 0, 1),
        ("0.0", 0, 1),
        ("2.500e1", 25, 1),
        ("0.0000000000000000000000000000000000000000000005e46", 5, 1),
        ("1.50000000000000000000000000000000000000000000000000", 3, 2),
        ("170141183460469231731687303715884105727", i128::MAX, 1),
        ("5e-38", 1, 2 * 10_i128.pow(37)),
        ("340282366920938463463374607431768211456e-38", 0, 0),
        ("100000000000000000000000000000000000000000e-41", 1, 1),
    ] {
        let expected = Ratio::new(num, den);
        assert_eq!(parse(text), expected, "{text}");
    }
}

#[test]
fn what_is_no_numeral() {
    for text in [
        "",
        "-",
        "+",
        ".",
        "--1",
        "-+1",
        "1-",
        "1e",
        "1e+",
        "e5",
        ".e5",
        "_1",
        "1._5",
        "1e_5",
        "1.2.3",
        "1e5e5",
        "1e5.",
        " 1",
        "1 ",
        "0x10",
        "1,5",
        "inf",
        "nan",
        "90deg",
        "½",
        "１",
        "−1",
        "1e400",
        "-1e400",
        "1e-400",
        "1e39",
        "1e-39",
        "170141183460469231731687303715884105728",
        "1e99999999999999999999",
        "1e-99999999999999999999",
    ] {
        assert_eq!(Ratio::parse_decimal(text), None, "{text:?}");
    }
}

#[test]
fn ratios_are_in_lowest_terms_with_a_positive_denominator() {
    assert_eq!((ratio(6, -4).num(), ratio(6, -4).den()), (-3, 2));
    assert_eq!(ratio(0, -5), Ratio::ZERO);
    assert_eq!(ratio(i128::MIN, i128::MIN), Ratio::ONE);
    assert_eq!(ratio(i128::MIN, 2).num(), -(1 << 126));
    assert_eq!(ratio(2, i128::MIN), ratio(-1, 1 << 126));
    assert_eq!([ratio(3, 2), ratio(-7, 1), Ratio::ZERO].map(|r| r.to_string()), ["3/2", "-7", "0"]);
    assert_eq!([ratio(-3, 2), Ratio::ZERO, Ratio::ONE].map(Ratio::signum), [-1, 0, 1]);
    assert_eq!((ratio(-3, 2).abs(), ratio(3, 2).neg()), (ratio(3, 2), ratio(-3, 2)));
    assert!(ratio(4, 2).is_integer() && !ratio(1, 2).is_integer());
}

#[test]
fn ratios_say_none_rather_than_round() {
    let (large, small) = (ratio(i128::MAX, 1), ratio(1, i128::MAX));
    assert_eq!(Ratio::new(1, 0), None);
    assert_eq!(Ratio::new(i128::MIN, 1), None);
    assert_eq!(Ratio::new(1, i128::MIN), None);
    assert_eq!(large.checked_add(Ratio::ONE), None);
    assert_eq!(large.neg().checked_sub(Ratio::ONE), None);
    assert_eq!(large.checked_mul(ratio(2, 1)), None);
    assert_eq!(small.checked_div(ratio(2, 1)), None);
    assert_eq!(small.checked_add(ratio(1, i128::MAX - 1)), None);
    assert_eq!(Ratio::ONE.checked_div(Ratio::ZERO), None);
    // What fits in the end is found, however large the factors.
    assert_eq!(large.checked_mul(small), Some(Ratio::ONE));
    assert_eq!(large.checked_div(large), Some(Ratio::ONE));
    assert_eq!(small.checked_add(small.neg()), Some(Ratio::ZERO));
    assert_eq!(small.checked_sub(small), Some(Ratio::ZERO));
    assert_eq!(ratio(1, 6).checked_add(ratio(1, 3)), Some(ratio(1, 2)));
    assert_eq!(ratio(-3, 4).checked_div(ratio(-9, 2)), Some(ratio(1, 6)));
}

#[test]
fn ratios_are_ordered_exactly() {
    let max = i128::MAX;
    let rising = [
        ratio(-max, 1),
        ratio(-max, max - 1),
        ratio(-1, 1),
        ratio(1 - max, max),
        ratio(-1, max),
        Ratio::ZERO,
        ratio(1, max),
        ratio(1, max - 1),
        ratio(1, 3),
        ratio(max - 2, max - 1),
        ratio(max - 1, max),
        Ratio::ONE,
        ratio(max, max - 1),
        ratio(max, 1),
    ];
    for (i, a) in rising.iter().enumerate() {
        for (j, b) in rising.iter().enumerate() {
            assert_eq!(a.cmp(b), i.cmp(&j), "{a} {b}");
        }
    }
}

#[test]
fn scalars_stay_exact() {
    let two = Scalar::from(2);
    assert_eq!(Scalar::from(4).sqrt(), Some(two));
    assert_eq!(exact(9, 16).sqrt(), Some(exact(3, 4)));
    assert_eq!(exact(1, 3).mul(Scalar::from(3)), Some(Scalar::one()));
    assert_eq!(exact(i128::MAX, 1).add(Scalar::one()), None);
    assert_eq!(two.div(Scalar::zero()), None);
    let root = two.sqrt().unwrap();
    assert_eq!(root.mul(root).and_then(|square| square.sub(two)), Some(Scalar::zero()));
    assert_eq!(root.sub(root), Some(Scalar::zero()));
    assert_eq!(root.mul(Scalar::zero()), Some(Scalar::zero()));
    assert_eq!(root.div(root.sub(root).unwrap()), None);
    assert_eq!(Scalar::from(-2).sqrt(), None);
    assert_eq!(root.neg().sqrt(), None);
    assert_eq!(Scalar::zero().sqrt(), Some(Scalar::zero()));
    assert_eq!([root.neg(), Scalar::zero(), root].map(Scalar::signum), [-1, 0, 1]);
    let difference = Scalar::from(8).sqrt().unwrap().sub(Scalar::from(2).mul(root).unwrap());
    assert_eq!(difference, Some(Scalar::zero()));
    assert_eq!(Scalar::from(whole(5) / whole(8)), exact(5, 8));
}

#[test]
fn scalars_are_ordered_by_value() {
    let root = Scalar::from(2).sqrt().unwrap();
    let rising = [root.neg(), exact(-7, 5), Scalar::zero(), exact(7, 5), root, exact(3, 2), Scalar::from(2)];
    assert!(rising.is_sorted() && rising.iter().rev().is_sorted_by(|a, b| a > b));
    assert!(Scalar::Exact(Ratio::ONE) < Scalar::Real(Real::ONE));
    assert!(Scalar::Real(Real::ONE) > Scalar::Exact(Ratio::ONE));
}

#[test]
fn atan2_is_exact_on_the_axes_and_knows_the_quadrants() {
    let (zero, one, pi) = (Real::ZERO, Real::ONE, Real::pi());
    for size in [one, tiny_step(), Real::pi()] {
        assert_eq!(Real::atan2(zero, size), zero);
        assert_eq!(Real::atan2(zero, -size), pi);
        assert_eq!(Real::atan2(size, zero), pi / whole(2));
        assert_eq!(Real::atan2(-size, zero), -pi / whole(2));
    }
    assert_eq!(Real::atan2(zero, zero), zero);
    for (y, x, eighths) in [(1, 1, 1), (1, -1, 3), (-1, -1, -3), (-1, 1, -1)] {
        let off = Real::atan2(whole(y), whole(x)) - pi * whole(eighths) / whole(4);
        assert!(off.abs() <= tiny_step() * whole(8));
    }
}

#[test]
fn sums_that_cancel_are_exact() {
    let step = tiny_step();
    assert_eq!((Real::ONE + step) - Real::ONE, step);
    assert_eq!(Real::ONE - (Real::ONE - step / whole(2)), step / whole(2));
    // Ties go to even: half a step is lost on one, and completes the step on its neighbour.
    let half = step / whole(2);
    assert_eq!(Real::ONE + half, Real::ONE);
    assert_eq!((Real::ONE + step) + half, Real::ONE + step + step);
    assert_eq!(Real::ONE + (half + half * step), Real::ONE + step);
    assert_eq!(Real::ONE - half / whole(2), Real::ONE);
    assert_eq!(Real::ONE - (half / whole(2) + half * step), Real::ONE - half);
}

#[test]
fn every_operation_is_total() {
    for a in samples() {
        assert!(a.sqrt() >= Real::ZERO);
        let (sine, cosine) = a.sin_cos();
        assert!(sine.abs() <= Real::ONE && cosine.abs() <= Real::ONE);
        let _ = (a.to_f64(), format!("{a:?}"), Scalar::from(a), Angle::from_rad(Scalar::Real(a)).sin_cos());
        for b in samples() {
            assert_eq!(a + b, b + a);
            assert_eq!(a * b, b * a);
            assert_eq!(a - b, -(b - a));
            assert_eq!(a.cmp(&b), (-b).cmp(&-a));
            assert!(Real::atan2(a, b).abs() <= Real::pi());
            let _ = a / b;
            assert_eq!(Scalar::Real(a).div(Scalar::Real(b)).is_none(), b.is_negligible());
        }
    }
    assert_eq!(Real::ONE / Real::ZERO, Real::ZERO);
    assert_eq!(whole(-2).sqrt(), Real::ZERO);
    assert_eq!([f64::INFINITY, f64::NEG_INFINITY, f64::NAN].map(Real::from_f64), [None; 3]);
    assert_eq!(Real::from_f64(-0.0).map(|zero| zero.to_f64().to_bits()), Some(0));
}

#[test]
fn ratios_of_any_size_are_total() {
    let max = i128::MAX;
    let samples = [
        Ratio::ZERO,
        Ratio::ONE,
        ratio(-max, 1),
        ratio(1, max),
        ratio(max, max - 1),
        ratio(1 - max, max),
        ratio(max, 1 << 126),
        ratio(-1, 1 << 126),
    ];
    for a in samples {
        let angle = Angle { pi: a, rad: Scalar::Exact(a) };
        let _ = (angle.reduced(), angle.quarters(), angle.sin_cos(), angle.to_f64(), angle.times(i64::MIN));
        let _ = (Angle::from_pi(a).sin_cos(), Angle::from_degrees(a).to_f64(), Scalar::Exact(a).sqrt());
        for b in samples {
            let back = a.checked_add(b).and_then(|sum| sum.checked_sub(b));
            assert!(back.is_none_or(|back| back == a));
            let back = a.checked_mul(b).and_then(|product| product.checked_div(b));
            assert!(back.is_none_or(|back| back == a));
        }
    }
}
