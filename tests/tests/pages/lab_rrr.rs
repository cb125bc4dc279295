//! The report on an arm of three joints: its forward examples, and its inverse.

use std::f64::consts::TAU;

use serde_json::Value;

use crate::{PAGES, TRUTH, apart, close, float, floats, list};

#[test]
fn every_example() {
    let (page, truth) = (&PAGES["seed-004"], &TRUTH["seed004"]);
    let shown = |key: &str| -> Vec<String> {
        page.rows(key)[0].iter().skip(1).map(|cell| cell.text().replace('−', "-")).collect()
    };
    let texts = |value: &Value| -> Vec<String> {
        list(value).iter().map(|v| v.as_str().map_or_else(|| v.to_string(), str::to_owned)).collect()
    };
    // Twenty digits, as text.
    assert_eq!(shown("for_kin"), texts(&truth["for_kin(0.5,0.5,-0.5)"]["truth"]));
    close(&page.one("for_kin doubles"), &floats(&truth["for_kin(0.5,0.5,-0.5)"]["truth"]), 1e-15);
    close(&page.one("for_kin final"), &floats(&truth["with final table (d1=0)"]), 1e-12);
    let geometric = truth["geometric FK vs DH"].as_object().expect("configurations");
    assert_eq!(geometric.len(), 4);
    for (index, name) in
        ["[0.5, 0.5, -0.5]", "[0.5, 0.5, 0.5]", "[0.3, 0.9, -1.2]", "[0.3, 0.9, 1.2]"].iter().enumerate()
    {
        let case = &geometric[*name];
        close(&page.one(&format!("geometric {index}")), &floats(&case["geometric"]), 1e-14);
        close(&page.one(&format!("true {index}"))[..3], &floats(&case["dh"]), 1e-14);
    }
    let inverse = &truth["printed IK of that point"];
    close(&page.one("for_kin doubles"), &floats(&inverse["p"]), 1e-15);
    close(&page.one("printed inverse q"), &floats(&inverse["q"]), 1e-12);
    close(&page.one("printed inverse fk"), &floats(&inverse["fk"]), 1e-12);
    close(&page.one("printed inverse off"), &[float(&inverse["err"])], 1e-12);
    let solutions = list(&truth["true position IK (all)"]);
    let rows = page.numbers("isolated");
    assert_eq!((rows.len(), solutions.len()), (4, 4));
    for solution in solutions {
        let wanted = floats(solution);
        let near = rows.iter().map(|row| apart(row, &wanted, &[0, 1, 2])).fold(TAU, f64::min);
        assert!(near < 1e-12, "{wanted:?}: {near}");
    }
}
