//! Generated arms on general bases: labels along small motions, free joints, double roots and cusps.

use std::f64::consts::PI;

use kin_runtime::math;
use kin_runtime::prelude::*;
use tests::invented::{ParallelA, ParallelB, PppA, PprA, PrpA, PrrA, RppB, Skew, Square, Swinging};
use tests::sample::Sampler;

fn slides<A: Arm<6>>(joint: usize) -> bool {
    A::JOINTS[joint].kind == kin_runtime::JointKind::Prismatic
}

/// The difference of two joint values: an angle, or a slide over the reach.
fn way<A: Arm<6>>(arm: &A, joint: usize, way: f64) -> f64 {
    if slides::<A>(joint) { way / arm.reach() } else { math::wrap(way) }
}

fn apart<A: Arm<6>>(arm: &A, a: &Joints<f64, 6>, b: &Joints<f64, 6>) -> f64 {
    (0..6).map(|i| way(arm, i, a[i] - b[i]).abs()).fold(0.0, f64::max)
}

fn random_joints<A: Arm<6>>(random: &mut Sampler) -> Joints<f64, 6> {
    let angles = random.angles::<6>();
    let mut q = Joints::from_fn(|i, _| if slides::<A>(i) { random.between(-0.8, 0.8) } else { angles[i] });
    q[4] = random.between(0.3, 2.8);
    q
}

/// Whether the joints of the base are back, joint 2 as far as the pose tells of it where the point passes axis 2 at such a distance.
fn is_back(s: &Solution<f64, 6, Posture>, q: &Joints<f64, 6>, off: f64) -> bool {
    let [one, two, three] = [0, 1, 2].map(|i| math::wrap(s.q[i] - q[i]).abs());
    one < 1e-9 && three < 1e-9 && two < 1e3 * f64::EPSILON / off.abs()
}

/// The point passes axis 2 at 10⁻ᵏ: round-off leaves nothing of the square of that distance, but the pose still tells the direction.
#[test]
fn beside_axis_2_joints_come_back() {
    let (arm, mut random) = (ParallelA, Sampler::new(11));
    // Where the wrist centre, √0.18 from axis 3, lies on axis 2.
    let on_axis = (-0.4 / 0.18_f64.sqrt()).acos() - 0.25 * PI;
    for k in 4..=13 {
        for side in [1.0, -1.0] {
            let off = side * 10f64.powi(-k);
            let q = joints![random.between(-PI, PI), random.between(-PI, PI), on_axis + off, 0.4, 0.9, 0.3];
            let solutions = arm.ik(&arm.fk(&q));
            assert!(solutions.iter().any(|s| is_back(s, &q, off)), "{k} {side} {q}\n{solutions}");
        }
    }
}

/// At a double root whose figure round-off has opened, the joints that are lost are sought along the direction that is.
#[test]
fn double_roots_that_round_off_has_opened_come_back() {
    let bits = [
        0xbfb8_f984_cc19_a7e0_u64,
        0xbff0_d6f6_aa86_60d0,
        0xc003_5764_2713_1aa1,
        0x4001_06ee_1f02_44fc,
        0x3fe9_0454_27c2_f718,
        0xbfd8_8d30_33d3_2e88,
    ];
    let q = Joints::from(bits.map(f64::from_bits));
    let solutions = PrrA.ik(&PrrA.fk(&q));
    assert!(solutions.iter().any(|s| apart(&PrrA, &s.q, &q) < 1e-6), "{solutions}");
}

/// The wrist centre's motion, column by column, and its determinant.
fn base_motion<A: SphericalWrist<6>>(arm: &A, q: &Joints<f64, 6>) -> nalgebra::Matrix3<f64> {
    let frames = arm.frames(q);
    let (_, centre) = arm.r03(q[0], q[1], q[2]);
    let mut axis = (nalgebra::Vector3::z(), nalgebra::Vector3::zeros());
    let mut columns = nalgebra::Matrix3::zeros();
    for (joint, frame) in frames.iter().enumerate().take(3) {
        columns.set_column(joint, &axis.0.cross(&(centre.coords - axis.1)));
        axis = (frame.rotation.matrix().column(2).into_owned(), frame.translation.vector);
    }
    columns
}

