//! From the compiler's tokens to the grammar's.
//!
//! After [`Tokens::read`]: groups are an opening and a closing token, the invisible groups of `macro_rules` are gone
//! (`2 * $x` means what it says: where `$x` is a sum, it is now in parentheses), nothing is nested deeper than
//! [`DEEPEST`], and the token numbered `i` came from span `i`.

use kin_gen::decl::{Kind, MAX_NESTING, Token};
use kin_gen::report::{At, Place};
use proc_macro2::{Delimiter, Group, Ident, Literal, Span, TokenStream, TokenTree, token_stream};

/// Brackets nested deeper than this are refused here, before syn, which recurses, can see them. The grammar's own
/// bound is lower and its message better: only hostile input comes here.
const DEEPEST: usize = 4 * MAX_NESTING;

/// The tokens of one `dh!`, and where each of them was written.
#[derive(Debug, Default)]
pub(crate) struct Tokens {
    /// What the grammar reads.
    pub(crate) list: Vec<Token>,
    /// The table of places: `list[i].at` is `i`, and `spans[i]` is where that token stands.
    spans: Vec<Span>,
}

impl Tokens {
    /// Flattens `stream`, without recursion: what a user pastes must not overflow the compiler's stack.
    pub(crate) fn read(stream: TokenStream) -> syn::Result<Tokens> {
        let mut tokens = Tokens::default();
        let mut open = vec![Level { trees: stream.into_iter(), close: None }];
        let mut depth = 0;
        while let Some(level) = open.last_mut() {
            match level.trees.next() {
                Some(TokenTree::Group(group)) => {
                    let close = tokens.open(&group);
                    depth += usize::from(close.is_some());
                    if depth > DEEPEST {
                        let message = format!("brackets are nested more than {DEEPEST} deep");
                        return Err(syn::Error::new(group.span_open(), message));
                    }
                    open.push(Level { trees: group.stream().into_iter(), close });
                }
                Some(TokenTree::Ident(word)) => tokens.push(Kind::Word, word.to_string(), word.span()),
                Some(TokenTree::Punct(mark)) => {
                    tokens.push(Kind::Punct, mark.as_char().to_string(), mark.span())
                }
                Some(TokenTree::Literal(literal)) => tokens.literal(&literal),
                None => {
                    if let Some((text, span)) = level.close {
                        tokens.push(Kind::Close, text.to_owned(), span);
                        depth -= 1;
                    }
                    open.pop();
                }
            }
        }
        Ok(tokens)
    }

    /// The spans of the first and the last token of a place; of the whole invocation if there is no such token.
    pub(crate) fn ends(&self, place: Place) -> (Span, Span) {
        let first = self.span(place.first).unwrap_or_else(Span::call_site);
        (first, self.span(place.last).unwrap_or(first))
    }

    /// The parameter `name` as it stands in its declaration, so that its field is found from there.
    pub(crate) fn param(&self, name: &str) -> Ident {
        let declared = self.list.windows(2).find(|pair| pair[0].text == "param" && pair[1].text == name);
        let span = declared.and_then(|pair| self.span(pair[1].at)).unwrap_or_else(Span::call_site);
        match name.strip_prefix("r#") {
            Some(raw) => Ident::new_raw(raw, span),
            None => Ident::new(name, span),
        }
    }

    fn span(&self, at: At) -> Option<Span> {
        self.spans.get(usize::try_from(at.0).ok()?).copied()
    }

    /// Pushes the opening bracket and returns the closing one; an invisible group has them only if it needs them.
    fn open(&mut self, group: &Group) -> Option<(&'static str, Span)> {
        let (open, close) = match group.delimiter() {
            Delimiter::Parenthesis => ("(", ")"),
            Delimiter::Bracket => ("[", "]"),
            Delimiter::Brace => ("{", "}"),
            Delimiter::None if is_sum_or_product(group) => ("(", ")"),
            Delimiter::None => return None,
        };
        self.push(Kind::Open, open.to_owned(), group.span_open());
        Some((close, group.span_close()))
    }

    /// A number has a sign of its own only where another macro made it. Texts and characters mean nothing to the
    /// grammar outside attributes; it will name them in its message.
    fn literal(&mut self, literal: &Literal) {
        let (text, span) = (literal.to_string(), literal.span());
        let magnitude = text.strip_prefix('-').unwrap_or(&text);
        if magnitude.len() < text.len() {
            self.push(Kind::Punct, "-".to_owned(), span);
        }
        let kind =
            if magnitude.starts_with(|c: char| c.is_ascii_digit()) { Kind::Number } else { Kind::Punct };
        self.push(kind, magnitude.to_owned(), span);
    }

    fn push(&mut self, kind: Kind, text: String, span: Span) {
        // Four thousand million tokens do not fit in a compiler; should they, the last place stands for the rest.
        let at = At(u32::try_from(self.list.len()).unwrap_or(u32::MAX));
        self.list.push(Token { kind, text, at, line: line(span) });
        self.spans.push(span);
    }
}

