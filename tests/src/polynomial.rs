//! Polynomials as printed text: compared term by term, whatever the order of terms and factors.

use std::collections::BTreeMap;

/// The terms of a sum of products such as `-c4·c5·s6 - s4*c6 + 2*d1`: sorted factors and their integer coefficient.
///
/// # Panics
///
/// On an unreadable coefficient: the texts are part of the tests.
pub fn terms(text: &str) -> BTreeMap<Vec<String>, i64> {
    let mut terms = BTreeMap::new();
    let spaced = text.trim().replace(" - ", " + -");
    for term in spaced.split(" + ").filter(|term| *term != "0") {
        let (sign, product) = term.strip_prefix('-').map_or((1, term), |rest| (-1, rest));
        let mut coefficient = sign;
        let mut factors = Vec::new();
        for factor in product.split(['·', '*']) {
            match factor.starts_with(|c: char| c.is_ascii_digit()) {
                true => {
                    coefficient *= factor.parse::<i64>().unwrap_or_else(|_| panic!("`{factor}` in `{text}`"))
                }
                false => factors.push(factor.to_owned()),
            }
        }
        factors.sort();
        *terms.entry(factors).or_insert(0) += coefficient;
    }
    terms.retain(|_, coefficient| *coefficient != 0);
    terms
}

#[test]
fn order_does_not_matter() {
    assert_eq!(terms("-c4·c5·s6 - s4·c6"), terms("-c6*s4 - c5*s6*c4"));
    assert_eq!(terms("2·a - a"), terms("a"));
    assert_eq!(terms("0"), terms("b - b"));
    assert_ne!(terms("-c4·c6·s6 - s4·c6"), terms("-c4·c5·s6 - s4·c6"));
}
