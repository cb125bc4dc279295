//! The arms of `robots` as the reference speaks: metres, slices, reference names.
//!
//! Nothing is judged here: units are converted and generics turned into function pointers, so that one loop can go over
//! all arms.

use kin_runtime::JointKind;
use kin_runtime::prelude::*;

use crate::pose::{isometry, matrix};
use crate::reference::{self, Matrix4, Record};

/// A pose and a Jacobian by columns.
pub type PoseAndJacobian = (Matrix4, Vec<[f64; 6]>);

/// An inverse: pose and task in, all solutions out.
pub type Inverse = fn(&Matrix4, &str) -> Vec<Vec<f64>>;

/// One arm of `robots` that the reference knows.
pub struct Declared {
    /// Its name in the reference.
    pub name: &'static str,
    /// Σ|a| + |d| and prismatic travel.
    pub reach: fn() -> f64,
    /// The limits of each joint.
    pub limits: fn() -> Vec<Option<(f64, f64)>>,
    /// The pose of the tool.
    pub fk: fn(&[f64]) -> Matrix4,
    /// The frame of each joint.
    pub frames: fn(&[f64]) -> Vec<Matrix4>,
    /// The Jacobian by columns.
    pub jacobian: fn(&[f64]) -> Vec<[f64; 6]>,
    /// Both at once.
    pub fk_jacobian: fn(&[f64]) -> PoseAndJacobian,
    /// All solutions, where there is an inverse.
    pub inverse: Option<Inverse>,
    /// What it can be asked for.
    pub tasks: &'static [&'static str],
}

impl Declared {
    /// What the reference says about it.
    pub fn record(&self) -> Record {
        reference::arm(self.name)
    }
}

macro_rules! declared {
    ($($Arm:ident $file:ident $inverse:ident $reference:tt;)*) => {
        /// Every arm of `robots` that the reference knows.
        pub fn all() -> Vec<Declared> {
            [$(entry!($Arm $inverse $reference)),*].into_iter().flatten().collect()
        }
    };
}

macro_rules! entry {
    ($Arm:ident $inverse:ident _) => {
        None
    };
    ($Arm:ident $inverse:ident $reference:literal) => {
        Some(Declared {
            name: $reference,
            reach: reach::<_, robots::$Arm>,
            limits: limits::<_, robots::$Arm>,
            fk: fk::<_, robots::$Arm>,
            frames: frames::<_, robots::$Arm>,
            jacobian: jacobian::<_, robots::$Arm>,
            fk_jacobian: fk_jacobian::<_, robots::$Arm>,
            inverse: inverse!($Arm $inverse),
            tasks: tasks!($inverse),
        })
    };
}

macro_rules! inverse {
    ($Arm:ident pose) => {
        Some(from_pose::<_, robots::$Arm> as Inverse)
    };
    ($Arm:ident short) => {
        Some(from_pose::<_, robots::$Arm> as Inverse)
    };
    ($Arm:ident position) => {
        Some(from_either::<_, robots::$Arm> as Inverse)
    };
    ($Arm:ident pair) => {
        Some(from_either::<_, robots::$Arm> as Inverse)
    };
    ($Arm:ident none) => {
        None
    };
}

macro_rules! tasks {
    (pose) => {
        &["pose"]
    };
    (short) => {
        &["pose"]
    };
    (position) => {
        &["pose", "position"]
    };
    (pair) => {
        &["pose", "position"]
    };
    (none) => {
        &[]
    };
}

robots::for_each!(declared);

fn metres<const N: usize, A: Arm<N>>() -> f64 {
    A::LENGTH_UNIT.metres()
}

/// One for a turning joint, the unit of length for a sliding one.
fn unit<const N: usize, A: Arm<N>>(joint: usize) -> f64 {
    if A::JOINTS[joint].kind == JointKind::Prismatic { metres::<N, A>() } else { 1.0 }
}

fn joints<const N: usize, A: Arm<N>>(q: &[f64]) -> Joints<f64, N> {
    Joints::from_fn(|joint, _| q[joint] / unit::<N, A>(joint))
}

fn values<const N: usize, A: Arm<N>>(q: &Joints<f64, N>) -> Vec<f64> {
    (0..N).map(|joint| q[joint] * unit::<N, A>(joint)).collect()
}

fn columns<const N: usize, A: Arm<N>>(j: &Jacobian<f64, N>) -> Vec<[f64; 6]> {
    let length = metres::<N, A>();
    (0..N)
        .map(|c| std::array::from_fn(|r| j[(r, c)] * if r < 3 { length } else { 1.0 } / unit::<N, A>(c)))
        .collect()
}

fn reach<const N: usize, A: Arm<N> + Default>() -> f64 {
    A::default().reach() * metres::<N, A>()
}

fn limits<const N: usize, A: Arm<N> + Default>() -> Vec<Option<(f64, f64)>> {
    let limits = A::default().limits();
    (0..N)
        .map(|i| limits.range(i).map(|(low, high)| (low * unit::<N, A>(i), high * unit::<N, A>(i))))
        .collect()
}

fn fk<const N: usize, A: Arm<N> + Default>(q: &[f64]) -> Matrix4 {
    matrix(&A::default().fk(&joints::<N, A>(q)), metres::<N, A>())
}

fn frames<const N: usize, A: Arm<N> + Default>(q: &[f64]) -> Vec<Matrix4> {
    A::default().frames(&joints::<N, A>(q)).iter().map(|frame| matrix(frame, metres::<N, A>())).collect()
}

fn jacobian<const N: usize, A: Arm<N> + Default>(q: &[f64]) -> Vec<[f64; 6]> {
    columns::<N, A>(&A::default().jacobian(&joints::<N, A>(q)))
}

fn fk_jacobian<const N: usize, A: Arm<N> + Default>(q: &[f64]) -> PoseAndJacobian {
    let (pose, jacobian) = A::default().fk_jacobian(&joints::<N, A>(q));
    (matrix(&pose, metres::<N, A>()), columns::<N, A>(&jacobian))
}

fn from_pose<const N: usize, A: InverseKinematics<N> + Default>(pose: &Matrix4, _: &str) -> Vec<Vec<f64>> {
    let solutions = A::default().ik(&isometry(pose, 1.0 / metres::<N, A>()));
    solutions.iter().map(|s| values::<N, A>(&s.q)).collect()
}

fn from_either<const N: usize, A: InverseKinematics<N> + PositionInverse<N> + Default>(
    pose: &Matrix4,
    task: &str,
) -> Vec<Vec<f64>> {
    if task == "pose" {
        return from_pose::<N, A>(pose, task);
    }
    let point = [0, 1, 2].map(|i| pose[i][3] / metres::<N, A>());
    let solutions = A::default().ik_position(&Point3::from(point));
    solutions.iter().map(|s| values::<N, A>(&s.q)).collect()
}
