//! `cargo run -p tests --bin timing`: how long the compiler makes a user wait.
//!
//! Promises: `dh!` expands, as users get it, in less than 100 ms for a six-axis arm of a common structure, 500 ms for one of
//! a structure that has no plan, 1 s for seven axes; `cargo check` of one arm in a new crate, its dependencies built,
//! takes less than 2 s. Exit code 1 if one of them is missed.
//!
//! "As users get it" is unoptimised: cargo builds macros at `opt-level = 0`, in release builds too. So the expansion is
//! timed in this process only if the process is a plain `cargo run` (with `--release` it would time an optimised
//! kin-gen, and refuses); and the new crate stands outside the workspace, so that no profile of ours reaches it. There
//! the cost of one more arm, expansion and type check together, says the same a second time.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::{Duration, Instant};

use kin_gen::decl::lex;

/// Promised for one expansion of a six-axis arm of a common structure.
const EXPANSION: Duration = Duration::from_millis(100);
/// Promised for one of a structure that has no plan.
const UNKNOWN: Duration = Duration::from_millis(500);
/// Promised for one of seven axes.
const SEVEN: Duration = Duration::from_secs(1);
/// Promised for `cargo check` of one arm in a new crate.
const CHECK: Duration = Duration::from_secs(2);
/// How often each thing is timed; the median counts.
const RUNS: usize = 5;
/// How many arms the second crate has more than the first.
const MORE: usize = 10;

/// Unimation Puma 560; NAME is replaced.
const PUMA: &str = "
pub struct NAME(standard, m, deg);
| joint | alpha |   a    |    d    | theta | limits      |
|-------|-------|--------|---------|-------|-------------|
| J1    |  90   | 0      | 26.45in | q     | -160 .. 160 |
| J2    |   0   | 0.4318 | 0       | q     |  -45 .. 225 |
| J3    | -90   | 0.0203 | 0.15005 | q     | -225 ..  45 |
| J4    |  90   | 0      | 0.4318  | q     | -110 .. 170 |
| J5    | -90   | 0      | 0       | q     | -100 .. 100 |
| J6    |   0   | 0      | 0       | q     | -266 .. 266 |
";

/// Universal Robots UR5.
const UR5: &str = "
pub struct NAME(standard, m, deg);
| joint | alpha |    a     |    d     | theta |
|-------|-------|----------|----------|-------|
| J1    |  90   | 0        | 0.089159 | q     |
| J2    |   0   | -0.425   | 0        | q     |
| J3    |   0   | -0.39225 | 0        | q     |
| J4    |  90   | 0        | 0.10915  | q     |
| J5    | -90   | 0        | 0.09465  | q     |
| J6    |   0   | 0        | 0.0823   | q     |
";

/// The lab arm of seed 000, with its fixed rows and its check.
const LAB: &str = "
pub struct NAME(modified, mm, deg);
let d1 = 47; let a1 = 30; let d2 = 45; let a2 = 120; let a4 = 20; let d5 = 130; let d6 = 29;
| joint | alpha |  a  |  d  | theta  |
|-------|-------|-----|-----|--------|
| J1    |   0   |  0  | d1  | q      |
|       |   0   | -a1 | d2  | 0      |
| J2    |  90   |  0  | 0   | q      |
| J3    |   0   |  a2 | 0   | q + 90 |
| J4    | -90   |  a4 | 0   | q      |
|       |   0   |  0  | d5  | 0      |
| J5    |  90   |  0  | 0   | q      |
| J6    | -90   |  0  | d6  | q      |
check [0, 0, 0, 0, 0, 0] => (-69, 0, 112);
";

/// Two pairs of parallel axes, and an axis at an odd angle: no plan fits.
const ODD: &str = "
pub struct NAME(modified, mm, deg);
| joint | alpha |  a  |  d  | theta  |
|-------|-------|-----|-----|--------|
| J1    |   0   |  0  | 300 | q      |
| J2    |  90   |  40 | 20  | q      |
| J3    |   0   | 410 | 0   | q + 90 |
| J4    | -90   |  25 | 350 | q      |
| J5    |   0   |  90 | 15  | q      |
| J6    |  60   |  10 | 85  | q      |
";

/// Parallel axes where few arms have them, at right angles otherwise.
const RARE: &str = "
pub struct NAME(modified, mm, deg);
| joint | alpha |  a  |  d  | theta  |
|-------|-------|-----|-----|--------|
| J1    |   0   |  0  | 300 | q      |
| J2    |   0   | 140 | 20  | q      |
| J3    |  90   | 410 | 30  | q + 90 |
| J4    | -90   |  25 | 350 | q      |
| J5    |   0   |  90 | 15  | q      |
| J6    |  90   |  10 | 85  | q      |
";

