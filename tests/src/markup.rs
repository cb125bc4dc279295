//! Pages read back, and the mathematics on them computed, as their reader would.
//!
//! Nothing here knows how it was printed: a tree of elements. Of mathematics, juxtaposition is multiplication, an index belongs to its
//! letter, and an equation defines its left side for the ones below it.

use std::collections::BTreeMap;

/// An element with its children, or a text.
#[derive(Clone, PartialEq, Debug)]
pub enum Node {
    /// An element: its name, its attributes as they stand, what is in it.
    Element(String, String, Vec<Node>),
    /// A text, entities resolved.
    Text(String),
}

impl Node {
    /// All text in it.
    pub fn text(&self) -> String {
        match self {
            Node::Text(text) => text.trim().to_owned(),
            Node::Element(.., children) => children.iter().map(Node::text).collect(),
        }
    }

    /// The elements of that name in it, outermost first, those inside one of them left out.
    pub fn all<'a>(&'a self, name: &str, found: &mut Vec<&'a Node>) {
        if let Node::Element(own, _, children) = self {
            if own == name {
                found.push(self);
            } else {
                children.iter().for_each(|child| child.all(name, found));
            }
        }
    }

    /// What is in it.
    pub fn children(&self) -> &[Node] {
        match self {
            Node::Element(.., children) => children,
            Node::Text(_) => &[],
        }
    }

    /// The value of an attribute.
    pub fn attribute(&self, name: &str) -> Option<&str> {
        let Node::Element(_, attributes, _) = self else { return None };
        let (_, rest) = attributes.split_once(&format!(" {name}=\""))?;
        rest.split('"').next()
    }
}

/// Reads well-formed markup.
///
/// # Panics
///
/// Where it is not well formed.
pub fn read(markup: &str) -> Node {
    let mut stack = vec![("document".to_owned(), String::new(), Vec::new())];
    let mut rest = markup;
    while let Some(start) = rest.find('<') {
        let (text, tail) = rest.split_at(start);
        push_text(&mut stack, text);
        if let Some(comment) = tail.strip_prefix("<!--") {
            rest = comment.split_once("-->").expect("a comment ends").1;
            continue;
        }
        let (tag, after) = tail[1..].split_once('>').expect("a tag ends");
        rest = after;
        if let Some(name) = tag.strip_prefix('/') {
            let (open, attributes, children) = stack.pop().expect("an open element");
            assert_eq!(open, name, "elements are nested");
            stack.last_mut().expect("a parent").2.push(Node::Element(open, attributes, children));
        } else if !tag.starts_with('!') {
            let name = tag.split_whitespace().next().unwrap_or_default().trim_end_matches('/');
            let element = (name.to_owned(), tag[name.len()..].to_owned(), Vec::new());
            if tag.ends_with('/') || VOID.contains(&name) {
                let (name, attributes, children) = element;
                stack.last_mut().expect("a parent").2.push(Node::Element(name, attributes, children));
            } else {
                stack.push(element);
            }
        }
    }
    push_text(&mut stack, rest);
    assert_eq!(stack.len(), 1, "every element is closed");
    let (name, attributes, children) = stack.remove(0);
    Node::Element(name, attributes, children)
}

/// Elements of HTML that have no end.
const VOID: [&str; 4] = ["meta", "br", "link", "hr"];

/// An open element: its name, its attributes, what is in it so far.
type Open = (String, String, Vec<Node>);

fn push_text(stack: &mut [Open], text: &str) {
    if !text.is_empty() {
        let text = text.replace("&#x2062;", "\u{2062}").replace("&#x2061;", "\u{2061}");
        let text =
            text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&");
        stack.last_mut().expect("a parent").2.push(Node::Text(text));
    }
}

/// The values that are known, and what to ask for one that is not.
pub struct Values<'a> {
    /// Known by name, indices appended to letters: `c23`.
    pub known: BTreeMap<String, f64>,
    /// The value of any other name.
    pub other: &'a dyn Fn(&str) -> Option<f64>,
}

