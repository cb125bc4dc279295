//! Generated arms on general bases, in both precisions: round trips at and around their singular sets, parameters, labels along
//! small motions, free joints and cusps.

use std::f64::consts::PI;

use kin_runtime::math;
use kin_runtime::prelude::*;
use tests::invented::{Meeting, ParallelA, ParallelB, PrrA, Skew, Sliding, Square};
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

/// Joint values at which the base has lost a direction, found along joint 3.
fn singular<A: Arm<6>>(arm: &A, random: &mut Sampler) -> Joints<f64, 6> {
    loop {
        let mut q = random_joints::<A>(random);
        let mut at = |value: f64| {
            q[2] = value;
            arm.jacobian(&q).determinant()
        };
        let start = random.between(-PI, PI);
        let ends = (0..24).map(|k| start + f64::from(k) * PI / 12.0).map(|low| (low, low + PI / 12.0));
        let Some((mut low, mut high)) = ends.clone().find(|(low, high)| at(*low) * at(*high) < 0.0) else {
            continue;
        };
        let sign = at(low);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if at(middle) * sign > 0.0 { low = middle } else { high = middle }
        }
        q[2] = low;
        return q;
    }
}

#[derive(Default, Debug)]
struct Tally {
    tries: usize,
    solutions: usize,
    lost: usize,
    twice: usize,
    residual: f64,
    blurred: usize,
}

trait Number: Float {
    fn wide(self) -> f64;
}

impl Number for f64 {
    fn wide(self) -> f64 {
        self
    }
}

impl Number for f32 {
    fn wide(self) -> f64 {
        f64::from(self)
    }
}

/// How far a pose misses another, as the rows of a Jacobian count: a length over the reach, then a turn.
fn missed<A: Arm<6>>(arm: &A, to: &Pose<f64>, q: &Joints<f64, 6>) -> nalgebra::Vector6<f64> {
    let here = arm.fk(q);
    let shift = (to.translation.vector - here.translation.vector) / arm.reach();
    let turn = to.rotation.matrix() * here.rotation.matrix().transpose();
    let turn = 0.5 * (turn - turn.transpose());
    nalgebra::Vector6::new(shift.x, shift.y, shift.z, turn[(2, 1)], turn[(0, 2)], turn[(1, 0)])
}

/// Whether joint values all along the way between two reach the pose but for round-off: then no solver that is given the pose in
/// this precision can tell them apart. The way is bent; each of its points is brought onto it by a step that leaves alone the
/// direction that the arm has lost.
fn cannot_be_told_apart<A: Arm<6>>(arm: &A, a: &Joints<f64, 6>, b: &Joints<f64, 6>, window: f64) -> bool {
    let step =
        Joints::<f64, 6>::from_fn(|i, _| if slides::<A>(i) { b[i] - a[i] } else { math::wrap(b[i] - a[i]) });
    let pose = arm.fk(a);
    (1..=8).all(|k| {
        let mut q = a + step * (f64::from(k) / 8.0);
        for _ in 0..3 {
            let jacobian = kin_runtime::singularity::scaled(&arm.jacobian(&q), arm.reach());
            let miss = missed(arm, &pose, &q);
            let decomposed = jacobian.svd(true, true);
            // All but the smallest singular value.
            let least = decomposed.singular_values.min();
            let others = decomposed.singular_values.iter().copied().filter(|s| *s > least);
            let cutoff = 0.5 * (least + others.fold(f64::INFINITY, f64::min));
            let mended = decomposed.solve(&miss, cutoff).expect("both sides were asked for");
            q += mended;
        }
        let near = apart(arm, &q, &(a + step * (f64::from(k) / 8.0))) <= 0.1 * apart(arm, a, b);
        near && missed(arm, &pose, &q).amax() <= window
    })
}

/// There and back: the joints are among the solutions, within 1e3·ε/σ_min, at most 1e2·√ε. Near a cusp, where three solutions
/// meet in one, within 1e2·∛ε, if nothing on the way could be told apart.
fn round_trip<T: Number, A: InverseKinematics<6>>(arm: &A, q: &Joints<f64, 6>, tally: &mut Tally) {
    let q = Joints::<T, 6>::from_fn(|i, _| T::lit(q[i]));
    let wide = |q: &Joints<T, 6>| Joints::<f64, 6>::from_fn(|i, _| q[i].wide());
    let pose = arm.fk(&q);
    let solutions = arm.ik(&pose);
    let (epsilon, own) = (T::EPS.wide(), wide(&q));
    let sigma = kin_runtime::dexterity(arm, &own).margin;
    let allowed = (1e3 * epsilon / sigma).min(1e2 * epsilon.sqrt());
    let all: Vec<_> = solutions.iter().map(|s| wide(&s.q)).collect();
    let nearest =
        |all: &[Joints<f64, 6>]| all.iter().map(|s| apart(arm, s, &own)).fold(f64::INFINITY, f64::min);
    let mut near = nearest(&all);
    if near > allowed && solutions.iter().any(|s| !s.is_isolated()) {
        near = near.min(nearest(&arm.ik_holding(&pose, &q).iter().map(|s| wide(&s.q)).collect::<Vec<_>>()));
    }
    let blurred = || {
        all.iter().any(|s| {
            apart(arm, s, &own) <= 1e2 * epsilon.cbrt() && cannot_be_told_apart(arm, &own, s, 64.0 * epsilon)
        })
    };
    tally.tries += 1;
    tally.solutions += all.len();
    if near > allowed && blurred() {
        tally.blurred += 1;
    } else if near > allowed {
        tally.lost += 1;
        println!(
            "{} lost {:?} by {near:e} of {allowed:e}, σ {sigma:e}\n{solutions}",
            A::NAME,
            own.as_slice()
        );
    }
    let unit = arm.reach().min(1.0) / arm.reach();
    for (i, a) in solutions.iter().enumerate() {
        tally.residual = tally.residual.max(a.residual.wide() / epsilon);
        let a = wide(&a.q);
        tally.twice += usize::from(all[..i].iter().any(|b| apart(arm, &a, b) < 6.7 * epsilon.sqrt() * unit));
    }
}