fn main() -> ExitCode {
    if !cfg!(debug_assertions) {
        eprintln!("run this without --release: macros are built unoptimised, so that is what must be timed");
        return ExitCode::from(2);
    }
    match measure() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("timing: {error}");
            ExitCode::from(2)
        }
    }
}

fn measure() -> Result<bool, Box<dyn Error>> {
    let mut kept = true;
    let panda = <robots::Panda as kin_runtime::Arm<7>>::TABLE;
    let arms = [
        ("Puma560", PUMA, EXPANSION),
        ("Ur5", UR5, EXPANSION),
        ("LabArm", LAB, EXPANSION),
        ("a rare structure", RARE, UNKNOWN),
        ("odd angles", ODD, UNKNOWN),
        ("Panda", panda, SEVEN),
    ];
    for (name, text, promised) in arms {
        let time = expansion(&text.replace("NAME", "Subject"))?;
        kept &= verdict(&format!("expansion of {name}, unoptimised"), time, promised);
    }
    let folder = NewCrate::create()?;
    let one = folder.check(1)?;
    kept &= verdict("cargo check of one arm in a new crate", one, CHECK);
    let each = folder.check(1 + MORE)?.saturating_sub(one) / u32::try_from(MORE)?;
    println!("{:<46} {:>8.1} ms", "there, each further arm, expansion and check", milliseconds(each));
    Ok(kept)
}

/// Prints one line and says whether the promise was kept.
fn verdict(what: &str, time: Duration, promised: Duration) -> bool {
    let kept = time < promised;
    let word = if kept { "kept" } else { "MISSED" };
    println!("{what:<46} {:>8.1} ms   under {:>5} ms: {word}", milliseconds(time), promised.as_millis());
    kept
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// The median of several runs.
fn median(mut run: impl FnMut() -> Result<Duration, Box<dyn Error>>) -> Result<Duration, Box<dyn Error>> {
    let mut times = (0..RUNS).map(|_| run()).collect::<Result<Vec<_>, _>>()?;
    times.sort();
    Ok(times[RUNS / 2])
}

/// From text to generated code, all that the macro does but for the exchange of tokens with the compiler.
fn expansion(text: &str) -> Result<Duration, Box<dyn Error>> {
    median(|| {
        let (tokens, _, _) = lex(text);
        let start = Instant::now();
        let expansion = kin_gen::expand(&tokens, "::kin_runtime");
        let time = start.elapsed();
        match expansion.report.diagnostics().first() {
            Some(diagnostic) => Err(diagnostic.to_string().into()),
            None => Ok(time),
        }
    })
}

/// A crate of its own, beside the build output, that depends on the runtime by path.
struct NewCrate {
    folder: PathBuf,
}

impl NewCrate {
    fn create() -> Result<NewCrate, Box<dyn Error>> {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
        let executable = std::env::current_exe()?;
        let target = executable.ancestors().nth(2).ok_or("this program does not stand in a target folder")?;
        let folder = target.join("timing");
        fs::create_dir_all(folder.join("src"))?;
        let runtime = workspace.join("kin-runtime");
        let manifest = format!(
            "[package]\nname = \"new-arm\"\nedition = \"2024\"\n\n[dependencies]\nkin-runtime = {{ path = {runtime:?} }}\n\n\
             [workspace]\n"
        );
        fs::write(folder.join("Cargo.toml"), manifest)?;
        // The versions that the workspace has, so that nothing needs to be fetched.
        fs::copy(workspace.join("Cargo.lock"), folder.join("Cargo.lock"))?;
        Ok(NewCrate { folder })
    }

    /// The time of `cargo check` with so many arms, dependencies built.
    fn check(&self, arms: usize) -> Result<Duration, Box<dyn Error>> {
        let arm = |index| {
            format!("dh! {{\n/// Unimation Puma 560.{}}}\n", PUMA.replace("NAME", &format!("Puma{index}")))
        };
        let text: String = (0..arms).map(arm).collect();
        let text = format!("//! A new crate.\nuse kin_runtime::prelude::*;\n\n{text}");
        let source = self.folder.join("src/lib.rs");
        fs::write(&source, &text)?;
        self.cargo_check()?;
        median(|| {
            // Written anew, so that cargo sees a later time and checks the crate again.
            fs::write(&source, &text)?;
            self.cargo_check()
        })
    }

    fn cargo_check(&self) -> Result<Duration, Box<dyn Error>> {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let start = Instant::now();
        let output = Command::new(cargo)
            .args(["check", "--offline", "--target-dir", "target"])
            // What the first check of a new crate cannot have: the results of the last one.
            .env("CARGO_INCREMENTAL", "0")
            .current_dir(&self.folder)
            .output()?;
        let time = start.elapsed();
        let messages = String::from_utf8_lossy(&output.stderr);
        // A check that cargo found to be fresh would be a check that was not timed.
        if !output.status.success() || !messages.contains("Checking new-arm") {
            return Err(messages.into_owned().into());
        }
        Ok(time)
    }
}
