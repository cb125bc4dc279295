//! The examples of seed 000, sections 6.1 to 6.5, in its own words and numbers; choosing among solutions.
#![allow(clippy::approx_constant, reason = "the report prints pi with four decimals")]

use crate::pose::{self, Joints, Pose};
use crate::sample::{Figures, LAB_ARM, PUMA_560, Random, STANFORD_ARM, Text};
use crate::{
    Arm, ArmPosture, Boundary, Branch, Constraint, EulerZyx, InverseKinematics, JointSet, Limits, Posture,
    Reason, Singularity, Slot, Solutions,
};
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

fn printed(z: f64, y: f64, x: f64, position: [f64; 3]) -> Solutions<f64, 6, Posture> {
    LAB_ARM.ik(&EulerZyx { z, y, x }.at(position))
}

fn on_its_side(position: [f64; 3]) -> Solutions<f64, 6, Posture> {
    printed(FRAC_PI_4, -FRAC_PI_2, -FRAC_PI_4, position)
}

fn level(position: [f64; 3]) -> Solutions<f64, 6, Posture> {
    printed(0.0, 0.0, 0.0, position)
}

fn holds(solutions: &Solutions<f64, 6, Posture>, row: [f64; 6]) -> bool {
    solutions.iter().any(|s| s.q.iter().zip(row).all(|(a, b)| crate::math::wrap(a - b).abs() < 1e-4))
}

#[test]
fn default_position_of_section_6_1() {
    let solutions = on_its_side([-69.0, 0.0, 112.0]);
    let rows = [
        [-3.1416, -1.1547, -0.4276, 3.1416, 1.5593, 0.0],
        [-3.1416, -1.1547, -0.4276, 0.0, -1.5593, 3.1416],
        [-3.1416, 1.7113, 0.7329, 0.0, 0.6974, 3.1416],
        [-3.1416, 1.7113, 0.7329, -3.1416, -0.6974, 0.0],
        [0.0, 4.0689, 0.3053, 0.0, 1.9090, 0.0],
        [0.0, 4.0689, 0.3053, 3.1416, -1.9090, 3.1416],
    ];
    assert!(rows.iter().all(|row| holds(&solutions, *row)), "{solutions}");
    assert_eq!(solutions.iter().filter(|s| s.is_isolated()).count(), 6);
    let singular = solutions.iter().find(|s| !s.is_isolated()).unwrap();
    let family = singular.family().unwrap();
    assert_eq!(
        (singular.families().count(), family.singularity(), family.free()),
        (1, Singularity::Wrist, 3)
    );
    assert_eq!(family.moving(), JointSet::EMPTY.with(3).with(5));
    let Constraint::Sum { joints: [3, 5], difference: false, equals } = family.constraint() else {
        panic!("{family}")
    };
    assert!(equals.abs() < 1e-14);
    // The other row that the report prints is a member of the family.
    let pose = EulerZyx { z: FRAC_PI_4, y: -FRAC_PI_2, x: -FRAC_PI_4 }.at([-69.0, 0.0, 112.0]);
    let Slot::Solved(member) = family.member(&LAB_ARM, &pose, PI) else { panic!() };
    assert!((member.q - pose::column([0.0, 0.0, 0.0, PI, 0.0, -PI])).map(crate::math::wrap).amax() < 1e-13);
    let text = Text::of(&solutions);
    assert!(text.as_str().starts_with(
        "SINGULARITY: There are infinite solutions for the value of theta4 and theta6. These angles will then assume \
         symmetrical values.\n"
    ));
    assert_eq!(text.as_str().lines().count(), 9);
    assert!(
        text.as_str()
            .contains("0.0000    0.0000    0.0000    0.0000    0.0000    0.0000   theta4 + theta6 = 0.0000")
    );
}

#[test]
fn stretched_forward_of_section_6_2() {
    let solutions = on_its_side([-309.0, 0.0, 72.0]);
    let rows = [
        [0.0, -3.1416, -2.8363, -3.1416, 0.3053, 3.1416],
        [0.0, -3.1416, -2.8363, 0.0, -0.3053, 0.0],
        [0.0, -2.9819, 3.1416, -3.1416, 0.1597, 3.1416],
        [0.0, -2.9819, 3.1416, 0.0, -0.1597, 0.0],
    ];
    assert!(rows.iter().all(|row| holds(&solutions, *row)) && solutions.len() == 4, "{solutions}");
    let text = Text::of(&solutions);
    let warning =
        "for theta1 = 3.1416, the coordinates inserted are out of reach: 59.115027 beyond the outer circle\n";
    assert!(text.as_str().starts_with(warning) && text.as_str().matches("out of reach").count() == 1);
}