/// A stream that is being read, and what to push at its end.
struct Level {
    trees: token_stream::IntoIter,
    close: Option<(&'static str, Span)>,
}

/// Whether unwrapping would tear the group apart: it has an operator, and is not a range.
fn is_sum_or_product(group: &Group) -> bool {
    let marks = || {
        group.stream().into_iter().filter_map(|tree| match tree {
            TokenTree::Punct(mark) => Some(mark.as_char()),
            _ => None,
        })
    };
    marks().any(|mark| "+-*/".contains(mark)) && !marks().any(|mark| mark == '.')
}

/// The line a token stands on, 0 if there is no compiler to ask. rustc's own spans know it on stable; proc-macro2's
/// `span-locations` feature would be switched on in every build script and macro of the user's workspace.
fn line(span: Span) -> u32 {
    if !proc_macro::is_available() {
        return 0;
    }
    u32::try_from(span.unwrap().line()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proc_macro2::Punct;

    fn texts(stream: TokenStream) -> Vec<String> {
        Tokens::read(stream).unwrap().list.into_iter().map(|token| token.text).collect()
    }

    #[test]
    fn groups_become_brackets_and_places_count_up() {
        let tokens = Tokens::read("check [0, 90deg] => (1.5, q3);".parse().unwrap()).unwrap();
        let read: Vec<_> = tokens.list.iter().map(|token| (token.kind, token.text.as_str())).collect();
        assert_eq!(
            read,
            [
                (Kind::Word, "check"),
                (Kind::Open, "["),
                (Kind::Number, "0"),
                (Kind::Punct, ","),
                (Kind::Number, "90deg"),
                (Kind::Close, "]"),
                (Kind::Punct, "="),
                (Kind::Punct, ">"),
                (Kind::Open, "("),
                (Kind::Number, "1.5"),
                (Kind::Punct, ","),
                (Kind::Word, "q3"),
                (Kind::Close, ")"),
                (Kind::Punct, ";"),
            ]
        );
        assert!(tokens.list.iter().enumerate().all(|(index, token)| token.at.0 as usize == index));
        assert_eq!(tokens.list.len(), tokens.spans.len());
    }

    #[test]
    fn invisible_groups_vanish_at_any_depth() {
        let mut stream: TokenStream = "1.5 + x".parse().unwrap();
        for _ in 0..10 * DEEPEST {
            stream = TokenTree::Group(Group::new(Delimiter::None, stream)).into();
        }
        assert_eq!(texts(stream), ["(", "1.5", "+", "x", ")"]);
    }

    #[test]
    fn invisible_groups_keep_sums_together_and_nothing_else() {
        let wrapped = |text: &str| {
            let group = TokenTree::Group(Group::new(Delimiter::None, text.parse().unwrap()));
            texts(["2 *".parse::<TokenStream>().unwrap(), group.into()].into_iter().collect()).join(" ")
        };
        assert_eq!(wrapped("1 + x"), "2 * ( 1 + x )");
        assert_eq!(wrapped("-5"), "2 * ( - 5 )");
        assert_eq!(wrapped("x"), "2 * x");
        assert_eq!(wrapped("-170 .. 170"), "2 * - 170 . . 170");
        assert_eq!(wrapped("pub(crate)"), "2 * pub ( crate )");
    }

    #[test]
    fn ranges_boundaries_and_signs_are_single_marks() {
        assert_eq!(
            texts("| -170 .. 170 || 190".parse().unwrap()),
            "| - 170 . . 170 | | 190".split(' ').collect::<Vec<_>>()
        );
        let negative = TokenTree::Literal(Literal::f64_unsuffixed(-2.5));
        assert_eq!(texts(negative.into()), ["-", "2.5"]);
        let glued = TokenTree::Punct(Punct::new('=', proc_macro2::Spacing::Joint));
        assert_eq!(texts(glued.into()), ["="]);
    }

    #[test]
    fn texts_and_characters_are_single_tokens() {
        let tokens = Tokens::read(r#"#[doc = "5 axes"] 'c'"#.parse().unwrap()).unwrap();
        assert_eq!(tokens.list[4].text, r#""5 axes""#);
        assert!(tokens.list.iter().all(|token| token.kind != Kind::Number));
    }

    #[test]
    fn deep_brackets_are_refused() {
        let nested = |depth: usize| {
            let text = "(".repeat(depth) + &")".repeat(depth);
            Tokens::read(text.parse().unwrap())
        };
        assert_eq!(nested(DEEPEST).unwrap().list.len(), 2 * DEEPEST);
        assert_eq!(nested(DEEPEST + 1).unwrap_err().to_string(), "brackets are nested more than 256 deep");
    }
}
