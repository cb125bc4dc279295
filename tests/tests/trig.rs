//! The trigonometric kernel: its errors, its special values, and lanes that have the bits of their numbers alone.

use kin_gen::number::Real as Reference;
use kin_runtime::prelude::*;
use kin_runtime::{Lanes, math};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use tests::sample::Sampler;
use tests::trig::{DRAWS, double, single};

#[test]
fn sine_and_cosine_are_within_one_last_place_and_arctangents_within_two() {
    for (seed, (name, draw)) in DRAWS.iter().enumerate() {
        for errors in [double(*draw, 20_000, seed as u64), single(*draw, 20_000, seed as u64)] {
            let [sine, cosine, angle] = errors.largest;
            assert!(sine <= 1 && cosine <= 1 && angle <= 2, "{name}: {errors:?}");
        }
    }
}

/// The judge of the other tests is C; this one is our own, with 256 bits.
#[test]
fn errors_by_256_bits_are_below_one_last_place_and_two() {
    let mut sampler = Sampler::new(3);
    let error = |found: f64, exact: Reference| {
        let place = found.abs().next_up() - found.abs();
        (Reference::from_f64(found).unwrap() - exact).to_f64().abs() / place
    };
    for _ in 0..2_000 {
        let (x, y) = (sampler.between(-7.0, 7.0), sampler.between(-7.0, 7.0));
        let [exact_x, exact_y] = [x, y].map(|x| Reference::from_f64(x).unwrap());
        let ((sine, cosine), (exact_sine, exact_cosine)) = (math::sin_cos(x), exact_x.sin_cos());
        assert!(error(sine, exact_sine) < 0.9 && error(cosine, exact_cosine) < 0.9, "{x}");
        let exact = Reference::atan2(exact_y, exact_x);
        assert!(error(math::atan2(y, x), exact) < 1.9, "{y} {x}");
        // What rounding took off the angle, and whoever knows it, knows the angle better.
        let (angle, lost) = f64::atan2_straight(y, x);
        let sum = Reference::from_f64(angle).unwrap() + Reference::from_f64(lost).unwrap();
        assert!((sum - exact).to_f64().abs() < 0.5 * f64::EPSILON, "{y} {x}");
        let (angle, lost) = f32::atan2_straight(y as f32, x as f32);
        let exact = libm::atan2(f64::from(y as f32), f64::from(x as f32));
        assert!((f64::from(angle) + f64::from(lost) - exact).abs() < 1e-3 * f64::from(f32::EPSILON));
    }
}

#[test]
fn zeros_infinities_and_nan() {
    let inf = f64::INFINITY;
    for (y, x, angle) in [
        (0.0, 1.0, 0.0),
        (0.0, 0.0, 0.0),
        (0.0, -0.0, PI),
        (0.0, -1.0, PI),
        (1.0, 0.0, FRAC_PI_2),
        (1.0, -0.0, FRAC_PI_2),
        (1.0, inf, 0.0),
        (1.0, -inf, PI),
        (inf, 1.0, FRAC_PI_2),
        (inf, -1.0, FRAC_PI_2),
        (inf, inf, FRAC_PI_4),
        (inf, -inf, 3.0 * FRAC_PI_4),
        (f64::MAX, f64::MAX, FRAC_PI_4),
        (f64::MAX, -f64::MAX, 3.0 * FRAC_PI_4),
        (5e-324, 5e-324, FRAC_PI_4),
        (5e-324, f64::MAX, 0.0),
    ] {
        assert_eq!(math::atan2(y, x).to_bits(), angle.to_bits(), "{y} {x}");
        assert_eq!(math::atan2(-y, x).to_bits(), (-angle).to_bits(), "-{y} {x}");
        // What single precision has too: the smallest double is zero there.
        if y != 5e-324 {
            let (y, x, angle) = (y as f32, x as f32, angle as f32);
            assert_eq!(math::atan2(y, x).to_bits(), angle.to_bits(), "{y} {x}");
            assert_eq!(math::atan2(-y, x).to_bits(), (-angle).to_bits(), "-{y} {x}");
        }
    }
    for (y, x) in [(f64::NAN, 1.0), (1.0, f64::NAN), (f64::NAN, inf), (-inf, -f64::NAN), (0.0, -f64::NAN)] {
        assert_eq!(math::atan2(y, x).to_bits(), f64::NAN.to_bits(), "one NaN on every target");
    }
    let (sine, cosine) = math::sin_cos(-0.0_f64);
    assert!(sine == 0.0 && sine.is_sign_negative() && cosine == 1.0);
    for x in [inf, -inf, f64::NAN, -f64::NAN] {
        let (sine, cosine) = math::sin_cos(x);
        assert!([sine, cosine].iter().all(|x| x.to_bits() == f64::NAN.to_bits()), "one NaN on every target");
    }
}

#[test]
fn a_lane_that_is_huge_or_nothing_leaves_the_others_alone() {
    let angles = [0.1, 1e300, f64::NAN, -2.5, f64::NEG_INFINITY, 25_000.1, -0.0, f64::MAX];
    // As lanes; and one by one, as a program has its turns: fours, a two and a rest.
    let [a, b, c, d, e, f, g, h] = angles;
    same_alone(angles, math::sin_cos_lanes(angles));
    same_alone(angles, Real::sin_cos_all(angles));
    same_alone([b, a, c, d, e, f, g], Real::sin_cos_all([b, a, c, d, e, f, g]));
    same_alone([h, a, d, g, c, d], Real::sin_cos_all([h, a, d, g, c, d]));
    same_alone([e], Real::sin_cos_all([e]));
    let odd = [1e308, 0.0, f64::NAN, -1.0, f64::INFINITY, 2.0, -0.0];
    for (y, x) in odd.iter().flat_map(|y| odd.map(|x| (*y, x))) {
        let (ys, xs) = ([1.0, y, -0.5, y, 0.25, y, y], [2.0, x, 0.0, x, -3.0, 1.0, x]);
        for ((y, x), angle) in ys.into_iter().zip(xs).zip(math::atan2_lanes(ys, xs)) {
            assert_eq!(angle.to_bits(), math::atan2(y, x).to_bits(), "{y} {x}");
        }
    }
}

