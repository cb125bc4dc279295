//! Arms of the seeds and the textbook, as their tables print them; the constants of their figures found by hand.

use super::{Step, apply, chain};
use crate::ik::{Base, ElbowBase, TelescopeBase, Wrist, position, spherical_wrist};
use crate::math::{self, Float, Real};
use crate::pose::{self, Joints, Pose};
use crate::private::{self, SolvePosition, SolveWrist};
use crate::{
    Arm, ArmPosture, InverseKinematics, Joint, JointKind, LengthUnit, Limits, PositionInverse, Posture,
    Solutions, SphericalWrist,
};
use core::f64::consts::{FRAC_PI_2, PI};
use nalgebra::{Matrix3, Point3};

const REVOLUTE: Joint = Joint { name: "J", kind: JointKind::Revolute };

/// The tables: by type, because the kinds of joint are constants of an arm's type.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Table<const WHICH: char>;

const LAB: char = 'l';
const PUMA: char = 'p';
const STANFORD: char = 's';

/// The arm of seed 000 in millimetres.
pub(crate) const LAB_ARM: Table<LAB> = Table;
/// The Puma 560.
pub(crate) const PUMA_560: Table<PUMA> = Table;
/// The base of the Stanford arm, with the wrist of the others.
pub(crate) const STANFORD_ARM: Table<STANFORD> = Table;

/// The last three rows of all three arms turn about z, -y, z.
fn zyz<T: Real>([t4, t5, t6]: [T; 3]) -> [Step<T>; 5] {
    let quarter = T::lit(FRAC_PI_2);
    [Step::TurnZ(t4), Step::TurnX(quarter), Step::TurnZ(t5), Step::TurnX(-quarter), Step::TurnZ(t6)]
}

impl<const WHICH: char> Table<WHICH> {
    /// From the base to just before axis 4, through the wrist centre.
    fn arm<T: Real>([t1, t2, t3]: [T; 3]) -> Pose<T> {
        let quarter = T::lit(FRAC_PI_2);
        let shift = |x: f64, y: f64, z: f64| Step::Shift([x, y, z].map(T::lit));
        chain(match WHICH {
            LAB => [
                Step::TurnZ(t1),
                shift(-30.0, 0.0, 92.0),
                Step::TurnX(quarter),
                Step::TurnZ(t2),
                shift(120.0, 0.0, 0.0),
                Step::TurnZ(t3 + quarter),
                Step::TurnX(-quarter),
                shift(20.0, 0.0, 130.0),
            ],
            PUMA => [
                Step::TurnZ(t1),
                shift(0.0, 0.0, 26.45 * 0.0254),
                Step::TurnX(quarter),
                Step::TurnZ(t2),
                shift(0.4318, 0.0, 0.15005),
                Step::TurnZ(t3),
                shift(0.0203, 0.4318, 0.0),
                Step::TurnX(-quarter),
            ],
            _ => [
                Step::TurnZ(t1),
                shift(0.0, 0.0, 0.412),
                Step::TurnX(-quarter),
                Step::TurnZ(t2),
                shift(0.0, 0.0, 0.154),
                Step::TurnX(quarter),
                Step::TurnZ(-quarter),
                Step::Shift([T::lit(0.0203), T::lit(0.0), t3]),
            ],
        })
    }

    fn tool<T: Real>() -> [T; 3] {
        [0.0, 0.0, if WHICH == LAB { 29.0 } else { 0.0 }].map(T::lit)
    }
}

impl<const WHICH: char> Arm<6> for Table<WHICH> {
    const NAME: &'static str = "Table";
    const LENGTH_UNIT: LengthUnit = if WHICH == LAB { LengthUnit::Millimetre } else { LengthUnit::Metre };
    const TABLE: &'static str = "";
    const JOINTS: [Joint; 6] = {
        let mut joints = [REVOLUTE; 6];
        if WHICH == STANFORD {
            joints[2].kind = JointKind::Prismatic;
        }
        joints
    };

    fn reach(&self) -> f64 {
        match WHICH {
            LAB => 47.0 + 30.0 + 45.0 + 120.0 + 20.0 + 130.0 + 29.0,
            PUMA => 26.45 * 0.0254 + 0.4318 + 0.15005 + 0.0203 + 0.4318,
            _ => 0.412 + 0.154 + 0.0203 + 38.0 * 0.0254,
        }
    }

    fn limits(&self) -> Limits<6> {
        Limits::new([Some((-PI, PI)), Some((-1.0, 1.0)), Some((-1.0, 1.0)), None, None, None])
    }

    fn fk<T: Real>(&self, q: &Joints<T, 6>) -> Pose<T> {
        let [t1, t2, t3, t4, t5, t6] = pose::entries(q);
        let (r, p) = pose::rows(&Self::arm([t1, t2, t3]));
        chain(
            [Step::Shift(p), Step::Turn(r)]
                .into_iter()
                .chain(zyz([t4, t5, t6]))
                .chain([Step::Shift(Self::tool())]),
        )
    }

    by_forward_kinematics!(6);
}

impl<const WHICH: char> SphericalWrist<6> for Table<WHICH> {
    fn r36<T: Real>(&self, q4: T, q5: T, q6: T) -> Matrix3<T> {
        let turned = pose::rows(&chain(zyz([q4, q5, q6]))).0;
        pose::matrix3(turned)
    }

    fn r03<T: Real>(&self, q1: T, q2: T, q3: T) -> (Matrix3<T>, Point3<T>) {
        let (r, p) = pose::rows(&Self::arm([q1, q2, q3]));
        (pose::matrix3(r), private::point(p))
    }

