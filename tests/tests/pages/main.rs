//! The pages of the four lab reports, read back from their markup: every numeric example of `data/seeds_truth.json` is on
//! them, with its true value.

mod elbow_wrist;
mod lab_arm;
mod lab_rrr;
mod yzy;

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde_json::Value;
use tests::expression;
use tests::markup::{Node, Values, read};
use tests::reference;
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

/// Joint values modulo a turn.
fn apart(found: &[f64], wanted: &[f64], joints: &[usize]) -> f64 {
    joints.iter().map(|i| wrap(found[*i] - wanted[*i]).abs()).fold(0.0, f64::max)
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

/// `0 of 200` in a cell.
fn share(cell: &Node) -> (usize, usize) {
    let text = cell.text();
    let (count, of) = text.split_once(" of ").unwrap_or_else(|| panic!("`{text}` is no share"));
    (count.parse().expect("a count"), of.parse().expect("a count"))
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
