//! Same bits everywhere: forward kinematics, Jacobians and inverse solutions of many poses in one number.
//!
//! This file is compiled for every target, by `tests` and by the programs of `tests/no-std`: it uses `core` alone.

pub mod aimed;

use kin_runtime::Constraint;
use kin_runtime::prelude::*;
use robots::{Cobra600, Irb2400, LabArm, LabRrr, Orion5, Puma560, Stanford, TwoLink};

dh! {
    /// No two neighbouring axes of the base meet or are parallel, and joint 2 is coupled to joint 1.
    pub struct Oblique(standard, m, deg);

    | joint | theta | d    | a    | alpha |
    |-------|-------|------|------|-------|
    | J1    | q     | 0.3  | 0.15 | 60    |
    | J2    | q     | 0.1  | 0.45 | 75    |
    | J3    | q     | -0.2 | 0.25 | 110   |
    | J4    | q     | 0.3  | 0    | -80   |
    | J5    | q     | 0    | 0    | 70    |
    | J6    | q     | 0.1  | 0    | 0     |

    couple: J2 += J1;
}

dh! {
    /// Two slides carry the turn that carries the wrist.
    pub struct Gantry(standard, m, deg);

    | joint | theta | d   | a   | alpha |
    |-------|-------|-----|-----|-------|
    | J1    | 0     | q   | 0.1 | 90    |
    | J2    | 40    | q   | 0.2 | 55    |
    | J3    | q     | 0.1 | 0.5 | 90    |
    | J4    | q     | 0.3 | 0   | -90   |
    | J5    | q     | 0   | 0   | 90    |
    | J6    | q     | 0.1 | 0   | 0     |
}

dh! {
    /// A shoulder like a ball, an elbow, and a hand of two axes.
    pub struct Ball(standard, m, deg);

    | joint | theta  | d    | a    | alpha |
    |-------|--------|------|------|-------|
    | J1    | q      | 0.3  | 0    | -90   |
    | J2    | q      | 0    | 0    | 90    |
    | J3    | q + 90 | 0.4  | 0    | -90   |
    | J4    | q      | 0    | 0.35 | 0     |
    | J5    | q      | 0.03 | 0    | 90    |
    | J6    | q      | 0.08 | 0    | 0     |

    base: Rx(20) Tz(0.5);
    tool: Tz(0.1) Ry(30);
}

/// The poses of the figure that all targets must agree on.
pub const POSES: u32 = 2_000;
/// The poses of the quick figure, for targets that are interpreted: every arm three times.
pub const QUICK: u32 = 33;

/// A hash that depends on every bit and on the order: multiply and fold, over NaNs made one.
struct Hash(u64);

impl Hash {
    fn word(&mut self, word: u64) {
        let mixed = (self.0 ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = (mixed ^ (mixed >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9) ^ (mixed >> 32);
    }

    fn numbers(&mut self, numbers: impl IntoIterator<Item = f64>) {
        for number in numbers {
            self.word(if number.is_nan() { f64::NAN.to_bits() } else { number.to_bits() });
        }
    }

    fn pose(&mut self, pose: &Pose<f64>) {
        self.numbers(pose.rotation.matrix().data.0.into_iter().flatten());
        self.numbers(pose.translation.vector.data.0.into_iter().flatten());
    }

    fn solutions<const N: usize, B: Branch>(&mut self, solutions: &Solutions<f64, N, B>) {
        for slot in solutions.slots() {
            match slot {
                Slot::Solved(solution) => {
                    self.word(1);
                    self.numbers(solution.q.data.0.into_iter().flatten());
                    self.numbers([solution.residual, solution.margins.shoulder, solution.margins.elbow]);
                    self.numbers(solution.margins.wrist);
                    for family in solution.families() {
                        self.word(family.free() as u64);
                        if let Constraint::Sum { equals, .. } = family.constraint() {
                            self.numbers([equals]);
                        }
                    }
                }
                Slot::Merged { .. } => self.word(2),
                Slot::Empty(Reason::OutOfReach { by, theta1, .. }) => {
                    self.word(3);
                    self.numbers([*by]);
                    self.numbers(*theta1);
                }
                Slot::Empty(Reason::Orientation { by }) => {
                    self.word(5);
                    self.numbers([*by]);
                }
                Slot::Empty(_) => self.word(4),
            }
        }
    }
}

/// A linear congruential generator (D. Knuth, MMIX): a few lines that any target does alike.
pub struct Random(pub u64);

impl Random {
    /// In [-1, 1).
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    /// Joint values: any, some far beyond a turn, some at multiples of a quarter turn, where arms are singular.
    pub fn joints<const N: usize>(&mut self) -> Joints<f64, N> {
        let kind = self.unit();
        let mut value = || {
            let (unit, near) = (self.unit(), self.unit());
            match () {
                () if kind < 0.4 => unit * core::f64::consts::PI,
                () if kind < 0.5 => unit * 1e4,
                () if unit < 0.0 => near * core::f64::consts::PI,
                () if unit < 0.3 => 0.0,
                () if unit < 0.6 => near * 1e-9,
                () => core::f64::consts::FRAC_PI_2 + near * 1e-14,
            }
        };
        kin_runtime::private::joints(core::array::from_fn(|_| value()))
    }
}

fn forward<const N: usize>(arm: &impl Arm<N>, q: &Joints<f64, N>, hash: &mut Hash) -> Pose<f64> {
    let (pose, jacobian) = (arm.fk(q), arm.jacobian(q));
    hash.pose(&pose);
    hash.numbers(jacobian.data.0.into_iter().flatten());
    pose
}

fn from_pose<const N: usize>(arm: &impl InverseKinematics<N>, random: &mut Random, hash: &mut Hash) {
    let q = random.joints::<N>();
    let mut pose = forward(arm, &q, hash);
    hash.solutions(&arm.ik(&pose));
    // Out of reach, or just so.
    for x in pose.translation.vector.data.0.iter_mut().flatten() {
        *x *= 1.5;
    }
    hash.solutions(&arm.ik(&pose));
}

fn from_position<const N: usize>(arm: &impl PositionInverse<N>, random: &mut Random, hash: &mut Hash) {
    let q = random.joints::<N>();
    let pose = forward(arm, &q, hash);
    hash.solutions(&arm.ik_position(&Point3 { coords: pose.translation.vector }));
}

/// The hash of so many poses, each of one of the arms in turn: wrists on every kind of base, a shoulder, two to four joints.
pub fn hash(poses: u32) -> u64 {
    let (mut random, mut hash) = (Random(1), Hash(0));
    for pose in 0..poses {
        match pose % 11 {
            0 => from_pose(&Puma560, &mut random, &mut hash),
            1 => from_pose(&LabArm, &mut random, &mut hash),
            2 => from_pose(&Irb2400, &mut random, &mut hash),
            3 => from_pose(&Stanford, &mut random, &mut hash),
            4 => from_pose(&Oblique, &mut random, &mut hash),
            5 => from_pose(&Gantry, &mut random, &mut hash),
            6 => from_pose(&Ball, &mut random, &mut hash),
            7 => from_pose(&Cobra600, &mut random, &mut hash),
            8 => from_pose(&Orion5, &mut random, &mut hash),
            9 => from_position(&LabRrr, &mut random, &mut hash),
            _ => from_position(&TwoLink, &mut random, &mut hash),
        }
    }
    hash.0
}