    fn wrist_angles<T: Float>(&self, r36: &Matrix3<T>) -> Wrist<T> {
        private::zyz(pose::matrix_rows(r36), [T::lit(0.0); 3], [false, true, false])
    }
}

impl<const WHICH: char> SolveWrist<6> for Table<WHICH> {
    fn base<T: Float>(&self) -> Base<T> {
        let [zero, one] = [0.0, 1.0].map(T::lit);
        let reach = T::lit(self.reach());
        let elbow = |a1: f64, twist, lateral: f64, upper: f64, fore: [f64; 2], turned: [f64; 3]| {
            let [x, y] = fore.map(T::lit);
            let [o1, o2, o3] = turned.map(T::lit);
            Base::Elbow(ElbowBase {
                a1: T::lit(a1),
                twist,
                lateral: T::lit(lateral),
                upper: T::lit(upper),
                fore: math::hypot(x, y),
                offset: [o1, o2, o3 + math::atan2(y, x)],
                reversed: [false; 3],
                reach,
            })
        };
        match WHICH {
            // The common normal of axes 1 and 2 points to -x, so that all is seen from behind.
            LAB => elbow(30.0, (-one, zero), 0.0, 120.0, [20.0, 130.0], [PI, PI, FRAC_PI_2]),
            PUMA => elbow(0.0, (one, zero), 0.15005, 0.4318, [0.0203, 0.4318], [0.0; 3]),
            _ => Base::Telescope(TelescopeBase {
                a1: zero,
                twist: (-one, zero),
                lateral: T::lit(0.154 - 0.0203),
                arm: zero,
                // The slide points away from axis 2 along -y of its frame.
                offset: [zero, T::lit(PI), zero],
                reversed: [false; 3],
                reach,
            }),
        }
    }

    fn wrist_centre<T: Real>(&self, pose: &Pose<T>) -> [T; 3] {
        let (r, [x, y, z]) = pose::rows(pose);
        let [tx, ty, tz] = apply(&r, &Self::tool());
        let [x, y, z] = [x - tx, y - ty, z - tz];
        match WHICH {
            LAB => [x, y, z - T::lit(92.0)],
            PUMA => [x, y, z - T::lit(26.45 * 0.0254)],
            _ => [x, y, z - T::lit(0.412)],
        }
    }

    fn wrist_rotation<T: Real>(&self, rows: [T; 3], pose: &Pose<T>) -> Matrix3<T> {
        let r03 = pose::rows(&Self::arm(rows)).0;
        pose::matrix3(pose::product(&pose::transposed(&r03), &pose::rows(pose).0))
    }

    fn command<T: Real>(&self, rows: [T; 6]) -> [T; 6] {
        rows
    }

    fn rows<T: Real>(&self, q: [T; 6]) -> [T; 6] {
        q
    }
}

impl<const WHICH: char> InverseKinematics<6> for Table<WHICH> {
    type Branch = Posture;

    fn ik<T: Float>(&self, pose: &Pose<T>) -> Solutions<T, 6, Posture> {
        spherical_wrist::solve(self, pose)
    }

    fn ik_holding<T: Float>(&self, pose: &Pose<T>, hold: &Joints<T, 6>) -> Solutions<T, 6, Posture> {
        spherical_wrist::solve_holding(self, pose, hold)
    }
}

/// The three-joint arm of seed 004, with its d = 0.168.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LabRrr;

impl Arm<3> for LabRrr {
    const NAME: &'static str = "LabRrr";
    const LENGTH_UNIT: LengthUnit = LengthUnit::Metre;
    const TABLE: &'static str = "";
    const JOINTS: [Joint; 3] = [REVOLUTE; 3];

    fn reach(&self) -> f64 {
        0.168 + 2.0 * 0.13335
    }

    fn limits(&self) -> Limits<3> {
        Limits::NONE
    }

    fn fk<T: Real>(&self, q: &Joints<T, 3>) -> Pose<T> {
        let [t1, t2, t3] = pose::entries(q);
        let link = [0.13335, 0.0, 0.0].map(T::lit);
        let quarter = T::lit(FRAC_PI_2);
        let stand = [Step::TurnZ(t1), Step::Shift([0.0, 0.0, 0.168].map(T::lit)), Step::TurnX(quarter)];
        chain(stand.into_iter().chain([
            Step::TurnZ(t2),
            Step::Shift(link),
            Step::TurnZ(t3),
            Step::Shift(link),
        ]))
    }

    by_forward_kinematics!(3);
}

impl SolvePosition<3> for LabRrr {
    fn base<T: Float>(&self) -> Base<T> {
        let [zero, one, link] = [0.0, 1.0, 0.13335].map(T::lit);
        Base::Elbow(ElbowBase {
            a1: zero,
            twist: (one, zero),
            lateral: zero,
            upper: link,
            fore: link,
            offset: [zero; 3],
            reversed: [false; 3],
            reach: T::lit(self.reach()),
        })
    }

    fn tool_point<T: Real>(&self, p: &Point3<T>) -> [T; 3] {
        let [x, y, z] = pose::entries(&p.coords);
        [x, y, z - T::lit(0.168)]
    }

    fn command<T: Real>(&self, rows: [T; 3]) -> [T; 3] {
        rows
    }

    fn rows<T: Real>(&self, q: [T; 3]) -> [T; 3] {
        q
    }
}

impl PositionInverse<3> for LabRrr {
    type Branch = ArmPosture;

    fn ik_position<T: Float>(&self, p: &Point3<T>) -> Solutions<T, 3, ArmPosture> {
        position::solve(self, p)
    }

    fn ik_position_holding<T: Float>(
        &self,
        p: &Point3<T>,
        hold: &Joints<T, 3>,
    ) -> Solutions<T, 3, ArmPosture> {
        position::solve_holding(self, p, hold)
    }
}
