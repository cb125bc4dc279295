//! Arms of random geometry, spelled in the solver's own figures.

use super::{Random, Rotation, Step, about_z, apply, chain, lit};
use crate::ik::{Base, ElbowBase, TelescopeBase, Wrist, spherical_wrist};
use crate::math::{self, Float, Real};
use crate::pose::{self, Joints, Pose};
use crate::private::{self, SolveWrist};
use crate::{
    Arm, InverseKinematics, Joint, JointKind, LengthUnit, Limits, Posture, Solutions, SphericalWrist,
};
use core::f64::consts::FRAC_PI_2;
use nalgebra::{Matrix3, Point3};

/// A quarter turn about x, exactly, and back.
const QUARTERS: [Rotation; 2] = [
    [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]],
    [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]],
];

/// Every constant is free: what the solver is given is what this multiplies out. A slide stands in the place of
/// joint 3 if `SLIDE`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Figures<const SLIDE: bool> {
    pub(crate) a1: f64,
    pub(crate) twist: f64,
    pub(crate) lateral: f64,
    /// Upper and fore; the arm and nothing for a slide.
    pub(crate) links: [f64; 2],
    pub(crate) offset: [f64; 6],
    pub(crate) reversed: [bool; 6],
    /// The shoulder frame in the base.
    pub(crate) base: (Rotation, [f64; 3]),
    /// Before the wrist and after it, and the tool point from the wrist centre.
    pub(crate) mount: [Rotation; 2],
    pub(crate) tool: [f64; 3],
    /// The constant rotations between the wrist axes, if the wrist is oblique.
    pub(crate) between: Option<[Rotation; 2]>,
    /// q3 is tied to joint 2, q5 to joint 4 and q6 to joint 5, as in industrial arms.
    pub(crate) coupled: bool,
}

impl<const SLIDE: bool> Figures<SLIDE> {
    pub(crate) fn random(random: &mut Random, orthogonal: bool) -> Self {
        let twist = if random.coin() { FRAC_PI_2 } else { random.within(0.5, 2.6) };
        let twist = if random.coin() { twist } else { -twist };
        let arm = if SLIDE { random.sometimes(0.0, 0.3) } else { random.within(0.2, 1.0) };
        Self {
            a1: random.sometimes(0.0, 0.5),
            twist,
            lateral: random.sometimes(-0.4, 0.4),
            links: [arm, if SLIDE { 0.0 } else { random.within(0.2, 1.0) }],
            offset: [(); 6].map(|()| random.angle()),
            reversed: [(); 6].map(|()| random.coin()),
            base: (random.rotation(), [(); 3].map(|()| random.within(-0.5, 0.5))),
            mount: [random.rotation(), random.rotation()],
            tool: [(); 3].map(|()| random.sometimes(-0.2, 0.2)),
            between: (!orthogonal).then(|| [random.rotation(), random.rotation()]),
            coupled: random.coin(),
        }
    }

    fn figure<T: Real>(&self, rows: [T; 6]) -> [T; 6] {
        let mut values = rows;
        for ((value, offset), reversed) in values.iter_mut().zip(self.offset).zip(self.reversed) {
            *value = T::lit(offset) + if reversed { -*value } else { *value };
        }
        values
    }

    /// From the base to just before the wrist, by figure values.
    fn arm<T: Real>(&self, [psi1, psi2, psi3, ..]: [T; 6]) -> Pose<T> {
        let zero = T::lit(0.0);
        let (rotation, position) = self.base;
        let [first, second] = self.links.map(T::lit);
        let link = if SLIDE {
            [Step::Shift([first, psi3, zero]), Step::TurnZ(zero), Step::TurnZ(zero)]
        } else {
            [Step::Shift([first, zero, zero]), Step::TurnZ(psi3), Step::Shift([second, zero, zero])]
        };
        let stand = [
            Step::Shift(position.map(T::lit)),
            Step::Turn(lit(&rotation)),
            Step::TurnZ(psi1),
            Step::Shift([T::lit(self.a1), zero, zero]),
            Step::TurnX(T::lit(self.twist)),
            Step::TurnZ(psi2),
        ];
        chain(stand.into_iter().chain(link).chain([Step::Shift([zero, zero, T::lit(self.lateral)])]))
    }

    fn wrist<T: Real>(&self, [.., psi4, psi5, psi6]: [T; 6]) -> [[T; 3]; 3] {
        let [before, after] = self.mount.map(|m| lit(&m));
        let [k4, k5] = self.between.unwrap_or(QUARTERS).map(|m| lit(&m));
        let turns = [before, about_z(psi4), k4, about_z(psi5), k5, about_z(psi6), after];
        pose::rows(&chain(turns.map(Step::Turn))).0
    }

    fn twist<T: Real>(&self) -> (T, T) {
        if self.twist == FRAC_PI_2 { (T::lit(1.0), T::lit(0.0)) } else { math::sin_cos(T::lit(self.twist)) }
    }
}

impl<const SLIDE: bool> Arm<6> for Figures<SLIDE> {
    const NAME: &'static str = "Figures";
    const LENGTH_UNIT: LengthUnit = LengthUnit::Metre;
    const TABLE: &'static str = "";
    const JOINTS: [Joint; 6] = {
        let mut joints = [Joint { name: "J", kind: JointKind::Revolute }; 6];
        if SLIDE {
            joints[2].kind = JointKind::Prismatic;
        }
        joints
    };

