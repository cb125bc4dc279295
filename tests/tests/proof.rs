//! The proof rejects what is wrong: programs corrupted at random, one sign, one operand or one constant at a time.

use kin_gen::algebra::frame::Values;
use kin_gen::algebra::ring::{Poly, Ring};
use kin_gen::chain::Chain;
use kin_gen::eval::{Inputs, eval};
use kin_gen::model::Solver;
use kin_gen::program::{Op, Program, Value};
use kin_gen::report::Report;
use kin_gen::truth::{self, Symbols};
use kin_gen::{decl, model};
use tests::sample::Sampler;

const PUMA: &str = "struct Puma(standard, m, deg);
    | joint | theta | d       | a      | alpha |
    | J1    | q     | 0       | 0      | 90    |
    | J2    | q     | 0       | 0.4318 | 0     |
    | J3    | q     | 0.15005 | 0.0203 | -90   |
    | J4    | q     | 0.4318  | 0      | 90    |
    | J5    | q     | 0       | 0      | -90   |
    | J6    | q     | 0       | 0      | 0     |";

/// A general twist, an angle offset, a parameter of each kind, a coupling, a slide, base and tool.
const GENERAL: &str = "struct General(modified, mm, deg);
    let d1 = 300; let a2 = 410.5;
    param reach = 250; param droop = 3deg;
    | joint | alpha | a  | d     | theta     | limits    |
    | J1    | 0     | 0  | d1    | q         |           |
    | J2    | -90   | 50 | 0     | q + 30    |           |
    | J3    | 0     | a2 | 0     | -q        |           |
    | J4    | 37    | 0  | reach | q + droop |           |
    | J5    | 90    | 0  | q     | 0         | 0 .. 100  |
    base: Rx(20) Tz(100);
    tool: Tx(15) Ry(90);
    couple: J3 -= J2;";

fn chain(text: &str) -> Chain {
    let (tokens, _, mut report) = decl::lex(text);
    let chain = decl::parse(&tokens, &mut report).and_then(|d| kin_gen::chain::check(&d, &mut report));
    assert!(!report.has_errors(), "{report:?}");
    let _: &Report = &report;
    chain.expect("no errors, so there is a chain")
}

/// One arm with its forward programs and their truths.
struct Subject {
    chain: Chain,
    ring: Ring,
    symbols: Symbols,
    programs: Vec<(Program, Vec<Poly>)>,
}

fn subject(text: &str) -> Subject {
    let chain = chain(text);
    let arm = model::derive(&chain).expect("derived and proved");
    let (mut ring, symbols) = (arm.ring.clone(), arm.symbols.clone());
    let raw =
        truth::whole(&mut ring, &symbols, &chain, Values::Commanded, &arm.outers).expect("representable");
    let tip: Vec<Poly> = raw.tip.rotation.iter().flatten().chain(&raw.tip.position).cloned().collect();
    let columns = truth::jacobian(&ring, &symbols, &chain, &raw);
    let columns: Vec<Poly> = columns.into_iter().flatten().collect();
    let both: Vec<Poly> = tip.iter().chain(&columns).cloned().collect();
    let pose =
        |p: &truth::RawPose| p.rotation.iter().flatten().chain(&p.position).cloned().collect::<Vec<_>>();
    let frames: Vec<Poly> = raw.frames.iter().flat_map(pose).collect();
    let forward = arm.forward;
    let mut programs = vec![
        (forward.fk, tip),
        (forward.frames, frames),
        (forward.jacobian, columns),
        (forward.fk_jacobian, both),
    ];
    if let Solver::Pose(solver) = arm.solver {
        programs.push((solver.r36, solver.r36_meaning.iter().flatten().cloned().collect()));
    }
    Subject { chain, ring, symbols, programs }
}