#[test]
fn first_axis_aligned_with_the_last_of_section_6_3() {
    let solutions = level([0.0, 0.0, 300.0]);
    assert_eq!(solutions.len(), 4, "{solutions}");
    for solution in solutions.iter() {
        let family = solution.family().unwrap();
        assert_eq!(Text::of(&family).as_str(), "theta1 free, theta6 follows");
        // The report's two rows of each family: theta1 = 0 and theta1 = pi.
        let pose = EulerZyx { z: 0.0, y: 0.0, x: 0.0 }.at([0.0, 0.0, 300.0]);
        let Slot::Solved(other) = family.member(&LAB_ARM, &pose, PI) else { panic!() };
        assert!((other.q[0], other.q[4]) == (PI, solution.q[4]));
        assert!((crate::math::wrap(other.q[5] - solution.q[5]).abs() - PI).abs() < 1e-12);
    }
    for row in [
        [0.0, 0.5950, -1.4575, 3.1416, 0.7083, -3.1416],
        [0.0, 0.5950, -1.4575, 0.0, -0.7083, 0.0],
        [0.0, 2.2145, 1.7628, 0.0, 0.7351, 0.0],
        [0.0, 2.2145, 1.7628, -3.1416, -0.7351, 3.1416],
    ] {
        assert!(holds(&solutions, row), "{solutions}");
    }
    assert!(Text::of(&solutions).as_str().starts_with(
        "SINGULARITY: There are infinite solutions for the value of theta1 and theta6. By default, theta1 will assume \
         the value 0.0000. The value of theta6 must take into account other angles, and will be defined accordingly.\n"
    ));
}

#[test]
fn fourth_axis_aligned_with_the_last_of_section_6_4() {
    let solutions = level([-10.0, 0.0, 371.0]);
    assert!(holds(&solutions, [6.2832, 1.4111, -2.8363, 3.1416, 0.1456, -3.1416]), "{solutions}");
    assert!(holds(&solutions, [6.2832, 1.4111, -2.8363, 0.0, -0.1456, 0.0]), "{solutions}");
    assert_eq!((solutions.len(), solutions.iter().filter(|s| s.is_isolated()).count()), (3, 2));
    let text = Text::of(&solutions);
    assert!(text.as_str().starts_with(
        "for theta1 = 3.1416, the coordinates inserted are out of reach: 1.650314 beyond the outer circle\nSINGULARITY: "
    ));
}

#[test]
fn reach_and_precision_of_section_6_5() {
    assert_eq!(level([-30.0, 0.0, 372.52]).len(), 4);
    assert_eq!(level([-30.0, 0.0, 372.529_464_3]).len(), 4);
    let beyond = level([-30.0, 0.0, 372.529_464_38]);
    assert!(beyond.is_empty());
    let text = Text::of(&beyond);
    assert!(
        text.as_str()
            .contains("for theta1 = 0.0000, the coordinates inserted are out of reach: 3.409e-10 beyond")
    );
}

#[test]
fn other_reasons_in_words() {
    let words = |reason: Reason<f64>| Text::of(&reason);
    assert_eq!(words(Reason::NotFinite).as_str(), "the coordinates inserted are not finite numbers");
    assert!(
        words(Reason::NotARotation { defect: 0.25 }).as_str().ends_with("R'R differs from 1 by 2.500e-1")
    );
    assert!(words(Reason::LeftHanded).as_str().contains("left-handed"));
    assert_eq!(
        words(Reason::Limit { joint: 2, by: 0.5 }).as_str(),
        "the limit of joint 3 is passed by 0.500000"
    );
    assert!(words(Reason::Inaccurate { residual: 1e-9 }).as_str().contains("1.000e-9"));
    assert_eq!(Text::of(&JointSet::EMPTY.with(0).with(3).with(4)).as_str(), "theta1, theta4 and theta5");
}

fn puma() -> (Pose<f64>, Joints<f64, 6>, Solutions<f64, 6, Posture>) {
    let q = pose::column([0.3, 0.5, -0.2, 0.4, 0.6, -0.9]);
    let pose = PUMA_560.fk(&q);
    (pose, q, PUMA_560.ik(&pose))
}

#[test]
fn the_nearest_solution_is_the_one_with_the_smallest_largest_move() {
    let (_, q, solutions) = puma();
    let turned = pose::column([2.0 * PI, 0.0, -2.0 * PI, 0.0, 0.0, 2.0 * PI]);
    let nearest = solutions.nearest(&(q + turned)).unwrap();
    assert!((nearest.q - q).amax() < 1e-12);
    for solution in solutions.iter() {
        assert_eq!(solutions.nearest(&solution.q).map(|s| s.branch), Some(solution.branch));
    }
    assert!(level([1e4, 0.0, 0.0]).nearest(&q).is_none());
    // A slide is not an angle: a turn more is far away.
    let pose = STANFORD_ARM.fk(&pose::column([0.1, 0.2, 0.5, 0.3, 0.4, 0.5]));
    let solutions = STANFORD_ARM.ik(&pose);
    let near = solutions.nearest(&pose::column([0.1, 0.2, 0.5 - 2.0 * PI, 0.3, 0.4, 0.5])).unwrap();
    assert!(near.q[2] < 0.0);
}

