//! The value of a string of the reference data: `"-100*pi/180"`, `"26.45*0.0254"`, `"0.086+0.040"`.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = factor { ("*" | "/") factor }
//! factor  = { "-" } ( number | "pi" | ("sin" | "cos") "(" sum ")" | "(" sum ")" )
//! ```

use std::f64::consts::PI;

/// The value in f64.
///
/// # Panics
///
/// On anything outside the grammar: the data is part of the tests.
pub fn value(text: &str) -> f64 {
    let mut reader = Reader { text, rest: text };
    let value = reader.sum();
    assert!(reader.rest.trim().is_empty(), "`{}` is left of `{text}`", reader.rest);
    value
}

struct Reader<'a> {
    text: &'a str,
    rest: &'a str,
}

impl Reader<'_> {
    fn eat(&mut self, word: &str) -> bool {
        let rest = self.rest.trim_start();
        let found = rest.strip_prefix(word);
        self.rest = found.unwrap_or(rest);
        found.is_some()
    }

    fn sum(&mut self) -> f64 {
        let mut total = self.product();
        loop {
            if self.eat("+") {
                total += self.product();
            } else if self.eat("-") {
                total -= self.product();
            } else {
                return total;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut total = self.factor();
        loop {
            if self.eat("*") {
                total *= self.factor();
            } else if self.eat("/") {
                total /= self.factor();
            } else {
                return total;
            }
        }
    }

    fn factor(&mut self) -> f64 {
        if self.eat("-") {
            -self.factor()
        } else if self.eat("pi") {
            PI
        } else if self.eat("sin") {
            self.factor().sin()
        } else if self.eat("cos") {
            self.factor().cos()
        } else if self.eat("(") {
            let inner = self.sum();
            assert!(self.eat(")"), "a parenthesis of `{}` stays open", self.text);
            inner
        } else {
            self.number()
        }
    }

    fn number(&mut self) -> f64 {
        let rest = self.rest.trim_start();
        let bytes = rest.as_bytes();
        let exponent =
            |i: usize| i > 0 && matches!(bytes[i - 1], b'e' | b'E') && matches!(bytes[i], b'+' | b'-');
        let part =
            |i: usize| bytes[i].is_ascii_digit() || matches!(bytes[i], b'.' | b'e' | b'E') || exponent(i);
        let end = (0..bytes.len()).find(|&i| !part(i)).unwrap_or(bytes.len());
        self.rest = &rest[end..];
        rest[..end].parse().unwrap_or_else(|_| panic!("`{rest}` in `{}` is no number", self.text))
    }
}

#[test]
fn strings_of_the_data() {
    assert_eq!(value("-100*pi/180"), -100.0 * PI / 180.0);
    assert_eq!(value("26.45*0.0254"), 26.45 * 0.0254);
    assert_eq!(value("0.086+0.040"), 0.086 + 0.040);
    assert_eq!(value("-pi/2"), -PI / 2.0);
    assert_eq!(value("1.5e-3 - (2 - 3) * sin(pi/2)"), 1.0015);
}
