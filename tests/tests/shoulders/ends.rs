//! Any arms with a spherical shoulder as the wrist arms that they are when seen from the tool.

use kin_runtime::prelude::*;
use tests::interpreted::Interpreted;
use tests::mirrored::Mirrored;
use tests::sample::Sampler;

use crate::apart;

/// One element of a chain: a fixed one, or a joint of either sense.
#[derive(Clone)]
enum Element {
    Fixed(&'static str, f64),
    Joint(&'static str, i8, f64),
}

fn printed(elements: &[Element]) -> String {
    let print = |element: &Element| match element {
        Element::Fixed(motion, by) => format!("{motion}({by:.4})"),
        Element::Joint(motion, sense, offset) => {
            format!("{motion}({}q + {offset:.4})", if *sense < 0 { "-" } else { "" })
        }
    };
    let text: Vec<String> = elements.iter().map(print).collect();
    format!("struct Any(chain, m, deg);\n{};", text.join(" "))
}

/// The chain from its other end: the inverse of each element, last first.
fn mirrored(elements: &[Element]) -> Vec<Element> {
    let inverse = |element: &Element| match *element {
        Element::Fixed(motion, by) => Element::Fixed(motion, -by),
        Element::Joint(motion, sense, offset) => Element::Joint(motion, -sense, -offset),
    };
    elements.iter().rev().map(inverse).collect()
}

fn wrist_arm(random: &mut Sampler, slides: u8) -> Vec<Element> {
    let mut elements = vec![Element::Fixed("Tz", 0.2)];
    for joint in 0..6 {
        let (sense, offset) =
            ([1, -1][random.below(2)], [0.0, 90.0, random.between(-170.0, 170.0)][random.below(3)]);
        let length = |random: &mut Sampler| [0.0, random.between(0.1, 0.5)][random.below(2)];
        let twist = [90.0, -90.0, random.between(35.0, 145.0)][random.below(3)];
        if slides >> joint & 1 == 1 {
            elements.push(Element::Joint("Tz", sense, random.between(-0.2, 0.2)));
            elements.push(Element::Fixed("Rz", random.between(-90.0, 90.0)));
        } else {
            elements.push(Element::Joint("Rz", sense, offset));
        }
        match joint {
            0..3 => {
                elements.push(Element::Fixed("Tz", length(random)));
                elements.push(Element::Fixed("Tx", random.between(0.1, 0.5)));
                elements
                    .push(Element::Fixed("Rx", if joint == 1 && random.below(2) == 0 { 0.0 } else { twist }));
            }
            3 => {
                elements.extend([Element::Fixed("Tz", random.between(0.1, 0.5)), Element::Fixed("Rx", twist)])
            }
            4 => elements.push(Element::Fixed("Rx", twist)),
            _ => elements.extend([Element::Fixed("Tx", length(random)), Element::Fixed("Ry", 25.0)]),
        }
    }
    elements
}

/// The solutions of an arm at a pose are those of its mirror image at the inverse pose, joint for joint.
fn same_from_both_ends<const SLIDES: u8, const MIRRORED: u8>(seed: u64) -> [usize; 2] {
    let mut random = Sampler::new(seed);
    let (mut arms, mut found) = (0, 0);
    while arms < 8 {
        let elements = wrist_arm(&mut random, SLIDES);
        let (text, back) = (printed(&elements), printed(&mirrored(&elements)));
        let derived = |text: &str| kin_gen::compile_text(text).unwrap_or_else(|m| panic!("{text}\n{m}"));
        let Some(arm) = Interpreted::<SLIDES>::new(derived(&text)) else { continue };
        let shoulder = Mirrored::<MIRRORED>::new(derived(&back)).unwrap_or_else(|| panic!("{back}"));
        arms += 1;
        for _ in 0..15 {
            let mut q = random.angles::<6>();
            for (joint, value) in q.iter_mut().enumerate() {
                if SLIDES >> joint & 1 == 1 {
                    *value = random.between(-0.8, 0.8);
                }
            }
            let pose = arm.fk(&Joints::from(q));
            let ahead = arm.ik(&pose);
            let behind = shoulder.ik(&pose.inverse());
            assert_eq!(ahead.len(), behind.len(), "{q:?}\n{ahead}\n{behind}\n{text}");
            for solution in behind.iter() {
                let turned = Joints::from_fn(|i, _| solution.q[5 - i]);
                let near = ahead.iter().map(|s| apart(&arm, &s.q, &turned)).fold(9.0, f64::min);
                let sigma = kin_runtime::dexterity(&arm, &turned).margin;
                assert!(
                    near <= (1e3 * f64::EPSILON / sigma).min(1.5e-6),
                    "{near:e} {sigma:e}\n{ahead}\n{behind}\n{text}"
                );
                assert!(solution.residual <= 64.0 * f64::EPSILON);
                found += 1;
            }
        }
    }
    [arms, found]
}

#[test]
fn an_arm_is_the_same_from_both_ends() {
    let found = [
        same_from_both_ends::<0, 0>(11),
        same_from_both_ends::<0b000_001, 0b100_000>(12),
        same_from_both_ends::<0b000_010, 0b010_000>(13),
        same_from_both_ends::<0b000_100, 0b001_000>(14),
        same_from_both_ends::<0b000_101, 0b101_000>(15),
        same_from_both_ends::<0b000_110, 0b011_000>(16),
    ];
    println!("arms and solutions: {found:?}");
    assert!(found.iter().all(|[_, solutions]| *solutions >= 8 * 15 * 2), "{found:?}");
}