fn round_trips<T: Number, A: InverseKinematics<6>>(arm: &A, tries: usize, seed: u64) -> Tally {
    let (mut random, mut tally) = (Sampler::new(seed), Tally::default());
    for _ in 0..tries {
        let q = random_joints::<A>(&mut random);
        round_trip::<T, A>(arm, &q, &mut tally);
        let mut q = singular(arm, &mut random);
        let off = 10f64.powf(-random.between(0.0, 17.0)) * [1.0, -1.0, 0.0][random.below(3)];
        q[random.below(3)] += off;
        round_trip::<T, A>(arm, &q, &mut tally);
    }
    tally
}

/// In a release build 2·10⁵ tries of each kind lose nothing either.
fn comes_back<A: InverseKinematics<6>>(arm: &A, seed: u64) {
    for tally in [round_trips::<f64, A>(arm, 250, seed), round_trips::<f32, A>(arm, 250, seed + 1)] {
        println!("{} {tally:?}", A::NAME);
        assert!(tally.lost == 0 && tally.twice == 0 && tally.residual <= 64.0, "{} {tally:?}", A::NAME);
        assert!(tally.blurred * 100 <= tally.tries && tally.solutions > 3 * tally.tries, "{tally:?}");
    }
}

#[test]
fn skew_axes_come_back_in_both_precisions() {
    comes_back(&Skew, 1);
}

#[test]
fn a_cuspidal_arm_comes_back_in_both_precisions() {
    comes_back(&Square, 3);
}

#[test]
fn meeting_axes_come_back_in_both_precisions() {
    comes_back(&Meeting, 5);
}

#[test]
fn a_slide_between_comes_back_in_both_precisions() {
    comes_back(&Sliding, 7);
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
            let near = |s: &&Solution<f64, 6, Posture>| {
                let [one, two, three] = [0, 1, 2].map(|i| math::wrap(s.q[i] - q[i]).abs());
                one < 1e-9 && three < 1e-9 && two < 1e3 * f64::EPSILON / off.abs()
            };
            assert!(solutions.iter().any(|s| near(&s)), "{k} {side} {q}\n{solutions}");
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

dh! {
    /// Every length of a general base is open; some values bring axes together.
    pub struct Open(standard, m, deg);

    param a1 = 0.2; param d2 = 0.1; param a2 = 0.4; param d3 = -0.1; param a3 = 0.2; param d4 = 0.3; param turn = 15deg;

    | joint | theta    | d   | a  | alpha |
    |-------|----------|-----|----|-------|
    | J1    | q        | 0.3 | a1 | 70    |
    | J2    | q + turn | d2  | a2 | 80    |
    | J3    | q        | d3  | a3 | -60   |
    | J4    | q        | d4  | 0  | -90   |
    | J5    | q        | 0   | 0  | 90    |
    | J6    | q        | 0.1 | 0  | 0     |
}

#[test]
fn parameters_of_a_general_base_hold_for_every_value() {
    let mut random = Sampler::new(9);
    let mut tally = Tally::default();
    for round in 0..200 {
        let mut length = || random.between(-0.6, 0.6);
        let mut arm = Open {
            a1: length(),
            d2: length(),
            a2: length(),
            d3: length(),
            a3: length(),
            d4: length(),
            turn: length(),
        };
        // Axes 1 and 2 meet, axes 2 and 3 meet, the point is carried about axis 3 at no height.
        match round % 4 {
            1 => arm.a1 = 0.0,
            2 => arm.a2 = 0.0,
            3 => (arm.d3, arm.d2) = (0.0, 0.0),
            _ => {}
        }
        let q = random_joints::<Open>(&mut random);
        round_trip::<f64, _>(&arm, &q, &mut tally);
        round_trip::<f32, _>(&arm, &q, &mut tally);
    }
    assert!(tally.lost == 0 && tally.twice == 0 && tally.blurred <= 2, "{tally:?}");
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

#[test]
fn a_wrist_centre_on_axis_1_leaves_joint_1_free() {
    let mut random = Sampler::new(12);
    // The arm as it is, but that the wrist centre can come onto axis 1.
    let arm = Open { a1: 0.3, d2: 0.1, a2: 0.35, d3: 0.1, a3: 0.2, d4: 0.3, turn: 0.0 };
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

dh! {
    /// Axes 2 and 3 meet at right angles, and the wrist centre can swing onto axis 2.
    pub struct Swinging(standard, m, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | q     | 0.3 | 0.2 | 60    |
    | J2    | q     | 0.4 | 0   | 90    |
    | J3    | q     | 0   | 0.3 | -90   |
    | J4    | q     | 0   | 0   | 90    |
    | J5    | q     | 0   | 0   | -90   |
    | J6    | q     | 0.1 | 0   | 0     |
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
