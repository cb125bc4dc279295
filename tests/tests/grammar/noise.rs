//! Tokens and text that nobody would write: each gets its messages, or a chain, and none a panic.

use kin_gen::decl::{Kind, Token, lex, render};
use kin_gen::report::{At, Report};

use crate::{chain_of, without_places};

/// xorshift64*: small, and the same everywhere.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % bound
    }
}

const WORDS: &str = "struct let param base tool couple check ik zyx within modified standard chain m mm deg rad q q2 a1 J1 \
                     J2 pi sqrt sin cos Rz Tx Ry Foo joint alpha a d theta limits pub A in";
const NUMBERS: &str =
    "0 1 2 90 0.5 1e-3 47mm 90deg 170. 1.5708 1e99 0x1f 1_0 99999999999999999999999999999999999999 1e";
const MARKS: &str = "| | | | ; ; ; = + - * / , . . : > # ! ^ ? \"text\"";

fn token(random: &mut Random, index: usize) -> Token {
    let pick = |random: &mut Random, list: &str| {
        let list: Vec<&str> = list.split_whitespace().collect();
        list[random.below(list.len())].to_string()
    };
    let (kind, text) = match random.below(10) {
        0..4 => (Kind::Word, pick(random, WORDS)),
        4..6 => (Kind::Number, pick(random, NUMBERS)),
        6 => (Kind::Open, pick(random, "( [ {")),
        7 => (Kind::Close, pick(random, ") ] }")),
        _ => (Kind::Punct, pick(random, MARKS)),
    };
    Token { kind, text, at: At(index as u32), line: random.below(4) as u32 }
}

/// Only that it returns, and that there is a chain exactly where there is no error.
fn survives(tokens: &[Token]) {
    let mut report = Report::new();
    let chain = chain_of(tokens, &mut report);
    assert_eq!(chain.is_some(), !report.has_errors(), "{tokens:?}");
    if let Some(chain) = chain {
        let (tokens, ranges, mut report) = lex(&chain.text);
        let again = chain_of(&tokens, &mut report);
        let said = render(&chain.text, &ranges, &report);
        assert_eq!(again.map(without_places), Some(without_places(chain)), "{said}");
    }
}

#[test]
fn no_soup_of_tokens_makes_it_panic() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let header = lex("struct A(modified, m, deg);").0;
    for round in 0..60_000 {
        let mut tokens = if round % 3 == 0 { Vec::new() } else { header.clone() };
        let length = random.below(60);
        tokens.extend((0..length).map(|i| token(&mut random, i)));
        survives(&tokens);
    }
}

#[test]
fn no_damage_to_a_declaration_makes_it_panic() {
    let text = "struct A(standard, m, deg); let a1 = 0.5; param p = 0.1;
        | joint | alpha | a      | d     | theta    | limits    |
        |-------|-------|--------|-------|----------|-----------|
        | J1    | 90    | -a1    | 2*a1  | q + 90   | -90 .. 90 |
        |       | 0     | p      | 0     | 0        |           |
        | J2    | pi/2  | 30cm   | a1/2  | -q       |           |
        base: Rx(180) Tz(0.5); couple: J2 -= J1; check [0, 0] => (0, 0, 0) zyx(0, 0, 0) within 100m; ik: x;";
    let whole = lex(text).0;
    survives(&whole);
    let mut random = Random(0x1234_5678_9ABC_DEF1);
    for _ in 0..40_000 {
        let mut tokens = whole.clone();
        for _ in 0..=random.below(4) {
            let at = random.below(tokens.len());
            match random.below(4) {
                0 => drop(tokens.remove(at)),
                1 => tokens.insert(at, token(&mut random, at)),
                2 => {
                    tokens[at] = Token { at: tokens[at].at, line: tokens[at].line, ..token(&mut random, at) }
                }
                _ => {
                    let other = random.below(tokens.len());
                    tokens.swap(at, other);
                }
            }
        }
        survives(&tokens);
    }
}

#[test]
fn no_text_makes_the_lexer_panic() {
    let mut random = Random(0xDEAD_BEEF_CAFE_F00D);
    let pieces = [
        "|", "\n", "θ₃", "π", "°", "−", "1", ".", "..", "e", "e-", "/*", "*/", "//", "\"", "\\", "é", "₁",
        "q", " ", "\u{0}", "(", "𝛼",
    ];
    for _ in 0..20_000 {
        let text: String = (0..random.below(30)).map(|_| pieces[random.below(pieces.len())]).collect();
        let (tokens, ranges, mut report) = lex(&text);
        chain_of(&tokens, &mut report);
        render(&text, &ranges, &report);
    }
}
