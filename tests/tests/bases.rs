//! Every structure of a three-joint base, at and near its singular sets, against solutions found without this project.

use kin_runtime::prelude::*;
use serde::Deserialize;
use std::path::Path;
use tests::interpreted::Interpreted;

#[derive(Deserialize)]
struct Invented {
    name: String,
    table: String,
    slides: String,
    cases: Vec<Case>,
}

#[derive(Deserialize)]
struct Case {
    kind: String,
    #[serde(rename = "T")]
    pose: [[f64; 4]; 3],
    ik: Vec<Isolated>,
    families: Vec<Shared>,
}

/// An isolated solution and the size of the base's determinant there.
#[derive(Deserialize)]
struct Isolated {
    q: [f64; 6],
    sigma: f64,
}

/// The base of a family whose joints 4 and 6 share a sum.
#[derive(Deserialize)]
struct Shared {
    q: [f64; 3],
    sum46: f64,
    sigma: f64,
}

/// How far round-off of the pose may move a solution: 1e3·ε over the determinant and the wrist's sine, at most 1e2·√ε; for a
/// general base, whose three ways may meet in one, 1e2·∛ε.
fn tolerance(sigma: f64, wrist: f64) -> f64 {
    (1e3 * f64::EPSILON / (sigma * wrist).max(1e-300)).clamp(1e-11, 1.5e-6)
}

fn wrapped(angle: f64) -> f64 {
    (angle + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI
}

/// The largest difference of two joint vectors, angles modulo a turn.
fn apart(slides: &str, a: &[f64], b: &[f64]) -> f64 {
    let kinds = slides.chars().chain("RRR".chars());
    let differences = kinds.zip(a.iter().zip(b)).map(|(kind, (a, b))| match kind {
        'P' => (a - b).abs(),
        _ => wrapped(a - b).abs(),
    });
    differences.fold(0.0, f64::max)
}

#[derive(Default)]
struct Tally {
    cases: usize,
    solutions: usize,
    residual: f64,
    faults: Vec<String>,
}

fn judge<const SLIDES: u8>(invented: &Invented, tally: &mut Tally) {
    let derived =
        kin_gen::compile_text(&invented.table).unwrap_or_else(|m| panic!("{}\n{m}", invented.table));
    let arm =
        Interpreted::<SLIDES>::new(derived).unwrap_or_else(|| panic!("{} is not recognised", invented.name));
    for (number, case) in invented.cases.iter().enumerate() {
        let [x, y, z] = case.pose;
        let rotation = [[x[0], x[1], x[2]], [y[0], y[1], y[2]], [z[0], z[1], z[2]]];
        let solutions = arm.ik(&kin_runtime::private::pose(rotation, [x[3], y[3], z[3]]));
        let mut fault = |what: String| {
            tally.faults.push(format!("{} {number} ({}): {what}", invented.name, case.kind));
        };
        let found: Vec<_> = solutions.iter().collect();
        for truth in &case.ik {
            let near =
                found.iter().map(|s| apart(&invented.slides, s.q.as_slice(), &truth.q)).fold(9.0, f64::min);
            if near > tolerance(truth.sigma, truth.q[4].sin().abs()) {
                fault(format!("lost {:?}, nearest {near:e}, determinant {:e}", truth.q, truth.sigma));
            }
        }
        for truth in &case.families {
            let near = found.iter().filter(|s| !s.is_isolated()).map(|s| {
                let base = apart(&invented.slides, &s.q.as_slice()[..3], &truth.q);
                base.max(wrapped(s.q[3] + s.q[5] - truth.sum46).abs())
            });
            if near.fold(9.0, f64::min) > tolerance(truth.sigma, 1.0) {
                fault(format!("lost the family at {:?}", truth.q));
            }
        }
        for solution in &found {
            let isolated = case.ik.iter().map(|t| apart(&invented.slides, solution.q.as_slice(), &t.q));
            let family =
                case.families.iter().map(|t| apart(&invented.slides, &solution.q.as_slice()[..3], &t.q));
            if isolated.chain(family).fold(9.0, f64::min) > 2e-6 {
                fault(format!("{:?} is not in the truth", solution.q.as_slice()));
            }
            tally.residual = tally.residual.max(solution.residual);
        }
        tally.cases += 1;
        tally.solutions += found.len();
    }
}

#[test]
fn every_structure_against_multistart() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/invented/bases.json");
    let text = std::fs::read_to_string(path).expect("the data stands beside the tests");
    let arms: Vec<Invented> = serde_json::from_str(&text).expect("the tool writes what this reads");
    let mut tally = Tally::default();
    for arm in &arms {
        match arm.slides.as_str() {
            "RRR" => judge::<0>(arm, &mut tally),
            "PRR" => judge::<1>(arm, &mut tally),
            "RPR" => judge::<2>(arm, &mut tally),
            "PPR" => judge::<3>(arm, &mut tally),
            "RRP" => judge::<4>(arm, &mut tally),
            "PRP" => judge::<5>(arm, &mut tally),
            "RPP" => judge::<6>(arm, &mut tally),
            _ => judge::<7>(arm, &mut tally),
        }
    }
    println!(
        "{} arms, {} poses, {} solutions, worst residual {:e}, {} faults",
        arms.len(),
        tally.cases,
        tally.solutions,
        tally.residual,
        tally.faults.len()
    );
    assert!(tally.faults.is_empty(), "{}", tally.faults.join("\n"));
}
