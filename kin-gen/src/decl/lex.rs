//! Text to tokens: the front end of `.dh` files. The macro front end makes the same tokens from rustc's.

use crate::report::{At, Report};
use std::ops::Range;

/// What a token is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// A name or keyword, in ASCII.
    Word,
    /// A number with its suffix, if any: `90`, `0.5`, `1e-3`, `47mm`.
    Number,
    /// One character of punctuation (or a whole string literal, which has no meaning outside attributes).
    Punct,
    /// `(`, `[` or `{`.
    Open,
    /// `)`, `]` or `}`.
    Close,
}

/// One token and its place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Token {
    /// What it is.
    pub kind: Kind,
    /// Its characters.
    pub text: String,
    /// Its index in the front end's table of places.
    pub at: At,
    /// Its line, counted from 1; 0 if unknown. Only messages about miscounted rows look at it.
    pub line: u32,
}

/// Splits text into tokens; `ranges[at]` is the byte range of the place `at`.
pub fn lex(text: &str) -> (Vec<Token>, Vec<Range<usize>>, Report) {
    let mut lexer =
        Lexer { text, pos: 0, line: 1, tokens: Vec::new(), ranges: Vec::new(), report: Report::new() };
    while let Some(c) = lexer.peek() {
        lexer.step(c);
    }
    (lexer.tokens, lexer.ranges, lexer.report)
}

struct Lexer<'a> {
    text: &'a str,
    pos: usize,
    line: u32,
    tokens: Vec<Token>,
    ranges: Vec<Range<usize>>,
    report: Report,
}

impl Lexer<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.pos..).unwrap_or("")
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn second(&self) -> Option<char> {
        self.rest().chars().nth(1)
    }

    fn bump(&mut self) {
        if let Some(c) = self.peek() {
            self.pos += c.len_utf8();
            self.line += u32::from(c == '\n');
        }
    }

    fn bump_while(&mut self, wanted: impl Fn(char) -> bool) {
        while self.peek().is_some_and(&wanted) {
            self.bump();
        }
    }

    fn place(&mut self, start: usize) -> At {
        self.ranges.push(start..self.pos);
        At(u32::try_from(self.ranges.len() - 1).unwrap_or(u32::MAX))
    }

    fn push(&mut self, kind: Kind, text: String, start: usize, line: u32) {
        let at = self.place(start);
        self.tokens.push(Token { kind, text, at, line });
    }

    fn step(&mut self, c: char) {
        let (start, line) = (self.pos, self.line);
        if c.is_whitespace() || c == '\u{feff}' {
            self.bump();
        } else if self.rest().starts_with("//") {
            self.bump_while(|c| c != '\n');
        } else if self.rest().starts_with("/*") {
            self.block_comment();
        } else if c.is_ascii_digit() {
            self.number();
            let text = self.text[start..self.pos].to_string();
            self.push(Kind::Number, text, start, line);
        } else if c == '_' || letters(c).is_some_and(|s| !s.starts_with(|c: char| c.is_ascii_digit())) {
            let mut word = String::new();
            while let Some(more) = self.peek().and_then(letters) {
                word.push_str(&more);
                self.bump();
            }
            self.push(Kind::Word, word, start, line);
        } else if c == '"' {
            self.string(start, line);
        } else {
            self.bump();
            self.punctuation(c, start, line);
        }
    }

    fn punctuation(&mut self, c: char, start: usize, line: u32) {
        let (kind, c) = match c {
            '(' | '[' | '{' => (Kind::Open, c),
            ')' | ']' | '}' => (Kind::Close, c),
            '°' => return self.push(Kind::Word, "deg".into(), start, line),
            '−' | '–' => (Kind::Punct, '-'),
            '×' | '·' | '⋅' | '∗' => (Kind::Punct, '*'),
            '÷' | '∕' => (Kind::Punct, '/'),
            '√' => return self.push(Kind::Word, "sqrt".into(), start, line),
            c if c.is_ascii_graphic() => (Kind::Punct, c),
            c => {
                let at = self.place(start);
                let help = "write names in ASCII or Greek letters, numbers in decimal";
                return self.report.error_help(
                    at,
                    format!("the character `{}` has no meaning here", c.escape_debug()),
                    help,
                );
            }
        };
        self.push(kind, c.to_string(), start, line);
    }

    /// Digits, a fraction, an exponent and a suffix; the two points of `170..190` are left alone.
    fn number(&mut self) {
        let digit = |c: char| c.is_ascii_digit() || c == '_';
        self.bump_while(digit);
        if self.peek() == Some('.')
            && !self.second().is_some_and(|c| c == '.' || letters(c).is_some_and(|_| !c.is_ascii_digit()))
        {
            self.bump();
            self.bump_while(digit);
        }
        if matches!(self.peek(), Some('e' | 'E')) {
            let mut after = self.rest().chars().skip(1);
            let sign_or_digit = after.next();
            let exponent = match sign_or_digit {
                Some('+' | '-') => after.next(),
                other => other,
            };
            if exponent.is_some_and(|c| c.is_ascii_digit()) {
                self.bump();
                self.bump();
                self.bump_while(digit);
            }
        }
        self.bump_while(|c| c.is_ascii_alphanumeric() || c == '_');
    }

    fn block_comment(&mut self) {
        let start = self.pos;
        let mut depth = 0usize;
        while self.pos < self.text.len() {
            if self.rest().starts_with("/*") {
                depth += 1;
                self.bump();
            } else if self.rest().starts_with("*/") {
                depth -= 1;
                self.bump();
            }
            self.bump();
            if depth == 0 {
                return;
            }
        }
        let at = self.place(start);
        self.report.error(at, "this comment is never closed with `*/`");
    }

    fn string(&mut self, start: usize, line: u32) {
        self.bump();
        while let Some(c) = self.peek() {
            self.bump();
            match c {
                '\\' => self.bump(),
                '"' => {
                    let text = self.text[start..self.pos].to_string();
                    return self.push(Kind::Punct, text, start, line);
                }
                _ => {}
            }
        }
        let at = self.place(start);
        self.report.error(at, "this string is never closed");
    }
}

/// The ASCII spelling of a character that may stand in a name; `None` if it may not.
fn letters(c: char) -> Option<String> {
    if c.is_ascii_alphanumeric() || c == '_' {
        return Some(c.to_string());
    }
    if let '₀'..='₉' = c {
        return char::from_digit(u32::from(c) - u32::from('₀'), 10).map(String::from);
    }
    let name = match c {
        'ᵢ' => "_i",
        'α' => "alpha",
        'β' => "beta",
        'γ' => "gamma",
        'δ' | 'Δ' => "delta",
        'ε' => "epsilon",
        'ζ' => "zeta",
        'η' => "eta",
        'θ' | 'ϑ' | 'Θ' => "theta",
        'κ' => "kappa",
        'λ' => "lambda",
        'μ' | 'µ' => "mu",
        'ν' => "nu",
        'ξ' => "xi",
        'π' => "pi",
        'ρ' => "rho",
        'σ' => "sigma",
        'τ' => "tau",
        'φ' | 'ϕ' => "phi",
        'χ' => "chi",
        'ψ' => "psi",
        'ω' => "omega",
        'ℓ' => "l",
        _ => return None,
    };
    Some(name.to_string())
}
