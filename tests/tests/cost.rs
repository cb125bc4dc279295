//! What the derived programs cost, against what is promised and against the best that other generators reach.

use std::path::Path;

use kin_runtime::Arm;
use tests::measured::{self, ARMS};

#[test]
fn no_program_costs_more_than_the_best_peer() {
    for measured in &ARMS {
        let arm = measured::derived(measured.table);
        let forward = &arm.forward;
        let programs = [&forward.fk, &forward.jacobian, &forward.fk_jacobian];
        for (program, [mul, add]) in programs.iter().zip(measured.peers) {
            let cost = program.cost();
            assert!(cost.mul <= mul && cost.add <= add, "{} {}: {cost}", arm.name, program.name);
        }
    }
}

#[test]
fn every_program_costs_what_is_promised_or_less() {
    for measured in &ARMS {
        let arm = measured::derived(measured.table);
        for (name, [mul, add, trig]) in measured.promised {
            let programs = measured::programs(&arm);
            let program = programs.iter().find(|p| p.name == *name);
            let cost = program.unwrap_or_else(|| panic!("{} has no {name}", arm.name)).cost();
            println!("{:10} {name:12} {cost}; promised {mul}/{add};{trig}", arm.name);
            let kept = cost.mul <= *mul && cost.add <= *add && cost.trig <= *trig;
            assert!(kept, "{} {name}: {cost}, promised {mul}/{add};{trig}", arm.name);
        }
    }
}

/// A fixed row that turns about the axis of the joint behind it by an odd angle is an offset of that joint, and costs no more.
#[test]
fn a_fixed_turn_about_a_joint_s_own_axis_costs_no_more_than_an_offset() {
    let arm = |between: &str, second: &str| {
        let text = format!(
            "struct Any(standard, m, deg);
| joint | theta | d | a | alpha |
| J1 | q | 0.3 | 0.1 | 0 |
{between}| J2 | {second} | 0.4 | 90 |
| J3 | q | 0.1 | 0.2 | 0 |
"
        );
        kin_gen::compile_text(&text).unwrap_or_else(|messages| panic!("{text}\n{messages}"))
    };
    for angle in ["25", "-67.5", "90"] {
        let fixed = arm(&format!("| | {angle} | 0.05 | 0 | 0 |\n"), "q | 0");
        let offset = arm("", &format!("q + {angle} | 0.05"));
        let costs = [&fixed, &offset].map(|arm| {
            let forward = &arm.forward;
            [&forward.fk, &forward.jacobian, &forward.fk_jacobian].map(|program| program.cost())
        });
        let [fixed, offset] = costs;
        for (fixed, offset) in fixed.iter().zip(&offset) {
            let dearer = fixed.mul > offset.mul || fixed.add > offset.add || fixed.trig > offset.trig;
            assert!(!dearer, "{angle}: {fixed}, and {offset} with an offset");
        }
    }
}

/// What `counts` prints, for every arm.
#[test]
fn the_counts_are_current() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden/counts.txt");
    let counts = measured::counts();
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(&file, &counts).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    }
    let golden = std::fs::read_to_string(&file).unwrap_or_default();
    for (line, (is, was)) in counts.lines().zip(golden.lines()).enumerate() {
        assert_eq!(is, was, "line {}; `UPDATE=1 cargo test -p tests --test cost` writes it anew", line + 1);
    }
    assert_eq!(counts.lines().count(), golden.lines().count());
}

/// The lines of one generated method, from its doc comment to its closing brace.
fn method<'a>(items: &'a str, name: &str) -> Vec<&'a str> {
    let start = items.find(&format!("fn {name}<")).unwrap_or_else(|| panic!("no method {name}"));
    let lines = items[start..].lines();
    lines.take_while(|line| !line.starts_with("///") && !line.starts_with("#[")).collect()
}

#[test]
fn puma_560_reads_like_a_textbook() {
    let arm = kin_gen::compile_text(robots::Puma560::TABLE).unwrap_or_else(|messages| panic!("{messages}"));
    let items = kin_gen::back::rust::items(&arm, "::kin_runtime");
    let parts = ["fk_inlined", "jacobian_inlined", "r36"].map(|name| method(&items, name));
    let lines: usize = parts.iter().map(Vec::len).sum();
    println!("{lines} lines for FK, Jacobian and ³R₆");
    assert!(lines < 200, "{lines} lines");
    let text = parts.concat().join("\n");
    for name in ["[s1, s2, s23", "[c1, c2, c23", "let a2 =", "let d4 =", "let px =", "let r31 ="] {
        assert!(text.contains(name), "{name} is missing from\n{text}");
    }
    assert!(!text.contains("tmp"));
}
