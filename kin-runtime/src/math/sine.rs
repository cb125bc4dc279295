//! Sine and cosine: a quarter turn taken off as often as it goes, then two polynomials.
//!
//! The remainder is taken with π/2 in three parts (W. J. Cody and W. Waite, Software Manual for the Elementary
//! Functions, 1980): the first two have 39 bits, so that their products with fewer than 2^14 quarters are exact, and no
//! multiple of π/2 below that is nearer to a double than 2^-60. Angles beyond go through [`super::remainder`].
//!
//! The usual way has no branch and no table: a loop over an array is a loop over vectors, and the same operations in
//! the same order give the same bits, one angle at a time or many. Constants: `tests/tools/minimax.py`.

use super::remainder::remainder;

/// Angles up to this size, some 4,000 turns, take the usual way.
const USUAL: f64 = 25_000.0;
/// 1.5·2^52: a number added to it is rounded to a whole one, which stands in its last bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;
/// π/2 in parts of 39, 39 and 53 bits.
const QUARTER: [f64; 3] = [1.5707963267923333, 2.5633441515905732e-12, 3.9455541665632055e-24];
/// (1 - sin(r)/r)/r² in powers of r², for |r| ≤ π/4; relative error of the sine 2^-57.9.
const SINE: [f64; 6] = [
    0.1666666666666663,
    -0.008333333333322118,
    0.00019841269829589544,
    -2.7557313621391296e-06,
    2.5050747764531712e-08,
    -1.5896230297698567e-10,
];
/// (cos(r) - 1 + r²/2)/r⁴ in powers of r², for |r| ≤ π/4; relative error of the cosine 2^-64.
const COSINE: [f64; 6] = [
    0.041666666666666595,
    -0.0013888888888873056,
    2.4801587288851768e-05,
    -2.7557314179311066e-07,
    2.087570084351791e-09,
    -1.1358536586759383e-11,
];

/// Sine and cosine of any number; NaN for infinities and NaN.
#[inline]
pub(super) fn sin_cos(x: f64) -> (f64, f64) {
    if is_usual(x) { usual(x) } else { unusual(x) }
}

/// The same bits without a branch, for angles of usual size; NaN for what is none.
#[inline(always)]
pub(super) fn straight(x: f64) -> (f64, f64) {
    usual(x)
}

/// Sines and cosines side by side, each with the bits that [`sin_cos`] gives; with the instructions of the caller.
#[inline(always)]
pub(super) fn sin_cos_lanes<const L: usize>(angles: [f64; L]) -> ([f64; L], [f64; L]) {
    let (mut sines, mut cosines) = (angles, angles);
    for (sine, cosine) in sines.iter_mut().zip(&mut cosines) {
        (*sine, *cosine) = usual(*sine);
    }
    // Without `all`, whose early return is a branch for each lane.
    if !angles.iter().fold(true, |usual, x| usual & is_usual(*x)) {
        repair(&angles, &mut sines, &mut cosines);
    }
    (sines, cosines)
}

/// Puts right what the usual way cannot know.
#[cold]
fn repair(angles: &[f64], sines: &mut [f64], cosines: &mut [f64]) {
    for ((x, sine), cosine) in angles.iter().zip(sines).zip(cosines) {
        (*sine, *cosine) = sin_cos(*x);
    }
}

/// The same of angles that come one by one.
#[inline(always)]
pub(super) fn sin_cos_all<const L: usize>(angles: [f64; L]) -> ([f64; L], [f64; L]) {
    let (mut sines, mut cosines) = (angles, angles);
    let (fours, rest) = angles.as_chunks::<4>();
    let (four_sines, rest_sines) = sines.as_chunks_mut::<4>();
    let (four_cosines, rest_cosines) = cosines.as_chunks_mut::<4>();
    for ((&[a, b, c, d], sines), cosines) in fours.iter().zip(four_sines).zip(four_cosines) {
        (*sines, *cosines) = four(a, b, c, d);
    }
    let (twos, rest) = rest.as_chunks::<2>();
    let (two_sines, rest_sines) = rest_sines.as_chunks_mut::<2>();
    let (two_cosines, rest_cosines) = rest_cosines.as_chunks_mut::<2>();
    for ((&[a, b], sines), cosines) in twos.iter().zip(two_sines).zip(two_cosines) {
        (*sines, *cosines) = two(a, b);
    }
    for ((x, sine), cosine) in rest.iter().zip(rest_sines).zip(rest_cosines) {
        (*sine, *cosine) = sin_cos(*x);
    }
    (sines, cosines)
}