/// One random corruption, and what kind it is.
fn corrupt(program: &mut Program, random: &mut Sampler) -> &'static str {
    loop {
        let index = random.below(program.steps.len());
        let other = random.below(index.max(1));
        let step = &mut program.steps[index];
        match (random.below(6), step.op.clone()) {
            (0, Op::Add(a, b)) => {
                step.op = Op::Sub(a, b);
                return "sign";
            }
            (0, Op::Sub(a, b)) => {
                step.op = if random.below(2) == 0 { Op::Add(a, b) } else { Op::Sub(b, a) };
                return "sign";
            }
            (1, _) => {
                let output = random.below(program.outputs.len());
                if let Value::Step { negative, .. } = &mut program.outputs[output].value {
                    *negative = !*negative;
                    return "sign";
                }
            }
            (2, Op::Add(a, b)) if other != b => {
                step.op = if random.below(2) == 0 { Op::Add(other, b) } else { Op::Add(a, other) };
                return "operand";
            }
            (2, Op::Sub(a, b)) if other != b => {
                step.op = if random.below(2) == 0 { Op::Sub(other, b) } else { Op::Sub(a, other) };
                return "operand";
            }
            (3, Op::Mul(a, b)) if other != b => {
                step.op = if random.below(2) == 0 { Op::Mul(other, b) } else { Op::Mul(a, other) };
                return "operand";
            }
            (4, Op::Constant(meaning, value)) => {
                step.op = Op::Constant(
                    meaning,
                    if random.below(2) == 0 { value * 1.0625 } else { value.next_up() },
                );
                return "constant";
            }
            (4, Op::Cos(turn)) => {
                step.op = Op::Sin(turn);
                return "operand";
            }
            (5, _) => {
                let output = random.below(program.outputs.len());
                if let Value::Unit(unit) = &mut program.outputs[output].value {
                    *unit = if *unit == 0 { 1 } else { 0 };
                    return "constant";
                }
            }
            _ => {}
        }
    }
}

/// Whether two programs differ at some of a few random points by more than rounding does.
fn differ(a: &Program, b: &Program, chain: &Chain, random: &mut Sampler) -> bool {
    (0..4).any(|_| {
        let joints: Vec<f64> = chain.joints.iter().map(|_| random.between(-3.0, 3.0)).collect();
        let params: Vec<f64> = chain.params.iter().map(|_| random.between(0.5, 300.0)).collect();
        let inputs = Inputs { joints: &joints, params: &params, entries: &[] };
        let (a, b) = (eval(a, inputs), eval(b, inputs));
        a.iter().zip(&b).any(|(x, y)| (x - y).abs() > 1e-9 * (1.0 + x.abs()))
    })
}

#[test]
fn every_corruption_that_changes_a_value_is_rejected() {
    let subjects = [subject(PUMA), subject(GENERAL)];
    let mut random = Sampler::new(2019);
    let (mut changed, mut neutral, mut kinds) = (0, 0, std::collections::BTreeMap::new());
    for round in 0..1000 {
        let subject = &subjects[round % 2];
        let (program, truth) = &subject.programs[random.below(subject.programs.len())];
        let mut corrupted = program.clone();
        *kinds.entry(corrupt(&mut corrupted, &mut random)).or_insert(0) += 1;
        let accepted = corrupted.prove(&mut subject.ring.clone(), &subject.symbols, truth).is_ok();
        if differ(program, &corrupted, &subject.chain, &mut random) {
            changed += 1;
            assert!(!accepted, "round {round}: a wrong {} was accepted", program.name);
        } else {
            neutral += 1;
        }
    }
    println!("{changed} corruptions changed a value, {neutral} did not; by kind {kinds:?}");
    assert!(changed > 800, "most corruptions must matter: {changed}");
    assert!(
        ["sign", "operand", "constant"].iter().all(|k| kinds.get(k).is_some_and(|n| *n > 50)),
        "{kinds:?}"
    );
}

#[test]
fn a_constant_off_by_one_unit_in_the_last_place_is_rejected() {
    let subject = subject(PUMA);
    let (program, truth) = &subject.programs[0];
    for index in 0..program.steps.len() {
        let mut corrupted = program.clone();
        let Op::Constant(meaning, value) = corrupted.steps[index].op.clone() else { continue };
        corrupted.steps[index].op = Op::Constant(meaning, value.next_up());
        assert!(corrupted.prove(&mut subject.ring.clone(), &subject.symbols, truth).is_err());
    }
}

#[test]
fn an_operand_that_does_not_precede_its_use_is_rejected() {
    let subject = subject(PUMA);
    let (program, truth) = &subject.programs[0];
    let mut corrupted = program.clone();
    let last = corrupted.steps.len() - 1;
    corrupted.steps[last].op = Op::Mul(last, 0);
    assert!(corrupted.prove(&mut subject.ring.clone(), &subject.symbols, truth).is_err());
}