    fn reach(&self) -> f64 {
        let [first, second] = self.links;
        let tool = self.tool.iter().fold(0.0, |sum, x| sum + x.abs());
        self.a1 + self.lateral.abs() + first + second + tool + if SLIDE { 1.0 } else { 0.0 }
    }

    fn limits(&self) -> Limits<6> {
        Limits::NONE
    }

    fn fk<T: Real>(&self, q: &Joints<T, 6>) -> Pose<T> {
        let figure = self.figure(self.rows(pose::entries(q)));
        let (r, p) = pose::rows(&self.arm(figure));
        chain([
            Step::Shift(p),
            Step::Turn(r),
            Step::Turn(self.wrist(figure)),
            Step::Shift(self.tool.map(T::lit)),
        ])
    }

    by_forward_kinematics!(6);
}

impl<const SLIDE: bool> SphericalWrist<6> for Figures<SLIDE> {
    fn r36<T: Real>(&self, q4: T, q5: T, q6: T) -> Matrix3<T> {
        let zero = T::lit(0.0);
        pose::matrix3(self.wrist(self.figure([zero, zero, zero, q4, q5, q6])))
    }

    fn r03<T: Real>(&self, q1: T, q2: T, q3: T) -> (Matrix3<T>, Point3<T>) {
        let zero = T::lit(0.0);
        let (r, p) = pose::rows(&self.arm(self.figure([q1, q2, q3, zero, zero, zero])));
        (pose::matrix3(r), private::point(p))
    }

    fn wrist_angles<T: Float>(&self, r36: &Matrix3<T>) -> Wrist<T> {
        let [before, after] = self.mount.map(|m| lit::<T>(&m));
        let m = pose::product(
            &pose::product(&pose::transposed(&before), &pose::matrix_rows(r36)),
            &pose::transposed(&after),
        );
        let [_, _, _, o4, o5, o6] = self.offset.map(T::lit);
        let [_, _, _, r4, r5, r6] = self.reversed;
        match self.between {
            None => private::zyz(m, [o4, o5, o6], [r4, r5, r6]),
            Some([k4, k5]) => private::oblique(m, lit(&k4), lit(&k5), [o4, o5, o6], [r4, r5, r6]),
        }
    }
}

impl<const SLIDE: bool> SolveWrist<6> for Figures<SLIDE> {
    fn base<T: Float>(&self) -> Base<T> {
        let [o1, o2, o3, ..] = self.offset.map(T::lit);
        let [r1, r2, r3, ..] = self.reversed;
        let (offset, reversed) = ([o1, o2, o3], [r1, r2, r3]);
        let (a1, lateral, reach) = (T::lit(self.a1), T::lit(self.lateral), T::lit(self.reach()));
        let (twist, [first, second]) = (self.twist(), self.links.map(T::lit));
        if SLIDE {
            Base::Telescope(TelescopeBase { a1, twist, lateral, arm: first, offset, reversed, reach })
        } else {
            Base::Elbow(ElbowBase { a1, twist, lateral, upper: first, fore: second, offset, reversed, reach })
        }
    }

    fn wrist_centre<T: Real>(&self, pose: &Pose<T>) -> [T; 3] {
        let (r, [x, y, z]) = pose::rows(pose);
        let (base, [bx, by, bz]) = self.base;
        let [tx, ty, tz] = apply(&r, &self.tool.map(T::lit));
        let centre = [x - tx - T::lit(bx), y - ty - T::lit(by), z - tz - T::lit(bz)];
        apply(&pose::transposed(&lit(&base)), &centre)
    }

    fn wrist_rotation<T: Real>(&self, rows: [T; 3], pose: &Pose<T>) -> Matrix3<T> {
        let [t1, t2, t3] = rows;
        let (r03, _) = self.r03(t1, t2, t3);
        pose::matrix3(pose::product(&pose::transposed(&pose::matrix_rows(&r03)), &pose::rows(pose).0))
    }

    fn command<T: Real>(&self, rows: [T; 6]) -> [T; 6] {
        let [t1, t2, t3, t4, t5, t6] = rows;
        if !self.coupled {
            return rows;
        }
        // The third joint slides: a length takes no angle.
        let q3 = if SLIDE { t3 } else { t3 + t2 };
        [t1, t2, q3, t4, t5 - t4, t6 + t5 - t4]
    }

    fn rows<T: Real>(&self, q: [T; 6]) -> [T; 6] {
        let [q1, q2, q3, q4, q5, q6] = q;
        if !self.coupled {
            return q;
        }
        let t3 = if SLIDE { q3 } else { q3 - q2 };
        [q1, q2, t3, q4, q5 + q4, q6 - q5]
    }
}

impl<const SLIDE: bool> InverseKinematics<6> for Figures<SLIDE> {
    type Branch = Posture;

    fn ik<T: Float>(&self, pose: &Pose<T>) -> Solutions<T, 6, Posture> {
        spherical_wrist::solve(self, pose)
    }

    fn ik_holding<T: Float>(&self, pose: &Pose<T>, hold: &Joints<T, 6>) -> Solutions<T, 6, Posture> {
        spherical_wrist::solve_holding(self, pose, hold)
    }
}