#[test]
fn limits_empty_slots_and_say_by_how_much() {
    let (_, q, solutions) = puma();
    let limits = Limits::new([Some((0.0, 0.3)), None, None, None, Some((0.0, 1.0)), None]);
    let kept = solutions.within(&limits);
    assert!(kept.iter().all(|s| s.q[4] >= 0.0 && (s.q[0] - 0.3).abs() < 1e-12));
    assert!(kept.iter().any(|s| (s.q - q).amax() < 1e-12));
    let flipped =
        kept.slots().iter().zip(solutions.slots()).filter_map(|(now, before)| match (now, before) {
            (Slot::Empty(Reason::Limit { joint: 4, by }), Slot::Solved(s)) => Some((*by, s.q[4])),
            _ => None,
        });
    let shortest = |q5: f64| crate::math::wrap(q5).abs().min(crate::math::wrap(q5 - 1.0).abs());
    assert!(
        flipped.clone().count() > 0 && flipped.into_iter().all(|(by, q5)| (by - shortest(q5)).abs() < 1e-12)
    );
    assert_eq!(solutions.within(&Limits::NONE), solutions);
    // A slot that is merged with an emptied one is emptied with it.
    let singular = on_its_side([-69.0, 0.0, 112.0]);
    let merged = singular.slots().iter().position(|slot| matches!(slot, Slot::Merged { .. })).unwrap();
    let narrow = Limits::new([None, None, None, Some((1.0, 2.0)), None, None]);
    assert!(matches!(singular.within(&narrow).slots()[merged], Slot::Empty(Reason::Limit { joint: 3, .. })));
}

#[test]
fn slots_answer_by_name() {
    let (_, _, solutions) = puma();
    for (branch, slot) in solutions.branches() {
        assert_eq!(solutions.get(branch), slot);
        assert_eq!(solutions.solution(branch).map(|s| s.branch), Some(branch));
    }
    assert_eq!(solutions.clone(), solutions);
    let singular = on_its_side([-69.0, 0.0, 112.0]);
    for branch in Posture::ALL {
        assert!(singular.solution(*branch).is_some());
    }
}

#[test]
fn members_of_a_coupled_wrist_keep_to_their_line() {
    let mut random = Random(8);
    for round in 0..50 {
        let mut arm = Figures::<false>::random(&mut random, true);
        (arm.coupled, arm.offset[2], arm.offset[4]) = (round % 2 == 0, 1.5, 0.0);
        let q = pose::column([0.3, 1.0, 0.5, 0.7, if arm.coupled { -0.7 } else { 0.0 }, 0.2]);
        let pose = arm.fk(&q);
        let solutions = arm.ik(&pose);
        let families = solutions.iter().filter_map(|s| s.family());
        let mut members = 0;
        for family in families {
            let Slot::Solved(member) = family.member(&arm, &pose, 0.7) else { panic!("{solutions}") };
            assert!(crate::math::abs(member.q[3] - 0.7) < 1e-15 && member.residual < 40.0 * f64::EPSILON);
            let plain = matches!(family.constraint(), Constraint::Sum { joints: [3, 5], .. });
            assert!(arm.coupled != plain && arm.coupled == family.moving().contains(4), "{family}");
            members += usize::from((member.q - q).map(crate::math::wrap).amax() < 1e-10);
        }
        assert!(members > 0, "{solutions}");
    }
}

#[test]
fn the_four_slots_of_three_joints_have_their_names() {
    assert_eq!(ArmPosture::ALL.len(), 4);
    let labels = ["right/up", "right/down", "left/up", "left/down"];
    assert!(ArmPosture::ALL.iter().zip(labels).all(|(posture, label)| Text::of(posture).as_str() == label));
}

#[test]
fn columns_stand_apart_and_large_numbers_have_exponents() {
    let mut arm = Figures::<true>::random(&mut Random(12), true);
    (arm.base, arm.coupled) = ((crate::sample::about_z(0.0), [0.0; 3]), false);
    let apart = |solutions: &Solutions<f64, 6, Posture>| {
        let text = Text::of(solutions);
        let rows = || text.as_str().lines().filter(|line| line.contains("flip") && !line.ends_with("none"));
        assert!(
            rows().count() > 0 && rows().all(|row| row.split_whitespace().count() == 7),
            "{}",
            text.as_str()
        );
        let width = rows().map(str::len).max();
        assert!(rows().all(|row| Some(row.len()) == width), "{}", text.as_str());
    };
    for slide in [0.5, 1234.5, 123_456.75, 1.5e12] {
        apart(&arm.ik(&arm.fk(&pose::column([0.1, 0.2, slide, 0.3, 0.4, 0.5]))));
    }
    let far = |by| Text::of(&Reason::OutOfReach { by, towards: Boundary::OuterCircle, theta1: None });
    assert!(far(1e308).as_str().ends_with(": 1.000e308 beyond the outer circle"));
    assert!(Text::of(&Reason::Limit { joint: 0, by: 1e300 }).as_str().ends_with(" by 1.000e300"));
    // No circle bounds a slide.
    let text = Text::of(&STANFORD_ARM.ik(&EulerZyx { z: 0.0, y: 0.0, x: 0.0 }.at([1e16, 0.0, 0.0])));
    assert!(
        text.as_str()
            .starts_with("the coordinates inserted are out of reach: 1.000e16 beyond the reach of the arm")
    );
}
