//! Elements of XML, written one a line.

use crate::robot::number;
use std::fmt::Write;

/// Share of the largest of several numbers that is round-off.
const ROUND_OFF: f64 = 1e-15;

/// An element being written.
#[derive(Debug)]
pub(super) struct Element {
    tag: &'static str,
    attributes: String,
    inside: Vec<Element>,
    comment: Option<String>,
}

impl Element {
    /// An element without attributes.
    pub fn new(tag: &'static str) -> Element {
        Element { tag, attributes: String::new(), inside: Vec::new(), comment: None }
    }

    /// A comment: no element.
    fn comment(text: &str) -> Element {
        // Two hyphens would end it.
        Element { comment: Some(text.replace("--", "- -")), ..Element::new("") }
    }

    /// With a text as an attribute.
    pub fn text(mut self, name: &str, value: &str) -> Element {
        let _ = write!(self.attributes, " {name}=\"{}\"", escaped(value));
        self
    }

    /// With numbers as an attribute; of several, those at the size of the round-off of the largest are zero.
    pub fn numbers(self, name: &str, values: &[f64]) -> Element {
        let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
        let is_zero = |value: f64| value.abs() <= ROUND_OFF * largest;
        let words: Vec<String> =
            values.iter().map(|value| number(if is_zero(*value) { 0.0 } else { *value })).collect();
        self.text(name, &words.join(" "))
    }

    /// With an element inside.
    pub fn with(mut self, inner: Element) -> Element {
        self.inside.push(inner);
        self
    }

    /// With elements inside.
    pub fn with_all(mut self, inner: impl IntoIterator<Item = Element>) -> Element {
        self.inside.extend(inner);
        self
    }

    /// With comments before all that is inside.
    pub fn with_comments(mut self, texts: &[String]) -> Element {
        self.inside.splice(0..0, texts.iter().map(|text| Element::comment(text)));
        self
    }

    /// Whether anything is inside.
    pub fn is_empty(&self) -> bool {
        self.inside.is_empty()
    }

    /// The text of a document with this root.
    pub fn document(&self) -> String {
        let mut text = "<?xml version=\"1.0\"?>\n".to_owned();
        self.write(&mut text, 0);
        text
    }

    fn write(&self, text: &mut String, depth: usize) {
        let indent = "  ".repeat(depth);
        if let Some(comment) = &self.comment {
            let _ = writeln!(text, "{indent}<!-- {comment} -->");
            return;
        }
        let _ = write!(text, "{indent}<{}{}", self.tag, self.attributes);
        if self.inside.is_empty() {
            text.push_str("/>\n");
            return;
        }
        text.push_str(">\n");
        self.inside.iter().for_each(|inner| inner.write(text, depth + 1));
        let _ = writeln!(text, "{indent}</{}>", self.tag);
    }
}

fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            other if other.is_control() => escaped.push(' '),
            other => escaped.push(other),
        }
    }
    escaped
}
