//! One thing asked of the library each, with inputs that no optimiser can foresee.

use core::hint::black_box;
use core::ops::ControlFlow;

use kin_runtime::batch::{self, Progress};
use kin_runtime::prelude::*;
use kin_runtime::{dexterity, position_dexterity};
use robots::{Cobra600, Irb2400, LabArm, LabRrr, Orion5, Puma560, Stanford, TwoLink};

use crate::bits::Random;
use crate::motion;

/// The number format of this build.
#[cfg(not(feature = "single"))]
pub type Number = f64;
/// The number format of this build.
#[cfg(feature = "single")]
pub type Number = f32;

dh! {
    /// Three skew axes carry the wrist: a quartic.
    pub struct Skew(standard, m, deg);

    | joint | theta |  d   |  a   | alpha |
    |-------|-------|------|------|-------|
    | J1    | q     |  0.3 | 0.15 |  60   |
    | J2    | q     |  0.1 | 0.45 |  75   |
    | J3    | q     | -0.2 | 0.25 | 110   |
    | J4    | q     |  0.3 | 0    | -90   |
    | J5    | q     |  0   | 0    |  90   |
    | J6    | q     |  0.1 | 0    |   0   |
}

dh! {
    /// An elbow arm whose wrist axes stand at 60° to each other.
    pub struct Oblique(standard, m, deg);

    | joint | theta |  d   |  a   | alpha |
    |-------|-------|------|------|-------|
    | J1    | q     | 0.4  | 0.1  | -90   |
    | J2    | q     | 0    | 0.45 |   0   |
    | J3    | q     | 0    | 0.05 |  90   |
    | J4    | q     | 0.5  | 0    | -60   |
    | J5    | q     | 0    | 0    |  60   |
    | J6    | q     | 0.1  | 0    |   0   |
}

dh! {
    /// Two slides and a turn between them: conics that meet in a chord.
    pub struct Slides(standard, m, deg);

    | joint | theta |  d   |  a   | alpha | limits    |
    |-------|-------|------|------|-------|-----------|
    | J1    | 20    |  q   | 0.1  |  60   | 0 .. 1    |
    | J2    | q     |  0.1 | 0.35 |  75   |           |
    | J3    | 35    |  q   | 0.25 | 110   | 0.1 .. 1  |
    | J4    | q     |  0.3 | 0    | -90   |           |
    | J5    | q     |  0   | 0    |  90   |           |
    | J6    | q     |  0.1 | 0    |   0   |           |
}

dh! {
    /// A shoulder whose three axes meet, an elbow, and a hand of two axes.
    pub struct Ball(standard, m, deg);

    | joint | theta  | d    | a    | alpha |
    |-------|--------|------|------|-------|
    | J1    | q      | 0.3  | 0    | -90   |
    | J2    | q      | 0    | 0    | 90    |
    | J3    | q + 90 | 0.4  | 0    | -90   |
    | J4    | q      | 0    | 0.35 | 0     |
    | J5    | q      | 0.03 | 0    | 90    |
    | J6    | q      | 0.08 | 0    | 0     |
}

/// Called with the step that is to be measured.
pub type Run<'a> = &'a mut dyn FnMut(&mut dyn FnMut());

