//! A bounded walk over the tokens of one statement, cell or pair of brackets.

use super::lex::{Kind, Token};
use crate::report::{Place, Report};

/// What is left of a run of tokens.
#[derive(Clone, Copy)]
pub(super) struct Cursor<'a> {
    tokens: &'a [Token],
    /// What to underline where the run has ended.
    end: Place,
}

impl<'a> Cursor<'a> {
    /// Over `tokens`; a message about something missing at their end goes to `end`.
    pub(super) fn new(tokens: &'a [Token], end: Place) -> Cursor<'a> {
        Cursor { tokens, end }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.tokens.is_empty()
    }

    pub(super) fn len(&self) -> usize {
        self.tokens.len()
    }

    pub(super) fn rest(&self) -> &'a [Token] {
        self.tokens
    }

    pub(super) fn peek(&self) -> Option<&'a Token> {
        self.tokens.first()
    }

    pub(super) fn next(&mut self) -> Option<&'a Token> {
        let (first, rest) = self.tokens.split_first()?;
        self.tokens = rest;
        Some(first)
    }

    /// The next token, or the end.
    pub(super) fn place(&self) -> Place {
        self.peek().map_or(self.end, |t| t.at.into())
    }

    /// Everything that is left, or the end.
    pub(super) fn all(&self) -> Place {
        self.tokens.last().map_or(self.end, |t| self.place().to(t.at.into()))
    }

    /// Whether the next token reads `text` (a word or one character of punctuation).
    pub(super) fn is(&self, text: &str) -> bool {
        self.peek().is_some_and(|t| t.is(text))
    }

    /// Whether the tokens start with these.
    pub(super) fn are(&self, texts: &[&str]) -> bool {
        self.tokens.len() >= texts.len() && self.tokens.iter().zip(texts).all(|(t, text)| t.is(text))
    }

    pub(super) fn eat(&mut self, text: &str) -> bool {
        let found = self.is(text);
        if found {
            self.next();
        }
        found
    }

    pub(super) fn word(&mut self) -> Option<&'a Token> {
        if self.peek()?.kind == Kind::Word { self.next() } else { None }
    }

    /// Splits off the tokens before the first that satisfies `stop`; that token stays.
    pub(super) fn until(&mut self, stop: impl FnMut(&Token) -> bool) -> Cursor<'a> {
        let at = self.tokens.iter().position(stop).unwrap_or(self.tokens.len());
        let (head, tail) = self.tokens.split_at(at);
        self.tokens = tail;
        let end = if head.is_empty() { self.place() } else { Place::from(head[head.len() - 1].at) };
        Cursor::new(head, end)
    }

    /// The inside of the brackets that open here, which are walked over; the place covers them too.
    pub(super) fn group(&mut self, open: &str, report: &mut Report) -> Option<(Cursor<'a>, Place)> {
        let opening = self.peek().filter(|t| t.kind == Kind::Open && t.text == open)?;
        let mut depth = 0usize;
        for (i, token) in self.tokens.iter().enumerate() {
            match token.kind {
                Kind::Open => depth += 1,
                Kind::Close => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                let inside = Cursor::new(&self.tokens[1..i], token.at.into());
                self.tokens = &self.tokens[i + 1..];
                return Some((inside, Place::from(opening.at).to(token.at.into())));
            }
        }
        report.error(opening.at, format!("this `{open}` is never closed"));
        self.tokens = &[];
        None
    }

    /// Splits at commas outside brackets; a trailing comma is allowed.
    pub(super) fn commas(self) -> Vec<Cursor<'a>> {
        let mut parts = Vec::new();
        let mut rest = self;
        while !rest.is_empty() {
            let mut depth = 0usize;
            parts.push(rest.until(|t| {
                match t.kind {
                    Kind::Open => depth += 1,
                    Kind::Close => depth = depth.saturating_sub(1),
                    _ => {}
                }
                depth == 0 && t.is(",")
            }));
            rest.next();
        }
        parts
    }
}

impl Token {
    /// Whether it reads `text` and is not a number.
    pub(super) fn is(&self, text: &str) -> bool {
        self.kind != Kind::Number && self.text == text
    }
}
