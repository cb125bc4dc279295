//! The item shell, the only part of the declaration that is ordinary Rust: attributes, visibility, name.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::parse::{ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::{Attribute, Path, Token, Visibility};

/// What every arm derives, whether or not its author says so.
const DERIVES: [&str; 4] = ["Clone", "Copy", "Debug", "PartialEq"];

/// Stands in the generated text for a path that text cannot hold: `$crate` means what it means only as a token.
const STAND_IN: &str = "__dh_crate";

/// A field of the struct: one `param`.
pub(crate) struct Field {
    /// Its name, where the declaration has it.
    pub(crate) name: Ident,
    /// Its documentation.
    pub(crate) doc: String,
}

/// Everything before the header, with the author's own tokens.
pub(crate) struct Shell {
    /// What is wrong with `#[dh(…)]`; the rest of the declaration is read all the same.
    pub(crate) mistakes: Vec<syn::Error>,
    attributes: Vec<Attribute>,
    derives: Vec<Path>,
    visibility: Visibility,
    /// The name of the struct.
    pub(crate) name: Ident,
    krate: Option<Path>,
}

impl Shell {
    /// Reads up to the name; `None` where there is no `struct Name`, of which the grammar speaks.
    pub(crate) fn read(stream: TokenStream) -> syn::Result<Option<Shell>> {
        let mut trees = visible(stream).into_iter();
        let is_struct = |tree: &TokenTree| matches!(tree, TokenTree::Ident(word) if word == "struct");
        let head = trees.by_ref().take_while(|tree| !is_struct(tree)).collect();
        let Some(TokenTree::Ident(name)) = trees.next() else { return Ok(None) };
        let parts = |input: ParseStream| {
            let parts = (input.call(Attribute::parse_outer)?, input.parse()?);
            // Whatever else stands before `struct` is the grammar's to refuse.
            input.parse::<TokenStream>()?;
            Ok(parts)
        };
        let (attributes, visibility) = parts.parse2(head)?;
        let derives = DERIVES.map(|name| Ident::new(name, Span::call_site()).into()).into();
        let mut shell =
            Shell { mistakes: Vec::new(), attributes: Vec::new(), derives, visibility, name, krate: None };
        for attribute in attributes {
            shell.attribute(attribute);
        }
        Ok(Some(shell))
    }

    /// Takes `#[dh(…)]` for itself, gathers the derives, keeps the rest.
    fn attribute(&mut self, attribute: Attribute) {
        if attribute.path().is_ident("dh") {
            if let Err(mistake) = self.option(&attribute) {
                self.mistakes.push(mistake);
            }
        } else if let Some(paths) = derived(&attribute) {
            for path in paths {
                let name = path.segments.last().map(|last| last.ident.to_string()).unwrap_or_default();
                // `Default` is the nominal arm, and generated.
                if name != "Default" && !DERIVES.contains(&name.as_str()) {
                    self.derives.push(path);
                }
            }
        } else {
            self.attributes.push(attribute);
        }
    }

    /// `#[dh(crate = path)]`: where the runtime is, for a user who has it under another name.
    fn option(&mut self, attribute: &Attribute) -> syn::Result<()> {
        attribute.parse_nested_meta(|meta| {
            if !meta.path.is_ident("crate") {
                return Err(meta.error("`dh` has one option: `crate = path::to::kin_runtime`"));
            }
            self.krate = Some(meta.value()?.call(Path::parse_mod_style)?);
            Ok(())
        })
    }

    /// The path of the runtime.
    pub(crate) fn krate(&self) -> TokenStream {
        self.krate.as_ref().map_or_else(|| quote!(::kin_runtime), Path::to_token_stream)
    }

    /// How generated text names the runtime.
    pub(crate) fn krate_text(&self) -> String {
        match &self.krate {
            Some(path) if is_macro_crate(path) => STAND_IN.to_owned(),
            _ => self.krate().to_string().replace(' ', ""),
        }
    }

    /// The generated text as tokens; the stand-in, if it was given out, gives way to the path.
    pub(crate) fn items(&self, text: &str) -> syn::Result<TokenStream> {
        let items: TokenStream = text.parse().map_err(|error| {
            syn::Error::new(
                self.name.span(),
                format!("internal error of `dh!`: its output is not Rust: {error}"),
            )
        })?;
        Ok(match &self.krate {
            Some(path) if is_macro_crate(path) => replace(items, &path.to_token_stream()),
            _ => items,
        })
    }

    /// The struct item itself: a unit struct, or one field for each `param`.
    pub(crate) fn item(&self, fields: &[Field]) -> TokenStream {
        let Shell { attributes, visibility, name, derives, .. } = self;
        let fields = fields.iter().map(|Field { name, doc }| quote!(#[doc = #doc] pub #name: f64));
        let body = if fields.len() == 0 { quote!(;) } else { quote!({ #(#fields),* }) };
        // Two lints judge the struct by what its author cannot change: the macro chose the derives and the fields.
        quote! {
            #[derive(#(#derives),*)]
            #[allow(clippy::derive_partial_eq_without_eq, clippy::exhaustive_structs)]
            #(#attributes)* #visibility struct #name #body
        }
    }
}

/// The traits of a `derive`; `None` if it is another attribute, or one that rustc will refuse in its own words.
fn derived(attribute: &Attribute) -> Option<Punctuated<Path, Token![,]>> {
    let derive = attribute.path().is_ident("derive");
    derive.then(|| attribute.parse_args_with(Punctuated::parse_terminated).ok()).flatten()
}

/// Whether the path begins with the `$crate` of a `macro_rules` definition.
fn is_macro_crate(path: &Path) -> bool {
    path.segments.first().is_some_and(|first| first.ident == "$crate")
}

/// The top level with the invisible groups of `macro_rules` (`$vis`, `$name`) opened.
fn visible(stream: TokenStream) -> Vec<TokenTree> {
    let mut open = vec![stream.into_iter()];
    let mut trees = Vec::new();
    while let Some(level) = open.last_mut() {
        match level.next() {
            Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::None => {
                open.push(group.stream().into_iter())
            }
            Some(tree) => trees.push(tree),
            None => drop(open.pop()),
        }
    }
    trees
}

/// `items` with every stand-in replaced by `path`; as deep as our own output is nested.
fn replace(items: TokenStream, path: &TokenStream) -> TokenStream {
    items
        .into_iter()
        .flat_map(|tree| match tree {
            TokenTree::Ident(word) if word == STAND_IN => path.clone(),
            TokenTree::Group(group) => {
                TokenTree::Group(Group::new(group.delimiter(), replace(group.stream(), path))).into()
            }
            other => other.into(),
        })
        .collect()
}