/// Four angles at once. They come one by one, because a call has registers for them: numbers that were just written to
/// memory one at a time cannot be read from there as a vector without waiting.
#[inline(never)]
fn four(a: f64, b: f64, c: f64, d: f64) -> ([f64; 4], [f64; 4]) {
    // Without `&&`, which is a branch for each.
    if (is_usual(a) & is_usual(b)) & (is_usual(c) & is_usual(d)) {
        let ((sa, ca), (sb, cb), (sc, cc), (sd, cd)) = (usual(a), usual(b), usual(c), usual(d));
        ([sa, sb, sc, sd], [ca, cb, cc, cd])
    } else {
        let (([sa, sb], [ca, cb]), ([sc, sd], [cc, cd])) = (each(a, b), each(c, d));
        ([sa, sb, sc, sd], [ca, cb, cc, cd])
    }
}

/// Two angles at once.
#[inline(never)]
fn two(a: f64, b: f64) -> ([f64; 2], [f64; 2]) {
    if is_usual(a) & is_usual(b) {
        let ((sa, ca), (sb, cb)) = (usual(a), usual(b));
        ([sa, sb], [ca, cb])
    } else {
        each(a, b)
    }
}

/// Two angles, one after the other.
#[cold]
#[inline(never)]
fn each(a: f64, b: f64) -> ([f64; 2], [f64; 2]) {
    let ((sa, ca), (sb, cb)) = (sin_cos(a), sin_cos(b));
    ([sa, sb], [ca, cb])
}

/// Whether the usual way is right for an angle.
#[inline(always)]
fn is_usual(x: f64) -> bool {
    x.abs() <= USUAL
}

/// Sine and cosine of an angle of usual size; of others, nothing of meaning.
#[inline(always)]
fn usual(x: f64) -> (f64, f64) {
    let whole = x * core::f64::consts::FRAC_2_PI + WHOLE;
    let quarters = whole - WHOLE;
    let [first, second, third] = QUARTER;
    let (far, step) = (x - quarters * first, quarters * second);
    let near = far - step;
    turned(whole.to_bits(), near, quarters * third - ((far - near) - step))
}

/// Sine and cosine of an angle of unusual size, or of none.
#[cold]
fn unusual(x: f64) -> (f64, f64) {
    if !x.is_finite() {
        return (f64::NAN, f64::NAN);
    }
    let (quarters, r, over) = remainder(x);
    turned(quarters, r, over)
}

/// Sine and cosine of so many quarter turns and the angle r - over, |r| ≤ π/4. What is over is either less than a last
/// place of r, or r is so small that its square is nothing beside 1.
///
/// Differences are written such that -0 keeps its sign, and that what is small is rounded before it is added.
#[inline(always)]
fn turned(quarters: u64, r: f64, over: f64) -> (f64, f64) {
    let z = r * r;
    let half = 0.5 * z;
    let most = 1.0 - half;
    let sine = r - (over * most + (z * r) * polynomial(&SINE, z));
    let cosine = most + (((1.0 - most) - half) + (z * z * polynomial(&COSINE, z) + r * over));
    // An odd number of quarters exchanges the two; bit 1 of the number is the sign of the sine, that of the next
    // number the sign of the cosine. In bits, so that there is nothing to branch on.
    let (s, c) = (sine.to_bits(), cosine.to_bits());
    let exchange = (s ^ c) & (quarters & 1).wrapping_neg();
    let sign = |quarters: u64| (quarters & 2) << 62;
    (
        f64::from_bits(s ^ exchange ^ sign(quarters)),
        f64::from_bits(c ^ exchange ^ sign(quarters.wrapping_add(1))),
    )
}

/// A polynomial by pairs of coefficients, which wait for each other less than Horner's do.
#[inline(always)]
fn polynomial(c: &[f64; 6], z: f64) -> f64 {
    let w = z * z;
    (c[0] + z * c[1]) + w * ((c[2] + z * c[3]) + w * (c[4] + z * c[5]))
}
