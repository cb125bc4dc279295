//! What came of a run: a table for the terminal, and RELIABILITY.md.

use std::collections::BTreeSet;
use std::fmt::{self, Write};

use super::parts::Part;
use super::run::State;
use super::tally::{Fault, Tally};

/// What is promised of a part and was not kept.
pub fn missed(part: &Part, tally: &Tally) -> Vec<String> {
    let mut missed = Vec::new();
    for (fault, what) in Fault::ALL {
        let count = tally.of(fault);
        if count.tries > 0 {
            let arms: Vec<String> = count.arms.iter().map(|(arm, tries)| format!("{arm} {tries}")).collect();
            let (name, tries) = (&part.name, tally.tries);
            missed.push(format!("{name}: {} of {tries} tries {what} ({})", count.tries, arms.join(", ")));
        }
    }
    if tally.tries < part.tries {
        missed.push(format!("{}: {} of {} tries done", part.name, tally.tries, part.tries));
    }
    missed
}

/// Everything that was missed.
pub fn all_missed(state: &State) -> Vec<String> {
    let tally = |part: &Part| state.parts.get(&part.name).map(|done| done.tally.clone()).unwrap_or_default();
    state.asked().iter().flat_map(|part| missed(part, &tally(part))).collect()
}

/// The counts, one line for each part.
pub fn table(state: &State) -> String {
    let mut text = String::from("| part | tries | solutions | with families |");
    Fault::ALL.iter().for_each(|(_, what)| text.push_str(&format!(" {what} |")));
    text.push_str(" blurred | worst residual / ε |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for part in state.asked() {
        let Some(done) = state.parts.get(&part.name) else { continue };
        let tally = &done.tally;
        let _ =
            write!(text, "| {} | {} | {} | {} |", part.name, tally.tries, tally.solutions, tally.families);
        // Wild bits promise an answer, not a solution.
        let cell = |of_wild: bool, value: String| if part.wild && !of_wild { "–".into() } else { value };
        for (fault, _) in Fault::ALL {
            let of_wild = matches!(fault, Fault::Malformed | Fault::Panicked);
            let _ = write!(text, " {} |", cell(of_wild, tally.of(fault).tries.to_string()));
        }
        let blurred = cell(false, tally.blurred.tries.to_string());
        let residual = cell(false, format!("{:.2}", tally.residual.badness()));
        let _ = writeln!(text, " {blurred} | {residual} |");
    }
    text
}

/// RELIABILITY.md.
pub fn markdown(state: &State) -> String {
    let mut text = String::from(HEAD);
    let missed = all_missed(state);
    if missed.is_empty() {
        text.push_str("Every figure above that is guaranteed was kept.\n");
    } else {
        text.push_str("**Missed:**\n\n");
        missed.iter().for_each(|line| text.push_str(&format!("- {line}\n")));
    }
    text.push('\n');
    let round_trips = state.parts.iter().filter(|(name, _)| !name.starts_with("bits"));
    let (blurs, tries) = round_trips.fold((0, 0), |(blurs, tries), (_, done)| {
        (blurs + done.tally.blurred.tries, tries + done.tally.tries)
    });
    let _ = writeln!(
        text,
        "**Missed as first asked for**, joints within min(10³·ε/σ, 10²·√ε) at every pose: in {blurs} of {tries} tries."
    );
    let command = format!(
        "cargo run --release -p tests --bin reliability -- --poses {} --patterns {} --seed {}",
        state.poses, state.patterns, state.seed
    );
    let _ = write!(text, "\n## Counts\n\n`{command}`\n\n{}", table(state));
    text.push_str(LEGEND);
    let _ = write!(text, "\n## Arms\n\n{}", arms(state));
    let _ = write!(text, "\n## Worst cases\n\n{}", CASES.replace("SEED", &state.seed.to_string()));
    let _ = worst_cases(&mut text, state);
    text.push_str(TARGETS);
    text.push_str(STEADY);
    text.push_str(include_str!("../../data/steady.md"));
    text.push_str(EMBEDDED);
    text.push_str(include_str!("../../no-std/contract.md"));
    text
}

