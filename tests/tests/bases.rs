//! Every structure of a three-joint base, at and near its singular sets, against solutions found without this project.

use kin_runtime::prelude::*;
use serde::Deserialize;
use std::path::Path;
use tests::interpreted::Interpreted;
use tests::mirrored::Mirrored;

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

/// The base of a family whose outer joints of the wrist, or of the shoulder, share a sum.
#[derive(Deserialize)]
struct Shared {
    q: [f64; 3],
    #[serde(alias = "sum46")]
    sum: f64,
    sigma: f64,
}

/// Which joints are the base's.
#[derive(Clone, Copy)]
enum Base {
    /// The first three, under a wrist.
    First,
    /// The last three, behind a shoulder.
    Last,
}

impl Base {
    /// Where the base's joints begin, and the three of the wrist or shoulder.
    fn split(self) -> (usize, [usize; 3]) {
        match self {
            Base::First => (0, [3, 4, 5]),
            Base::Last => (3, [0, 1, 2]),
        }
    }
}

/// How far round-off of the pose may move a solution: 1e3·ε over the determinant and the wrist's sine, at most 1e2·√ε; for a
/// general base, whose three ways may meet in one, 1e2·∛ε.
fn tolerance(sigma: f64, wrist: f64) -> f64 {
    (1e3 * f64::EPSILON / (sigma * wrist).max(1e-300)).clamp(1e-11, 1.5e-6)
}

fn wrapped(angle: f64) -> f64 {
    (angle + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI
}

/// The largest difference of two joint vectors, angles modulo a turn. Joints that are not told turn.
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
    arms: usize,
    cases: usize,
    solutions: usize,
    residual: f64,
    faults: Vec<String>,
}

fn judge<A: InverseKinematics<6>>(invented: &Invented, arm: &A, base: Base, tally: &mut Tally) {
    let (start, [outer, middle, last]) = base.split();
    let slides = invented.slides.as_str();
    let of_base = slides.get(start..start + 3).unwrap_or(slides);
    tally.arms += 1;
    for (number, case) in invented.cases.iter().enumerate() {
        let [x, y, z] = case.pose;
        let rotation = [[x[0], x[1], x[2]], [y[0], y[1], y[2]], [z[0], z[1], z[2]]];
        let solutions = arm.ik(&kin_runtime::private::pose(rotation, [x[3], y[3], z[3]]));
        let mut fault = |what: String| {
            tally.faults.push(format!("{} {number} ({}): {what}", invented.name, case.kind));
        };
        let found: Vec<_> = solutions.iter().collect();
        for truth in &case.ik {
            let near = found.iter().map(|s| apart(slides, s.q.as_slice(), &truth.q)).fold(9.0, f64::min);
            if near > tolerance(truth.sigma, truth.q[middle].sin().abs()) {
                fault(format!("lost {:?}, nearest {near:e}, determinant {:e}", truth.q, truth.sigma));
            }
        }
        for truth in &case.families {
            let near = found.iter().filter(|s| !s.is_isolated()).map(|s| {
                let off = apart(of_base, &s.q.as_slice()[start..start + 3], &truth.q);
                off.max(wrapped(s.q[outer] + s.q[last] - truth.sum).abs())
            });
            if near.fold(9.0, f64::min) > tolerance(truth.sigma, 1.0) {
                fault(format!("lost the family at {:?}", truth.q));
            }
        }
        for solution in &found {
            let q = solution.q.as_slice();
            let isolated = case.ik.iter().map(|t| apart(slides, q, &t.q));
            let family = case.families.iter().map(|t| apart(of_base, &q[start..start + 3], &t.q));
            if isolated.chain(family).fold(9.0, f64::min) > 2e-6 {
                fault(format!("{q:?} is not in the truth"));
            }
            tally.residual = tally.residual.max(solution.residual);
        }
        tally.cases += 1;
        tally.solutions += found.len();
    }
}

fn derived(invented: &Invented) -> kin_gen::model::Arm {
    kin_gen::compile_text(&invented.table).unwrap_or_else(|m| panic!("{}\n{m}", invented.table))
}

fn under_a_wrist<const SLIDES: u8>(invented: &Invented, tally: &mut Tally) {
    let arm = Interpreted::<SLIDES>::new(derived(invented));
    let arm = arm.unwrap_or_else(|| panic!("{} is not recognised", invented.name));
    judge(invented, &arm, Base::First, tally);
}