#[test]
fn up_and_down_stay_until_the_determinant_vanishes() {
    let mut random = Sampler::new(11);
    let (mut steps, mut swaps) = (0, 0);
    while steps < 3_000 {
        let (from, way) = (random_joints::<Skew>(&mut random), random_joints::<Skew>(&mut random) * 1e-3);
        let sign = base_motion(&Skew, &from).determinant().signum();
        let mut before: Option<Posture> = None;
        for k in 0..60 {
            let q = from + way * f64::from(k);
            if base_motion(&Skew, &q).determinant() * sign < 1e-4 || q[4].sin().abs() < 0.05 {
                break;
            }
            let solutions = Skew.ik(&Skew.fk(&q));
            let own = solutions.nearest(&q).expect("its own pose");
            assert!(apart(&Skew, &own.q, &q) < 1e-9);
            if let Some(before) = before {
                assert_eq!(
                    (own.branch.elbow, own.branch.wrist),
                    (before.elbow, before.wrist),
                    "{q}\n{solutions}"
                );
                swaps += usize::from(own.branch.shoulder != before.shoulder);
            }
            before = Some(own.branch);
            steps += 1;
        }
    }
    // Right and left are the order among those of the same sign: another that comes or goes may change it.
    assert!(swaps * 100 <= steps, "{swaps} of {steps}");
}

dh! {
    /// Three axes that are oblique to each other, and the wrist centre can come onto axis 1.
    pub struct Reaching(standard, m, deg);

    | joint | theta | d   | a    | alpha |
    |-------|-------|-----|------|-------|
    | J1    | q     | 0.3 | 0.3  | 70    |
    | J2    | q     | 0.1 | 0.35 | 80    |
    | J3    | q     | 0.1 | 0.2  | -60   |
    | J4    | q     | 0.3 | 0    | -90   |
    | J5    | q     | 0   | 0    | 90    |
    | J6    | q     | 0.1 | 0    | 0     |
}

#[test]
fn a_wrist_centre_on_axis_1_leaves_joint_1_free() {
    let (arm, mut random) = (Reaching, Sampler::new(12));
    let mut tried = 0;
    while tried < 10 {
        let on_axis = |q2: f64, q3: f64| {
            let (_, centre) = arm.r03(0.0, q2, q3);
            [centre.x, centre.y]
        };
        let [q2, q3] = newton(on_axis, random.angles());
        if on_axis(q2, q3).iter().any(|miss| miss.is_nan() || miss.abs() >= 1e-15) {
            continue;
        }
        tried += 1;
        let q = joints![0.7, q2, q3, 0.4, 0.9, -0.3];
        let pose = arm.fk(&q);
        let solutions = arm.ik(&pose);
        let families: Vec<_> = solutions
            .iter()
            .flat_map(|s| s.families())
            .filter(|f| f.singularity() == kin_runtime::Singularity::Shoulder)
            .collect();
        assert!(!families.is_empty(), "{q}\n{solutions}");
        assert!(families.iter().all(|f| f.free() == 0 && f.solution().q[0] == 0.0), "{solutions}");
        assert!(arm.ik_holding(&pose, &q).iter().any(|s| apart(&arm, &s.q, &q) < 1e-6));
        // Whole turns in what is held on to, however many, cost no digits.
        for turns in [3.0, -1e6, 1e12] {
            let mut hold = q;
            hold[0] = 0.7 + turns * 2.0 * PI;
            let held = arm.ik_holding(&pose, &hold);
            assert!(held.len() == solutions.len(), "{turns:e}\n{held}");
            assert!(held.iter().all(|s| s.residual <= 64.0 * f64::EPSILON));
        }
    }
}

