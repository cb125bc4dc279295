//! Batches, by the instructions that they may use, beside what others take one by one.

use crate::clock::STRETCH;
use crate::data::Data;
use crate::peers::{self, Chain, Isometries, OPW_STEP};
use crate::ways::{Way, each, joints, q};
use kin_runtime::batch::{Found, Instructions, Run};
use kin_runtime::prelude::*;
use robots::Irb2400;
use rs_opw_kinematics::jacobian::Jacobian as OpwJacobian;
use rs_opw_kinematics::kinematic_traits::Kinematics;
use std::cell::RefCell;
use std::hint::black_box;
use std::ops::Range;
use std::rc::Rc;

/// Every batch with each set of instructions that this machine has, the widest first, then the peers.
pub(crate) fn all(data: &Rc<Data>) -> Vec<Way> {
    let sets = [
        (Instructions::Avx512, "this library, AVX-512"),
        (Instructions::Avx2, "this library, AVX2"),
        (Instructions::Baseline, "this library, baseline"),
    ];
    let here = || sets.into_iter().filter(|(set, _)| set.are_here());
    let (isometries, opw, opw_jacobian, chain, inverse) =
        (Isometries::new(), peers::opw(), peers::opw(), Chain::new(), peers::opw());
    let mut ways: Vec<Way> = here().map(|(set, name)| fk(data, set, name)).collect();
    ways.extend([
        each("fk, batch", "this library, one by one", data, joints, |q| Irb2400.fk(q)),
        each("fk, batch", "nalgebra, isometries", data, q, move |q| isometries.fk(q)),
        each("fk, batch", "rs-opw-kinematics", data, q, move |q| opw.forward(q)),
    ]);
    ways.extend(here().map(|(set, name)| jacobian(data, set, name)));
    ways.extend([
        each("jacobian, batch", "this library, one by one", data, joints, |q| Irb2400.jacobian(q)),
        each("jacobian, batch", "k", data, q, move |q| chain.jacobian(q)),
        each("jacobian, batch", "rs-opw-kinematics", data, q, move |q| {
            OpwJacobian::new(&opw_jacobian, q, OPW_STEP)
        }),
    ]);
    ways.extend(here().map(|(set, name)| both(data, set, name)));
    ways.push(each("fk and jacobian, batch", "this library, one by one", data, joints, |q| {
        Irb2400.fk_jacobian(q)
    }));
    // What takes nanoseconds is timed over more elements: of a short stretch a third would be the way of code and numbers into
    // the caches, which a batch makes once.
    ways.iter_mut().filter(|way| !SLOW.contains(&way.name)).for_each(|way| way.stretch = 16 * STRETCH);
    ways.extend(here().map(|(set, name)| ik(data, set, name)));
    ways.extend([
        each("ik, batch", "this library, one by one", data, |data| &data.poses, |pose| Irb2400.ik(pose)),
        each(
            "ik, batch",
            "rs-opw-kinematics",
            data,
            |data| &data.opw_poses,
            move |pose| inverse.inverse(pose),
        ),
    ]);
    ways
}

/// Whose Jacobians take a microsecond.
const SLOW: [&str; 2] = ["k", "rs-opw-kinematics"];

/// The slices fit.
const FITS: &str = "as many places as elements";

/// Poses and Jacobians of a batch.
pub(crate) const LENGTH: usize = 64;
/// Solutions of a batch: of more the caches would hold nothing else, for those that are timed after it either.
const SOLUTIONS: usize = 16;

/// Batches into the same places, which stay in the cache, as those of single calls do.
fn batch<I: 'static, P: 'static>(
    group: &'static str,
    name: &'static str,
    data: &Rc<Data>,
    list: fn(&Data) -> &[I],
    mut places: Vec<P>,
    call: impl Fn(&[I], &mut [P]) + 'static,
) -> Way {
    let data = Rc::clone(data);
    let run = move |which: Range<usize>| {
        for items in list(&data)[which].chunks(places.len()) {
            let places = &mut places[..items.len()];
            call(black_box(items), places);
            black_box(places);
        }
    };
    Way { group, name, stretch: STRETCH, run: Box::new(run) }
}

fn fk(data: &Rc<Data>, set: Instructions, name: &'static str) -> Way {
    batch("fk, batch", name, data, joints, vec![Pose::identity(); LENGTH], move |q, poses| {
        Run::new().at_most(set).fk(&Irb2400, q, poses).expect(FITS);
    })
}

fn jacobian(data: &Rc<Data>, set: Instructions, name: &'static str) -> Way {
    batch("jacobian, batch", name, data, joints, vec![Jacobian::zeros(); LENGTH], move |q, jacobians| {
        Run::new().at_most(set).jacobian(&Irb2400, q, jacobians).expect(FITS);
    })
}

fn both(data: &Rc<Data>, set: Instructions, name: &'static str) -> Way {
    let poses = RefCell::new(vec![Pose::identity(); LENGTH]);
    batch(
        "fk and jacobian, batch",
        name,
        data,
        joints,
        vec![Jacobian::zeros(); LENGTH],
        move |q, jacobians| {
            let poses = &mut poses.borrow_mut()[..q.len()];
            Run::new().at_most(set).fk_jacobian(&Irb2400, q, poses, jacobians).expect(FITS);
            black_box(poses);
        },
    )
}

fn ik(data: &Rc<Data>, set: Instructions, name: &'static str) -> Way {
    let places: Vec<Found<f64, 6, Irb2400>> = vec![None; SOLUTIONS];
    batch(
        "ik, batch",
        name,
        data,
        |data| &data.poses,
        places,
        move |poses, solutions| {
            Run::new().at_most(set).ik(&Irb2400, poses, solutions).expect(FITS);
        },
    )
}
