//! Every numeric example of the four lab reports.
//!
//! The truth is `data/seeds_truth.json` (50 digits). The reports' own misprints are put right there and named here.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use kin_gen::model::{PoseSolver, Solver};
use kin_gen::program::Program;
use kin_runtime::prelude::*;
use kin_runtime::singularity::{dexterity, scaled, singular_values};
use kin_runtime::{Boundary, Constraint, GimbalLock, Singularity};
use nalgebra::Matrix3;
use robots::{Anthropomorphic, ElbowWrist, LabArm, LabRrr, Seed001Yzy};
use tests::polynomial::terms;
use tests::pose::{from_zyx, isometry};
use tests::sample::Sampler;
use tests::score::wrap;
use tests::seeds::{self, Example};

type LabSolutions = Solutions<f64, 6, Posture>;

/// Half a unit of the fourth decimal, in which the report prints angles, and as much for the pose behind them.
const PRINTED: f64 = 1e-4;

fn apart(a: &Joints<f64, 6>, b: &Joints<f64, 6>) -> f64 {
    (a - b).map(|x| wrap(x).abs()).amax()
}

/// An inverse example of section 6: the pose in millimetres, and its truth.
fn example(name: &str) -> (Pose<f64>, LabSolutions, Example) {
    let mut examples = seeds::truth().seed000.ik;
    let example = examples.remove(name).unwrap_or_else(|| panic!("no example {name}"));
    let pose = isometry(&example.pose, 1000.0);
    (pose, LabArm.ik(&pose), example)
}

/// The isolated solutions are exactly the listed ones.
fn isolated_are(solutions: &LabSolutions, example: &Example, tolerance: f64) {
    let found: Vec<_> = solutions.iter().filter(|s| s.is_isolated()).collect();
    assert_eq!(found.len(), example.isolated.len(), "{solutions}");
    for listed in &example.isolated {
        let nearest = found.iter().map(|s| apart(&s.q, &Joints::from(*listed))).fold(f64::INFINITY, f64::min);
        assert!(nearest < tolerance, "{listed:?} is {nearest:e} away\n{solutions}");
    }
}

/// Every printed row is a solution, or the member of a family at its own value of the free joint.
fn printed_rows_are_found(pose: &Pose<f64>, solutions: &LabSolutions, example: &Example) {
    for row in &example.printed_check {
        let printed = Joints::from(row.q);
        let isolated = solutions.iter().filter(|s| s.is_isolated()).map(|s| s.q);
        let members = solutions.iter().flat_map(|s| s.families()).filter_map(|family| {
            let member = family.member(&LabArm, pose, printed[family.free()]);
            member.solution().map(|s| s.q)
        });
        let nearest = isolated.chain(members).map(|q| apart(&q, &printed)).fold(f64::INFINITY, f64::min);
        assert!(nearest < PRINTED, "{:?} is {nearest:e} away\n{solutions}", row.q);
    }
}

/// The slots with that first joint are out of reach by so many millimetres.
fn out_of_reach(solutions: &LabSolutions, theta1: f64, by: f64) {
    let mut count = 0;
    for slot in solutions.slots() {
        if let Slot::Empty(Reason::OutOfReach { by: found, towards, theta1: Some(first) }) = slot {
            assert!((found - by).abs() < 5e-7, "{found}");
            assert_eq!(*towards, Boundary::OuterCircle);
            assert!(wrap(first - theta1).abs() < 1e-12, "{first}");
            count += 1;
        }
    }
    assert_eq!(count, 4, "{solutions}");
}

fn count_isolated_and_families(solutions: &LabSolutions) -> (usize, usize) {
    let isolated = solutions.iter().filter(|s| s.is_isolated()).count();
    (isolated, solutions.iter().map(|s| s.families().count()).sum())
}

