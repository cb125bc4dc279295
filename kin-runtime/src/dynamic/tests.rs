//! Every kind of arm in one list, and what comes out of it.

use super::*;
use crate::sample::{LAB_ARM, LabRrr, Text};

/// An arm that can only go forward.
struct Bare;
impl Arm<3> for Bare {
    const NAME: &'static str = "Bare";
    const LENGTH_UNIT: LengthUnit = LengthUnit::Inch;
    const TABLE: &'static str = "| J1 |";
    const JOINTS: [Joint; 3] = LabRrr::JOINTS;
    fn reach(&self) -> f64 {
        LabRrr.reach()
    }
    fn limits(&self) -> crate::Limits<3> {
        crate::Limits::new([Some((-1.0, 2.0)), None, None])
    }
    fn fk<T: crate::Real>(&self, q: &Joints<T, 3>) -> Pose<T> {
        LabRrr.fk(q)
    }
    fn frames<T: crate::Real>(&self, q: &Joints<T, 3>) -> [Pose<T>; 3] {
        LabRrr.frames(q)
    }
    fn jacobian<T: crate::Real>(&self, q: &Joints<T, 3>) -> crate::Jacobian<T, 3> {
        LabRrr.jacobian(q)
    }
    fn fk_jacobian<T: crate::Real>(&self, q: &Joints<T, 3>) -> (Pose<T>, crate::Jacobian<T, 3>) {
        LabRrr.fk_jacobian(q)
    }
}

type Lab = crate::sample::Table<'l'>;
crate::private::dyn_arm!(Lab, 6, pose);
crate::private::dyn_arm!(LabRrr, 3, position);
crate::private::dyn_arm!(Bare, 3, plain);

#[test]
fn one_list_holds_every_kind_of_arm() {
    let arms: [&dyn DynArm; 3] = [&LAB_ARM, &LabRrr, &Bare];
    let inverses = [Inverse::Pose, Inverse::Position, Inverse::None];
    let zeros = [0.0; 6];
    for (arm, inverse) in arms.into_iter().zip(inverses) {
        assert_eq!(arm.inverse(), inverse);
        let q = &zeros[..arm.joints().len()];
        let pose = arm.pose_at(q).unwrap();
        let mut branches = 0;
        let from_pose = arm.solve_pose(&pose, &mut |_| branches += 1);
        assert_eq!(from_pose.is_ok(), inverse == Inverse::Pose);
        let [point] = pose.translation.vector.data.0;
        let from_point = arm.solve_position(point, &mut |_| branches += 1);
        assert_eq!(from_point.is_ok(), inverse == Inverse::Position);
        assert_eq!(
            branches,
            if inverse == Inverse::Pose { 8 } else { 4 * usize::from(inverse != Inverse::None) }
        );
    }
    assert_eq!(
        (arms[2].name(), arms[2].table(), arms[2].length_unit()),
        ("Bare", "| J1 |", LengthUnit::Inch)
    );
    assert_eq!((arms[2].limit(0), arms[2].limit(1), arms[2].limit(9)), (Some((-1.0, 2.0)), None, None));
    assert_eq!(arms[2].size(), LabRrr.reach());
}

#[test]
fn slots_come_out_as_they_are() {
    let arm: &dyn DynArm = &LAB_ARM;
    let pose = arm.pose_at(&[0.0; 6]).unwrap();
    let (mut solved, mut merged) = (0, 0);
    arm.solve_pose(&pose, &mut |slot| match slot.outcome {
        DynOutcome::Solved { q, residual, isolated, families } => {
            solved += 1;
            assert!(q.len() == 6 && residual < 1e-14);
            assert_eq!(Text::of(families).as_str().is_empty(), isolated);
        }
        DynOutcome::Merged { with } => {
            merged += 1;
            let (own, other) = (Text::of(slot.branch), Text::of(with));
            assert_eq!((own.as_str(), other.as_str()), ("right/up/flip", "right/up/noflip"));
        }
        DynOutcome::Empty { reason } => panic!("{reason}"),
    })
    .unwrap();
    assert_eq!((solved, merged), (7, 1));
    let mut empty = 0;
    let far = crate::pose::from_rows(crate::pose::rows(&pose).0, [1e4, 0.0, 0.0]);
    arm.solve_pose(&far, &mut |slot| empty += usize::from(matches!(slot.outcome, DynOutcome::Empty { .. })))
        .unwrap();
    assert_eq!(empty, 8);
}

#[test]
fn slices_of_the_wrong_length_are_errors() {
    let arm: &dyn DynArm = &LabRrr;
    let wrong = DynError::Joints { wanted: 3, given: 2 };
    assert_eq!(arm.pose_at(&[0.0; 2]).unwrap_err(), wrong);
    assert_eq!(arm.jacobian_at(&[0.0; 3], &mut [[0.0; 6]; 2]), Err(wrong));
    assert_eq!(arm.frames_at(&[0.0; 2], &mut []), Err(wrong));
    let mut columns = [[0.0; 6]; 3];
    arm.jacobian_at(&[0.0; 3], &mut columns).unwrap();
    assert!((columns[0][5] - 1.0).abs() < 1e-15);
    assert_eq!(Text::of(&wrong).as_str(), "the arm has 3 joints, 2 were given");
    assert!(Text::of(&DynError::NoInverse).as_str().contains("no inverse kinematics"));
}
