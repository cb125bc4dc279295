//! What went wrong, where, and the remedy; all mistakes of one declaration at once.
//!
//! A place is an index that only the front end can turn back into a source location: the macro keeps one
//! `Span` for each token, the text front end one byte range. Nothing in this crate knows which of the two asked.

use std::fmt;

/// The index of one token in the front end's table of places.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct At(pub u32);

/// The tokens `first ..= last`: what a message underlines.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub struct Place {
    /// The first token.
    pub first: At,
    /// The last token, itself included.
    pub last: At,
}

impl Place {
    /// From the first token of `self` to the last of `end`.
    pub fn to(self, end: Place) -> Place {
        Place { first: self.first, last: end.last }
    }
}

impl From<At> for Place {
    fn from(at: At) -> Place {
        Place { first: at, last: at }
    }
}

/// A value together with the place where it was written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Where it was written.
    pub place: Place,
}

/// Whether a message stops the declaration.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Severity {
    /// No code is generated.
    Error,
    /// Code is generated; the author should look.
    Warning,
}

/// One mistake: the place, what is wrong there (with the value), and the remedy.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Diagnostic {
    /// Whether it stops the declaration.
    pub severity: Severity,
    /// What to underline.
    pub place: Place,
    /// What is wrong, naming the value; one sentence without a final full stop.
    pub message: String,
    /// The remedy, as an imperative sentence, where there is one.
    pub help: Option<String>,
}

/// All that is to be said about one declaration, in source order.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Report {
    diagnostics: Vec<Diagnostic>,
}

impl Report {
    /// An empty report.
    pub fn new() -> Report {
        Report::default()
    }

    /// Adds an error without a remedy.
    pub fn error(&mut self, place: impl Into<Place>, message: impl Into<String>) {
        self.push(Severity::Error, place.into(), message.into(), None);
    }

    /// Adds an error and its remedy.
    pub fn error_help(
        &mut self,
        place: impl Into<Place>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.push(Severity::Error, place.into(), message.into(), Some(help.into()));
    }

    /// Adds a warning and its remedy.
    pub fn warn(&mut self, place: impl Into<Place>, message: impl Into<String>, help: impl Into<String>) {
        self.push(Severity::Warning, place.into(), message.into(), Some(help.into()));
    }

    fn push(&mut self, severity: Severity, place: Place, message: String, help: Option<String>) {
        let diagnostic = Diagnostic { severity, place, message, help };
        // One mistake, one message: the same sentence at the same place is said once.
        if !self.diagnostics.contains(&diagnostic) {
            self.diagnostics.push(diagnostic);
        }
    }

    /// The diagnostics in the order of their places.
    pub fn diagnostics(&self) -> Vec<&Diagnostic> {
        let mut sorted: Vec<&Diagnostic> = self.diagnostics.iter().collect();
        sorted.sort_by_key(|d| (d.place.first, d.place.last));
        sorted
    }

    /// Whether anything in it stops the declaration.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }

    /// Whether there is nothing to say.
    pub fn is_empty(&self) -> bool {
        self.diagnostics.is_empty()
    }

    /// Takes over everything that `other` says.
    pub fn absorb(&mut self, other: Report) {
        for d in other.diagnostics {
            self.push(d.severity, d.place, d.message, d.help);
        }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        match &self.help {
            Some(help) => write!(f, "\n  help: {help}"),
            None => Ok(()),
        }
    }
}