#[test]
fn seed_000_forward_at_zero() {
    let pose = LabArm.fk(&joints![0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert!((pose.translation.vector - nalgebra::Vector3::new(-69.0, 0.0, 112.0)).amax() < 1e-13);
    let printed = Matrix3::new(0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0);
    assert_eq!(*pose.rotation.matrix(), printed);
    // The report prints (pi/4, -pi/2, -pi/4), one triple of infinitely many: z + x = 0 is what is true.
    let Euler::GimbalLock(lock) = EulerZyx::from_rotation(&pose.rotation) else {
        panic!("not a gimbal lock")
    };
    assert_eq!(lock, GimbalLock { up: false, turn: 0.0 });
    assert_eq!(lock.member(FRAC_PI_4), EulerZyx { z: FRAC_PI_4, y: -FRAC_PI_2, x: -FRAC_PI_4 });
    let rebuilt = lock.member(FRAC_PI_4).to_rotation();
    assert!((rebuilt.matrix() - printed).amax() < 1e-15);
}

#[test]
fn seed_000_forward_of_the_truncated_solutions() {
    for case in seeds::truth().seed000.fk_of_truncated {
        let pose = LabArm.fk(&Joints::from(case.q));
        let number = |text: &String| text.parse::<f64>().unwrap_or(f64::NAN);
        let truth = case.truth_xyz_mm.each_ref().map(number);
        let angles = case.truth_zyx.each_ref().map(number);
        // Ten figures of the position are known, four decimals printed; eight figures of the angles.
        for ((found, truth), printed) in pose.translation.vector.iter().zip(truth).zip(case.printed) {
            assert!((found - truth).abs() <= 5e-10 * 112.0, "{:?}", case.q);
            assert!((found - printed).abs() < 5e-5, "{:?}", case.q);
        }
        let near =
            |zyx: [f64; 3]| (from_zyx([0.0; 3], zyx).rotation.matrix() - pose.rotation.matrix()).amax();
        assert!(near(angles) < 1e-7, "{:?}", case.q);
        assert!(near([case.printed[3], case.printed[4], case.printed[5]]) < PRINTED, "{:?}", case.q);
        // Our own angles, printed or not, give the orientation back.
        let euler = EulerZyx::from_rotation(&pose.rotation).any();
        assert!((euler.to_rotation().matrix() - pose.rotation.matrix()).amax() < 1e-15, "{:?}", case.q);
    }
}

#[test]
fn seed_000_section_6_1() {
    let (pose, solutions, example) = example("6.1 default");
    assert_eq!(count_isolated_and_families(&solutions), (6, 1), "{solutions}");
    isolated_are(&solutions, &example, 1e-12);
    printed_rows_are_found(&pose, &solutions, &example);
    let family = solutions.iter().find_map(|s| s.family());
    let Some(family) = family else { panic!("no family") };
    assert_eq!(family.singularity(), Singularity::Wrist);
    match family.constraint() {
        Constraint::Sum { joints, difference, equals } => {
            assert_eq!((joints, difference), ([3, 5], false));
            assert!(equals.abs() < 1e-12);
        }
        other => panic!("{other:?}"),
    }
    assert_eq!(family.to_string(), "theta4 + theta6 = 0.0000");
    // The whole family reaches the pose.
    for value in [-3.0, -0.5, 0.0, 1.0, 3.1] {
        let member = family.member(&LabArm, &pose, value);
        let Some(member) = member.solution() else { panic!("no member at {value}") };
        assert!((LabArm.fk(&member.q).to_homogeneous() - pose.to_homogeneous()).amax() < 1e-11);
    }
    assert!(solutions.to_string().contains(
        "SINGULARITY: There are infinite solutions for the value of theta4 and theta6. \
         These angles will then assume symmetrical values."
    ));
    // The printed four decimals are another pose, which is not singular: eight isolated solutions.
    #[expect(clippy::approx_constant, reason = "the report prints four decimals")]
    let printed = LabArm.ik(&from_zyx([-69.0, 0.0, 112.0], [0.7854, -1.5708, -0.7854]));
    assert_eq!(count_isolated_and_families(&printed), (8, 0), "{printed}");
}

#[test]
fn seed_000_section_6_2() {
    let (pose, solutions, example) = example("6.2 stretched forward");
    assert_eq!(count_isolated_and_families(&solutions), (4, 0), "{solutions}");
    isolated_are(&solutions, &example, 1e-10);
    printed_rows_are_found(&pose, &solutions, &example);
    assert!(solutions.iter().all(|s| s.q[0].abs() < 1e-12));
    out_of_reach(&solutions, PI, 59.115027);
    let printed = solutions.to_string();
    let sentence =
        "for theta1 = 3.1416, the coordinates inserted are out of reach: 59.115027 beyond the outer circle";
    assert!(printed.contains(sentence), "{printed}");
}

#[test]
fn seed_000_section_6_3() {
    let (pose, solutions, example) = example("6.3 z1 aligned z6");
    assert_eq!(count_isolated_and_families(&solutions), (0, 4), "{solutions}");
    printed_rows_are_found(&pose, &solutions, &example);
    for solution in solutions.iter() {
        let Some(family) = solution.family() else { panic!("{solution}") };
        assert_eq!(family.singularity(), Singularity::Shoulder);
        assert_eq!(family.free(), 0);
        assert_eq!(family.moving().iter().collect::<Vec<_>>(), [0, 5]);
        assert_eq!(family.constraint(), Constraint::Follow);
        assert_eq!(family.to_string(), "theta1 free, theta6 follows");
    }
    let printed = solutions.to_string();
    let sentence = "SINGULARITY: There are infinite solutions for the value of theta1 and theta6. By default, theta1 will \
                    assume the value 0.0000. The value of theta6 must take into account other angles, and will be defined \
                    accordingly.";
    assert_eq!(printed.matches(sentence).count(), 1, "{printed}");
}

#[test]
fn seed_000_section_6_4() {
    let (pose, solutions, example) = example("6.4 z4 aligned z6");
    assert_eq!(count_isolated_and_families(&solutions), (2, 1), "{solutions}");
    isolated_are(&solutions, &example, 1e-10);
    printed_rows_are_found(&pose, &solutions, &example);
    assert!(solutions.iter().all(|s| wrap(s.q[0]).abs() < 1e-12));
    out_of_reach(&solutions, PI, 1.650314);
    let printed = solutions.to_string();
    for sentence in [
        "for theta1 = 3.1416, the coordinates inserted are out of reach: 1.650314 beyond the outer circle",
        "SINGULARITY: There are infinite solutions for the value of theta4 and theta6.",
    ] {
        assert!(printed.contains(sentence), "{printed}");
    }
}

#[test]
fn seed_000_section_6_5() {
    for (name, tolerance) in [("6.5 near reach z=372.52", 1e-9), ("6.5 z=372.5294643", 1e-7)] {
        let (_, solutions, example) = example(name);
        assert_eq!(count_isolated_and_families(&solutions), (4, 0), "{name}\n{solutions}");
        isolated_are(&solutions, &example, tolerance);
        assert!(solutions.iter().all(|s| s.q[0].abs() < 1e-12), "{name}");
    }
    // 3.4e-10 mm too far.
    let (_, solutions, _) = example("6.5 z=372.52946438");
    assert!(solutions.is_empty(), "{solutions}");
    let nearest = solutions.slots().iter().filter_map(|slot| match slot {
        Slot::Empty(Reason::OutOfReach { by, .. }) => Some(*by),
        _ => None,
    });
    let nearest = nearest.fold(f64::INFINITY, f64::min);
    assert!((3.0e-10..4.0e-10).contains(&nearest), "{nearest:e}");
    let (_, solutions, _) = example("6.5 z=372.53");
    assert!(solutions.is_empty(), "{solutions}");
}

#[test]
fn seed_000_section_5_singularities() {
    // "z1 aligned with z4 is not a singularity" is false, and so is the test for the shoulder singularity by the tool.
    let truth = seeds::truth().seed000;
    for case in [truth.z1_aligned_z4, truth.wrist_on_z1_general_orientation] {
        let q = Joints::from(case.q);
        assert!(dexterity(&LabArm, &q).margin < 1e-15, "{:?}", case.q);
        // The truth's linear rows are in metres.
        let raw = singular_values(&scaled(&LabArm.jacobian(&q), 1000.0));
        for (ours, theirs) in raw.iter().zip(case.singular_values) {
            assert!((ours - theirs).abs() < 1e-14, "{ours} {theirs}");
        }
    }
}

/// What the generated program of ³R₆, or of ⁰R₃ and the wrist centre, computes: printed polynomials of these outputs.
fn polynomials<const M: usize>(
    table: &str,
    program: fn(&PoseSolver) -> &Program,
    names: [&str; M],
) -> [String; M] {
    let mut arm = kin_gen::compile_text(table).unwrap_or_else(|e| panic!("{e}"));
    let Solver::Pose(solver) = &arm.solver else { panic!("no inverse") };
    let program = program(solver);
    let expanded = program.expand(&mut arm.ring, &arm.symbols);
    names.map(|name| {
        let index = program.outputs.iter().position(|output| output.name == name);
        index.map_or_else(|| panic!("no output {name}"), |i| arm.ring.show(&expanded[i]).to_string())
    })
}

fn r36(table: &str) -> [String; 9] {
    let names = ["r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"];
    polynomials(table, |solver| &solver.r36, names)
}

fn wrist_centre(table: &str) -> [String; 3] {
    polynomials(table, |solver| &solver.r03, ["px", "py", "pz"])
}

fn same_polynomials(found: &[String], printed: &[&str]) {
    assert_eq!(found.len(), printed.len());
    for (found, printed) in found.iter().zip(printed) {
        assert_eq!(terms(found), terms(printed), "{found}");
    }
}

#[test]
fn seed_000_matrix_4_7() {
    let found = r36(LabArm::TABLE);
    let printed = [
        ["c4*c5*c6 - s4*s6", "-c4*c5*s6 - s4*c6", "-c4*s5"], // the report has -c4*c6*s6 - s4*c6, a misprint
        ["s5*c6", "-s5*s6", "c5"],
        ["-s4*c5*c6 - c4*s6", "s4*c5*s6 - c4*c6", "s4*s5"],
    ];
    same_polynomials(&found, printed.as_flattened());
    assert_eq!(found[1], "-c4·c5·s6 - s4·c6");
    assert_ne!(terms(&found[1]), terms("-c4*c6*s6 - s4*c6"));
}

#[test]
fn seed_001_reaches_the_point_of_its_figure_3() {
    let pose = from_zyx([4.0, 0.0, 0.0], [0.0; 3]);
    let solutions = Anthropomorphic.ik(&pose);
    assert!(!solutions.is_empty(), "{solutions}");
    for solution in solutions.iter() {
        let off = Anthropomorphic.fk(&solution.q).to_homogeneous() - pose.to_homogeneous();
        assert!(off.amax() < 1e-14 * Anthropomorphic.reach(), "{solution}");
    }
}

#[test]
fn seed_001_every_pose_has_eight_branches() {
    let mut sampler = Sampler::new(11);
    for _ in 0..200 {
        let q = Joints::from(sampler.angles::<6>());
        let pose = Anthropomorphic.fk(&q);
        let solutions = Anthropomorphic.ik(&pose);
        assert!(solutions.slots().iter().all(|slot| matches!(slot, Slot::Solved(_))), "{solutions}");
        assert!(solutions.nearest(&q).is_some_and(|s| apart(&s.q, &q) < 1e-6), "{solutions}");
        assert_eq!(Seed001Yzy.ik(&Seed001Yzy.fk(&q)).len(), 8);
    }
}

#[test]
fn seed_001_printed_matrix() {
    let printed = [
        ["-s4*s6 + c4*c5*c6", "-s5*c4", "s4*c6 + s6*c4*c5"],
        ["s5*c6", "c5", "s5*s6"],
        ["-s4*c5*c6 - s6*c4", "s4*s5", "-s4*s6*c5 + c4*c6"],
    ];
    same_polynomials(&r36(Anthropomorphic::TABLE), printed.as_flattened());
    // The wrist: (-s1 k, c1 k, …) with k = d2 c2 + (d3 + d4) c23, where the report has (c1 k, s1 k, …) and d3 alone.
    let reach = ["d2*c2", "d3*c2*c3", "-d3*s2*s3", "d4*c2*c3", "-d4*s2*s3"];
    let height = "d1 + d2*s2 + d3*s2*c3 + d3*c2*s3 + d4*s2*c3 + d4*c2*s3";
    same_polynomials(
        &wrist_centre(Anthropomorphic::TABLE),
        &[&times("-s1", reach), &times("c1", reach), height],
    );
}

/// A factor times each term.
fn times(factor: &str, sum: [&str; 5]) -> String {
    let (sign, name) = factor.strip_prefix('-').map_or((1, factor), |name| (-1, name));
    let product = |term: &str| {
        let (own, rest) = term.strip_prefix('-').map_or((1, term), |rest| (-1, rest));
        format!("{}{name}*{rest}", if sign * own < 0 { "-" } else { "" })
    };
    sum.map(product).join(" + ")
}

#[test]
fn seed_003_printed_matrix_and_wrist() {
    let printed = [
        ["s4*s6 - c4*c5*c6", "s4*c6 + s6*c4*c5", "s5*c4"],
        ["-s4*c5*c6 - s6*c4", "s4*s6*c5 - c4*c6", "s4*s5"],
        ["s5*c6", "-s5*s6", "c5"],
    ];
    same_polynomials(&r36(ElbowWrist::TABLE), printed.as_flattened());
    // Printed with numbers: l2 = 1, l3 + l4 = 0.8, l1 = 0.3.
    let reach = ["l2*c2", "l3*c2*c3", "-l3*s2*s3", "l4*c2*c3", "-l4*s2*s3"];
    let height = "l1 + l2*s2 + l3*s2*c3 + l3*c2*s3 + l4*s2*c3 + l4*c2*s3";
    same_polynomials(&wrist_centre(ElbowWrist::TABLE), &[&times("-s1", reach), &times("c1", reach), height]);
}

#[test]
fn seed_004_forward_and_all_four_inverses() {
    let truth = seeds::truth().seed004;
    let p = LabRrr.fk(&joints![0.5, 0.5, -0.5]).translation.vector;
    for i in 0..3 {
        assert!((p[i] - truth.for_kin.truth[i].parse::<f64>().unwrap_or(f64::NAN)).abs() < 1e-16);
        assert!((p[i] - truth.for_kin.printed[i]).abs() < 5e-6);
    }
    let solutions = LabRrr.ik_position(&Point3::from(p));
    assert_eq!((solutions.len(), truth.solutions.len()), (4, 4), "{solutions}");
    for listed in &truth.solutions {
        let apart = |q: &Joints<f64, 3>| (q - Joints::from(*listed)).map(|x| wrap(x).abs()).amax();
        let nearest = solutions.iter().map(|s| apart(&s.q)).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-14, "{listed:?} is {nearest:e} away\n{solutions}");
    }
}