/// The arms of each part, then how many of them are aimed at each kind of singular poses.
fn arms(state: &State) -> String {
    let asked = state.asked();
    let parts: Vec<&Part> = asked.iter().filter(|part| !part.wild && part.format == "f64").collect();
    let family = |part: &Part| part.name.trim_end_matches("-f64").to_owned();
    let mut text = String::new();
    for part in &parts {
        let names: Vec<&str> = part.arms().collect();
        let _ = writeln!(text, "- {}: {}.", family(part), names.join(", "));
    }
    text.push_str(AIMED);
    let kinds: BTreeSet<&str> = parts.iter().flat_map(|part| part.kinds()).collect();
    let heads: Vec<&str> = kinds.iter().copied().collect();
    let _ =
        writeln!(text, "| part | arms | {} |\n|---|---|{}", heads.join(" | "), "---|".repeat(heads.len()));
    for part in &parts {
        let _ = write!(text, "| {} | {} |", family(part), part.arms().count());
        for kind in &kinds {
            let _ = match part.aimed(kind) {
                0 => write!(text, " – |"),
                arms => write!(text, " {arms} |"),
            };
        }
        text.push('\n');
    }
    text
}

fn worst_cases(text: &mut String, state: &State) -> fmt::Result {
    for part in state.asked() {
        let Some(done) = state.parts.get(&part.name) else { continue };
        let tally = &done.tally;
        let kept = [
            ("residual / ε", &tally.residual),
            ("distance / asked for", &tally.strayed),
            ("blurred, distance / asked for", &tally.blurred.worst),
        ];
        // Of what was kept, two of each are enough; of faults, all that are held.
        let faults = Fault::ALL.map(|(fault, what)| (what, &tally.of(fault).worst, 5));
        let all = faults.into_iter().chain(kept.map(|(what, cases)| (what, cases, 2)));
        for (what, cases, most) in all {
            for case in cases.0.iter().take(most) {
                writeln!(
                    text,
                    "| {}:{} | {} | {what} {:.3} | `{}` |",
                    part.name,
                    case.index,
                    case.arm,
                    case.badness(),
                    case.bits.join(" ")
                )?;
            }
        }
    }
    Ok(())
}

const HEAD: &str = "\
# Reliability

Written by `cargo run --release -p tests --bin reliability`; not edited by hand.

## What is guaranteed

For the arms listed below, and for every pose that their forward kinematics can produce, up to and at every singular set (for other
arms that `dh!` gives an `ik` or `ik_position` the same is meant, and was tried less: see below):

- **Something comes back**: no reachable pose is empty.
- **Nothing is lost**: the joints that the pose came from are among the solutions, or are a member of a returned family,
  within min(10³·ε/σ, 10²·√ε); σ is the smallest singular value of the Jacobian, its linear rows divided by the reach, slides
  counted in reaches. Where the rounded pose does not determine them so well (*blurred*, see below), a solution or a member
  comes back that the pose cannot tell from them.
- **Nothing is wrong**: forward kinematics of every solution returns to the pose within 16 ε of the reach (positions) and
  16 ε (rotation entries); where the joints that carry the point are a general base, within 64 ε. The solver itself refuses
  whatever misses by more than 64 ε, of the reach or of the pose's largest coordinate where that is more (a slide without limits, a
  `base:` far away); of short arms, and isolated solutions of a spherical wrist or shoulder on a planar base, by more than 16 ε.
  A general base is one that [a page of its own](kin-runtime/src/ik/general.rs) solves: of the parts below all but elbow, telescope,
  shoulder, position and short.
- **Nothing comes twice**: two solutions differ by more than 6.7·√ε (1e-7 for doubles), and there are never more than the
  structure has: 4 ways of three joints that carry a point, 2 where two of them slide or where there are two, 1 where three
  slide; twice that with a spherical wrist or shoulder.
- **Every bit pattern gets an answer**: NaN, infinities, denormals, huge numbers and matrices that are no rotations end in a
  typed reason; nothing panics, no solution holds a NaN, angles are in (-π, π].

ε is 2⁻⁵² for `f64` and 2⁻²³ for `f32`; the same holds for both.

## What is not

- The figures are counts, not proofs: they hold for the poses that were tried, on the arms listed below.
- **Other arms** may be lost more often. `cargo test --release -p tests --test open` aims in the same way at ten structures whose lengths
  are drawn at random, a quarter of them zero. It finds nothing, but more tries do: in doubles fewer than one in 10⁵ is lost or comes
  back empty, in singles five, nearly all of them where three figures are singular at once under a wrist or shoulder that is oblique. Of
  telescopes whose slide draws in to where axes 1 and 2 meet, under an oblique wrist, it is one in two hundred of poses aimed so.
- **Families of a general base** are those of joint 1 or joint 2 alone: the carried point on axis 1, or on axis 2. Where axis 3 can
  come to lie on axis 1 (a₁ = a₂, d₂ = 0, α₁ = ±α₂) joints 1 and 3 are free together; members come back then, as isolated
  solutions. No real arm is known to be built so.
