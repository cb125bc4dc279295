//! Exact rational numbers of 127 bits over 127 bits.

use super::limbs;
use std::cmp::Ordering;
use std::fmt;

/// An exact rational number in lowest terms, its denominator positive.
///
/// Numerator and denominator lie within ±(2^127 − 1), so that a sign can always be changed. An operation whose
/// result (or a product on the way to it) leaves that range says `None`; there is no rounding.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Ratio {
    num: i128,
    den: i128,
}

impl Ratio {
    /// Zero.
    pub const ZERO: Ratio = Ratio { num: 0, den: 1 };
    /// One.
    pub const ONE: Ratio = Ratio { num: 1, den: 1 };

    /// `num / den` in lowest terms; `None` if `den` is zero or the result does not fit.
    pub fn new(num: i128, den: i128) -> Option<Ratio> {
        if den == 0 {
            return None;
        }
        let divisor = gcd(num.unsigned_abs(), den.unsigned_abs());
        let negative = (num < 0) != (den < 0);
        let size = i128::try_from(num.unsigned_abs() / divisor).ok()?;
        let den = i128::try_from(den.unsigned_abs() / divisor).ok()?;
        Some(Ratio { num: if negative { -size } else { size }, den })
    }

    /// A whole number.
    pub const fn integer(value: i64) -> Ratio {
        Ratio { num: value as i128, den: 1 }
    }

    /// The numerator, which carries the sign.
    pub const fn num(self) -> i128 {
        self.num
    }

    /// The denominator, at least 1.
    pub const fn den(self) -> i128 {
        self.den
    }

    /// Whether this is zero.
    pub const fn is_zero(self) -> bool {
        self.num == 0
    }

    /// Whether this is a whole number.
    pub const fn is_integer(self) -> bool {
        self.den == 1
    }

    /// −1, 0 or 1.
    pub const fn signum(self) -> i32 {
        self.num.signum() as i32
    }

    /// The absolute value.
    pub const fn abs(self) -> Ratio {
        Ratio { num: self.num.abs(), den: self.den }
    }

    /// The same size with the other sign.
    pub const fn neg(self) -> Ratio {
        Ratio { num: -self.num, den: self.den }
    }

    /// The sum.
    pub fn checked_add(self, other: Ratio) -> Option<Ratio> {
        // Over the least common denominator, so that the products stay as small as they can be.
        let common = gcd(self.den as u128, other.den as u128) as i128;
        let (left, right) = (self.den / common, other.den / common);
        let num = self.num.checked_mul(right)?.checked_add(other.num.checked_mul(left)?)?;
        // A factor that the sum shares with its denominator can only come from the common part.
        let shared = gcd(num.unsigned_abs(), common as u128);
        Ratio::new(num / shared as i128, left.checked_mul(other.den / shared as i128)?)
    }

    /// The difference.
    pub fn checked_sub(self, other: Ratio) -> Option<Ratio> {
        self.checked_add(other.neg())
    }

    /// The product.
    pub fn checked_mul(self, other: Ratio) -> Option<Ratio> {
        // Cancelled crosswise first, the product is in lowest terms and overflows only if it must.
        let down = gcd(self.num.unsigned_abs(), other.den as u128) as i128;
        let up = gcd(other.num.unsigned_abs(), self.den as u128) as i128;
        let num = (self.num / down).checked_mul(other.num / up)?;
        let den = (self.den / up).checked_mul(other.den / down)?;
        Ratio::new(num, den)
    }

    /// The quotient; `None` also of a division by zero.
    pub fn checked_div(self, other: Ratio) -> Option<Ratio> {
        if other.is_zero() {
            return None;
        }
        self.checked_mul(Ratio { num: other.den * other.num.signum(), den: other.num.abs() })
    }

    /// The root, where it is itself a ratio.
    pub fn exact_sqrt(self) -> Option<Ratio> {
        // In lowest terms a ratio is a square only if both its parts are.
        let (num, den) = (self.num.checked_isqrt()?, self.den.checked_isqrt()?);
        (num * num == self.num && den * den == self.den).then_some(Ratio { num, den })
    }

