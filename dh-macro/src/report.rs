//! A report as the compiler shows it: each message under its own tokens.

use kin_gen::report::{Diagnostic, Report, Severity};
use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

use crate::tokens::Tokens;

/// Everything the report says, as items that make rustc say it.
pub(crate) fn render(report: &Report, tokens: &Tokens) -> TokenStream {
    report
        .diagnostics()
        .into_iter()
        .map(|diagnostic| {
            let (first, last) = tokens.ends(diagnostic.place);
            match diagnostic.severity {
                Severity::Error => error(&text(diagnostic), first, last),
                Severity::Warning => warning(&text(diagnostic), first),
            }
        })
        .collect()
}

fn text(diagnostic: &Diagnostic) -> String {
    match &diagnostic.help {
        Some(help) => format!("{}\nhelp: {help}", diagnostic.message),
        None => diagnostic.message.clone(),
    }
}

/// rustc underlines a macro call from the first token of its path to its closing bracket, so a path spanned at the
/// first token and a bracket spanned at the last underline the whole place.
fn error(message: &str, first: Span, last: Span) -> TokenStream {
    let path = quote_spanned!(first=> ::core::compile_error!);
    let brace = quote_spanned!(last=> { #message });
    quote_spanned!(first=> #path #brace)
}

/// A stable macro cannot warn; the use of a deprecated constant does, at the span of the use.
fn warning(message: &str, at: Span) -> TokenStream {
    quote_spanned! {at=>
        const _: () = {
            #[deprecated(note = #message)]
            #[allow(non_upper_case_globals)]
            const dh_warning: () = ();
            dh_warning
        };
    }
}
