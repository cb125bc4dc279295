//! `cargo run --release -p tests --bin steady`: how steady the time of an inverse is, in instructions.
//!
//! The program runs itself under callgrind, which writes down what each pose has cost. Poses are grouped by arm and by how
//! many solutions they have, a double solution counting as two, as many as there are slots that are not empty; of each group
//! the worst is compared with the median. Instructions are counted,
//! not seconds: the same binary gives the same table whatever else the machine does.
//!
//! The table is printed, and written to `tests/data/steady.md`, which RELIABILITY.md quotes. Exit code 1 if a worst case is
//! more than 1.5 times its median, 2 if valgrind could not be run.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use kin_runtime::prelude::*;
use kin_runtime::private::{SolvePosition, SolveWrist};
use robots::{Irb2400, LabArm, LabRrr, Puma560, Stanford};
use tests::reliability::subject::{ByPoint, ByPose, Subject, Tried};
use tests::sample::Sampler;
use tests::skew::Skew;

/// Poses for each arm, three in four aimed at singular sets.
const POSES: usize = 1000;
/// A group of fewer poses has no median worth the name.
const FEWEST: usize = 16;
/// The worst over the median that is promised.
const PROMISED: f64 = 1.5;
/// The word by which the program knows that it is being counted.
const COUNTED: &str = "counted";

/// The function that is counted: one pose, all solutions.
#[inline(never)]
fn one_inverse<const N: usize, S: Subject<N>>(arm: &S, pose: &Pose<f64>) -> Solutions<f64, N, S::Branch> {
    arm.solve(black_box(pose))
}

/// Solves the poses of one arm and says of each how many solutions it had.
fn solve<const N: usize, S: Subject<N>>(arm: &S) {
    let (sights, mut random) = (arm.sights(), Sampler::new(17));
    for _ in 0..POSES {
        let commanded = arm.commanded(sights.row_values(&mut random));
        let pose = arm.fk(&Joints::<f64, N>::from_fn(|joint, _| commanded[joint]));
        let solutions = black_box(one_inverse(arm, &pose));
        let solved = solutions.slots().iter().filter(|slot| !matches!(slot, Slot::Empty(_))).count();
        println!("{} {solved}", S::NAME);
    }
}

fn pose<A: SolveWrist<6> + InverseKinematics<6>>(arm: A) {
    solve(&Tried(arm, ByPose));
}

fn point<A: SolvePosition<3> + PositionInverse<3>>(arm: A) {
    solve(&Tried(arm, ByPoint));
}

fn solve_all() {
    pose(Puma560);
    pose(Irb2400);
    pose(LabArm);
    pose(Stanford);
    pose(Skew);
    point(LabRrr);
}

/// What callgrind wrote when a function returned: the cost since the last time.
fn cost(dump: &Path) -> Result<u64, Box<dyn Error>> {
    let text = fs::read_to_string(dump)?;
    let total = text.lines().find_map(|line| line.strip_prefix("totals: "));
    Ok(total.ok_or("callgrind wrote no total")?.trim().parse()?)
}

/// Runs the program under callgrind: groups by name, each with its costs, rising.
fn counted() -> Result<BTreeMap<String, Vec<u64>>, Box<dyn Error>> {
    let folder = std::env::temp_dir().join(format!("steady-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    let file = folder.join("costs");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--zero-before=*one_inverse", "--dump-after=*one_inverse"])
        .arg(format!("--callgrind-out-file={}", file.display()))
        .arg(std::env::current_exe()?)
        .arg(COUNTED)
        .output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let mut groups: BTreeMap<String, Vec<u64>> = BTreeMap::new();
    for (pose, group) in String::from_utf8(output.stdout)?.lines().enumerate() {
        let dump = PathBuf::from(format!("{}.{}", file.display(), pose + 1));
        groups.entry(group.into()).or_default().push(cost(&dump)?);
    }
    fs::remove_dir_all(folder)?;
    groups.values_mut().for_each(|costs| costs.sort_unstable());
    Ok(groups)
}

/// The table, and the worst ratio in it.
fn table(groups: &BTreeMap<String, Vec<u64>>) -> (String, f64) {
    let mut text = String::from(
        "| arm, solutions | poses | least | median | worst | worst / median |\n|---|---|---|---|---|---|\n",
    );
    let mut largest: f64 = 0.0;
    for (name, costs) in groups.iter().filter(|(_, costs)| costs.len() >= FEWEST) {
        let (least, median, worst) = (costs[0], costs[costs.len() / 2], costs[costs.len() - 1]);
        let ratio = worst as f64 / median as f64;
        largest = largest.max(ratio);
        let _ = writeln!(text, "| {name} | {} | {least} | {median} | {worst} | {ratio:.2} |", costs.len());
    }
    (text, largest)
}

fn main() -> ExitCode {
    if std::env::args().nth(1).as_deref() == Some(COUNTED) {
        solve_all();
        return ExitCode::SUCCESS;
    }
    match report() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("steady: {error}");
            ExitCode::from(2)
        }
    }
}

/// Counts, prints and writes; whether the promise was kept.
fn report() -> Result<bool, Box<dyn Error>> {
    let (text, worst) = table(&counted()?);
    print!("{text}");
    fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join("data/steady.md"), text)?;
    Ok(worst <= PROMISED)
}