/// A task: prepares inputs and hands the step itself to be measured.
pub type Task = fn(&mut Inputs, Run<'_>);

/// All tasks, as the programs of `bin` are named.
pub const ALL: [(&str, Task); 14] = [
    ("forward", forward),
    ("elbow", elbow),
    ("slide", slide),
    ("oblique", oblique),
    ("general", general),
    ("batch", batch),
    ("position", position),
    ("choice", choice),
    ("track", track),
    ("ball", ball),
    ("short", short),
    ("trajectory", motion::trajectory),
    ("watch", motion::watch),
    ("velocity", motion::velocity),
];

/// Where inputs come from.
pub struct Inputs(Random);

impl Inputs {
    /// A start that the compiler does not know.
    pub fn unknown() -> Self {
        Inputs(Random(black_box(1)))
    }

    /// Joint values, one in two at or near a singular pose.
    pub fn joints<const N: usize>(&mut self) -> Joints<Number, N> {
        let [values] = self.0.joints::<N>().data.0;
        kin_runtime::private::joints(values.map(<Number as Real>::lit))
    }
}

/// `fk`, `frames`, `jacobian` and `fk_jacobian` of the Puma.
pub fn forward(inputs: &mut Inputs, measure: Run<'_>) {
    let q = inputs.joints::<6>();
    measure(&mut || {
        let q = black_box(&q);
        let _ = black_box((Puma560.fk(q), Puma560.frames(q), Puma560.jacobian(q), Puma560.fk_jacobian(q)));
    });
}

fn inverse(arm: &impl InverseKinematics<6>, inputs: &mut Inputs, measure: Run<'_>) {
    let q = inputs.joints::<6>();
    let pose = arm.fk(&q);
    measure(&mut || {
        black_box(&arm.ik(black_box(&pose)));
    });
}

/// `ik` over a shoulder and an elbow.
pub fn elbow(inputs: &mut Inputs, measure: Run<'_>) {
    inverse(&Irb2400, inputs, measure);
}

/// `fk_jacobian_batch` and `ik_batch` of sixteen, told of as they go.
pub fn batch(inputs: &mut Inputs, measure: Run<'_>) {
    let q: [Joints<Number, 6>; 16] = core::array::from_fn(|_| inputs.joints());
    let poses = q.map(|q| Irb2400.fk(&q));
    let (mut places, mut jacobians) = (poses, q.map(|_| Jacobian::zeros()));
    let mut solutions = [const { None }; 16];
    measure(&mut || {
        let mut going_on = |_: Progress| black_box(ControlFlow::Continue(()));
        let mut run = batch::Run::new().with_progress(&mut going_on);
        let _ = black_box(run.fk_jacobian(&Irb2400, black_box(&q), &mut places, &mut jacobians));
        let _ = black_box(Irb2400.ik_batch(black_box(&poses), &mut solutions));
        black_box((&places, &jacobians, &solutions));
    });
}

/// `ik` over a shoulder and a slide.
pub fn slide(inputs: &mut Inputs, measure: Run<'_>) {
    inverse(&Stanford, inputs, measure);
}

/// `ik` with an oblique wrist.
pub fn oblique(inputs: &mut Inputs, measure: Run<'_>) {
    inverse(&Oblique, inputs, measure);
}

/// `ik` of an arm whose first three axes meet.
pub fn ball(inputs: &mut Inputs, measure: Run<'_>) {
    inverse(&Ball, inputs, measure);
}

/// `ik` and `ik_near` of an arm with a quill and of one with three parallel axes, `ik_position` of two joints.
pub fn short(inputs: &mut Inputs, measure: Run<'_>) {
    let (q, near, pair) = (inputs.joints::<4>(), inputs.joints::<4>(), inputs.joints::<2>());
    let (scara, waist) = (Cobra600.fk(&q), Orion5.fk(&q));
    let point = Point3 { coords: TwoLink.fk(&pair).translation.vector };
    measure(&mut || {
        let (scara, waist, near) = (black_box(&scara), black_box(&waist), black_box(&near));
        let _ = black_box((&Cobra600.ik(scara), &Orion5.ik(waist), &TwoLink.ik_position(black_box(&point))));
        let _ = black_box((Cobra600.ik_near(scara, near), Orion5.ik_near(waist, near)));
    });
}

/// `ik` over three skew axes, and over two slides.
pub fn general(inputs: &mut Inputs, measure: Run<'_>) {
    inverse(&Skew, inputs, measure);
    inverse(&Slides, inputs, measure);
}

/// `ik_position` and its choice.
pub fn position(inputs: &mut Inputs, measure: Run<'_>) {
    let (q, near) = (inputs.joints::<3>(), inputs.joints::<3>());
    let point = Point3 { coords: LabRrr.fk(&q).translation.vector };
    let limits = LabRrr.limits();
    measure(&mut || {
        let point = black_box(&point);
        let _ = black_box((
            &LabRrr.ik_position(point),
            LabRrr.ik_position_near_within(point, black_box(&near), &limits),
            LabRrr.closest_point(point),
            position_dexterity(&LabRrr, black_box(&near)),
        ));
    });
}

/// Everything that is asked of solutions: limits, windings, members of families, the nearest; and singular values.
pub fn choice(inputs: &mut Inputs, measure: Run<'_>) {
    let (q, near) = (inputs.joints::<6>(), inputs.joints::<6>());
    let (pose, limits) = (LabArm.fk(&q), LabArm.limits());
    measure(&mut || {
        let (pose, near, limits) = (black_box(&pose), black_box(&near), black_box(&limits));
        let solutions = LabArm.ik_holding(pose, near);
        let _ = black_box((
            solutions.nearest(near),
            &solutions.within(limits),
            solutions.nearest_winding(near, limits),
            LabArm.ik_near_within(pose, near, limits),
            LabArm.closest(pose),
            dexterity(&LabArm, near),
        ));
        for winding in solutions.windings(limits).take(64) {
            black_box(&winding);
        }
        for family in solutions.iter().flat_map(Solution::families).take(1) {
            let _ = black_box((
                family.constraint(),
                family.moving(),
                family.nearest(&LabArm, pose, near),
                &family.ranges(&LabArm, pose, limits),
            ));
        }
    });
}

/// Four poses of a path, a step for each, and how many solutions there are.
pub fn track(inputs: &mut Inputs, measure: Run<'_>) {
    let (start, way) = (inputs.joints::<6>(), inputs.joints::<6>());
    let pose = |step: u8| LabArm.fk(&(start + way * <Number as Real>::lit(1e-2 * f64::from(step))));
    let path = [pose(0), pose(1), pose(2), pose(3)];
    measure(&mut || {
        let path = black_box(&path);
        for step in
            LabArm.track(black_box(&start), path.iter().copied()).ahead(4).within(&LabArm.limits()).counted()
        {
            black_box(&step);
        }
    });
}