- **A position** of two or three joints is solved where all of them are needed to move the point; a point that stays on a surface or a
  curve whatever three joints do is not: the compiler says so.
- **The bound min(10³·ε/σ, 10²·√ε) does not hold for every pose**: the column *blurred* counts where it is missed. No solver
  that is given a rounded pose can keep it there. At a distance δ from the wrist's singular set, θ4 and θ6 alone are determined
  to ε/δ, which is more than 10²·√ε where δ < 1e-10, and a family is declared only where every member reaches the pose, δ ≤ 32 ε;
  where two sets are near, δ is their product; at a cusp of a general base three solutions are one, and round-off grows to its
  cube root. (`cargo test -p tests --test reliability` shows two joint vectors 1e-4 apart whose poses agree to the last bits.)
- **What blurred means**, and what it must not hide: a try counts as blurred, and not as lost, only if a solution within 10³·ε/m
  came back, m the manipulability (the product of all singular values), and a way of joint values has been found that leads to
  it from the joints that went in: a chain of points of which forward kinematics reaches the pose as exactly as a solution must
  (16 ε, 64 ε on a general base). Ways are looked for by halving: the middle of a piece is brought back onto the pose by
  least-squares steps, until a piece is a sixteenth of the distance or shorter, and its middle off the straight line by a tenth
  of its length at most; or else by following what the arm has lost, in steps that are brought back by a thousandth of their
  length at most; or by turning one joint on in small steps, which the others follow. All its points are then solutions as good as
  any that may be given out, more than six joints can have isolated ones, so that a solver which is given the pose alone has nothing
  to prefer one by. Another solution that happens to be as far from the singular sets, the arm on its other side for instance, is
  not connected to the joints that went in, and does not
  count; where no way is found the try counts as lost. At a pose that is singular exactly any member of a family is such a solution,
  whether it came back as a family or not: that it does is what `--test straight`, `crossings`, `shoulders` and `ik` hold. (`cargo test -p tests --test reliability` also looks for ways between
  solutions that their pose does determine, and must find none.)
- Two solutions closer than 6.7·√ε are given as one; a wrist that is within 32 ε of its singular set is given as a family.
- Poses that are not the arm's own by more than round-off are judged by their distance from the boundary, which itself has a
  round-off of 8 ε of the reach: within that, a pose may be called reachable or not.
- Joint limits, collisions and the difference between the declared and the real arm are the caller's.
- Whether *all* solutions are found, not only those that went in, is the business of `tests/tests/ik.rs`, which compares with
  the complete sets of the reference.
- Random bits go through `fk`, `jacobian` and `ik`; `ik_near`, `track`, `closest` and families meet infinities, NaN and huge numbers
  in tests of their own. Paths are followed by the million with `cargo run --release -p tests --bin motion`, which fails if one flips
  where a continuous choice exists: the page of `kin_runtime::track` tells what came of them.

## Verdict

";

const LEGEND: &str = "
A try of a family takes joint values, goes forward to the pose and back. One in four is anywhere; the others aim at the singular
sets of the wrist (or of a spherical shoulder), and of the joints that carry its centre or the tool point, alone and together, at
±10⁻ᵏ, k = 0 … 17, and exactly: the elbow stretched and folded, both shoulders in one; on a general base wherever the determinant
of its motions vanishes, where the point comes onto axis 1 or 2, where the singular set crosses itself, and its cusps; and, without
a wrist, whole quarter turns of any joint. Distances of slides are in reaches; a slide stays within its range, or else within half
a reach. A try of `bits` puts random bit patterns through `fk` and `jacobian`, and through the inverse poses that are random bits,
or an arm's own pose with one entry replaced by random bits, or by 0, -0, NaN, ±∞, a denormal or a huge number, or scaled, or with
every entry off by some last bits.

- empty: a pose without a solution · lost: neither the joints that went in come back nor others that the pose cannot tell from them
- inexact: a solution misses the pose by more than 16 ε (64 ε on a general base) · twice: one solution in two slots
- malformed: a value that is not finite, an angle outside (-π, π], more solutions than the structure has · panicked: as it says
- blurred: the joints that went in do not come back, but others that the pose cannot tell from them do, see above

