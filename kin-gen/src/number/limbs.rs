//! Unsigned integers of a fixed number of 64-bit limbs, the least significant first.
//!
//! Plain counted loops throughout: a proc-macro is built without optimisation, where an iterator chain costs ten
//! times the loop it stands for.

use std::cmp::Ordering;

/// Adds `b` to `a`; says whether a carry left the top limb.
pub(super) fn add<const N: usize>(a: &mut [u64; N], b: &[u64; N]) -> bool {
    let mut carry = false;
    let mut i = 0;
    while i < N {
        let (sum, first) = a[i].overflowing_add(b[i]);
        let (sum, second) = sum.overflowing_add(carry as u64);
        a[i] = sum;
        carry = first || second;
        i += 1;
    }
    carry
}

/// Subtracts `b` from `a`; says whether a borrow left the top limb.
pub(super) fn subtract<const N: usize>(a: &mut [u64; N], b: &[u64; N]) -> bool {
    let mut borrow = false;
    let mut i = 0;
    while i < N {
        let (rest, first) = a[i].overflowing_sub(b[i]);
        let (rest, second) = rest.overflowing_sub(borrow as u64);
        a[i] = rest;
        borrow = first || second;
        i += 1;
    }
    borrow
}

/// Adds one; says whether a carry left the top limb.
pub(super) fn increment<const N: usize>(a: &mut [u64; N]) -> bool {
    let mut i = 0;
    while i < N {
        a[i] = a[i].wrapping_add(1);
        if a[i] != 0 {
            return false;
        }
        i += 1;
    }
    true
}

/// Subtracts one; says whether a borrow left the top limb.
pub(super) fn decrement<const N: usize>(a: &mut [u64; N]) -> bool {
    let mut i = 0;
    while i < N {
        a[i] = a[i].wrapping_sub(1);
        if a[i] != u64::MAX {
            return false;
        }
        i += 1;
    }
    true
}

/// The order of two integers.
pub(super) fn compare<const N: usize>(a: &[u64; N], b: &[u64; N]) -> Ordering {
    let mut i = N;
    while i > 0 {
        i -= 1;
        if a[i] != b[i] {
            return a[i].cmp(&b[i]);
        }
    }
    Ordering::Equal
}

/// The number of zero bits above the highest one; `64 * N` of zero.
pub(super) fn leading_zeros<const N: usize>(a: &[u64; N]) -> u32 {
    let mut zeros = 0;
    let mut i = N;
    while i > 0 {
        i -= 1;
        if a[i] != 0 {
            return zeros + a[i].leading_zeros();
        }
        zeros += 64;
    }
    zeros
}

/// Whether any of the lowest `count` limbs is not zero.
pub(super) fn any_below<const N: usize>(a: &[u64; N], count: usize) -> bool {
    let mut i = 0;
    while i < count && i < N {
        if a[i] != 0 {
            return true;
        }
        i += 1;
    }
    false
}

/// `a · 2^by`, what leaves the top limb being lost.
pub(super) fn shift_left<const N: usize>(a: &[u64; N], by: u32) -> [u64; N] {
    let (limbs, bits) = ((by / 64) as usize, by % 64);
    let mut out = [0; N];
    let mut i = limbs;
    while i < N {
        out[i] = a[i - limbs] << bits;
        if bits > 0 && i > limbs {
            out[i] |= a[i - limbs - 1] >> (64 - bits);
        }
        i += 1;
    }
    out
}

/// `⌊a / 2^by⌋`, and whether the remainder is not zero.
pub(super) fn shift_right<const N: usize>(a: &[u64; N], by: u32) -> ([u64; N], bool) {
    let (limbs, bits) = ((by / 64) as usize, by % 64);
    let mut out = [0; N];
    let mut i = limbs;
    while i < N {
        out[i - limbs] = a[i] >> bits;
        if bits > 0 && i + 1 < N {
            out[i - limbs] |= a[i + 1] << (64 - bits);
        }
        i += 1;
    }
    let cut = limbs < N && bits > 0 && a[limbs] << (64 - bits) != 0;
    (out, cut || any_below(a, limbs))
}

