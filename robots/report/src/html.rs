//! Pages: one file each, with everything in it, for screens of any width, light and dark, and for paper.

use std::fmt::Write;

use crate::svg::{self, Svg, escaped};

/// The sheet of the pages; that of the drawings comes with it.
const STYLE: &str = include_str!("page.css");

/// A page being written.
#[derive(Clone, Debug)]
pub struct Page {
    title: String,
    lead: String,
    contents: Vec<(String, String)>,
    body: String,
    drawings: Vec<(String, Svg)>,
}

/// A table: its head and its rows, cells being markup.
#[derive(Clone, Debug, Default)]
pub struct Table {
    head: Vec<String>,
    rows: Vec<(String, Vec<String>)>,
    class: &'static str,
}

impl Table {
    /// A table with these column heads, as markup.
    pub fn new(head: &[&str]) -> Table {
        Table { head: head.iter().map(|h| (*h).to_owned()).collect(), ..Table::default() }
    }

    /// Smaller letters: for many columns of many digits.
    #[must_use]
    pub fn dense(self) -> Table {
        Table { class: "dense", ..self }
    }

    /// Each row becomes a block of its own where the screen is narrow: for cells with sentences.
    #[must_use]
    pub fn stacked(self) -> Table {
        Table { class: "stacked", ..self }
    }

    /// A row; `key` names it to programs that read the page.
    pub fn row(&mut self, key: &str, cells: Vec<String>) {
        self.rows.push((key.to_owned(), cells));
    }

    fn print(&self) -> String {
        let numeric = |column: usize| {
            let mut cells =
                self.rows.iter().filter_map(|(_, cells)| cells.get(column)).filter(|c| !c.is_empty());
            cells.clone().next().is_some() && cells.all(|cell| is_number(cell))
        };
        let mut text = format!("<div class=\"wide\"><table class=\"{}\"><thead><tr>", self.class);
        for (column, head) in self.head.iter().enumerate() {
            let class = if numeric(column) { " class=\"num\"" } else { "" };
            text.push_str(&format!("<th{class}>{head}</th>"));
        }
        text.push_str("</tr></thead><tbody>\n");
        for (key, cells) in &self.rows {
            let key = if key.is_empty() { String::new() } else { format!(" data-key=\"{}\"", escaped(key)) };
            text.push_str(&format!("<tr{key}>"));
            for (cell, head) in cells.iter().zip(&self.head) {
                let class = if is_number(cell) { " class=\"num\"" } else { "" };
                let label =
                    if self.class == "stacked" { format!(" data-head=\"{head}\"") } else { String::new() };
                text.push_str(&format!("<td{class}{label}>{cell}</td>"));
            }
            text.push_str("</tr>\n");
        }
        text + "</tbody></table></div>\n"
    }
}

/// Whether a cell is one number and nothing else.
fn is_number(cell: &str) -> bool {
    cell.starts_with("<span class=\"n\">") && cell.ends_with("</span>") && cell.matches("<span").count() == 1
}

impl Page {
    /// An empty page; `lead` is markup.
    pub fn new(title: &str, lead: &str) -> Page {
        Page {
            title: title.to_owned(),
            lead: lead.to_owned(),
            contents: Vec::new(),
            body: String::new(),
            drawings: Vec::new(),
        }
    }

    /// Every drawing, with a name that is its own on this page.
    pub fn drawings(&self) -> &[(String, Svg)] {
        &self.drawings
    }

    /// Begins a section.
    pub fn section(&mut self, id: &str, title: &str) {
        self.contents.push((id.to_owned(), title.to_owned()));
        self.push(&format!("<h2 id=\"{id}\">{}</h2>", escaped(title)));
    }

    /// Begins a part of a section.
    pub fn part(&mut self, title: &str) {
        self.push(&format!("<h3>{title}</h3>"));
    }

    /// A paragraph of markup.
    pub fn text(&mut self, markup: &str) {
        self.push(&format!("<p>{markup}</p>"));
    }

    /// A sentence that warns, as text.
    pub fn warning(&mut self, text: &str) {
        self.push(&format!("<p class=\"warning\">{}</p>", escaped(text)));
    }

    /// Text as it stands, in a fixed pitch.
    pub fn code(&mut self, text: &str) {
        self.push(&format!("<pre>{}</pre>", escaped(text)));
    }

