//! Scalable drawings as text.
//!
//! Colours are names of a style sheet, never values in an element: [`STYLE`] gives each a value for light paper, one for
//! dark screens and one for print. A drawing that stands alone carries the sheet with it; on a page it stands once.

use std::fmt::Write;

/// What every drawing is coloured by. Series colours keep their order and their contrast in both schemes.
pub const STYLE: &str = include_str!("style.css");

/// A drawing being written: a size, a name, and elements.
#[derive(Clone, Debug)]
pub struct Svg {
    width: f64,
    height: f64,
    name: String,
    body: String,
}

/// On which side of its point a text stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Anchor {
    /// It begins there.
    Start,
    /// It is centred there.
    Middle,
    /// It ends there.
    End,
}

impl Anchor {
    fn word(self) -> &'static str {
        match self {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        }
    }
}

/// Text as it stands in markup.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A coordinate: two decimals are a hundredth of a pixel.
fn short(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Appends one element; writing to a string cannot fail.
macro_rules! put {
    ($svg:expr, $($arguments:tt)*) => {{ let _ = writeln!($svg.body, $($arguments)*); }};
}

impl Svg {
    /// An empty drawing of that size in pixels; `name` says what it shows, to those who do not see it as well.
    pub fn new(width: f64, height: f64, name: &str) -> Svg {
        Svg { width, height, name: name.to_owned(), body: String::new() }
    }

    /// How wide it is, in pixels.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// A segment.
    pub fn line(&mut self, a: (f64, f64), b: (f64, f64), class: &str) {
        let [x1, y1, x2, y2] = [a.0, a.1, b.0, b.1].map(short);
        put!(self, r#"<line class="{class}" x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}"/>"#);
    }

    /// An open row of segments.
    pub fn polyline(&mut self, points: &[(f64, f64)], class: &str) {
        put!(self, r#"<polyline class="{class}" points="{}"/>"#, listed(points));
    }

    /// A row of segments of a given width in pixels.
    pub fn stroke(&mut self, points: &[(f64, f64)], width: f64, class: &str) {
        let width = short(width);
        put!(self, r#"<polyline class="{class}" style="stroke-width:{width}" points="{}"/>"#, listed(points));
    }

    /// A closed area.
    pub fn polygon(&mut self, points: &[(f64, f64)], class: &str) {
        put!(self, r#"<polygon class="{class}" points="{}"/>"#, listed(points));
    }

    /// A rectangle.
    pub fn rectangle(&mut self, corner: (f64, f64), size: (f64, f64), class: &str) {
        let [x, y, w, h] = [corner.0, corner.1, size.0, size.1].map(short);
        put!(self, r#"<rect class="{class}" x="{x}" y="{y}" width="{w}" height="{h}"/>"#);
    }

    /// A circle.
    pub fn circle(&mut self, centre: (f64, f64), radius: f64, class: &str) {
        self.ellipse(centre, (radius, radius), 0.0, class);
    }

    /// An ellipse, its first half-axis turned by an angle in radians from the horizontal, clockwise.
    pub fn ellipse(&mut self, centre: (f64, f64), radii: (f64, f64), turn: f64, class: &str) {
        let [x, y, rx, ry, degrees] = [centre.0, centre.1, radii.0, radii.1, turn.to_degrees()].map(short);
        put!(
            self,
            r#"<ellipse class="{class}" cx="{x}" cy="{y}" rx="{rx}" ry="{ry}" transform="rotate({degrees} {x} {y})"/>"#
        );
    }

    /// A line of text; its baseline is at the point.
    pub fn text(&mut self, at: (f64, f64), anchor: Anchor, class: &str, text: &str) {
        let [x, y] = [at.0, at.1].map(short);
        let (anchor, text) = (anchor.word(), escaped(text));
        put!(self, r#"<text class="{class}" x="{x}" y="{y}" text-anchor="{anchor}">{text}</text>"#);
    }

    /// A line of text that runs upwards.
    pub fn text_upwards(&mut self, at: (f64, f64), class: &str, text: &str) {
        let [x, y] = [at.0, at.1].map(short);
        let text = escaped(text);
        put!(
            self,
            r#"<text class="{class}" x="{x}" y="{y}" text-anchor="middle" transform="rotate(-90 {x} {y})">{text}</text>"#
        );
    }

    /// What is drawn until the matching [`Svg::close`] is visible inside this rectangle only. Names of clips are unique
    /// on a page if `key` is.
    pub fn clip(&mut self, key: &str, corner: (f64, f64), size: (f64, f64)) {
        let [x, y, w, h] = [corner.0, corner.1, size.0, size.1].map(short);
        put!(
            self,
            r#"<clipPath id="{key}"><rect x="{x}" y="{y}" width="{w}" height="{h}"/></clipPath><g clip-path="url(#{key})">"#
        );
    }

    /// Opens a group of one class.
    pub fn group(&mut self, class: &str) {
        put!(self, r#"<g class="{class}">"#);
    }

    /// Closes what [`Svg::clip`] or [`Svg::group`] opened.
    pub fn close(&mut self) {
        put!(self, "</g>");
    }

    /// For a page that has [`STYLE`].
    pub fn inline(&self) -> String {
        self.element("")
    }

    /// A file of its own.
    pub fn standalone(&self) -> String {
        let style =
            format!("<style>{STYLE}</style>\n<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n");
        self.element(&style)
    }

    fn element(&self, style: &str) -> String {
        let (w, h) = (short(self.width), short(self.height));
        let name = escaped(&self.name);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"drawing\" viewBox=\"0 0 {w} {h}\" width=\"{w}\" \
             height=\"{h}\" role=\"img\" aria-label=\"{name}\">\n<title>{name}</title>\n{style}{}</svg>\n",
            self.body
        )
    }
}

fn listed(points: &[(f64, f64)]) -> String {
    let point = |&(x, y): &(f64, f64)| format!("{},{}", short(x), short(y));
    points.iter().map(point).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    /// The colours of each scheme: light, dark, print.
    fn schemes() -> Vec<BTreeMap<&'static str, [f64; 3]>> {
        let blocks = STYLE.split(":root{").skip(1).map(|block| block.split('}').next().unwrap_or_default());
        let colour = |text: &str| -> Option<[f64; 3]> {
            let digits = text.strip_prefix('#')?;
            let short = digits.len() == 3;
            let part = |i: usize| {
                let range = if short { i..i + 1 } else { 2 * i..2 * i + 2 };
                let value = u32::from_str_radix(digits.get(range)?, 16).ok()?;
                Some(f64::from(if short { 17 * value } else { value }) / 255.0)
            };
            Some([part(0)?, part(1)?, part(2)?])
        };
        let variables = |block: &'static str| {
            let pairs = block.split(';').filter_map(|line| line.trim().strip_prefix("--")?.split_once(':'));
            pairs.filter_map(|(name, value)| Some((name, colour(value)?))).collect()
        };
        blocks.map(variables).collect()
    }

    /// The contrast of the Web Content Accessibility Guidelines 2.1.
    fn contrast(a: [f64; 3], b: [f64; 3]) -> f64 {
        let linear = |x: f64| if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) };
        let light = |c: [f64; 3]| 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
        let (a, b) = (light(a) + 0.05, light(b) + 0.05);
        if a > b { a / b } else { b / a }
    }

    #[test]
    fn every_colour_is_legible_in_light_dark_and_print() {
        let schemes = schemes();
        assert_eq!(schemes.len(), 3);
        for scheme in schemes {
            let paper = scheme["paper"];
            for text in ["ink", "soft", "accent", "good", "bad"] {
                assert!(contrast(scheme[text], paper) >= 4.5, "{text}: {}", contrast(scheme[text], paper));
            }
            for line in ["s1", "s2", "s3", "s4", "s5", "s6", "target", "edge", "ghost", "x", "y", "z"] {
                assert!(contrast(scheme[line], paper) >= 3.0, "{line}: {}", contrast(scheme[line], paper));
            }
        }
    }

    #[test]
    fn text_is_escaped_and_a_drawing_that_stands_alone_has_its_sheet() {
        let mut svg = Svg::new(10.0, 20.0, "a < b & c");
        svg.text((1.0, 2.0), Anchor::End, "soft", "1 < 2");
        assert!(svg.inline().contains("<title>a &lt; b &amp; c</title>"));
        assert!(svg.inline().contains(">1 &lt; 2</text>") && !svg.inline().contains("<style>"));
        assert!(svg.standalone().contains("prefers-color-scheme:dark"));
    }
}