#[test]
fn a_wrist_centre_on_axis_2_leaves_joint_2_free() {
    for q3 in [PI / 2.0, -PI / 2.0] {
        let q = joints![0.3, 0.7, q3, 0.4, 0.9, -0.3];
        let pose = Swinging.fk(&q);
        let solutions = Swinging.ik(&pose);
        let family = solutions
            .iter()
            .flat_map(|s| s.families())
            .find(|f| f.singularity() == kin_runtime::Singularity::Elbow);
        let family = family.unwrap_or_else(|| panic!("{solutions}"));
        assert!(family.free() == 1 && family.solution().q[1].abs() < 1e-15);
        assert_eq!(family.solution().margins.shoulder, 0.0);
        for value in [0.7, -2.0, 3.0 + 2e9 * PI] {
            let Slot::Solved(member) = family.member(&Swinging, &pose, value) else { panic!("{solutions}") };
            assert!(math::wrap(member.q[1] - value).abs() < 1e-6 && member.residual <= 64.0 * f64::EPSILON);
        }
        assert!(Swinging.ik_holding(&pose, &q).iter().any(|s| apart(&Swinging, &s.q, &q) < 1e-6));
    }
}

#[test]
fn at_a_cusp_three_solutions_meet_and_none_is_lost() {
    // Where the determinant vanishes along the direction that is lost too.
    let lost = |q: &Joints<f64, 6>| {
        let motion = base_motion(&Square, q).svd(false, true);
        let turned = motion.v_t.expect("it was asked for");
        let (least, _) = motion.singular_values.argmin();
        let direction = turned.row(least).transpose();
        direction * if direction.z < 0.0 { -1.0 } else { 1.0 }
    };
    let determinant =
        |q2: f64, q3: f64| base_motion(&Square, &joints![0.4, q2, q3, 0.3, 0.9, 0.2]).determinant();
    let slope = |q2: f64, q3: f64| {
        let along = lost(&joints![0.4, q2, q3, 0.3, 0.9, 0.2]) * 1e-4;
        (determinant(q2 + along.y, q3 + along.z) - determinant(q2 - along.y, q3 - along.z)) / 2e-4
    };
    let mut random = Sampler::new(13);
    let mut cusps = 0;
    while cusps < 4 {
        let start = random.angles::<2>();
        let [q2, q3] = newton(|x, y| [determinant(x, y), slope(x, y)], start);
        let (_, centre) = Square.r03(0.0, q2, q3);
        let found = determinant(q2, q3).abs() < 1e-9 && slope(q2, q3).abs() < 1e-6;
        // On axis 1 the determinant vanishes for another reason.
        if !found || centre.x.hypot(centre.y) < 0.1 {
            continue;
        }
        // A fourth solution beside the three would make it flatter than a cusp.
        let at = joints![0.4, q2, q3, 0.3, 0.9, 0.2];
        let solutions = Square.ik(&Square.fk(&at));
        if solutions.iter().any(|s| (0.01..0.3).contains(&apart(&Square, &s.q, &at))) {
            continue;
        }
        cusps += 1;
        for off in [0.0, 1e-12, 1e-9, -1e-9, 1e-6, -1e-6, 1e-4, -1e-4, 1e-3, -1e-3] {
            let q = joints![0.4, q2, q3 + off, 0.3, 0.9, 0.2];
            let solutions = Square.ik(&Square.fk(&q));
            let near = solutions.iter().map(|s| apart(&Square, &s.q, &q)).fold(9.0, f64::min);
            assert!(near <= 1e2 * f64::EPSILON.cbrt(), "{near:e} at {off:e}\n{solutions}");
            assert!(solutions.iter().all(|s| s.residual <= 64.0 * f64::EPSILON));
        }
    }
}