impl Values<'_> {
    /// The value of a row of mathematics.
    ///
    /// # Panics
    ///
    /// On what is no sum of products.
    pub fn value(&self, node: &Node) -> f64 {
        let mut tokens = Vec::new();
        flatten(node, &mut tokens);
        let mut reader = Reader { values: self, tokens: &tokens };
        let value = reader.sum();
        assert!(reader.tokens.is_empty(), "left over: {:?}", reader.tokens);
        value
    }

    /// Carries the equations of a table out, and gives all left sides.
    pub fn equations(&mut self, table: &Node) -> BTreeMap<String, f64> {
        let mut rows = Vec::new();
        table.all("mtr", &mut rows);
        let mut defined = BTreeMap::new();
        for row in rows {
            let [left, right] = row.children() else { panic!("an equation has two sides: {row:?}") };
            let mut tokens = Vec::new();
            flatten(right, &mut tokens);
            assert_eq!(tokens.remove(0), Token::Operator("=".to_owned()));
            let mut reader = Reader { values: self, tokens: &tokens };
            let value = reader.sum();
            assert!(reader.tokens.is_empty(), "left over: {:?}", reader.tokens);
            self.known.insert(left.text(), value);
            defined.insert(left.text(), value);
        }
        defined
    }

    fn named(&self, name: &str) -> f64 {
        let known = self.known.get(name).copied();
        known.or_else(|| (self.other)(name)).unwrap_or_else(|| panic!("{name} has no value"))
    }
}

#[derive(Clone, PartialEq, Debug)]
enum Token {
    Name(String),
    Number(f64),
    Operator(String),
    Power(Vec<Token>, u32),
}

fn flatten(node: &Node, tokens: &mut Vec<Token>) {
    let Node::Element(name, _, children) = node else { return };
    match name.as_str() {
        "mi" | "msub" => tokens.push(Token::Name(node.text())),
        "mn" => tokens.push(Token::Number(node.text().parse().expect("a number"))),
        "mo" => tokens.push(Token::Operator(node.text())),
        "msup" => {
            let [base, exponent] = children.as_slice() else { panic!("a base and an exponent: {node:?}") };
            let mut inner = Vec::new();
            flatten(base, &mut inner);
            tokens.push(Token::Power(inner, exponent.text().parse().expect("an exponent")));
        }
        _ => children.iter().for_each(|child| flatten(child, tokens)),
    }
}

struct Reader<'a, 'b> {
    values: &'a Values<'a>,
    tokens: &'b [Token],
}

impl Reader<'_, '_> {
    fn eat(&mut self, operator: &str) -> bool {
        let found = matches!(self.tokens.first(), Some(Token::Operator(own)) if own == operator);
        if found {
            self.tokens = &self.tokens[1..];
        }
        found
    }

    fn sum(&mut self) -> f64 {
        let mut total = if self.eat("−") { -self.product() } else { self.product() };
        loop {
            if self.eat("+") {
                total += self.product();
            } else if self.eat("−") {
                total -= self.product();
            } else {
                return total;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut total = self.factor();
        while self.eat("\u{2062}") {
            total *= self.factor();
        }
        total
    }

    fn factor(&mut self) -> f64 {
        if self.eat("(") {
            let inner = self.sum();
            assert!(self.eat(")"), "a parenthesis stays open");
            return inner;
        }
        let (first, rest) = self.tokens.split_first().expect("a factor");
        self.tokens = rest;
        match first {
            Token::Number(value) => *value,
            Token::Name(name) if self.eat("\u{2061}") => match name.as_str() {
                "cos" => self.factor().cos(),
                "sin" => self.factor().sin(),
                other => panic!("no function {other}"),
            },
            Token::Name(name) => self.values.named(name),
            Token::Power(base, exponent) => {
                let mut reader = Reader { values: self.values, tokens: base };
                reader.sum().powi(i32::try_from(*exponent).expect("a small exponent"))
            }
            Token::Operator(operator) => panic!("no factor: {operator}"),
        }
    }
}

#[test]
fn sums_products_indices_and_functions() {
    let markup = "<math><mrow><mo>−</mo><msub><mi>c</mi><mn>2</mn></msub><mo>&#x2062;</mo><mrow><mo>(</mo><mn>3</mn>\
                  <mo>−</mo><mi>x</mi><mo>)</mo></mrow><mo>+</mo><mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mn>0</mn>\
                  <mo>)</mo></mrow><mo>+</mo><msup><mrow><mi>x</mi></mrow><mn>3</mn></msup></mrow></math>";
    let known = BTreeMap::from([("c2".to_owned(), 0.5), ("x".to_owned(), 2.0)]);
    assert_eq!(Values { known, other: &|_| None }.value(&read(markup)), -0.5 + 1.0 + 8.0);
}
