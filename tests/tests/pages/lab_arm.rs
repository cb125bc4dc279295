//! The report on the lab's arm of six joints: its table, every forward and inverse example, limits, singular poses, misprints.

use std::collections::BTreeMap;

use serde_json::Value;
use tests::pose::from_zyx;
use tests::product;
use tests::reference;
use tests::sample::Sampler;
use tests::score::wrap;

use crate::{
    PAGES, Page, TRUTH, apart, close, close_to_its_digits, expression_value, float, floats, list, shown_value,
};

fn lab() -> &'static Page {
    &PAGES["seed-000"]
}

/// The independent product of the table's matrices, in millimetres.
fn oracle(q: &[f64]) -> [[f64; 4]; 4] {
    let arms = reference::arms();
    let record = arms.iter().find(|arm| arm.name == "seed000_lab6dof").expect("the lab arm");
    let mut pose = product::pose(record, q);
    pose.iter_mut().take(3).for_each(|row| row[3] *= 1000.0);
    pose
}

#[test]
fn forward_examples() {
    let truth = &TRUTH["seed000"];
    let zero = &truth["fk_zero"];
    close(&lab().one("forward position 0"), &floats(&zero["truth_xyz_mm"]), 1e-12);
    for (found, row) in lab().numbers("forward matrix").iter().zip(list(&zero["T"])) {
        let mut wanted = floats(row);
        wanted[3] *= 1000.0;
        close(found, &wanted, 1e-12);
    }
    let cases = list(&truth["fk_of_truncated"]);
    assert_eq!(cases.len(), 7);
    for (index, case) in cases.iter().enumerate() {
        let position = lab().one(&format!("forward position {}", index + 1));
        for (found, wanted) in position.iter().zip(list(&case["truth_xyz_mm"])) {
            close_to_its_digits(*found, wanted);
        }
        // The listed truth has ten digits; the plain product has the rest.
        let expected = oracle(&floats(&case["q"]));
        close(&position, &[expected[0][3], expected[1][3], expected[2][3]], 1e-12);
        let angles = lab().one(&format!("forward angles {}", index + 1));
        for (found, wanted) in angles.iter().zip(floats(&case["truth_zyx"])) {
            assert!(wrap(found - wanted).abs() < 1e-7, "{angles:?}");
        }
        let turned = from_zyx([0.0; 3], [angles[0], angles[1], angles[2]]);
        let entries = (0..9).map(|k| turned.rotation.matrix()[(k / 3, k % 3)] - expected[k / 3][k % 3]);
        assert!(entries.map(f64::abs).fold(0.0, f64::max) < 1e-12, "{angles:?}");
    }
}

const ALL: [usize; 6] = [0, 1, 2, 3, 4, 5];

/// The joints that a family leaves alone, and the sum that it keeps.
fn family(found: &[f64], member: &[f64]) -> f64 {
    let wrist = found[4].abs() < 1e-9 && wrap(found[3] + found[5] - member[3] - member[5]).abs() < 1e-9;
    let (fixed, pair) = if wrist { ([0, 1, 2, 4], [3, 5]) } else { ([1, 2, 3, 4], [0, 5]) };
    let sum = wrap(found[pair[0]] + found[pair[1]] - member[pair[0]] - member[pair[1]]).abs();
    apart(found, member, &fixed).max(sum)
}

#[test]
fn every_inverse_example() {
    let examples = TRUTH["seed000"]["ik"].as_object().expect("examples");
    assert_eq!(examples.len(), 8);
    for (name, example) in examples {
        let isolated = list(&example["isolated"]);
        let sigma = list(&example["sigma_min"]);
        let key = format!("isolated {name}");
        let found = if isolated.is_empty() { Vec::new() } else { lab().numbers(&key) };
        assert_eq!(lab().rows.get(&key).map_or(0, Vec::len), isolated.len(), "{name}");
        for (listed, sigma) in isolated.iter().zip(sigma) {
            let listed = floats(listed);
            let row = found.iter().find(|row| apart(row, &listed, &ALL) < 1e-12);
            let row = row.unwrap_or_else(|| panic!("{name}: {listed:?} is not on the page: {found:?}"));
            let wanted = float(sigma);
            assert!((row[6] - wanted).abs() <= 0.006 * wanted, "{name}: {row:?} {wanted}");
        }
        // The poses just beyond the reach list joint values that miss them; they are no solutions.
        let members = if isolated.is_empty() && name.starts_with("6.5") {
            &[]
        } else {
            list(&example["singular_members"])
        };
        let key = format!("family {name}");
        assert_eq!(lab().rows.get(&key).map_or(0, Vec::len), members.len(), "{name}");
        for member in members {
            let member = floats(member);
            let nearest = lab().numbers(&key).iter().map(|row| family(row, &member)).fold(f64::MAX, f64::min);
            assert!(nearest < 1e-12, "{name}: {member:?} is {nearest:e} from the page");
        }
        printed_rows(name, list(&example["printed_check"]));
    }
}

