//! Angles in (-π, π]: whole turns taken off in two parts, so that the last bit stays.

use super::{Float, Real, abs, is_nan};

/// Half a turn, π rounded.
#[inline(always)]
pub fn half_turn<T: Float>() -> T {
    T::TURN.0 * T::lit(0.5)
}

/// The same angle in (-π, π].
///
/// The turn is taken off in two parts, so that an angle within a few turns keeps its last bit. An angle of more
/// than a million turns has no meaningful last bits; it still gives a value of the range. NaN and infinities give NaN.
pub fn wrap<T: Float>(angle: T) -> T {
    let half = half_turn::<T>();
    if angle > -half && angle <= half {
        return angle;
    }
    if abs(angle) <= T::TURN.0 {
        return within_a_turn(angle);
    }
    let turns = Float::floor((angle + half) / T::TURN.0);
    if abs(turns) >= T::lit(1e6) || is_nan(turns) {
        let (s, c) = Real::sin_cos(angle);
        return into_range(Float::atan2(s, c));
    }
    into_range((angle - turns * T::TURN.0) - turns * T::TURN.1)
}

/// The same angles in (-π, π], side by side.
#[inline(always)]
pub fn wrap_all<T: Float, const L: usize>(angles: [T; L]) -> [T; L] {
    if in_range(&angles) { angles } else { wrapped(angles) }
}

/// As [`wrap_all`], where it has something to do.
#[inline(never)]
fn wrapped<T: Float, const L: usize>(mut angles: [T; L]) -> [T; L] {
    let (all, mut near) = (angles, true);
    for angle in &mut angles {
        near &= abs(*angle) <= T::TURN.0;
        *angle = within_a_turn(*angle);
    }
    if !near {
        for (angle, from) in angles.iter_mut().zip(all) {
            *angle = wrap(from);
        }
    }
    angles
}

/// Whether all angles are in (-π, π]; without an early return, which is a branch for each lane.
#[inline(always)]
fn in_range<T: Float, const L: usize>(angles: &[T; L]) -> bool {
    let half = half_turn::<T>();
    let mut all = true;
    for angle in angles {
        all &= (*angle > -half) & (*angle <= half);
    }
    all
}

/// The same angle in (-π, π], if it is within a turn: as [`into_range`], without a branch.
#[inline(always)]
fn within_a_turn<T: Float>(angle: T) -> T {
    if angle > half_turn::<T>() { wrap_down(angle).0 } else { wrap_up(angle).0 }
}

/// An angle of at most half a turn in (-π, π], without a branch: minus half a turn becomes half a turn.
#[inline(always)]
pub(crate) fn without_minus_half<T: Float>(angle: T) -> T {
    let half = half_turn::<T>();
    if angle <= -half { half } else { angle }
}

/// An angle of at least minus a turn and at most half a turn in (-π, π], as [`wrap`], without a branch. And what the value is
/// more than the angle, but for turns: exactly, as the angle is at least half of what is taken off.
#[inline(always)]
pub(crate) fn wrap_up<T: Float>(angle: T) -> (T, T) {
    let half = half_turn::<T>();
    let moved = angle + T::TURN.0;
    let forth = moved + T::TURN.1;
    let forth = if forth <= half { forth } else { half };
    if angle <= -half { (forth, (forth - moved) - T::TURN.1) } else { (angle, T::lit(0.0)) }
}

/// An angle of more than minus half a turn and at most a turn in (-π, π], as [`wrap`], without a branch. And what the value is
/// more than the angle, as of [`wrap_up`].
#[inline(always)]
pub(crate) fn wrap_down<T: Float>(angle: T) -> (T, T) {
    let half = half_turn::<T>();
    let moved = angle - T::TURN.0;
    let back = moved - T::TURN.1;
    let back = if back > -half { back } else { half };
    if angle > half { (back, (back - moved) + T::TURN.1) } else { (angle, T::lit(0.0)) }
}

/// Puts an angle that round-off left at or just beyond the ends of (-π, π] back into it.
fn into_range<T: Float>(angle: T) -> T {
    let half = half_turn::<T>();
    if angle > half {
        let back = (angle - T::TURN.0) - T::TURN.1;
        if back > -half { back } else { half }
    } else if angle <= -half {
        let back = (angle + T::TURN.0) + T::TURN.1;
        if back <= half { back } else { half }
    } else {
        angle
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    #[test]
    fn wrapping_keeps_the_angle_and_its_range() {
        for k in -40..=40 {
            let x = 0.1 * f64::from(k);
            let y = wrap(x);
            assert!(y > -PI && y <= PI);
            assert!((libm::sin(x) - libm::sin(y)).abs() < 1e-15);
            assert!((libm::cos(x) - libm::cos(y)).abs() < 1e-15);
        }
        assert_eq!(wrap(-PI), PI);
        assert_eq!(wrap(PI), PI);
        // 10 - 4π to the last bit, though 4π is not a double.
        assert_eq!(wrap(10.0), -2.566_370_614_359_173);
        assert!(wrap(f64::NAN).is_nan() && wrap(f64::INFINITY).is_nan());
        let (half, mut bits) = (core::f32::consts::PI, 1_u32);
        for _ in 0..1_000_000 {
            bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let y = wrap(f32::from_bits(bits));
            assert!(y.is_nan() || (y > -half && y <= half));
        }
    }

    #[test]
    fn without_a_branch_it_is_the_same_angle() {
        let half = half_turn::<f64>();
        let near = [0.0, 1e-300, 1e-20, 4.5e-16, 1e-9, 0.3, 1.0];
        let ends = [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0].map(|turns| turns * half);
        for angle in ends.iter().flat_map(|end| near.iter().flat_map(move |by| [end - by, end + by])) {
            let turns = libm::floor((angle + half) / f64::TURN.0);
            let expected = into_range((angle - turns * f64::TURN.0) - turns * f64::TURN.1);
            let same = |found: f64| found.to_bits() == expected.to_bits();
            assert!(same(wrap(angle)), "{angle}");
            assert!(angle.abs() > half || same(without_minus_half(angle)), "{angle}");
            assert!(angle > half || angle < -2.5 * half || same(wrap_up(angle).0), "{angle}");
            assert!(angle <= -half || angle > 2.5 * half || same(wrap_down(angle).0), "{angle}");
        }
        // Side by side each has the bits that it has alone, whatever the others are.
        for other in [0.0, -3.5, 100.0, f64::NAN] {
            let all = [3.0 * half, other, -3.0 * half, 1.5 * half];
            assert!(
                wrap_all(all).into_iter().zip(all).all(|(found, x)| found.to_bits() == wrap(x).to_bits())
            );
        }
        assert!(wrap_up(f64::NAN).0.is_nan() && wrap_down(f64::NAN).0.is_nan());
        assert!(without_minus_half(f64::NAN).is_nan());
    }

    #[test]
    fn the_turn_is_two_pi_in_two_parts() {
        assert!((f64::from(f32::TURN.0) + f64::from(f32::TURN.1) - 2.0 * PI).abs() < 1e-13);
        // sin(2π rounded) = -(what is left), to full precision
        assert!((libm::sin(f64::TURN.0) + f64::TURN.1).abs() < 1e-30);
    }
}