fn behind_a_shoulder<const SLIDES: u8>(invented: &Invented, tally: &mut Tally) {
    let arm = Mirrored::<SLIDES>::new(derived(invented));
    let arm = arm.unwrap_or_else(|| panic!("{} is not recognised", invented.name));
    judge(invented, &arm, Base::Last, tally);
}

fn arms(file: &str) -> Vec<Invented> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/invented").join(file);
    let text = std::fs::read_to_string(path).expect("the data stands beside the tests");
    serde_json::from_str(&text).expect("the tool writes what this reads")
}

fn told(tally: &Tally) {
    println!(
        "{} arms, {} poses, {} solutions, worst residual {:e}, {} faults",
        tally.arms,
        tally.cases,
        tally.solutions,
        tally.residual,
        tally.faults.len()
    );
    assert!(tally.faults.is_empty(), "{}", tally.faults.join("\n"));
}

#[test]
fn every_structure_against_multistart() {
    let mut tally = Tally::default();
    for arm in &arms("bases.json") {
        match arm.slides.as_str() {
            "RRR" => under_a_wrist::<0>(arm, &mut tally),
            "PRR" => under_a_wrist::<1>(arm, &mut tally),
            "RPR" => under_a_wrist::<2>(arm, &mut tally),
            "PPR" => under_a_wrist::<3>(arm, &mut tally),
            "RRP" => under_a_wrist::<4>(arm, &mut tally),
            "PRP" => under_a_wrist::<5>(arm, &mut tally),
            "RPP" => under_a_wrist::<6>(arm, &mut tally),
            _ => under_a_wrist::<7>(arm, &mut tally),
        }
    }
    told(&tally);
}

#[test]
fn spherical_shoulders_against_multistart() {
    let mut tally = Tally::default();
    for arm in &arms("shoulders.json") {
        match arm.slides.as_str() {
            "RRRRRR" => behind_a_shoulder::<0>(arm, &mut tally),
            "RRRPRR" => behind_a_shoulder::<0b001_000>(arm, &mut tally),
            "RRRRPR" => behind_a_shoulder::<0b010_000>(arm, &mut tally),
            "RRRRRP" => behind_a_shoulder::<0b100_000>(arm, &mut tally),
            other => panic!("{other}: no such arms are invented"),
        }
    }
    told(&tally);
}

/// A table of how many poses each structure has of each kind.
fn table(file: &str) -> String {
    let arms = arms(file);
    let (mut kinds, mut structures) = (Vec::new(), Vec::new());
    for arm in &arms {
        let structure = arm.name.rsplit_once('_').map_or(arm.name.as_str(), |(structure, _)| structure);
        if !structures.contains(&structure) {
            structures.push(structure);
        }
        for case in &arm.cases {
            if !kinds.contains(&case.kind) {
                kinds.push(case.kind.clone());
            }
        }
    }
    let cells = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let head = ["structure".to_owned(), "arms".to_owned()].into_iter();
    let mut text = cells(head.chain(kinds.iter().cloned()).collect());
    text.push_str(&cells(vec!["---".to_owned(); kinds.len() + 2]));
    for structure in structures {
        let own: Vec<_> = arms
            .iter()
            .filter(|arm| arm.name.rsplit_once('_').is_some_and(|(s, _)| s == structure))
            .collect();
        let mut row = vec![structure.replace('_', " "), own.len().to_string()];
        for kind in &kinds {
            let count = own.iter().flat_map(|arm| &arm.cases).filter(|case| case.kind == *kind).count();
            row.push(if count == 0 { "–".to_owned() } else { count.to_string() });
        }
        text.push_str(&cells(row));
    }
    text
}

const HEAD: &str = "# What the invented arms cover

How many poses there are for each structure, each kind of singular pose and each distance from it, counted in the data by
`bases::the_table_of_what_is_covered_is_current`. A distance stands beside its kind, in radians (metres where a joint slides);
on both sides of the base's singular poses, so that these come in pairs. Nothing stands where a structure has no such poses
along the joint that was moved.
";

/// COVERAGE.md is what the data holds.
#[test]
fn the_table_of_what_is_covered_is_current() {
    let text = format!(
        "{HEAD}\n## Three joints under a spherical wrist\n\n{}\n## Three joints behind a spherical shoulder\n\n{}",
        table("bases.json"),
        table("shoulders.json")
    );
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/invented/COVERAGE.md");
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(&path, &text).expect("the folder is there");
    }
    let committed = std::fs::read_to_string(&path).expect("COVERAGE.md stands beside the data");
    assert!(committed == text, "COVERAGE.md is out of date: UPDATE=1 cargo test -p tests --test bases");
}
