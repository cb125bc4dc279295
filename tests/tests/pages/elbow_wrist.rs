//! The report on an arm with a trajectory: its polynomials, its inverse replayed, and the singular pose on its way.

use std::collections::BTreeMap;

use tests::sample::Sampler;

use crate::{PAGES, TRUTH, close, expression_value, float, number, share, shown_value};

#[test]
fn replays_and_polynomials() {
    let (page, truth) = (&PAGES["seed-003"], &TRUTH["seed003"]);
    let replays = truth["replay"].as_object().expect("replays");
    assert_eq!(replays.len(), 5);
    for (name, outcome) in replays {
        let key = match name.as_str() {
            "q6 sign fixed" => "sign",
            "theta1 atan2" => "theta1",
            "theta1,theta2 atan2" => "theta2",
            "all atan2" => "all",
            _ => "printed",
        };
        let wanted: usize =
            outcome.as_str().and_then(|o| o.split('/').next()?.parse().ok()).expect("a count");
        let (found, of) = share(&page.rows(&format!("replay {key}"))[0][1]);
        assert_eq!(of, 200);
        // Counts of two samples of 200: all or nothing agree exactly, a part within four standard deviations.
        let part = wanted as f64 / 200.0;
        let spread = (2.0 * 200.0 * part * (1.0 - part)).sqrt();
        assert!((found as f64 - wanted as f64).abs() <= 4.0 * spread, "{name}: {found} {wanted}");
    }
    // The report's own wrist position, with its numbers, and its ³R₆.
    assert_eq!(truth["wrist_printed_ok"], serde_json::json!([true, true, true]));
    assert_eq!(float(&truth["R36_of_section2_minus_printed"]), 0.0);
    let printed = [
        "0.8*sin(t1)*sin(t2)*sin(t3) - 0.8*sin(t1)*cos(t2)*cos(t3) - 1.0*sin(t1)*cos(t2)",
        "-0.8*sin(t2)*sin(t3)*cos(t1) + 0.8*cos(t1)*cos(t2)*cos(t3) + 1.0*cos(t1)*cos(t2)",
        "0.8*sin(t2)*cos(t3) + 1.0*sin(t2) + 0.8*sin(t3)*cos(t2) + 0.3",
    ];
    let r36 = [
        "sin(t4)*sin(t6) - cos(t4)*cos(t5)*cos(t6)",
        "sin(t4)*cos(t6) + sin(t6)*cos(t4)*cos(t5)",
        "sin(t5)*cos(t4)",
        "-sin(t4)*cos(t5)*cos(t6) - sin(t6)*cos(t4)",
        "sin(t4)*sin(t6)*cos(t5) - cos(t4)*cos(t6)",
        "sin(t4)*sin(t5)",
        "sin(t5)*cos(t6)",
        "-sin(t5)*sin(t6)",
        "cos(t5)",
    ];
    let lengths = BTreeMap::from([("l1", 0.3), ("l2", 1.0), ("l3", 0.5), ("l4", 0.3)]);
    let mut sampler = Sampler::new(53);
    for _ in 0..20 {
        let angles = sampler.angles::<6>();
        for (key, printed) in [("wrist centre", printed.as_slice()), ("r36", r36.as_slice())] {
            let shown: Vec<f64> =
                page.matrix(key).iter().map(|cell| shown_value(cell, &angles, &lengths)).collect();
            let wanted: Vec<f64> =
                printed.iter().map(|text| expression_value(text, &angles, &BTreeMap::new())).collect();
            close(&shown, &wanted, 1e-13);
        }
    }
}

/// The monitor's crossing against the trapezoidal profile of joint 5, solved by hand.
#[test]
fn singularity_on_the_trajectory() {
    let page = &PAGES["seed-003"];
    let crossings = page.numbers("crossing");
    assert_eq!(crossings.len(), 1);
    // 1.73 rad at 1 rad/s and 2 rad/s² take joint 1 2.23 s; joint 5 has 1.3 rad to go in that time, the first 0.85 of
    // them to zero: v (T - v / a) = 1.3.
    let (duration, a, way) = (1.73 + 0.5, 2.0f64, 1.3);
    let v = (a * duration - (a * a * duration * duration - 4.0 * a * way).sqrt()) / 2.0;
    let time = 0.85 / v + v / a / 2.0;
    assert!((crossings[0][0] - time).abs() < 1e-8, "{crossings:?} {time}");
    // The determinant has opposite signs at the samples around it, and is zero at none.
    assert!(crossings[0][1] * crossings[0][2] < 0.0);
    // The printed switching time is right where the profile is trapezoidal, wrong where it is triangular.
    let profiles = page.rows("profile");
    assert_eq!(profiles.len(), 6);
    for row in profiles {
        let cell = |i: usize| number(&row[i]).expect("a number");
        let triangular = row[3].text() == "triangular";
        let true_tau = if triangular { (cell(1) / a).sqrt() } else { 1.0 / a };
        assert!((cell(5) - true_tau).abs() < 1e-4 && ((cell(4) - cell(5)).abs() > 0.1) == triangular);
    }
}