/// The rows that the report prints, and how far they miss the pose.
fn printed_rows(name: &str, printed: &[Value]) {
    if printed.is_empty() {
        return;
    }
    let rows = lab().numbers(&format!("printed {name}"));
    assert_eq!(rows.len(), printed.len(), "{name}");
    for (row, printed) in rows.iter().zip(printed) {
        close(&row[..6], &floats(&printed["q"]), 1e-12);
        close_to_its_digits(row[6], &printed["fk_err_pos_mm"]);
        let rotation = float(&printed["fk_err_rot"]);
        assert!((row[7] - rotation).abs() <= 0.006 * rotation + 1e-30, "{name}: {row:?} {rotation}");
    }
}

#[test]
fn limits_and_singular_configurations() {
    let truth = &TRUTH["seed000"];
    for (key, name) in [("limit d35", "d35"), ("limit zmax", "zmax")] {
        // As text: a double does not hold these digits.
        assert_eq!(lab().rows(key)[0][1].text(), truth["limits"][name].as_str().expect("a numeral"));
    }
    for (key, name) in
        [("singular z1 z4", "z1_aligned_z4"), ("singular wrist on z1", "wrist_on_z1_general_orientation")]
    {
        let case = &truth[name];
        close(&lab().one(&format!("{key} q")), &floats(&case["q"]), 1e-12);
        close(&lab().one(&format!("{key} sigma")), &floats(&case["singular_values"]), 1e-12);
    }
    let aligned = &truth["z1_aligned_z4"];
    assert_eq!(aligned["rank"], 5);
    assert!(lab().one("singular z1 z4 sigma")[5] < 1e-15);
    close(&lab().one("singular axis 1"), &floats(&aligned["z1"]), 1e-12);
    close(&lab().one("singular axis 4"), &floats(&aligned["z4"]), 1e-12);
    let tool = lab().one("singular tool");
    let metres: Vec<f64> = tool.iter().map(|x| x / 1000.0).collect();
    close(&metres, &floats(&truth["wrist_on_z1_general_orientation"]["ee_xy"]), 1e-12);
}

#[test]
fn printed_matrices_and_their_misprints() {
    let mut sampler = Sampler::new(51);
    let none = BTreeMap::new();
    let wrong = list(&TRUTH["seed000"]["matrix_4_7_wrong_entries"]);
    assert_eq!(wrong.len(), 1);
    let (printed, truth) = wrong[0]
        .as_str()
        .and_then(|text| text.strip_prefix("(1,2): printed ")?.split_once(" true "))
        .expect("printed and true");
    let row = &lab().rows("mistake 4.7")[0];
    let lengths = BTreeMap::from([("d6", 29.0)]);
    for _ in 0..20 {
        let angles = sampler.angles::<6>();
        close(
            &[shown_value(&row[1], &angles, &none), shown_value(&row[2], &angles, &none)],
            &[expression_value(printed, &angles, &none), expression_value(truth, &angles, &none)],
            1e-14,
        );
        let mut cells = Vec::new();
        lab().rows("mistake 4.3")[0][2].all("mtd", &mut cells);
        let origin: Vec<f64> = cells.iter().map(|cell| shown_value(cell, &angles, &lengths)).collect();
        let listed = TRUTH["seed000"]["p6_in_5"].as_str().expect("a vector").trim_matches(['[', ']']);
        let wanted: Vec<f64> = listed.split(", ").map(|v| expression_value(v, &angles, &lengths)).collect();
        close(&origin, &wanted, 0.0);
    }
}
