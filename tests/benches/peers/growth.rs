//! How cost grows: with joints, with solutions, with the length of a batch, with the size of angles. Each group beside its own
//! first line.

use crate::clock::STRETCH;
use crate::data::{COUNT, Data};
use crate::ways::Way;
use kin_runtime::batch::Found;
use kin_runtime::prelude::*;
use robots::{Cobra600, Irb2400, LabRrr, Panda, TwoLink};
use std::hint::black_box;
use std::ops::Range;
use std::rc::Rc;
use tests::sample::Sampler;

dh! {
    /// A waist, three parallel joints and a roll, in the proportions of small educational arms.
    pub struct FiveAxis(standard, m, deg);

    | joint | theta | d    | a    | alpha |
    |-------|-------|------|------|-------|
    | J1    | q     | 0.07 | 0    |  90   |
    | J2    | q     | 0    | 0.15 |   0   |
    | J3    | q     | 0    | 0.19 |   0   |
    | J4    | q     | 0    | 0    |  90   |
    | J5    | q     | 0.09 | 0    |   0   |
}

/// One call for each of a list, none waiting for the one before.
fn listed<I: 'static, O>(
    group: &'static str,
    name: &'static str,
    list: Vec<I>,
    call: impl Fn(&I) -> O + 'static,
) -> Way {
    let run = move |which: Range<usize>| {
        for item in &list[which] {
            black_box(&call(black_box(item)));
        }
    };
    Way { group, name, stretch: STRETCH, run: Box::new(run) }
}

fn random<const N: usize>() -> Vec<Joints<f64, N>> {
    let mut sampler = Sampler::new(19);
    (0..COUNT).map(|_| Joints::from(sampler.angles::<N>())).collect()
}

fn reached<const N: usize>(arm: &impl Arm<N>) -> Vec<Pose<f64>> {
    random().iter().map(|q| arm.fk(q)).collect()
}

fn point(pose: &Pose<f64>) -> Point3<f64> {
    Point3::from(pose.translation.vector)
}

/// All groups.
pub(crate) fn all(data: &Rc<Data>) -> Vec<Way> {
    let mut ways = joints();
    ways.extend(solutions());
    ways.extend(lengths(data));
    ways.extend(angles());
    ways
}

/// By the number of joints.
fn joints() -> Vec<Way> {
    let (fk, both, ik) = ("fk, by joints", "fk and jacobian, by joints", "ik, by joints");
    vec![
        listed(fk, "2", random(), |q| TwoLink.fk(q)),
        listed(fk, "3", random(), |q| LabRrr.fk(q)),
        listed(fk, "4", random(), |q| Cobra600.fk(q)),
        listed(fk, "5", random(), |q| FiveAxis.fk(q)),
        listed(fk, "6", random(), |q| Irb2400.fk(q)),
        listed(fk, "7", random(), |q| Panda.fk(q)),
        listed(both, "2", random(), |q| TwoLink.fk_jacobian(q)),
        listed(both, "3", random(), |q| LabRrr.fk_jacobian(q)),
        listed(both, "4", random(), |q| Cobra600.fk_jacobian(q)),
        listed(both, "5", random(), |q| FiveAxis.fk_jacobian(q)),
        listed(both, "6", random(), |q| Irb2400.fk_jacobian(q)),
        listed(both, "7", random(), |q| Panda.fk_jacobian(q)),
        listed(ik, "2, from a position", reached(&TwoLink), |pose| TwoLink.ik_position(&point(pose))),
        listed(ik, "3, from a position", reached(&LabRrr), |pose| LabRrr.ik_position(&point(pose))),
        listed(ik, "4", reached(&Cobra600), |pose| Cobra600.ik(pose)),
        listed(ik, "5", reached(&FiveAxis), |pose| FiveAxis.ik(pose)),
        listed(ik, "6", reached(&Irb2400), |pose| Irb2400.ik(pose)),
    ]
}

/// Poses that are too few to be a group of their own.
const FEW: usize = 1000;

