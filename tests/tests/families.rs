//! The shared solver on arms that nobody declared: any member of the family, not only the ones people build.

use kin_runtime::prelude::*;
use tests::interpreted::{Interpreted, interpret};
use tests::sample::Sampler;

const ARMS: usize = 30;
const POSES: usize = 30;

/// A random number with a few digits, of either sign, never near zero.
fn length(random: &mut Sampler) -> String {
    let sign = if random.below(2) == 0 { "-" } else { "" };
    format!("{sign}{:.3}", random.between(0.1, 1.2))
}

fn maybe_length(random: &mut Sampler) -> String {
    if random.below(2) == 0 { "0".to_owned() } else { length(random) }
}

/// A quarter turn, or now and then any other twist that is far from 0 and 180.
fn twist(random: &mut Sampler) -> String {
    match random.below(4) {
        0 => format!("{:.1}", random.between(35.0, 145.0)),
        1 | 2 => "90".to_owned(),
        _ => "-90".to_owned(),
    }
}

/// `q`, `-q`, with or without an offset.
fn moving(random: &mut Sampler, largest: f64) -> String {
    let joint = if random.below(4) == 0 { "-q" } else { "q" };
    match random.below(3) {
        0 => joint.to_owned(),
        1 => format!("{joint} + 90"),
        _ => format!("{joint} - {:.2}", random.between(0.1, largest)),
    }
}

/// A fixed row behind joint 6, a base, a tool, couplings: each now and then.
fn extras(random: &mut Sampler) -> String {
    let mut text = String::new();
    if random.below(4) == 0 {
        text.push_str(&format!("| | 25 | {} | 0 | {} |\n", length(random), twist(random)));
    }
    if random.below(3) == 0 {
        let turn = random.between(-90.0, 90.0);
        text.push_str(&format!("base: Tx({}) Rx(180) Rz({turn:.1});\n", length(random)));
    }
    if random.below(3) == 0 {
        text.push_str(&format!("tool: Tz({}) Tx({}) Ry(37.5);\n", length(random), length(random)));
    }
    text
}

/// Revolute joints tied to each other at random: always undone by integers, as each line can be taken back.
fn couplings(random: &mut Sampler) -> String {
    let mut text = String::new();
    for _ in 0..random.below(4) {
        let (joint, other) = (random.below(6) + 1, random.below(6) + 1);
        let sign = ["+", "-"][random.below(2)];
        if joint != other {
            text.push_str(&format!("couple: J{joint} {sign}= J{other};\n"));
        }
    }
    text
}

/// A standard table with axes 2 and 3 parallel and the last three axes through one point.
fn elbow_arm(random: &mut Sampler) -> String {
    let theta: Vec<String> = (0..6).map(|_| moving(random, 170.0)).collect();
    let flip = ["0", "180"][random.below(2)];
    let (t1, t3, t4, t5) = (twist(random), twist(random), twist(random), twist(random));
    let (d1, a1, d2, a2) = (maybe_length(random), maybe_length(random), maybe_length(random), length(random));
    let (d3, a3, d4, d6) = (maybe_length(random), maybe_length(random), length(random), maybe_length(random));
    let fixed = if random.below(3) == 0 { "|  | 0 | 0.25 | 0 | 0 |\n" } else { "" };
    let (extras, couple) = (extras(random), couplings(random));
    format!(
        "struct Any(standard, m, deg);
| joint | theta | d    | a    | alpha |
| J1 | {} | {d1} | {a1} | {t1} |
{fixed}| J2 | {} | {d2} | {a2} | {flip} |
| J3 | {} | {d3} | {a3} | {t3} |
| J4 | {} | {d4} | 0 | {t4} |
| J5 | {} | 0 | 0 | {t5} |
| J6 | {} | {d6} | {} | {:.1} |
{extras}{couple}",
        theta[0],
        theta[1],
        theta[2],
        theta[3],
        theta[4],
        theta[5],
        maybe_length(random),
        random.between(-180.0, 180.0),
    )
}

/// A table with two revolute joints and a slide at right angles to axis 2.
fn telescope_arm(random: &mut Sampler) -> String {
    let slide = ["q", "-q", "q + 0.2", "0.3 - q"][random.below(4)];
    let quarter = ["90", "-90"][random.below(2)];
    let (t1, t4, t5) = (twist(random), twist(random), twist(random));
    let theta: Vec<String> = (0..5).map(|_| moving(random, 170.0)).collect();
    let (d1, a1, d2, a2) =
        (maybe_length(random), maybe_length(random), maybe_length(random), maybe_length(random));
    let (a3, d6, extras) = (maybe_length(random), length(random), extras(random));
    format!(
        "struct Any(standard, m, deg);
| joint | theta | d    | a    | alpha |
| J1 | {} | {d1} | {a1} | {t1} |
| J2 | {} | {d2} | {a2} | {quarter} |
| J3 | 25 | {slide} | {a3} | 0 |
| J4 | {} | 0 | 0 | {t4} |
| J5 | {} | 0 | 0 | {t5} |
| J6 | {} | {d6} | 0 | 0 |
{extras}",
        theta[0], theta[1], theta[2], theta[3], theta[4],
    )
}

