//! What can be asked for: rotations that miss being one in one way alone, sizes, and numbers that are none.

use super::*;
use crate::ik::target::{Target, distance, judged, size};
use crate::math::Lanes;
use crate::sample::Rotation;

/// The largest entry of a difference.
fn off(a: &Rotation, b: &Rotation) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(x, y)| math::abs(x - y)).fold(0.0, math::max)
}

fn mended(rotation: Rotation) -> Rotation {
    let target = Target::for_reach(&pose::from_rows(rotation, [0.1, 0.2, 0.3]), 1.0).unwrap();
    pose::rows(&target.pose).0
}

/// One row too long, or two rows not at right angles: the nearest rotation is known to second order.
#[test]
fn a_rotation_spoiled_in_one_way_alone_is_mended() {
    let mut random = Random(61);
    let sizes = [1e-15, 1e-12, 1e-9, -1e-10];
    for _ in 0..200 {
        let r = random.rotation();
        assert!(off(&mended(r), &r) <= 4.0 * EPS);
        for (size, (i, j)) in sizes.iter().flat_map(|size| [(0, 1), (1, 2), (2, 0)].map(|pair| (*size, pair)))
        {
            let (mut long, mut askew, mut nearest) = (r, r, r);
            long[i] = r[i].map(|x| x * (1.0 + size));
            assert!(off(&mended(long), &r) <= 6.0 * EPS, "{size}");
            // Half of what is between the two rows each of them has to give.
            for k in 0..3 {
                askew[i][k] += size * r[j][k];
                nearest[i][k] += 0.5 * size * r[j][k];
                nearest[j][k] -= 0.5 * size * r[i][k];
            }
            assert!(off(&mended(askew), &nearest) <= 6.0 * EPS, "{size}");
        }
    }
}

/// What is far from a rotation says by how much; where the squares of its entries overflow, or cancel to no number, by 1/ε.
#[test]
fn what_is_no_rotation_misses_being_one_by_a_number() {
    let defect =
        |rotation: Rotation| match Target::for_reach(&pose::from_rows(rotation, [0.1, 0.2, 0.3]), 1.0) {
            Err(Reason::NotARotation { defect }) => defect,
            other => panic!("{other:?}"),
        };
    let diagonal = |x: f64| [[x, 0.0, 0.0], [0.0, x, 0.0], [0.0, 0.0, x]];
    assert_eq!(defect(diagonal(2.0)), 3.0);
    assert_eq!(defect(diagonal(1e200)), 1.0 / EPS);
    let [x, y, z] = diagonal(1.0);
    let cancelling = [x.map(|c| c + 1e200), y.map(|c| c - 1e200), z];
    assert_eq!(defect(cancelling), 1.0 / EPS);
}

#[test]
fn a_pose_is_as_large_as_its_largest_coordinate_or_the_arm() {
    for (position, expected) in
        [([0.1, -0.2, 0.3], 2.0), ([0.1, -5.0, 0.3], 5.0), ([7.0, 5.0, 0.3], 7.0), ([0.0, 0.0, -9.0], 9.0)]
    {
        assert_eq!(size(&position, 2.0), Ok(expected));
    }
    for none in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
        for position in [[none, 1.0, 2.0], [1.0, none, 2.0], [1.0, 2.0, none]] {
            assert_eq!(size(&position, 2.0), Err(Reason::NotFinite));
        }
    }
    // As far as 1/ε of the reach figures can be trusted.
    let far = 2.0 / EPS;
    assert_eq!(size(&[0.0, far, 0.0], 2.0), Ok(far));
    let beyond = size(&[0.0, 0.0, -2.0 * far], 2.0);
    assert!(
        matches!(beyond, Err(Reason::OutOfReach { by, towards: Boundary::Reach, theta1: None }) if by == 2.0 * far - 2.0)
    );
    for reach in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-150, 1e140] {
        assert_eq!(size(&[0.1, 0.2, 0.3], reach), Err(Reason::NotAnArm), "{reach}");
    }
    assert!(size(&[0.0; 3], 1e-140).is_ok() && size(&[0.0; 3], 1e130).is_ok());
}