    /// A displayed formula, which scrolls where it is wider than the screen; `key` names it to programs.
    pub fn formula(&mut self, key: &str, mathml: &str) {
        let key = if key.is_empty() { String::new() } else { format!(" data-key=\"{}\"", escaped(key)) };
        self.push(&format!("<div class=\"wide formula\"{key}>{mathml}</div>"));
    }

    /// Several formulas, side by side as far as there is room; each with its name to programs.
    pub fn formulas(&mut self, all: &[(String, String)]) {
        self.push("<div class=\"row\">");
        for (key, mathml) in all {
            self.formula(key, mathml);
        }
        self.push("</div>");
    }

    /// A table.
    pub fn table(&mut self, table: &Table) {
        let text = table.print();
        self.push(&text);
    }

    /// Drawings side by side as far as there is room, each with words of its own, and a caption. Both are markup.
    pub fn figure(&mut self, id: &str, drawings: &[(Svg, String)], caption: &str) {
        let _ = write!(self.body, "<figure id=\"{id}\"><div class=\"plates\">");
        for (count, (drawing, words)) in drawings.iter().enumerate() {
            let own = if drawings.len() == 1 { id.to_owned() } else { format!("{id}-{}", count + 1) };
            self.drawings.push((own, drawing.clone()));
            let width = drawing.width();
            let _ = write!(self.body, "<div class=\"plate\" style=\"width:{width}px\">{}", drawing.inline());
            if !words.is_empty() {
                let _ = write!(self.body, "<p class=\"words\">{words}</p>");
            }
            self.push("</div>");
        }
        self.push(&format!("</div><figcaption>{caption}</figcaption></figure>"));
    }

    fn push(&mut self, markup: &str) {
        self.body.push_str(markup);
        self.body.push('\n');
    }

    /// The file.
    pub fn finish(&self) -> String {
        let title = escaped(&self.title);
        let link =
            |(id, title): &(String, String)| format!("<li><a href=\"#{id}\">{}</a></li>", escaped(title));
        let contents: String = self.contents.iter().map(link).collect();
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" \
             content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light dark\">\n\
             <title>{title}</title>\n<style>\n{}{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n\
             <p class=\"lead\">{}</p>\n<nav><ul>{contents}</ul></nav>\n{}</main>\n</body>\n</html>\n",
            svg::STYLE,
            self.lead,
            self.body
        )
    }
}

/// A number with that many decimals; of a long row of them those after the fourth in a softer colour.
pub fn number(value: f64, decimals: usize) -> String {
    digits(&format!("{value:.decimals$}"))
}

/// A numeral, of a long row of decimals those after the fourth in a softer colour; a minus that stands before nothing but zeros is dropped.
pub fn digits(numeral: &str) -> String {
    let zero = !numeral.bytes().any(|b| b.is_ascii_digit() && b != b'0');
    let numeral = if zero { numeral.trim_start_matches('-') } else { numeral };
    let numeral = numeral.replace('-', "−");
    let split = numeral.find('.').map_or(numeral.len(), |dot| (dot + 5).min(numeral.len()));
    let short = numeral.contains('e') || numeral.len() < split + 4;
    let split = if short { numeral.len() } else { split };
    let (read, rest) = numeral.split_at(split);
    if rest.is_empty() {
        format!("<span class=\"n\">{read}</span>")
    } else {
        format!("<span class=\"n\">{read}<i>{rest}</i></span>")
    }
}

/// A small or large number with three significant digits.
pub fn rough(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        digits("0")
    } else if (1e-3..1e5).contains(&size) {
        let decimals = (2.0 - size.log10().floor()).max(0.0) as usize;
        digits(&format!("{value:.decimals$}"))
    } else {
        digits(&format!("{value:.2e}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numerals_keep_their_digits() {
        assert_eq!(number(-1.154_700_443_143_9, 9), "<span class=\"n\">−1.1547<i>00443</i></span>");
        assert_eq!(number(-0.0, 3), "<span class=\"n\">0.000</span>");
        assert_eq!(number(-4e-17, 5), "<span class=\"n\">0.00000</span>");
        assert_eq!(rough(0.002_724), "<span class=\"n\">0.00272</span>");
        assert_eq!(rough(59.115), "<span class=\"n\">59.1</span>");
        assert_eq!(rough(1.664e-17), "<span class=\"n\">1.66e−17</span>");
    }
}