/// How two neighbouring axes of a base lie to each other.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Lie {
    Meeting,
    Parallel,
    Square,
    Skew,
}

impl Lie {
    const ALL: [Lie; 4] = [Lie::Meeting, Lie::Parallel, Lie::Square, Lie::Skew];

    /// The cells `a` and `alpha` of the row between the two.
    fn cells(self, random: &mut Sampler) -> (String, String) {
        match self {
            Lie::Meeting => ("0".to_owned(), twist(random)),
            Lie::Parallel => (length(random), ["0", "180"][random.below(2)].to_owned()),
            Lie::Square => (length(random), ["90", "-90"][random.below(2)].to_owned()),
            Lie::Skew => (length(random), format!("{:.1}", random.between(35.0, 145.0))),
        }
    }
}

/// A table whose joints 1 to 3 slide where `slides` says so, under a spherical wrist.
fn base_arm(random: &mut Sampler, slides: u8, between: [Lie; 2]) -> String {
    let (mut rows, mut lies) = (String::new(), between.into_iter());
    for joint in 1..=3 {
        let slide = slides >> (joint - 1) & 1 == 1;
        let (a, alpha) =
            lies.next().unwrap_or([Lie::Skew, Lie::Square, Lie::Meeting][random.below(3)]).cells(random);
        let (theta, d) = if slide {
            (
                format!("{:.1}", random.between(-170.0, 170.0)),
                ["q", "-q", "q + 0.2", "0.3 - q"][random.below(4)].to_owned(),
            )
        } else {
            (moving(random, 170.0), maybe_length(random))
        };
        rows.push_str(&format!("| J{joint} | {theta} | {d} | {a} | {alpha} |\n"));
    }
    let (t4, t5, d4, d6, extras) =
        (twist(random), twist(random), length(random), maybe_length(random), extras(random));
    format!(
        "struct Any(standard, m, deg);
| joint | theta | d    | a    | alpha |
{rows}| J4 | {} | {d4} | 0 | {t4} |
| J5 | {} | 0 | 0 | {t5} |
| J6 | {} | {d6} | 0 | 0 |
{extras}",
        moving(random, 170.0),
        moving(random, 170.0),
        moving(random, 170.0),
    )
}

/// The largest entry of the difference, lengths divided by the reach.
fn miss(a: &Pose<f64>, b: &Pose<f64>, reach: f64) -> f64 {
    let rotation = (a.rotation.matrix() - b.rotation.matrix()).amax();
    rotation.max((a.translation.vector - b.translation.vector).amax() / reach)
}

fn distance(a: &Joints<f64, 6>, b: &Joints<f64, 6>, slides: u8) -> f64 {
    let wrapped = |i: usize| {
        let d = a[i] - b[i];
        if slides >> i & 1 == 1 {
            d
        } else {
            (d + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI
        }
    };
    (0..6).map(|i| wrapped(i).abs()).fold(0.0, f64::max)
}

struct Worst {
    residual: f64,
    found: usize,
    solutions: usize,
}

fn try_arm<const SLIDES: u8>(text: &str, random: &mut Sampler, worst: &mut Worst) {
    let derived = kin_gen::compile_text(text).unwrap_or_else(|messages| panic!("{text}\n{messages}"));
    let arm = Interpreted::<SLIDES>::new(derived).unwrap_or_else(|| panic!("not recognised:\n{text}"));
    let reach = arm.reach();
    for _ in 0..POSES {
        let mut values = random.angles::<6>();
        for joint in (0..3).filter(|joint| SLIDES >> joint & 1 == 1) {
            values[joint] = random.between(-1.5, 1.5);
        }
        let q = Joints::from(values);
        let pose = arm.fk(&q);
        let solutions = arm.ik(&pose);
        for solution in solutions.iter() {
            let residual = miss(&arm.fk(&solution.q), &pose, reach);
            assert!(residual <= 1e-14, "{residual:e} at {values:?}, {}\n{text}", solution.branch);
            worst.residual = worst.residual.max(residual);
        }
        let all: Vec<_> = solutions.iter().map(|s| s.q).collect();
        let nearest = all.iter().map(|s| distance(s, &q, SLIDES)).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-6, "lost {values:?} (nearest {nearest:e})\n{solutions}\n{text}");
        for (i, a) in all.iter().enumerate() {
            assert!(all[..i].iter().all(|b| distance(a, b, SLIDES) > 1e-7), "twice the same\n{text}");
        }
        worst.found += 1;
        worst.solutions += all.len();
    }
}

#[test]
fn any_elbow_arm_with_a_spherical_wrist() {
    let mut random = Sampler::new(3);
    let mut worst = Worst { residual: 0.0, found: 0, solutions: 0 };
    for _ in 0..ARMS {
        let text = elbow_arm(&mut random);
        try_arm::<0>(&text, &mut random, &mut worst);
    }
    println!("{} poses, {} solutions, worst residual {:e}", worst.found, worst.solutions, worst.residual);
    assert_eq!(worst.found, ARMS * POSES);
}