#[test]
fn poses_are_as_far_apart_as_their_entries() {
    assert_eq!(distance(&[1.0, -2.0, 3.0], &[1.5, -4.0, 2.0]), 2.0);
    assert_eq!(distance(&[1.0, -2.0, 3.0], &[-1.5, -2.0, 2.0]), 2.5);
    for place in 0..3 {
        let mut a = [9.0, 1.0, 5.0];
        a[place] = f64::NAN;
        assert!(math::is_nan(distance(&a, &[0.0; 3])) && math::is_nan(distance(&[0.0; 3], &a)));
    }
    let mut random = Random(62);
    for _ in 0..200 {
        let mut at = || pose::from_rows(random.rotation(), [(); 3].map(|()| random.within(-9.0, 9.0)));
        let (target, others) = (Target::for_reach(&at(), 2.0).unwrap(), [at(), at()]);
        let (r, p) = pose::rows(&target.pose);
        let scale = p.iter().map(|x| math::abs(*x)).fold(2.0, math::max);
        let expected = others.map(|other| {
            let (s, q) = pose::rows(&other);
            math::max(off(&r, &s), distance(&p, &q) / scale)
        });
        assert_eq!(others.map(|other| target.missed_by(&other)), expected);
        let lanes = |entry: fn(&Pose<f64>) -> [f64; 12]| {
            let [a, b] = others.each_ref().map(entry);
            core::array::from_fn::<_, 12, _>(|i| Lanes([a[i], b[i]]))
        };
        let [a, b, c, d, e, f, g, h, i, x, y, z] = lanes(|pose| {
            let ([[a, b, c], [d, e, f], [g, h, i]], [x, y, z]) = pose::rows(pose);
            [a, b, c, d, e, f, g, h, i, x, y, z]
        });
        let both = pose::from_rows([[a, b, c], [d, e, f], [g, h, i]], [x, y, z]);
        assert_eq!(target.missed_by_all(&both).0, expected);
    }
}

/// What is judged without a branch, many poses at a time, is let pass just where the careful way takes it as it is.
#[test]
fn a_pose_is_let_pass_where_nothing_of_it_is_mended() {
    let mut random = Random(62);
    let (mut passed, mut mended) = (0, 0);
    for round in 0..20_000 {
        let (mut rotation, mut position) = (random.rotation(), [(); 3].map(|()| random.within(-3.0, 3.0)));
        let by = match round % 5 {
            0 => 0.0,
            1 => random.within(-64.0, 64.0) * EPS,
            2 => random.within(-1.0, 1.0),
            3 => f64::NAN,
            _ => {
                // A mirror image is none.
                rotation[0] = rotation[0].map(|x| -x);
                0.0
            }
        };
        let [i, j, k] = [(); 3].map(|()| (random.bits() % 3) as usize);
        if random.coin() || by.is_nan() {
            rotation[i][j] += by;
        }
        if random.bits().is_multiple_of(8) {
            position[k] = [1e17, 1e300, f64::INFINITY, f64::NAN][(random.bits() % 4) as usize];
        }
        let pose = pose::from_rows(rotation, position);
        let (scale, refused) = judged(&pose, 1.5);
        let as_it_is = Target::for_reach(&pose, 1.5).ok().filter(|target| target.pose == pose);
        let square = pose::product(&rotation, &pose::transposed(&rotation));
        let defect = off(&square, &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        match as_it_is {
            Some(target) if refused == 0.0 => assert_eq!(scale, target.scale),
            // The careful way looks at the columns too.
            Some(_) => assert!(defect > 3.0 * EPS, "{pose}"),
            None => assert!(refused > 0.0, "{pose}"),
        }
        passed += u32::from(refused == 0.0);
        mended += u32::from(refused != 0.0 && Target::for_reach(&pose, 1.5).is_ok());
    }
    assert!(passed > 3_000 && mended > 1_000, "{passed} {mended}");
}
