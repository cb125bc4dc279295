//! The report on an anthropomorphic arm: its polynomials, and its inverse replayed with and without each of its mistakes.

use std::collections::BTreeMap;

use serde_json::Value;
use tests::pose::from_zyx;
use tests::sample::Sampler;

use crate::{PAGES, TRUTH, close, expression_value, list, number, share, shown_value};

#[test]
fn polynomials() {
    let (page, truth) = (&PAGES["seed-001"], &TRUTH["seed001"]);
    let lengths = BTreeMap::from([("d1", 1.1), ("d2", 2.9), ("d3", 0.7), ("d4", 1.3), ("d5", 0.9)]);
    let mut sampler = Sampler::new(52);
    assert!(list(&truth["R36_printed_wrong"]).is_empty());
    for _ in 0..20 {
        let angles = sampler.angles::<6>();
        let shown = |key: &str| -> Vec<f64> {
            page.matrix(key).iter().map(|cell| shown_value(cell, &angles, &lengths)).collect()
        };
        let true_value = |v: &Value| expression_value(v.as_str().expect("an expression"), &angles, &lengths);
        let wrist: Vec<f64> = list(&truth["wrist_true"]).iter().map(true_value).collect();
        close(&shown("wrist centre"), &wrist, 1e-13);
        let rotation: Vec<f64> = list(&truth["R36_true"]).iter().flat_map(list).map(true_value).collect();
        close(&shown("r36"), &rotation, 1e-13);
    }
}

#[test]
fn replays() {
    let page = &PAGES["seed-001"];
    let replays = TRUTH["seed001"]["replay"].as_object().expect("replays");
    assert_eq!(replays.len(), 14);
    for (name, outcome) in replays {
        let fixed = |word: &str| name.contains(&format!("{word}=1"));
        let fixes =
            [fixed("Ty(-d5)"), fixed("theta1=atan2(-Px,Py)"), fixed("theta4 sign"), fixed("d3->d3+d4")];
        let key = match fixes {
            [false, false, false, false] => "printed",
            [true, false, false, false] => "Ty",
            [false, true, false, false] => "theta1",
            [false, false, true, false] => "theta4",
            [true, true, false, false] => "Ty theta1",
            [true, true, true, false] => "Ty theta1 theta4",
            [true, true, true, true] => "all",
            other => panic!("{name}: {other:?}"),
        };
        let column = if name.contains("L=[0, 1, 1, 0, 1]") { 1 } else { 3 };
        let outcome = outcome.as_str().expect("words");
        let wanted: usize = outcome.split('/').next().and_then(|n| n.parse().ok()).expect("a count");
        // Random poses of our own: what is all or nothing there is all or nothing here.
        assert_eq!(share(&page.rows(&format!("replay {key}"))[0][column]), (wanted, 200), "{name}");
        let unreachable = number(&page.rows(&format!("replay {key}"))[0][column + 1]).expect("a count");
        assert_eq!(unreachable == 0.0, outcome.contains(" 0 unreachable"), "{name}");
    }
    // Figure 3 is reached, in eight ways.
    let solutions = page.numbers("isolated (4, 0, 0)");
    assert_eq!(solutions.len(), 8);
    for q in solutions {
        let q = kin_runtime::Joints::<f64, 6>::from_iterator(q.into_iter().take(6));
        let pose = kin_runtime::Arm::fk(&robots::Anthropomorphic, &q);
        let wanted = from_zyx([4.0, 0.0, 0.0], [0.0; 3]);
        assert!((pose.to_homogeneous() - wanted.to_homogeneous()).amax() < 1e-11, "{q}");
    }
}