/// Newton's method for two functions of two angles, wherever it leads.
fn newton(f: impl Fn(f64, f64) -> [f64; 2], [mut x, mut y]: [f64; 2]) -> [f64; 2] {
    for _ in 0..60 {
        let ([a, b], step) = (f(x, y), 1e-6);
        let ([ax, bx], [ay, by]) = (f(x + step, y), f(x, y + step));
        let (ax, bx, ay, by) = ((ax - a) / step, (bx - b) / step, (ay - a) / step, (by - b) / step);
        let determinant = ax * by - ay * bx;
        (x, y) = (x - (a * by - b * ay) / determinant, y - (b * ax - a * bx) / determinant);
    }
    [math::wrap(x), math::wrap(y)]
}

dh! {
    /// Three slides and nothing else: no length, no limit.
    pub struct Frameless(standard, mm, deg);

    | joint | theta | d | a | alpha |
    |-------|-------|---|---|-------|
    | J1    | 0     | q | 0 | -90   |
    | J2    | -90   | q | 0 | 90    |
    | J3    | 0     | q | 0 | 0     |
}

#[test]
fn an_arm_without_a_size_is_measured_in_its_unit() {
    assert_eq!(Frameless.reach(), 1.0);
    let mut random = Sampler::new(14);
    for _ in 0..100 {
        let size = 10f64.powf(random.between(-3.0, 12.0));
        let q =
            joints![random.between(-size, size), random.between(-size, size), random.between(-size, size)];
        let point = Point3 { coords: Frameless.fk(&q).translation.vector };
        let solutions = Frameless.ik_position(&point);
        let solution = solutions.iter().next().unwrap_or_else(|| panic!("{q}\n{solutions}"));
        assert!(solutions.len() == 1 && (solution.q - q).amax() <= 8.0 * f64::EPSILON * size.max(1.0));
    }
}

/// Found by the program `reliability`: the wrist centre so near axis 1 that joint 1 hardly moves it, the base at a double root.
#[test]
fn beside_axis_1_joint_1_is_told_by_the_place() {
    let found = [
        [
            0xc007_baee_e3d4_0f39,
            0xbfe0_2ce4_bd4e_bc8c,
            0xc007_7ad0_04ba_0472,
            0x3ff0_2f10_63ae_4ac0,
            0x4009_21fb_5444_2d18,
            0xc002_00fe_cbdc_1680,
        ],
        [
            0x3fff_017f_ffa0_7994,
            0xbfe0_2ce4_bd4e_bc8c,
            0xc007_7ad0_04ba_0467,
            0xbff2_b79f_1368_699d,
            0xbff3_e3d9_c030_15bf,
            0xc007_bc12_1977_3808,
        ],
    ];
    for q in found.map(|q| Joints::from(q.map(f64::from_bits))) {
        let solutions = ParallelB.ik(&ParallelB.fk(&q));
        let worst = solutions.iter().map(|solution| solution.residual).fold(0.0, f64::max) / f64::EPSILON;
        assert!(!solutions.is_empty() && worst <= 8.0, "{worst} ε at {q}\n{solutions}");
    }
}

fn lacks(slot: &Slot<f64, 6, Posture>) -> bool {
    matches!(slot, Slot::Empty(Reason::NoSuchBranch))
}

/// How many slots of an arm's own poses hold a way of the base, once and again with the other wrist, and that the others say that the
/// structure has no more.
fn has_ways<A: InverseKinematics<6, Branch = Posture>>(arm: &A, ways: usize) {
    let mut random = Sampler::new(31);
    for _ in 0..50 {
        let q = random_joints::<A>(&mut random);
        let solutions = arm.ik(&arm.fk(&q));
        let lacking = solutions.slots().iter().filter(|slot| lacks(slot));
        assert_eq!(
            (solutions.len(), lacking.count()),
            (2 * ways, 8 - 2 * ways),
            "{} {q}\n{solutions}",
            A::NAME
        );
    }
}

