//! The pages of the four lab reports, read back from their markup: every numeric example of `data/seeds_truth.json` is on
//! them, with its true value.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::LazyLock;

use serde_json::Value;
use tests::expression;
use tests::markup::{Node, Values, read};
use tests::pose::from_zyx;
use tests::product;
use tests::reference;
use tests::sample::Sampler;
use tests::score::wrap;

/// A page as its reader has it.
struct Page {
    /// The cells of each row that has a key.
    rows: BTreeMap<String, Vec<Vec<Node>>>,
    /// The displayed formulas that have one.
    formulas: BTreeMap<String, Node>,
    /// The file.
    markup: String,
}

static PAGES: LazyLock<BTreeMap<&str, Page>> = LazyLock::new(|| {
    let written = report::pages::ALL.iter().map(|report| {
        let page = (report.write)().unwrap_or_else(|error| panic!("{}: {error}", report.file));
        (report.file, understood(page.finish()))
    });
    written.collect()
});

static TRUTH: LazyLock<Value> = LazyLock::new(|| reference::read("seeds_truth.json"));

fn understood(markup: String) -> Page {
    let document = read(&markup);
    let (mut rows, mut formulas) = (BTreeMap::<String, Vec<Vec<Node>>>::new(), BTreeMap::new());
    let mut found = Vec::new();
    document.all("tr", &mut found);
    for row in found {
        if let Some(key) = row.attribute("data-key") {
            rows.entry(key.to_owned()).or_default().push(row.children().to_vec());
        }
    }
    let mut found = Vec::new();
    blocks(&document, &mut found);
    for block in found {
        if let Some(key) = block.attribute("data-key") {
            formulas.insert(key.to_owned(), block.clone());
        }
    }
    Page { rows, formulas, markup }
}

/// All blocks, those inside others as well.
fn blocks<'a>(node: &'a Node, found: &mut Vec<&'a Node>) {
    if let Node::Element(name, ..) = node {
        if name == "div" {
            found.push(node);
        }
        node.children().iter().for_each(|child| blocks(child, found));
    }
}

/// The number that stands alone in a cell.
fn number(cell: &Node) -> Option<f64> {
    cell.text().replace('−', "-").parse().ok()
}

impl Page {
    fn rows(&self, key: &str) -> &[Vec<Node>] {
        self.rows.get(key).unwrap_or_else(|| panic!("no row `{key}` on the page"))
    }

    /// The numbers of each row with that key.
    fn numbers(&self, key: &str) -> Vec<Vec<f64>> {
        self.rows(key).iter().map(|row| row.iter().filter_map(number).collect()).collect()
    }

    /// The numbers of the only row with that key.
    fn one(&self, key: &str) -> Vec<f64> {
        let rows = self.numbers(key);
        assert_eq!(rows.len(), 1, "`{key}` stands once");
        rows.into_iter().next().unwrap_or_default()
    }

    /// The entries of the matrix that a formula ends with.
    fn matrix(&self, key: &str) -> Vec<Node> {
        let block = self.formulas.get(key).unwrap_or_else(|| panic!("no formula `{key}` on the page"));
        let mut cells = Vec::new();
        block.all("mtd", &mut cells);
        cells.into_iter().cloned().collect()
    }
}

/// A number of the truth, whether written as one or as text.
fn float(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().unwrap_or_else(|_| panic!("{text} is no number")),
        other => other.as_f64().unwrap_or_else(|| panic!("{other} is no number")),
    }
}

fn floats(value: &Value) -> Vec<f64> {
    value.as_array().unwrap_or_else(|| panic!("{value} is no list")).iter().map(float).collect()
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap_or_else(|| panic!("{value} is no list"))
}

#[track_caller]
fn close(found: &[f64], wanted: &[f64], tolerance: f64) {
    assert_eq!(found.len(), wanted.len(), "{found:?} {wanted:?}");
    for (a, b) in found.iter().zip(wanted) {
        assert!((a - b).abs() <= tolerance, "{found:?} {wanted:?}");
    }
}

/// Half a unit of the last digit of a numeral, and a little.
fn last_digit(text: &str) -> f64 {
    let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    0.51 * 10f64.powi(exponent.parse::<i32>().unwrap_or(0) - decimals as i32)
}

#[track_caller]
fn close_to_its_digits(found: f64, wanted: &Value) {
    let text = wanted.as_str().map_or_else(|| wanted.to_string(), str::to_owned);
    let vanishing = found.abs() < 1e-30 && float(wanted).abs() < 1e-30;
    assert!(vanishing || (found - float(wanted)).abs() <= last_digit(&text).max(1e-12), "{found} {text}");
}

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
fn seed_000_forward_examples() {
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

/// Joint values modulo a turn.
fn apart(found: &[f64], wanted: &[f64], joints: &[usize]) -> f64 {
    joints.iter().map(|i| wrap(found[*i] - wanted[*i]).abs()).fold(0.0, f64::max)
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
fn seed_000_every_inverse_example() {
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
fn seed_000_limits_and_singular_configurations() {
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

/// The value of an expression of the truth, `t4` being the fourth angle.
fn expression_value(text: &str, angles: &[f64; 6], lengths: &BTreeMap<&str, f64>) -> f64 {
    let mut text = text.to_owned();
    for (index, angle) in angles.iter().enumerate() {
        text = text.replace(&format!("t{}", index + 1), &format!("({angle:.17})"));
    }
    for (name, value) in lengths {
        text = text.replace(name, &format!("({value:.17})"));
    }
    expression::value(&text)
}

/// The value of mathematics on a page at joint values, with fused angles where they are used.
fn shown_value(node: &Node, angles: &[f64; 6], lengths: &BTreeMap<&str, f64>) -> f64 {
    let mut known: BTreeMap<String, f64> = lengths.iter().map(|(k, v)| ((*k).to_owned(), *v)).collect();
    for (index, angle) in angles.iter().enumerate() {
        known.insert(format!("c{}", index + 1), angle.cos());
        known.insert(format!("s{}", index + 1), angle.sin());
    }
    let sum = angles[1] + angles[2];
    known.extend([("c23".to_owned(), sum.cos()), ("s23".to_owned(), sum.sin())]);
    Values { known, other: &|_| None }.value(node)
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

#[test]
fn seed_001_polynomials() {
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

/// `0 of 200` in a cell.
fn share(cell: &Node) -> (usize, usize) {
    let text = cell.text();
    let (count, of) = text.split_once(" of ").unwrap_or_else(|| panic!("`{text}` is no share"));
    (count.parse().expect("a count"), of.parse().expect("a count"))
}

#[test]
fn seed_001_replays() {
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

#[test]
fn seed_003_replays_and_polynomials() {
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
fn seed_003_singularity_on_the_trajectory() {
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

#[test]
fn seed_004_every_example() {
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

#[test]
fn pages_stand_alone() {
    for (file, page) in PAGES.iter() {
        let page = &page.markup;
        for word in ["src=", "http-equiv", "<script", "<link", "@import", "url(http"] {
            assert!(!page.contains(word), "{file}: {word}");
        }
        assert!(page.matches("<svg").count() > 4, "{file}");
        assert!(!page.contains("NaN") && !page.contains("inf<"), "{file}");
    }
}