/// The exact product; `C` is `A + B`.
pub(super) fn multiply<const A: usize, const B: usize, const C: usize>(
    a: &[u64; A],
    b: &[u64; B],
) -> [u64; C] {
    const { assert!(C == A + B, "a product has the limbs of both factors") };
    let mut out = [0; C];
    let mut i = 0;
    while i < A {
        let factor = a[i] as u128;
        let mut carry = 0;
        let mut j = 0;
        // A sparse factor, such as a small integer, is mostly zero limbs.
        while factor != 0 && j < B {
            let sum = factor * b[j] as u128 + out[i + j] as u128 + carry;
            out[i + j] = sum as u64;
            carry = sum >> 64;
            j += 1;
        }
        out[i + B] = carry as u64;
        i += 1;
    }
    out
}

/// Divides by one limb, which must not be zero, in place; the remainder is dropped.
pub(super) fn divide_small<const N: usize>(a: &mut [u64; N], divisor: u64) {
    let mut rest = 0;
    let mut i = N;
    while i > 0 && divisor != 0 {
        i -= 1;
        let part = (rest << 64) | a[i] as u128;
        a[i] = (part / divisor as u128) as u64;
        rest = part % divisor as u128;
    }
}

/// `⌊a · 2^320 / d⌋`, and whether there is a remainder. The top bit of `d` must be set.
///
/// Knuth, The Art of Computer Programming 2, 4.3.1, algorithm D.
pub(super) fn divide(a: &[u64; 4], d: &[u64; 4]) -> ([u64; 6], bool) {
    let mut rest = [0; 10];
    rest[5..9].copy_from_slice(a);
    let mut quotient = [0; 6];
    let mut j = 6;
    while j > 0 {
        j -= 1;
        let mut guess = guess_limb([rest[j + 4], rest[j + 3], rest[j + 2]], d);
        if subtract_multiple(&mut rest, j, d, guess) {
            guess -= 1;
            add_back(&mut rest, j, d);
        }
        quotient[j] = guess;
    }
    (quotient, any_below(&rest, 10))
}

/// One limb of a quotient from the three top limbs of what is left: right, or one too large.
fn guess_limb(top: [u64; 3], d: &[u64; 4]) -> u64 {
    let head = ((top[0] as u128) << 64) | top[1] as u128;
    let (first, second) = (d[3] as u128, d[2] as u128);
    let (mut guess, mut rest) = if top[0] >= d[3] {
        (u64::MAX as u128, head - u64::MAX as u128 * first)
    } else {
        (head / first, head % first)
    };
    // Twice at most, because the divisor's top bit is set.
    while rest <= u64::MAX as u128 && guess * second > ((rest << 64) | top[2] as u128) {
        guess -= 1;
        rest += first;
    }
    guess as u64
}

/// Takes `guess · d` from the five limbs of `rest` at `j`; says whether that was too much.
fn subtract_multiple(rest: &mut [u64; 10], j: usize, d: &[u64; 4], guess: u64) -> bool {
    let mut carry = 0;
    let mut i = 0;
    while i < 4 {
        let product = guess as u128 * d[i] as u128 + carry;
        let (left, borrow) = rest[j + i].overflowing_sub(product as u64);
        rest[j + i] = left;
        carry = (product >> 64) + borrow as u128;
        i += 1;
    }
    let (left, borrow) = rest[j + 4].overflowing_sub(carry as u64);
    rest[j + 4] = left;
    borrow
}

/// Gives `d` back to the five limbs of `rest` at `j`.
fn add_back(rest: &mut [u64; 10], j: usize, d: &[u64; 4]) {
    let mut carry = 0;
    let mut i = 0;
    while i < 4 {
        let sum = rest[j + i] as u128 + d[i] as u128 + carry;
        rest[j + i] = sum as u64;
        carry = sum >> 64;
        i += 1;
    }
    rest[j + 4] = rest[j + 4].wrapping_add(carry as u64);
}
