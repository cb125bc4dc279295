//! What the lab reports print, put right, comes out of the polynomial print of ³R₆ and of the wrist centre.

use kin_gen::model::{Arm, PoseSolver, Solver};
use kin_runtime::Arm as _;

fn compiled(table: &str) -> Arm {
    kin_gen::compile_text(table).unwrap_or_else(|messages| panic!("{messages}"))
}

fn solver(arm: &Arm) -> &PoseSolver {
    match &arm.solver {
        Solver::Pose(solver) => solver,
        other => panic!("no pose solver: {other:?}"),
    }
}

fn printed_r36(arm: &Arm) -> [[String; 3]; 3] {
    solver(arm).r36_meaning.clone().map(|row| row.map(|entry| arm.ring.show(&entry).to_string()))
}

fn printed_centre(arm: &Arm) -> [String; 3] {
    solver(arm).centre_meaning.clone().map(|entry| arm.ring.show(&entry).to_string())
}

#[test]
fn seed_000_equation_4_7() {
    // The report prints -c4·c6·s6 - s4·c6 in the place of the second entry; the other eight are right.
    assert_eq!(
        printed_r36(&compiled(robots::LabArm::TABLE)),
        [
            ["c4·c5·c6 - s4·s6", "-c4·c5·s6 - s4·c6", "-c4·s5"],
            ["s5·c6", "-s5·s6", "c5"],
            ["-c4·s6 - s4·c5·c6", "-c4·c6 + s4·c5·s6", "s4·s5"],
        ]
    );
}

#[test]
fn seed_001_wrist_rotation_as_printed_and_its_wrist_centre_put_right() {
    let arm = compiled(robots::Anthropomorphic::TABLE);
    assert_eq!(
        printed_r36(&arm),
        [
            ["c4·c5·c6 - s4·s6", "-c4·s5", "c4·c5·s6 + s4·c6"],
            ["s5·c6", "c5", "s5·s6"],
            ["-c4·s6 - s4·c5·c6", "s4·s5", "c4·c6 - s4·c5·s6"],
        ]
    );
    // (-s1 k, c1 k, d1 + …) with k = d2 c2 + (d3 + d4) c23, where the report has (c1 k, s1 k, …) without d4.
    assert_eq!(
        printed_centre(&arm),
        [
            "-d3·s1·c2·c3 - d4·s1·c2·c3 - d2·s1·c2 + d3·s1·s2·s3 + d4·s1·s2·s3",
            "d3·c1·c2·c3 + d4·c1·c2·c3 + d2·c1·c2 - d3·c1·s2·s3 - d4·c1·s2·s3",
            "d3·c2·s3 + d4·c2·s3 + d3·s2·c3 + d4·s2·c3 + d2·s2 + d1",
        ]
    );
}

#[test]
fn seed_003_wrist_rotation_and_wrist_position_as_printed() {
    let arm = compiled(robots::ElbowWrist::TABLE);
    assert_eq!(
        printed_r36(&arm),
        [
            ["-c4·c5·c6 + s4·s6", "c4·c5·s6 + s4·c6", "c4·s5"],
            ["-c4·s6 - s4·c5·c6", "-c4·c6 + s4·c5·s6", "s4·s5"],
            ["s5·c6", "-s5·s6", "c5"],
        ]
    );
    // Section 3.1 prints it with l2 = 1.0, l3 + l4 = 0.8 and l1 = 0.3:
    // 0.8 s1 s2 s3 - 0.8 s1 c2 c3 - 1.0 s1 c2, -0.8 s2 s3 c1 + 0.8 c1 c2 c3 + 1.0 c1 c2, 0.8 s2 c3 + 1.0 s2 + 0.8 s3 c2 + 0.3
    assert_eq!(
        printed_centre(&arm),
        [
            "-l3·s1·c2·c3 - l4·s1·c2·c3 - l2·s1·c2 + l3·s1·s2·s3 + l4·s1·s2·s3",
            "l3·c1·c2·c3 + l4·c1·c2·c3 + l2·c1·c2 - l3·c1·s2·s3 - l4·c1·s2·s3",
            "l3·c2·s3 + l4·c2·s3 + l3·s2·c3 + l4·s2·c3 + l2·s2 + l1",
        ]
    );
}