/// By the number of solutions that a pose has, of one arm.
fn solutions() -> Vec<Way> {
    let names = ["0", "1", "2", "3", "4", "5", "6", "7", "8"];
    let mut groups = vec![Vec::new(); names.len()];
    let mut sampler = Sampler::new(20);
    for index in 0..4 * COUNT {
        let mut pose = Irb2400.fk(&Joints::from(sampler.angles::<6>()));
        if index.is_multiple_of(4) {
            pose.translation.vector *= 1.5;
        }
        groups[Irb2400.ik(&pose).len()].push(pose);
    }
    let many = names.into_iter().zip(groups).filter(|(_, poses)| poses.len() >= FEW);
    let way = |(name, poses): (&'static str, Vec<Pose<f64>>)| {
        let list = poses.iter().copied().cycle().take(COUNT).collect();
        listed("ik, by solutions", name, list, |pose| Irb2400.ik(pose))
    };
    many.map(way).collect()
}

/// By the length of the slices that are given.
fn lengths(data: &Rc<Data>) -> Vec<Way> {
    let all = [("1", 1), ("4", 4), ("16", 16), ("64", 64), ("1024", 1024), ("16384", COUNT)];
    let mut ways = Vec::new();
    for (name, length) in all {
        let (data, mut poses) = (Rc::clone(data), vec![Pose::identity(); length]);
        let run = move |which: Range<usize>| {
            for q in data.joints[which].chunks(length) {
                black_box(Irb2400.fk_batch(black_box(q), black_box(&mut poses[..q.len()])))
                    .expect("they fit");
            }
        };
        ways.push(Way { group: "fk, batches of", name, stretch: length.max(STRETCH), run: Box::new(run) });
    }
    for (name, length) in all {
        let (data, mut jacobians) = (Rc::clone(data), vec![Jacobian::zeros(); length]);
        let run = move |which: Range<usize>| {
            for q in data.joints[which].chunks(length) {
                let places = black_box(&mut jacobians[..q.len()]);
                black_box(Irb2400.jacobian_batch(black_box(q), places)).expect("they fit");
            }
        };
        ways.push(Way {
            group: "jacobian, batches of",
            name,
            stretch: length.max(STRETCH),
            run: Box::new(run),
        });
    }
    for (name, length) in all {
        let (data, mut places): (_, Vec<Found<f64, 6, Irb2400>>) = (Rc::clone(data), vec![None; length]);
        let run = move |which: Range<usize>| {
            for poses in data.poses[which].chunks(length) {
                let places = black_box(&mut places[..poses.len()]);
                black_box(Irb2400.ik_batch(black_box(poses), places)).expect("they fit");
            }
        };
        ways.push(Way { group: "ik, batches of", name, stretch: length.max(STRETCH), run: Box::new(run) });
    }
    ways
}

/// By the size of angles: beyond 25,000 rad quarter turns are taken off in integers, with as many bits as it takes.
fn angles() -> Vec<Way> {
    let (group, fk) = ("sines and cosines of six angles", "fk, by the size of angles");
    let list = |draw: fn(&mut Sampler) -> f64, beyond: usize| -> Vec<[f64; 6]> {
        let mut sampler = Sampler::new(21);
        let mut six = || -> [f64; 6] {
            let usual = sampler.angles::<6>();
            std::array::from_fn(|joint| if joint < beyond { draw(&mut sampler) } else { usual[joint] })
        };
        (0..COUNT).map(|_| six()).collect()
    };
    let usual = |sampler: &mut Sampler| sampler.between(-25_000.0, 25_000.0);
    let large = |sampler: &mut Sampler| 25_001.0 + sampler.between(0.0, 1e9);
    // Every power of two alike.
    let huge = |sampler: &mut Sampler| f64::from_bits(sampler.bits() % (1000 << 52) + (1043 << 52));
    let all: [(&str, Vec<[f64; 6]>); 5] = [
        ("within a turn", list(usual, 0)),
        ("within 25,000 rad", list(usual, 6)),
        ("one of them from there to 1e9 rad", list(large, 1)),
        ("all from there to 1e9 rad", list(large, 6)),
        ("all from 1e6 to 1e307 rad", list(huge, 6)),
    ];
    let joints =
        |angles: &[[f64; 6]]| angles.iter().copied().map(Joints::from).collect::<Vec<Joints<f64, 6>>>();
    let arms: Vec<Way> =
        all.iter().map(|(name, list)| listed(fk, name, joints(list), |q| Irb2400.fk(q))).collect();
    let sines = |(name, list)| listed(group, name, list, |angles: &[f64; 6]| f64::sin_cos_all(*angles));
    all.into_iter().map(sines).chain(arms).collect()
}
