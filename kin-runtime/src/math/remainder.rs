//! What is left of a huge angle when quarter turns are taken off.
//!
//! The angle is multiplied by as many bits of 2/π as matter: those before count whole turns, those after are below the
//! last bit of any result (M. H. Payne and R. N. Hanek, Radian reduction for trigonometric functions, 1983). All of it
//! in integers. Constants: `tests/tools/minimax.py`.

/// The first 1344 bits of 2/π behind the binary point, after 64 zeros; beyond its end no double has use of it.
const TWO_OVER_PI: [u64; 22] = [
    0,
    0xa2f9_836e_4e44_1529,
    0xfc27_57d1_f534_ddc0,
    0xdb62_9599_3c43_9041,
    0xfe51_63ab_debb_c561,
    0xb724_6e3a_424d_d2e0,
    0x0649_2eea_09d1_921c,
    0xfe1d_eb1c_b129_a73e,
    0xe882_35f5_2ebb_4484,
    0xe99c_7026_b45f_7e41,
    0x3991_d639_8353_39f4,
    0x9c84_5f8b_bdf9_283b,
    0x1ff8_97ff_de05_980f,
    0xef2f_118b_5a0a_6d1f,
    0x6d36_7ecf_27cb_09b7,
    0x4f46_3f66_9e5f_ea2d,
    0x7527_bac7_ebe5_f17b,
    0x3d07_39f7_8a52_92ea,
    0x6bfb_5fb1_1f8d_5d08,
    0x5603_3046_fc7b_6bab,
    0xf0cf_bc20_9af4_361d,
    0xa9e3_9161_5ee6_1b08,
];
/// π/2 times 2^126.
const QUARTER: u128 = 0x6487_ed51_10b4_611a_6263_3145_c06e_0e69;

/// The number of quarter turns nearest to `x`, modulo 4, and the angle r - over that is left, |r| ≤ π/4 and `over` the
/// rounding error of r. For finite numbers of size 1 and more.
pub(super) fn remainder(x: f64) -> (u64, f64, f64) {
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    let mantissa = (x.to_bits() & ((1 << 52) - 1)) | (1 << 52);
    // |x| is mantissa·2^(exponent - 1075). The bit of 2/π that counts two quarters is the first of use.
    let [high, middle, low, least] = product(mantissa, exponent.saturating_sub(1013));
    let below = |word: u64, next: u64| (word << 2) | (next >> 62);
    let mut fraction = [below(high, middle), below(middle, low), below(low, least)];
    // To nearest: from half a quarter on, it is what is missing to the next one.
    let missing = fraction[0] >> 63 == 1;
    if missing {
        fraction = fraction.map(|word| !word);
    }
    let quarters = (high >> 62) + u64::from(missing);
    let (size, over) = radians(fraction);
    let (r, over) = if missing != (x < 0.0) { (-size, -over) } else { (size, over) };
    (if x < 0.0 { quarters.wrapping_neg() } else { quarters }, r, over)
}

/// The mantissa times 256 bits of 2/π from bit `start` on, modulo 2^256; the most significant word first.
fn product(mantissa: u64, start: u64) -> [u64; 4] {
    let (word, shift) = (start / 64, start % 64);
    let at = |index: u64| {
        let index = usize::try_from(index).unwrap_or(usize::MAX);
        u128::from(TWO_OVER_PI.get(index).copied().unwrap_or(0))
    };
    let mut product = [0; 4];
    let mut carry = 0;
    for (digit, index) in product.iter_mut().rev().zip((0..4).rev()) {
        let both = (at(word + index) << 64) | at(word + index + 1);
        let bits = (both << shift) >> 64;
        carry += u128::from(mantissa) * bits;
        *digit = carry as u64;
        carry >>= 64;
    }
    product
}

/// A fraction of a quarter turn, 192 bits of it, in radians: the nearest double and what that is too much.
fn radians([first, second, third]: [u64; 3]) -> (f64, f64) {
    let leading = (u128::from(first) << 64) | u128::from(second);
    // No double is so near to a multiple of π/2 that more than 62 bits are zero; `min` is for whoever reads on.
    let zeros = leading.leading_zeros().min(127);
    let fraction = (leading << zeros) | (((u128::from(third) << 64) >> 1) >> (127 - zeros));
    let size = high_half(fraction, QUARTER);
    let nearest = size as f64;
    let over = (nearest as u128).wrapping_sub(size) as i128;
    let unit = f64::from_bits((1023 - 126 - u64::from(zeros)) << 52);
    (nearest * unit, over as f64 * unit)
}

/// The upper 128 bits of a product, up to three units too small.
fn high_half(x: u128, y: u128) -> u128 {
    let low = u128::from(u64::MAX);
    let across = (((x >> 64) * (y & low)) >> 64) + (((x & low) * (y >> 64)) >> 64);
    (x >> 64) * (y >> 64) + across
}