The parts: elbow, telescope, general, meeting (axes 1 and 2), parallel (axes 1 and 2), crossing (axes 2 and 3 meet) and sliding
(one to three slides) are bases under a spherical wrist; shoulder and shoulder-general are such bases seen from the tool, where the
first three axes meet; position are three joints, and two, solved from a position; short are poses of two to five joints. Of these
three, arms that stand on a general base, two joints among them, are in parts that are called so; general, meeting, parallel, crossing
and sliding are all of them general bases.
";

const AIMED: &str = "
How many of them are aimed at each kind of singular poses, each at ±10⁻ᵏ, k = 0 … 17, and exactly, alone and in any company:

";

const CASES: &str = "\
Joint values (for `malformed` wild bits the pose, rotation by rows and then the position) as hexadecimal bit patterns. To run one
again: `cargo run --release -p tests --bin reliability -- --seed SEED --again PART:NUMBER`. (A run without `--no-report` or
`--report FILE` writes this page anew.)

| try | arm | what | bits |
|---|---|---|---|
";

const TARGETS: &str = "
## The same bits on every target

`tests/no-std/bits.sh all` hashes `fk`, `jacobian` and the inverse of 2,000 poses of eleven arms (wrists on an elbow, a telescope, a
general base and two slides; a spherical shoulder; two to four joints) on x86-64, x86-64-v3, wasm32, aarch64 and a Cortex-M4, and
compares with `tests/no-std/golden.txt`, which `cargo test` holds on the host; and, but for the Cortex-M4, of 4,000 poses of eight
arms aimed at where a factor of the determinant vanishes, with members and ranges of families, the nearest reachable poses, and
steps of paths. The script prints a table and fails if one differs.
`bits.sh miri` interprets the same program with Miri, for a big-endian processor, `bits.sh miri-quick` its first 33 poses.
";

const STEADY: &str = "
## How steady its time is

`cargo run --release -p tests --bin steady` counts the instructions of `ik` and `ik_position` for 1,000 poses of each arm with
callgrind, three in four of them aimed at singular sets, families among them. For a given arm and number of solutions (a double
one counts as two) the worst case is asked to be at most 1.5 times the median; the program fails where it is more. Poses that are
far from every singular set take a short way, a tenth to a seventh of the time: where they are most of a group, the median is
theirs, and singular poses are many times as much. General bases, aimed at where their determinant vanishes, miss it too.

";

const EMBEDDED: &str = "
## On a controller

`tests/no-std/contract.sh link`, which CI runs, builds the tasks below for `thumbv7em-none-eabihf` at opt-level 3 and \"s\", in double
and in single precision, with a panic handler that calls a function which nobody defines: they link only if no path leads to a
panic. A program that can panic is built in the same way, and must not link. `contract.sh figures` measures them, 200 inputs each
(the longest on 20 or more), one in two at or near singular poses: flash is text and constants of a program with that task alone,
its vector table of 1 KiB included; stack is what loses its paint; instructions are counted by qemu, to 40, from 3·10⁸ on to 1,000.
A Cortex-M4 has no doubles in hardware.

- forward: `fk`, `frames`, `jacobian` and `fk_jacobian` of the Puma 560, all four.
- elbow, slide, oblique, general: `ik` of the IRB 2400, of the Stanford arm, of an arm with an oblique wrist, and of an arm with
  three skew axes and one with two slides.
- batch: `fk_jacobian` of sixteen configurations, told of as it goes, and `ik_batch` of sixteen poses.
- position: `ik_position`, `ik_position_near_within`, `closest_point` and `position_dexterity` of a three-joint arm, all four.
- choice: `ik_holding`, then `nearest`, `within`, `nearest_winding`, `ik_near_within`, `closest`, `dexterity`, up to 64 `windings`, and of a
  family the constraint, the nearest member and the ranges of members within limits.
- track: four steps, looking four poses ahead, on paths that may be singular throughout, with the solutions of each pose counted.
- ball: `ik` of an arm whose first three axes meet.
- short: `ik` and `ik_near` of the Cobra 600 and the Orion 5, `ik_position` of two joints.
- trajectory: a trajectory of six joints, the same in a given time, a route through three stops, a line and an arc of the tool; all of
  their properties, and up to eight samples of each.
- watch: every figure and every factor of arms of three, six and seven joints; what is run is the Puma's: two readings, and of the
  smallest singular value and of one factor a range, a search for crossings and one for spells, with a threshold so far away
  that one range decides.
- velocity: `rates`, `position_rates`, `twist`, `torques`, `jacobian_rate`, `acceleration`; determinants and singular values.

What is left out is text: the formatting of numbers in `core` has paths to a panic of its own.

";
