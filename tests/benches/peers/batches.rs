//! Batches, by the instructions that they may use, beside what others take one by one.

use crate::data::Data;
use crate::peers::{self, Chain, Isometries, OPW_STEP};
use crate::ways::{Way, each, joints, q};
use kin_runtime::batch::{Found, Instructions, Run};
use kin_runtime::prelude::*;
use robots::Irb2400;
use rs_opw_kinematics::jacobian::Jacobian as OpwJacobian;
use rs_opw_kinematics::kinematic_traits::Kinematics;
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

/// The slices fit.
const FITS: &str = "as many places as elements";

fn fk(data: &Rc<Data>, set: Instructions, name: &'static str) -> Way {
    let data = Rc::clone(data);
    let mut poses = data.poses.clone();
    let run = move |which: Range<usize>| {
        let poses = &mut poses[which.clone()];
        Run::new().at_most(set).fk(&Irb2400, black_box(&data.joints[which]), poses).expect(FITS);
        black_box(poses);
    };
    Way { group: "fk, batch", name, run: Box::new(run) }
}

fn jacobian(data: &Rc<Data>, set: Instructions, name: &'static str) -> Way {
    let data = Rc::clone(data);
    let mut jacobians = vec![Jacobian::zeros(); data.joints.len()];
    let run = move |which: Range<usize>| {
        let jacobians = &mut jacobians[which.clone()];
        Run::new().at_most(set).jacobian(&Irb2400, black_box(&data.joints[which]), jacobians).expect(FITS);
        black_box(jacobians);
    };
    Way { group: "jacobian, batch", name, run: Box::new(run) }
}

fn both(data: &Rc<Data>, set: Instructions, name: &'static str) -> Way {
    let data = Rc::clone(data);
    let (mut poses, mut jacobians) = (data.poses.clone(), vec![Jacobian::zeros(); data.joints.len()]);
    let run = move |which: Range<usize>| {
        let (poses, jacobians) = (&mut poses[which.clone()], &mut jacobians[which.clone()]);
        let q = black_box(&data.joints[which]);
        Run::new().at_most(set).fk_jacobian(&Irb2400, q, poses, jacobians).expect(FITS);
        black_box((poses, jacobians));
    };
    Way { group: "fk and jacobian, batch", name, run: Box::new(run) }
}

/// Into the same places for every stretch, as its documentation advises.
fn ik(data: &Rc<Data>, set: Instructions, name: &'static str) -> Way {
    let data = Rc::clone(data);
    let mut places: Vec<Found<f64, 6, Irb2400>> = vec![None; 1024];
    let run = move |which: Range<usize>| {
        for poses in black_box(&data.poses[which]).chunks(places.len()) {
            let places = &mut places[..poses.len()];
            Run::new().at_most(set).ik(&Irb2400, poses, places).expect(FITS);
            black_box(places);
        }
    };
    Way { group: "ik, batch", name, run: Box::new(run) }
}