fn same_alone<const L: usize>(angles: [f64; L], (sines, cosines): ([f64; L], [f64; L])) {
    for (x, (s, c)) in angles.iter().zip(sines.iter().zip(cosines)) {
        let (sine, cosine) = math::sin_cos(*x);
        assert_eq!((s.to_bits(), c.to_bits()), (sine.to_bits(), cosine.to_bits()), "{x}");
    }
}

/// Lanes of configurations, and the bits that each of them has alone.
fn lanes_are_alone<T: Real, const N: usize, const L: usize>(
    arm: &impl Arm<N>,
    sampler: &mut Sampler,
    bits: impl Fn(T) -> u64,
) {
    let q: [[T; N]; L] = std::array::from_fn(|_| std::array::from_fn(|_| T::lit(sampler.between(-7.0, 7.0))));
    let lanes: [Lanes<T, L>; N] = std::array::from_fn(|j| Lanes(std::array::from_fn(|lane| q[lane][j])));
    let (poses, jacobians) = arm.fk_jacobian(&Joints::from(lanes));
    let fk = arm.fk(&Joints::from(lanes));
    let frames = arm.frames(&Joints::from(lanes));
    for (lane, q) in q.into_iter().enumerate() {
        let q = Joints::from(q);
        let same = |many: &[Lanes<T, L>], alone: &[T]| {
            let equal = |(many, alone): (&Lanes<T, L>, &T)| bits(many.0[lane]) == bits(*alone);
            assert!(many.len() == alone.len() && many.iter().zip(alone).all(equal), "lane {lane}");
        };
        let pose = |many: &Pose<Lanes<T, L>>, alone: &Pose<T>| {
            same(many.rotation.matrix().as_slice(), alone.rotation.matrix().as_slice());
            same(many.translation.vector.as_slice(), alone.translation.vector.as_slice());
        };
        let (alone, jacobian) = arm.fk_jacobian(&q);
        pose(&poses, &alone);
        same(jacobians.as_slice(), jacobian.as_slice());
        pose(&fk, &arm.fk(&q));
        frames.iter().zip(&arm.frames(&q)).for_each(|(many, alone)| pose(many, alone));
    }
}

#[test]
fn lanes_of_every_arm_have_the_bits_that_one_configuration_has() {
    let mut sampler = Sampler::new(5);
    macro_rules! arms {
        ($($Arm:ident $file:ident $inverse:ident $reference:tt;)*) => {$(
            let arm = robots::$Arm;
            for _ in 0..20 {
                lanes_are_alone::<f64, _, 4>(&arm, &mut sampler, f64::to_bits);
                lanes_are_alone::<f64, _, 7>(&arm, &mut sampler, f64::to_bits);
                lanes_are_alone::<f32, _, 8>(&arm, &mut sampler, |x| u64::from(x.to_bits()));
            }
        )*};
    }
    robots::for_each!(arms);
}

#[test]
fn what_has_no_branch_has_the_same_bits() {
    fn same<T: Float>(a: T, b: T) -> bool {
        format!("{a:?}") == format!("{b:?}")
    }
    fn check<T: Float>(sampler: &mut Sampler) {
        let zero = T::lit(0.0);
        let sizes = [1e-300, 1e-30, 1e-8, 1.0, 10.0, 1e6];
        for _ in 0..20_000 {
            let [x, y] =
                std::array::from_fn(|_| T::lit(sizes[sampler.below(6)] * sampler.between(-1.0, 1.0)));
            let y = if sampler.below(20) == 0 { zero } else { y };
            let angle = if Float::abs(x) > T::lit(6000.0) { y } else { x };
            if Float::abs(angle) <= T::lit(6000.0) {
                let ((s, c), (sine, cosine)) = (T::sin_cos_straight(angle), Real::sin_cos(angle));
                assert!(same(s, sine) && same(c, cosine), "{angle:?}");
            }
            for (y, x) in [(y, x), (-y, x), (y, -x), (x, y)] {
                if x != zero || y != zero {
                    assert!(same(T::atan2_straight(y, x).0, Float::atan2(y, x)), "{y:?} {x:?}");
                }
                if y > zero {
                    let (above, straight) = (T::atan2_above(y, x), T::atan2_straight(y, x));
                    assert!(same(above.0, straight.0) && same(above.1, straight.1), "{y:?} {x:?}");
                }
            }
        }
        let none = T::lit(f64::NAN);
        assert!(same(T::sin_cos_straight(none).0, none) && same(T::sin_cos_straight(none).1, none));
        for (y, x) in [(zero, zero), (zero, -zero), (none, zero), (T::lit(1.0), none)] {
            assert!(same(T::atan2_straight(y, x).0, none), "{y:?} {x:?}");
        }
    }
    let mut sampler = Sampler::new(91);
    check::<f64>(&mut sampler);
    check::<f32>(&mut sampler);
}
