//! Everything that is timed, each way over the same configurations.

use crate::batches;
use crate::clock::STRETCH;
use crate::data::Data;
use crate::peers::{self, Chain, Isometries, Matrices, OPW_STEP, Rotations};
use kin_runtime::prelude::*;
use robots::Irb2400;
use rs_opw_kinematics::jacobian::Jacobian as OpwJacobian;
use rs_opw_kinematics::kinematic_traits::Kinematics;
use std::hint::black_box;
use std::ops::Range;
use std::rc::Rc;

/// One way of computing one thing.
pub(crate) struct Way {
    pub(crate) group: &'static str,
    pub(crate) name: &'static str,
    /// How many elements it is timed over in one go.
    pub(crate) stretch: usize,
    /// Does so for these of the elements.
    pub(crate) run: Box<dyn FnMut(Range<usize>)>,
}

/// One after the other, none waiting for the one before.
pub(crate) fn each<I: 'static, O>(
    group: &'static str,
    name: &'static str,
    data: &Rc<Data>,
    list: fn(&Data) -> &[I],
    call: impl Fn(&I) -> O + 'static,
) -> Way {
    let data = Rc::clone(data);
    let run = move |which: Range<usize>| {
        for item in &list(&data)[which] {
            black_box(&call(black_box(item)));
        }
    };
    Way { group, name, stretch: STRETCH, run: Box::new(run) }
}

/// Each asked with what the one before gave: an addition and a multiplication, by nothing, go into every entry.
fn chained<I: 'static>(
    group: &'static str,
    name: &'static str,
    data: &Rc<Data>,
    list: fn(&Data) -> &[I],
    call: impl Fn(&I, f64) -> f64 + 'static,
) -> Way {
    let data = Rc::clone(data);
    let run = move |which: Range<usize>| {
        let mut carry = 0.0;
        for item in &list(&data)[which] {
            carry = call(black_box(item), carry * 0.0);
        }
        black_box(carry);
    };
    Way { group, name, stretch: STRETCH, run: Box::new(run) }
}

/// All ways; of each group this library's comes first. Single calls come before batches.
pub(crate) fn all(data: &Rc<Data>) -> Vec<Way> {
    let mut ways = single(data);
    ways.extend(batches::all(data));
    ways
}

/// Those of one call for each element.
pub(crate) fn single(data: &Rc<Data>) -> Vec<Way> {
    peers::agree(&data.q[..500]);
    let mut ways = forward(data);
    ways.extend(differential(data));
    ways.extend(inverse(data));
    ways
}

pub(crate) fn q(data: &Data) -> &[[f64; 6]] {
    &data.q
}

pub(crate) fn joints(data: &Data) -> &[Joints<f64, 6>] {
    &data.joints
}

fn forward(data: &Rc<Data>) -> Vec<Way> {
    let (opw, isometries, rotations) = (peers::opw(), Isometries::new(), Rotations::new());
    let (matrices, chain) = (Matrices::new(), Chain::new());
    let (waiting_opw, waiting) = (peers::opw(), Isometries::new());
    vec![
        each("fk", "this library", data, joints, |q| Irb2400.fk(q)),
        each("fk", "nalgebra, isometries", data, q, move |q| isometries.fk(q)),
        each("fk", "nalgebra, isometries with matrices", data, q, move |q| rotations.fk(q)),
        each("fk", "nalgebra, 4×4 matrices", data, q, move |q| matrices.fk(q)),
        each("fk", "rs-opw-kinematics", data, q, move |q| opw.forward(q)),
        each("fk", "k", data, q, move |q| chain.fk(q)),
        chained("fk, each waiting for the last", "this library", data, joints, |q, nothing| {
            Irb2400.fk(&q.map(|q| q + nothing)).translation.vector.x
        }),
        chained("fk, each waiting for the last", "nalgebra, isometries", data, q, move |q, nothing| {
            waiting.fk(&q.map(|q| q + nothing)).translation.vector.x
        }),
        chained("fk, each waiting for the last", "rs-opw-kinematics", data, q, move |q, nothing| {
            waiting_opw.forward(&q.map(|q| q + nothing)).translation.x
        }),
    ]
}

fn differential(data: &Rc<Data>) -> Vec<Way> {
    let (opw, chain) = (peers::opw(), Chain::new());
    vec![
        each("fk and jacobian", "this library", data, joints, |q| Irb2400.fk_jacobian(q)),
        each("fk and jacobian", "k", data, q, move |q| chain.jacobian(q)),
        each("fk and jacobian", "rs-opw-kinematics", data, q, move |q| OpwJacobian::new(&opw, q, OPW_STEP)),
    ]
}

fn inverse(data: &Rc<Data>) -> Vec<Way> {
    let (opw, waiting) = (peers::opw(), peers::opw());
    vec![
        each("ik", "this library", data, |data| &data.poses, |pose| Irb2400.ik(pose)),
        each("ik", "rs-opw-kinematics", data, |data| &data.opw_poses, move |pose| opw.inverse(pose)),
        chained(
            "ik, each waiting for the last",
            "this library",
            data,
            |data| &data.poses,
            |pose, nothing| {
                let mut pose = *pose;
                pose.translation.vector.x += nothing;
                Irb2400.ik(&pose).iter().next().map_or(0.0, |solution| solution.q.x)
            },
        ),
        chained(
            "ik, each waiting for the last",
            "rs-opw-kinematics",
            data,
            |data| &data.opw_poses,
            move |pose, nothing| {
                let mut pose = *pose;
                pose.translation.x += nothing;
                waiting.inverse(&pose).first().map_or(0.0, |q| q[0])
            },
        ),
    ]
}
