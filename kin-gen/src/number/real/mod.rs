//! Binary floating point with 256 bits, in integer arithmetic.

mod arithmetic;
mod round;
mod trig;

pub(super) use trig::turned;

use super::limbs;
use std::cmp::Ordering;
use std::fmt;

/// π to 768 bits, the first of which has the weight 2.
const PI: [u64; 12] = [
    0xee386bfb5a899fa5,
    0x0bff5cb6f406b7ed,
    0xf44c42e9a637ed6b,
    0xe485b576625e7ec6,
    0x4fe1356d6d51c245,
    0x302b0a6df25f1437,
    0xef9519b3cd3a431b,
    0x514a08798e3404dd,
    0x020bbea63b139b22,
    0x29024e088a67cc74,
    0xc4c6628b80dc1cd1,
    0xc90fdaa22168c234,
];

/// A real number rounded to 256 bits.
///
/// `+ − × ÷ √` and the conversions are correctly rounded (to nearest, ties to even); sine, cosine and `atan2` are
/// within a few units of the last bit. There is one zero, no infinity and no NaN: what would be larger than
/// 2^(2^30) is that bound, what would be smaller than its inverse is zero, and what has no value (a division by
/// zero, the root of a negative number) is zero. Callers who must know ask first; [`Scalar`](super::Scalar) does.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Real {
    /// Never set on zero.
    negative: bool,
    /// The weight of the mantissa's top bit is `2^exponent`; 0 of zero. Within ±[`EXPONENT_LIMIT`].
    exponent: i32,
    /// The top bit is set, except of zero.
    mantissa: [u64; 4],
}

/// Far from the ends of `i32`, so that sums of exponents need no care.
const EXPONENT_LIMIT: i64 = 1 << 30;

impl Real {
    /// Zero.
    pub const ZERO: Real = Real { negative: false, exponent: 0, mantissa: [0; 4] };
    /// One.
    pub const ONE: Real = Real::power_of_two(0);

    /// π.
    pub const fn pi() -> Real {
        // The limb below is 0x4fe1…, less than half: cutting it off rounds to nearest.
        Real { negative: false, exponent: 1, mantissa: [PI[8], PI[9], PI[10], PI[11]] }
    }

    const fn power_of_two(exponent: i32) -> Real {
        Real { negative: false, exponent, mantissa: [0, 0, 0, 1 << 63] }
    }

    /// Whether this is exactly zero.
    pub const fn is_zero(self) -> bool {
        self.mantissa[3] == 0
    }

    /// Whether the size is below 2^-160: what zero means for irrational constants, whose rounding errors are far
    /// below that and whose differences, where they do differ, are far above.
    pub const fn is_negligible(self) -> bool {
        self.is_zero() || self.exponent < -160
    }

    /// −1, 0 or 1.
    pub const fn signum(self) -> i32 {
        match (self.is_zero(), self.negative) {
            (true, _) => 0,
            (_, true) => -1,
            _ => 1,
        }
    }

    /// The absolute value.
    pub const fn abs(self) -> Real {
        Real { negative: false, ..self }
    }

    /// Times 2^by, exactly but for the range.
    fn scaled(self, by: i32) -> Real {
        Real::within_range(self.negative, self.exponent as i64 + by as i64, self.mantissa)
    }

    /// Puts a mantissa that is zero or has its top bit set within the range.
    fn within_range(negative: bool, exponent: i64, mantissa: [u64; 4]) -> Real {
        if mantissa[3] == 0 || exponent < -EXPONENT_LIMIT {
            Real::ZERO
        } else if exponent > EXPONENT_LIMIT {
            Real { negative, exponent: EXPONENT_LIMIT as i32, mantissa: [u64::MAX; 4] }
        } else {
            Real { negative, exponent: exponent as i32, mantissa }
        }
    }

    fn compare_sizes(&self, other: &Real) -> Ordering {
        match (self.is_zero(), other.is_zero()) {
            (true, true) => Ordering::Equal,
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
            (false, false) => self
                .exponent
                .cmp(&other.exponent)
                .then_with(|| limbs::compare(&self.mantissa, &other.mantissa)),
        }
    }
}

impl Ord for Real {
    fn cmp(&self, other: &Real) -> Ordering {
        match self.signum().cmp(&other.signum()) {
            Ordering::Equal if self.negative => other.compare_sizes(self),
            Ordering::Equal => self.compare_sizes(other),
            unequal => unequal,
        }
    }
}

impl PartialOrd for Real {
    fn partial_cmp(&self, other: &Real) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Default for Real {
    fn default() -> Real {
        Real::ZERO
    }
}

impl fmt::Debug for Real {
    /// All bits, as a hexadecimal floating-point numeral with a fraction of 256 bits, and the nearest double.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.negative { "-" } else { "" };
        write!(f, "{sign}0x0.")?;
        for limb in self.mantissa.iter().rev() {
            write!(f, "{limb:016x}")?;
        }
        write!(f, "p{} ({:e})", self.exponent as i64 + 1, self.to_f64())
    }
}