#[test]
fn a_branch_that_the_structure_lacks_says_so() {
    has_ways(&PppA, 1);
    has_ways(&RppB, 2);
    has_ways(&PrpA, 2);
    has_ways(&PprA, 2);
    let solutions = PppA.ik(&PppA.fk(&joints![0.1, 0.2, 0.3, 0.4, 0.9, -0.3]));
    assert!(solutions.to_string().contains("the arm has no such branch there"), "{solutions}");
    // What no branch reaches is out of reach by a distance.
    let mut random = Sampler::new(32);
    for _ in 0..200 {
        let mut pose = Skew.fk(&random_joints::<Skew>(&mut random));
        pose.translation.vector *= random.between(1.0, 3.0);
        let solutions = Skew.ik(&pose);
        assert!(!solutions.slots().iter().all(lacks), "{solutions}");
    }
}

/// Where the wrist centre comes onto axis 2 the determinant vanishes with the motion of joint 2, and the margin with both.
#[test]
fn the_elbow_s_margin_falls_towards_axis_2() {
    let mut before = f64::INFINITY;
    for k in 1..=12 {
        let q = joints![0.3, 0.7, 0.5 * PI + 10_f64.powi(-k), 0.4, 0.9, -0.3];
        let solutions = Swinging.ik(&Swinging.fk(&q));
        let own = solutions.nearest(&q).expect("the pose is the arm's own");
        // 0.3 m from axis 3, whose angle this is.
        let distance = 0.3 * 10_f64.powi(-k).sin() / Swinging.reach();
        assert!((own.margins.elbow - distance).abs() <= 1e-3 * distance + 1e-15, "{k}: {:?}", own.margins);
        assert!(own.margins.elbow < 0.2 * before, "{k}: {:?}", own.margins);
        before = own.margins.elbow;
    }
}

dh! {
    /// Axis 3 comes to lie on axis 1 where joint 2 is half a turn.
    struct Coinciding(standard, m, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | q     | 0.3 | 0.3 | 90    |
    | J2    | q     | 0   | 0.3 | 90    |
    | J3    | q     | 0.1 | 0.4 | 90    |
    | J4    | q     | 0.2 | 0   | -90   |
    | J5    | q     | 0   | 0   | 90    |
    | J6    | q     | 0.1 | 0   | 0     |
}

/// RELIABILITY.md names this among what is not: the family of joints 1 and 3 is none of the solver's, its members are solutions.
#[test]
fn where_axes_1_and_3_coincide_members_come_back() {
    let mut random = Sampler::new(33);
    for _ in 0..200 {
        let [one, three, four, six] = random.angles::<4>();
        let pose = Coinciding.fk(&joints![one, PI, three, four, 0.9, six]);
        let solutions = Coinciding.ik(&pose);
        let member = |s: &Solution<f64, 6, Posture>| math::wrap(s.q[1] - PI).abs() < 1e-6;
        assert!(solutions.iter().any(member), "{solutions}");
        assert!(solutions.iter().all(|s| s.residual <= 64.0 * f64::EPSILON), "{solutions}");
    }
}

/// Where the heights say nothing of joint 3, which carries the point straight through axis 2: two ways begin as one there, and joint 2 is
/// half a turn apart in the solutions that they lead to.
#[test]
fn what_is_carried_straight_through_axis_2_comes_back_on_either_side() {
    let mut random = Sampler::new(40);
    for k in 1..=13 {
        for _ in 0..200 {
            let [one, two, four, six] = random.angles::<4>();
            let side = if random.below(2) == 0 { 1.0 } else { -1.0 };
            let off = side * random.between(0.3, 1.0) * 10_f64.powi(-k);
            let three = if random.below(2) == 0 { 0.5 * PI } else { -0.5 * PI };
            let q = joints![one, two, three + off, four, 0.9, six];
            let solutions = Swinging.ik(&Swinging.fk(&q));
            assert!(solutions.iter().any(|s| is_back(s, &q, off)), "{k} {q}\n{solutions}");
        }
    }
}