    /// The number that a decimal numeral stands for: `12`, `-0.4318`, `1e-3`, `1_000`, `.5`, `170.`.
    ///
    /// One sign at most, at least one digit, underscores only after a digit of the same run. `None` if the text is
    /// no such numeral, or if its value does not fit.
    pub fn parse_decimal(text: &str) -> Option<Ratio> {
        let (negative, text) = split_sign(text);
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, parse_exponent(exponent)?),
            None => (text, 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let mut digits = Digits::default();
        digits.push_run(whole)?;
        let before = digits.count;
        digits.push_run(fraction)?;
        if digits.count == 0 {
            return None;
        }
        let value = digits.scaled(exponent.saturating_sub(digits.count - before))?;
        Some(if negative { value.neg() } else { value })
    }
}

/// Takes one sign off the front.
fn split_sign(text: &str) -> (bool, &str) {
    match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    }
}

/// The power of ten after the `e`; a very large one saturates, which no value survives but zero.
fn parse_exponent(text: &str) -> Option<i64> {
    let (negative, text) = split_sign(text);
    let mut value = 0_i64;
    let mut empty = true;
    for byte in text.bytes() {
        match byte {
            b'0'..=b'9' => value = value.saturating_mul(10).saturating_add((byte - b'0') as i64),
            b'_' if !empty => continue,
            _ => return None,
        }
        empty = false;
    }
    let value = if negative { -value } else { value };
    (!empty).then_some(value)
}

/// Decimal digits read so far. Zeros wait until a digit follows, so that those at the end cost no room.
#[derive(Default)]
struct Digits {
    value: i128,
    waiting: u32,
    count: i64,
    overflowed: bool,
}

impl Digits {
    /// Reads a run of digits; `None` if something else is in it.
    fn push_run(&mut self, run: &str) -> Option<()> {
        let before = self.count;
        for byte in run.bytes() {
            match byte {
                b'0'..=b'9' => self.push((byte - b'0') as i128),
                b'_' if self.count > before => {}
                _ => return None,
            }
        }
        Some(())
    }

    fn push(&mut self, digit: i128) {
        self.count += 1;
        self.waiting = self.waiting.saturating_add(1);
        if digit == 0 {
            return;
        }
        let scale = if self.value == 0 { Some(1) } else { 10_i128.checked_pow(self.waiting) };
        let value =
            scale.and_then(|scale| self.value.checked_mul(scale)).and_then(|value| value.checked_add(digit));
        self.overflowed |= value.is_none();
        self.value = value.unwrap_or(0);
        self.waiting = 0;
    }

    /// The digits times a power of ten.
    fn scaled(&self, exponent: i64) -> Option<Ratio> {
        if self.overflowed {
            return None;
        }
        if self.value == 0 {
            return Some(Ratio::ZERO);
        }
        let exponent = exponent.saturating_add(self.waiting as i64);
        if exponent >= 0 {
            let scale = 10_i128.checked_pow(u32::try_from(exponent).ok()?)?;
            return Some(Ratio { num: self.value.checked_mul(scale)?, den: 1 });
        }
        let (mut num, mut den) = (self.value, 1_i128);
        let mut left = exponent;
        // Ends soon whatever the exponent: 127 bits lose or gain a factor 2 only so often.
        while left < 0 {
            if num % 2 == 0 {
                num /= 2
            } else {
                den = den.checked_mul(2)?
            }
            if num % 5 == 0 {
                num /= 5
            } else {
                den = den.checked_mul(5)?
            }
            left += 1;
        }
        Ratio::new(num, den)
    }
}

/// The greatest common divisor; of 0 and 0 it is 1, so that one may divide by it.
fn gcd(a: u128, b: u128) -> u128 {
    let (mut a, mut b) = (a, b);
    // Euclid's remainders at least halve every two steps, so that this is bounded by twice the bits.
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

/// The two limbs of an integer that is not negative.
fn halves(value: i128) -> [u64; 2] {
    let value = value.unsigned_abs();
    [value as u64, (value >> 64) as u64]
}

impl Ord for Ratio {
    fn cmp(&self, other: &Ratio) -> Ordering {
        if self.signum() != other.signum() {
            return self.signum().cmp(&other.signum());
        }
        let left: [u64; 4] = limbs::multiply(&halves(self.num), &halves(other.den));
        let right: [u64; 4] = limbs::multiply(&halves(other.num), &halves(self.den));
        let sizes = limbs::compare(&left, &right);
        if self.num < 0 { sizes.reverse() } else { sizes }
    }
}

impl PartialOrd for Ratio {
    fn partial_cmp(&self, other: &Ratio) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Default for Ratio {
    fn default() -> Ratio {
        Ratio::ZERO
    }
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_integer() { write!(f, "{}", self.num) } else { write!(f, "{}/{}", self.num, self.den) }
    }
}