#[test]
fn any_telescope_arm_with_a_spherical_wrist() {
    let mut random = Sampler::new(4);
    let mut worst = Worst { residual: 0.0, found: 0, solutions: 0 };
    for _ in 0..ARMS {
        let text = telescope_arm(&mut random);
        try_arm::<4>(&text, &mut random, &mut worst);
    }
    println!("{} poses, {} solutions, worst residual {:e}", worst.found, worst.solutions, worst.residual);
    assert_eq!(worst.found, ARMS * POSES);
}

/// Whether the Jacobian has full rank somewhere, told from random joint values.
fn moves_in_space(derived: &kin_gen::model::Arm, random: &mut Sampler) -> bool {
    (0..6).any(|_| {
        let values = interpret::<f64>(&derived.forward.jacobian, &random.angles::<6>(), &[], &[]);
        Jacobian::<f64, 6>::from_column_slice(&values).determinant().abs() > 1e-10
    })
}

/// Every way in which the axes of a base with these kinds of joint may lie. Refused are those, and only those, that
/// keep the wrist centre in a surface.
fn any_base<const SLIDES: u8>(seed: u64) {
    let mut random = Sampler::new(seed);
    let mut worst = Worst { residual: 0.0, found: 0, solutions: 0 };
    let (mut tried, mut refused) = (0, 0);
    for lies in Lie::ALL.into_iter().flat_map(|a| Lie::ALL.map(|b| [a, b])) {
        let text = base_arm(&mut random, SLIDES, lies);
        let derived = kin_gen::compile_text(&text).unwrap_or_else(|messages| panic!("{text}\n{messages}"));
        if moves_in_space(&derived, &mut random) {
            try_arm::<SLIDES>(&text, &mut random, &mut worst);
        } else {
            assert!(Interpreted::<SLIDES>::new(derived).is_none(), "moves in a surface only:\n{text}");
            refused += 1;
        }
        tried += 1;
    }
    println!(
        "{tried} arms, {refused} refused, {} poses, {} solutions, worst residual {:e}",
        worst.found, worst.solutions, worst.residual
    );
    assert_eq!(worst.found, (tried - refused) * POSES);
}

#[test]
fn any_base_rrr() {
    any_base::<0>(5);
}

#[test]
fn any_base_rrp() {
    any_base::<4>(6);
}

#[test]
fn any_base_rpr() {
    any_base::<2>(7);
}

#[test]
fn any_base_prr() {
    any_base::<1>(8);
}

#[test]
fn any_base_rpp() {
    any_base::<6>(9);
}

#[test]
fn any_base_prp() {
    any_base::<5>(10);
}

#[test]
fn any_base_ppr() {
    any_base::<3>(11);
}

#[test]
fn any_base_ppp() {
    any_base::<7>(12);
}

/// Wrists that are exactly straight, or folded by exactly the nearest number to half a turn, wherever the base stands:
/// what comes back isolated is bent by more than the members of a family may miss the pose.
fn straight_wrists<A: InverseKinematics<6, Branch = Posture>>(arm: &A, random: &mut Sampler) -> usize {
    let mut families = 0;
    for pose in 0..1_000 {
        let mut values = random.angles::<6>();
        values[4] = if pose % 2 == 0 { 0.0 } else { std::f64::consts::PI };
        let q = Joints::from(values);
        let pose = arm.fk(&q);
        let solutions = arm.ik(&pose);
        for solution in solutions.iter() {
            let bend = solution.margins.wrist.unwrap_or(1.0);
            if solution.is_isolated() {
                assert!(bend > 55.0 * f64::EPSILON, "{values:?}\n{solutions}");
                continue;
            }
            families += 1;
            assert!(solution.residual <= 16.0 * f64::EPSILON, "{values:?}\n{solutions}");
        }
        for member in arm.ik_holding(&pose, &q).iter() {
            assert!(member.residual <= 64.0 * f64::EPSILON, "{values:?}");
        }
        // Bent by more than a family's members may miss the pose, it is never one.
        let bent = random.between(140.0, 1000.0) * f64::EPSILON;
        values[4] = if values[4] == 0.0 { bent } else { values[4] - bent };
        let solutions = arm.ik(&arm.fk(&Joints::from(values)));
        let own = solutions.nearest(&Joints::from(values)).filter(|own| own.margins.elbow > 0.3);
        assert!(
            own.is_none_or(|own| own.is_isolated() || own.margins.shoulder < 0.1 * arm.reach()),
            "{solutions}"
        );
    }
    families
}

#[test]
fn a_straight_wrist_is_a_family_wherever_its_members_reach_the_pose() {
    let mut random = Sampler::new(5);
    let families = [
        straight_wrists(&robots::Puma560, &mut random),
        straight_wrists(&robots::LabArm, &mut random),
        straight_wrists(&robots::Kr6R700, &mut random),
        straight_wrists(&robots::ElbowWrist, &mut random),
    ];
    assert!(families.iter().all(|found| *found >= 970), "{families:?} of 1000");
}
