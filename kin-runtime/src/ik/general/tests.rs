//! The conics against the axes that they stand for.

use super::*;
use crate::sample::{Random, apply};
use crate::solutions::Elbow;

fn vector(random: &mut Random) -> [f64; 3] {
    [(); 3].map(|()| random.within(-1.0, 1.0))
}

fn axis(random: &mut Random, slides: bool) -> Axis<f64> {
    Axis { slides, direction: apply(&random.rotation(), &[0.0, 0.0, 1.0]), point: vector(random) }
}

/// A path in the plane has, at every parameter, what joint 2 cannot change of the point there.
#[test]
fn paths_are_what_joint_2_cannot_change() {
    let mut random = Random(111);
    for round in 0..2_000 {
        let view = View::new(&axis(&mut random, round % 2 == 0), vector(&mut random));
        let seen = |p: [f64; 3]| {
            let off = less(p, view.axis.point);
            match view.axis.slides {
                true => view.across.map(|a| dot(&a, &p)),
                false => [dot(&view.axis.direction, &off), 0.5 * dot(&off, &off)],
            }
        };
        let slides = random.coin();
        let moving = axis(&mut random, slides);
        let (start, value) = (vector(&mut random), random.angle());
        let drawn = if moving.slides {
            view.line(start, moving.direction)
        } else {
            let arm = moving.arm(start);
            let x = arm.map(|c| c / length(arm));
            view.circle(less(start, arm), x, cross(moving.direction, x), length(arm))
        };
        let there = moving.moved(start, value);
        let [a, b] = drawn.at(value);
        let [x, y] = seen(there);
        assert!((a - x).abs().max((b - y).abs()) <= 1e-13, "{moving:?} seen from {:?}", view.axis);
        // And joint 2 does not change it.
        let [x, y] = seen(view.axis.moved(there, random.angle()));
        assert!((a - x).abs().max((b - y).abs()) <= 1e-13, "{moving:?} seen from {:?}", view.axis);
    }
}

/// The two paths of an arm are those of its carried point, moved by joint 3, and of the point to be reached, moved back by joint 1,
/// where that is on the joint's axis too.
#[test]
fn an_arm_s_paths_are_those_of_its_points() {
    let mut random = Random(114);
    for round in 0..2_000 {
        let axes @ [first, second, third] = [(); 3].map(|()| {
            let slides = random.coin();
            axis(&mut random, slides)
        });
        let (mut carried, mut point) = (vector(&mut random), vector(&mut random));
        if round % 4 == 0 {
            (carried, point) = (third.point, first.point);
        }
        let sized = Sized { axes, carried, point, radius: length(first.arm(point)) };
        let view = View::new(&second, carried);
        let seen = |p: [f64; 3]| {
            let off = less(p, view.axis.point);
            match second.slides {
                true => view.across.map(|a| dot(&a, &p)),
                false => [dot(&second.direction, &off), 0.5 * dot(&off, &off)],
            }
        };
        let near = |[a, b]: [f64; 2], p: [f64; 3]| {
            let [x, y] = seen(p);
            assert!((a - x).abs().max((b - y).abs()) <= 1e-13, "{axes:?}, {carried:?} to {point:?}");
        };
        let value = random.angle();
        near(sized.third_path(&view, &third).at(value), third.moved(carried, value));
        let (path, azimuth) = sized.first_path(&view, &first);
        let parameter = azimuth.map_or(value, |azimuth| azimuth - value);
        near(path.at(parameter), first.moved(point, -value));
    }
}

/// A point that passes axis 2 by 1e-9, the joints off by as much: the heights and the distances of what joint 2 must join
/// become the same but for round-off.
#[test]
fn a_way_beside_axis_2_is_led_to_where_joint_2_joins_its_ends() {
    let (mut random, mut led) = (Random(112), 0);
    for _ in 0..500 {
        let [first, second, third] = [(); 3].map(|()| axis(&mut random, false));
        let [v1, v2, v3] = [(); 3].map(|()| random.angle());
        let aside = vector(&mut random).map(|c| c * 1e-9);
        let lifted = plus(plus(second.point, second.direction, random.within(-1.0, 1.0)), aside, 1.0);
        let sized = Sized {
            carried: third.moved(lifted, -v3),
            point: first.moved(second.moved(lifted, v2), v1),
            axes: [first, second, third],
            radius: 1.0,
        };
        let off = |way: &Way<f64>| {
            let (from, to) = (third.moved(sized.carried, way.third), first.moved(sized.point, -way.first));
            let height = dot(&second.direction, &less(to, from)).abs();
            height.max((length(second.arm(to)) - length(second.arm(from))).abs())
        };
        let [by1, by3] = [(); 2].map(|()| random.within(-1e-9, 1e-9));
        let way = Way { first: v1 + by1, third: v3 + by3, free: false, open: false };
        let posture = ArmPosture { shoulder: Shoulder::Right, elbow: Elbow::Up };
        let least = [Shoulder::Right, Shoulder::Left].map(|shoulder| {
            let side = Side { posture, shared: false, told: Some(shoulder) };
            off(&sized.beside_second(&way, side))
        });
        let least = least[0].min(least[1]);
        led += u32::from(least <= 1e-4 * off(&way));
    }
    assert!(led >= 490, "{led} of 500");
}

#[test]
fn every_constant_must_be_a_number() {
    let mut random = Random(113);
    let whole = GeneralBase {
        axes: [(); 3].map(|()| axis(&mut random, false)),
        carried: vector(&mut random),
        offset: [0.1; 3],
        reach: 2.0,
    };
    assert!(whole.is_finite());
    for spoiled in [f64::NAN, f64::INFINITY] {
        for i in 0..3 {
            for part in 0..3 {
                let (mut direction, mut point, mut carried, mut offset) = (whole, whole, whole, whole);
                direction.axes[part].direction[i] = spoiled;
                point.axes[part].point[i] = spoiled;
                carried.carried[i] = spoiled;
                offset.offset[i] = spoiled;
                for base in [direction, point, carried, offset] {
                    assert!(!base.is_finite(), "{base:?}");
                }
            }
        }
    }
}
