//! The angle of a plane vector: the smaller coordinate over the larger, one polynomial, and the octant put back.
//!
//! No branch and no table, as in [`super::sine`], for the same reasons. Constants: `tests/tools/minimax.py`.

use core::f64::consts::FRAC_PI_4;

/// What π/4 has beyond its double, of which one to four times are doubles too.
const EIGHTH_REST: f64 = 3.061616997868383e-17;
/// (1 - atan(t)/t)/t² in powers of t², for |t| ≤ 1/2; relative error of the arctangent 2^-57.8.
const ARCTANGENT: [f64; 12] = [
    0.3333333333333298,
    -0.1999999999990316,
    0.14285714276389852,
    -0.11111110659793219,
    0.09090896248303762,
    -0.07692073963500157,
    0.06663811094505073,
    -0.05858301900931283,
    0.051220181240823295,
    -0.04186536669829941,
    0.02743543789131395,
    -0.010117170492241789,
];
/// Above this the sum of two coordinates may overflow.
const LARGE: f64 = f64::MAX / 4.0;

/// The angle of the vector (x, y), in [-π, π]. Signs of zeros count, and infinities are directions, as in IEEE 754.
#[inline]
pub(super) fn atan2(y: f64, x: f64) -> f64 {
    if is_usual(y, x) { usual(y, x).0 } else { unusual(y, x) }
}

/// The same bits without a branch, where the sum of the coordinates is a number, and what rounding has taken off; NaN for the
/// zero vector.
#[inline(always)]
pub(super) fn straight(y: f64, x: f64) -> (f64, f64) {
    usual(y, x)
}

/// Angles side by side, each with the bits that [`atan2`] gives; with the instructions of the caller.
#[inline(always)]
pub(super) fn atan2_lanes<const L: usize>(y: [f64; L], x: [f64; L]) -> [f64; L] {
    let (mut angles, mut all_usual) = (y, true);
    for (angle, x) in angles.iter_mut().zip(x) {
        // Without an early return, which is a branch for each lane.
        all_usual &= is_usual(*angle, x);
        *angle = usual(*angle, x).0;
    }
    if !all_usual {
        repair(&mut angles, &y, &x);
    }
    angles
}

/// Puts right what the usual way cannot know.
#[cold]
fn repair(angles: &mut [f64], y: &[f64], x: &[f64]) {
    for ((angle, y), x) in angles.iter_mut().zip(y).zip(x) {
        *angle = atan2(*y, *x);
    }
}

/// Whether the quotient of the coordinates and their sum are numbers.
#[inline(always)]
fn is_usual(y: f64, x: f64) -> bool {
    let sum = y.abs() + x.abs();
    // No comparison holds of what is not a number; a sum is zero only where both are.
    (sum <= LARGE) & (sum > 0.0)
}

/// The angle of infinite, enormous, absent and undefined vectors.
#[cold]
fn unusual(y: f64, x: f64) -> f64 {
    if x.is_nan() | y.is_nan() {
        return f64::NAN;
    }
    // Of two infinities the direction alone counts, and the zero vector has that of its signs.
    let finite = |size: f64, other: f64| match () {
        () if size < f64::INFINITY => {
            if other < f64::INFINITY {
                size * 0.25
            } else {
                0.0
            }
        }
        () => 1.0,
    };
    let (rise, run) = (y.abs(), x.abs());
    let (rise, run) = (finite(rise, run), finite(run, rise));
    let run = if (rise == 0.0) & (run == 0.0) { 1.0 } else { run };
    usual(rise.copysign(y), run.copysign(x)).0
}

/// The angle of a vector with [usual](is_usual) coordinates, and what the last rounding took off it; of others, nothing of
/// meaning.
#[inline(always)]
fn usual(y: f64, x: f64) -> (f64, f64) {
    let (angle, lost) = above(y.abs(), x);
    let below = y.to_bits() & (1 << 63);
    (angle.copysign(y), f64::from_bits(lost.to_bits() ^ below))
}

/// The same of a vector that does not point below the first axis.
#[inline(always)]
pub(super) fn above(rise: f64, x: f64) -> (f64, f64) {
    let run = x.abs();
    let steep = rise > run;
    let least = if rise < run { rise } else { run };
    let most = if steep { rise } else { run };
    // In the upper half the eighth of a turn is taken off: tan(φ - π/4) = (a - b)/(a + b), the difference exact.
    let upper = least + least > most;
    let t = (least - if upper { most } else { 0.0 }) / (most + if upper { least } else { 0.0 });
    // The octant says how many eighths of a turn there are besides, and whether the angle counts back from them.
    let (quarter, turned) = (if steep { 2.0 } else { 0.0 }, 1.0_f64.copysign(x));
    let (half, forth) = (2.0 - (turned + turned), 1.0 - quarter);
    let eighths = half + turned * (quarter + if upper { forth } else { 0.0 });
    let way = (turned * forth) * t;
    let bend = way * (t * t) * polynomial(t * t);
    let (whole, part) = (eighths * FRAC_PI_4, way + (eighths * EIGHTH_REST - bend));
    let angle = whole + part;
    // The whole is the larger, or nothing: the difference is exact.
    (angle, part - (angle - whole))
}

/// As [`super::sine`]'s, in three groups of four.
#[inline(always)]
fn polynomial(z: f64) -> f64 {
    let [a0, a1, a2, a3, b0, b1, b2, b3, c0, c1, c2, c3] = ARCTANGENT;
    let w = z * z;
    let four = |p: f64, q: f64, r: f64, s: f64| (p + z * q) + w * (r + z * s);
    let (a, b, c) = (four(a0, a1, a2, a3), four(b0, b1, b2, b3), four(c0, c1, c2, c3));
    a + (w * w) * (b + (w * w) * c)
}
