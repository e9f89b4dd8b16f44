//! XML with its places: elements, their attributes, and the numbers in them.

use super::problem::RobotProblem;
use loosepin_space::Vec3;
use loosepin_text::diagnostics::{Diagnostics, Place, Source, Span};
use roxmltree::{Document, Error, Node, ParsingOptions};
use std::sync::Arc;

/// Bytes of a file, at most.
const MAX_BYTES: usize = 32 << 20;
/// Elements, texts and comments of a file, at most.
const MAX_NODES: u32 = 400_000;
/// Elements inside each other, at most: they are walked by calls inside each other.
const MAX_DEPTH: usize = 256;
/// Attributes of an element, at most: the parser compares each with all of its element. MJCF has 50 at most.
const MAX_ATTRIBUTES: usize = 100;
/// Declarations of namespaces in a file, at most: the parser compares those around an element with each other.
const MAX_NAMESPACES: usize = 100;
/// What is no element, by its beginning and its end.
const NO_ELEMENTS: [(&str, &str); 4] = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>"), ("<!", ">")];
/// Characters of an attribute that a message shows, at most.
const SHOWN_CHARS: usize = 40;

/// Reads a text as XML.
///
/// # Errors
/// It is no XML; a document type, whose entities can make a small file very large; too many or too deep elements, too many attributes of one.
pub(super) fn parse(source: &Arc<Source>) -> Result<Document<'_>, Diagnostics> {
    if source.text().len() > MAX_BYTES {
        let problem = RobotProblem::TooLarge { what: "bytes", limit: MAX_BYTES };
        return Err(Diagnostics::one(&problem, Some(Place::new(source, 0..0))));
    }
    refuse_many_attributes(source)?;
    let options = ParsingOptions { nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(source.text(), options).map_err(|error| {
        let (problem, place) = match error {
            Error::DtdDetected => {
                let start = source.text().find("<!DOCTYPE").unwrap_or_default();
                (RobotProblem::DocumentType, Place::new(source, start..start + "<!DOCTYPE".len()))
            }
            Error::NodesLimitReached => {
                let limit = MAX_NODES as usize;
                (RobotProblem::TooLarge { what: "elements", limit }, Place::new(source, 0..0))
            }
            // Its text has the place, which stands before the message already.
            other => {
                let why = other.to_string().replacen(&format!(" at {}", other.pos()), "", 1);
                let byte = byte_of(source.text(), other.pos().row, other.pos().col);
                (RobotProblem::NotXml { why }, Place::new(source, byte..byte + 1))
            }
        };
        Diagnostics::one(&problem, Some(place))
    })?;
    // Ends of the elements around each, without calls inside each other.
    let mut open: Vec<usize> = Vec::new();
    for node in document.descendants().filter(Node::is_element) {
        let range = node.range();
        while open.last().is_some_and(|end| *end <= range.start) {
            open.pop();
        }
        open.push(range.end);
        if open.len() > MAX_DEPTH {
            let problem = RobotProblem::TooLarge { what: "elements inside each other", limit: MAX_DEPTH };
            return Err(Diagnostics::one(&problem, Some(Place::new(source, head(&node)))));
        }
    }
    Ok(document)
}

/// Goes through the text once, before it is parsed: the work of the parser grows with the square of the attributes of an element, and with
/// that of the namespaces.
///
/// # Errors
/// An element has too many attributes, or the file too many namespaces. What is no XML is for the parser to say.
fn refuse_many_attributes(source: &Arc<Source>) -> Result<(), Diagnostics> {
    let text = source.text();
    let (mut at, mut namespaces) = (0, 0);
    while let Some(start) = text[at..].find('<').map(|found| at + found) {
        let rest = &text[start..];
        if let Some((beginning, end)) = NO_ELEMENTS.iter().find(|(beginning, _)| rest.starts_with(beginning)) {
            let inside = start + beginning.len();
            at = text[inside..].find(end).map_or(text.len(), |found| inside + found + end.len());
            continue;
        }
        let tag = Tag::read(rest);
        namespaces += tag.namespaces;
        let problem = if tag.attributes > MAX_ATTRIBUTES {
            RobotProblem::ManyAttributes { element: tag.name.to_owned(), found: tag.attributes, limit: MAX_ATTRIBUTES }
        } else if namespaces > MAX_NAMESPACES {
            RobotProblem::TooLarge { what: "declarations of namespaces", limit: MAX_NAMESPACES }
        } else {
            at = start + tag.length;
            continue;
        };
        let head = start..start + 1 + tag.name.len();
        return Err(Diagnostics::one(&problem, Some(Place::new(source, head))));
    }
    Ok(())
}

/// The tag at the beginning of a text, as far as its attributes are counted.
struct Tag<'t> {
    name: &'t str,
    /// Bytes up to and with its `>`.
    length: usize,
    attributes: usize,
    /// Those of the attributes that declare namespaces.
    namespaces: usize,
}

impl Tag<'_> {
    fn read(text: &str) -> Tag<'_> {
        let is_end = |c: char| c.is_ascii_whitespace() || matches!(c, '/' | '>' | '=' | '"' | '\'');
        let name = text[1..].split(is_end).next().unwrap_or_default();
        let mut tag = Tag { name, length: text.len(), attributes: 0, namespaces: 0 };
        let mut quote = None;
        for (place, byte) in text.bytes().enumerate() {
            match (quote, byte) {
                (None, b'"' | b'\'') => quote = Some(byte),
                (Some(opened), _) if opened == byte => quote = None,
                (None, b'=') => {
                    let name = text[..place].trim_end().rsplit(is_end).next().unwrap_or_default();
                    tag.attributes += 1;
                    tag.namespaces += usize::from(name == "xmlns" || name.starts_with("xmlns:"));
                }
                (None, b'>') => {
                    tag.length = place + 1;
                    break;
                }
                _ => {}
            }
        }
        tag
    }
}

/// The byte at a line and a column, both from 1.
fn byte_of(text: &str, line: u32, column: u32) -> usize {
    let start = (1..line).try_fold(0, |start, _| text[start..].find('\n').map(|end| start + end + 1));
    let start = start.unwrap_or(text.len());
    text[start..].char_indices().nth(column.saturating_sub(1) as usize).map_or(text.len(), |(byte, _)| start + byte)
}

/// `<name` of an element: the whole element may be the file.
fn head(node: &Node<'_, '_>) -> Span {
    let range = node.range();
    let name = node.tag_name().name().len() + 1;
    (range.start..(range.start + name).min(range.end)).into()
}

/// An element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Element<'d> {
    node: Node<'d, 'd>,
    source: &'d Arc<Source>,
}

impl<'d> Element<'d> {
    /// The root of a document.
    pub fn root(document: &'d Document<'d>, source: &'d Arc<Source>) -> Element<'d> {
        Element { node: document.root_element(), source }
    }

    /// Its tag.
    pub fn tag(&self) -> &'d str {
        self.node.tag_name().name()
    }

    /// Its elements, those of other namespaces left out.
    pub fn children(&self) -> impl Iterator<Item = Element<'d>> + use<'d> {
        let source = self.source;
        let own = self.node.children().filter(|node| node.is_element() && node.tag_name().namespace().is_none());
        own.map(move |node| Element { node, source })
    }

    /// All elements below it, those of other namespaces as well, each with its namespace.
    pub fn namespaces(&self) -> impl Iterator<Item = (Element<'d>, &'d str)> + use<'d> {
        let source = self.source;
        self.node.descendants().filter_map(move |node| Some((Element { node, source }, node.tag_name().namespace()?)))
    }

    /// Its elements with a tag.
    pub fn all(&self, tag: &'static str) -> impl Iterator<Item = Element<'d>> + use<'d> {
        self.children().filter(move |child| child.tag() == tag)
    }

    /// Its element with a tag, of which there may be one.
    pub fn only(&self, tag: &'static str) -> Result<Option<Element<'d>>, Diagnostics> {
        let mut all = self.all(tag);
        let first = all.next();
        match all.next() {
            Some(second) => Err(second.error(&RobotProblem::Twice { element: self.words(), what: tag })),
            None => Ok(first),
        }
    }

    /// Its element with a tag, which must be there.
    pub fn required(&self, tag: &'static str) -> Result<Element<'d>, Diagnostics> {
        self.only(tag)?
            .ok_or_else(|| self.error(&RobotProblem::Missing { element: self.words(), what: format!("<{tag}>") }))
    }

    /// An attribute.
    pub fn attribute(&self, name: &str) -> Option<Attribute<'d>> {
        let found = self.node.attribute_node(name)?;
        Some(Attribute { element: *self, name: found.name(), text: found.value(), span: found.range().into() })
    }

    /// An attribute that must be there.
    pub fn required_attribute(&self, name: &str) -> Result<Attribute<'d>, Diagnostics> {
        self.attribute(name).ok_or_else(|| {
            self.error(&RobotProblem::Missing { element: self.words(), what: format!("attribute '{name}'") })
        })
    }

    /// Itself in words: `joint 'shoulder'`, or `<origin> of joint 'shoulder'`.
    pub fn words(&self) -> String {
        match self.attribute("name") {
            Some(name) => format!("{} '{}'", self.tag(), name.shown()),
            None => match self.named_ancestor() {
                Some(above) => format!("<{}> of {}", self.tag(), above.words()),
                None => format!("<{}>", self.tag()),
            },
        }
    }

    fn named_ancestor(&self) -> Option<Element<'d>> {
        let source = self.source;
        let above = self.node.ancestors().skip(1).filter(|node| node.is_element() && node.has_attribute("name"));
        // The robot itself says nothing.
        let mut below_root = above.filter(|node| node.parent_element().is_some());
        below_root.next().map(|node| Element { node, source })
    }

    /// A problem at this element.
    pub fn error(&self, problem: &RobotProblem) -> Diagnostics {
        Diagnostics::one(problem, Some(Place::new(self.source, head(&self.node))))
    }
}

/// An attribute of an element, or of the default that it takes it from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Attribute<'d> {
    element: Element<'d>,
    /// Its name.
    pub name: &'d str,
    /// Its text.
    pub text: &'d str,
    span: Span,
}

impl<'d> Attribute<'d> {
    /// Its text, shortened for a message.
    pub fn shown(&self) -> String {
        let mut shown: String = self.text.chars().take(SHOWN_CHARS).collect();
        if self.text.chars().nth(SHOWN_CHARS).is_some() {
            shown.push('…');
        }
        shown
    }

    /// The element in words.
    pub fn of(&self) -> String {
        self.element.words()
    }

    /// A problem at this attribute.
    pub fn error(&self, problem: &RobotProblem) -> Diagnostics {
        Diagnostics::one(problem, Some(Place::new(self.element.source, self.span)))
    }

    /// Exactly `N` finite numbers.
    pub fn numbers<const N: usize>(&self) -> Result<[f64; N], Diagnostics> {
        let words = || if N == 1 { "a number".to_owned() } else { format!("{N} numbers") };
        let list = self.list().and_then(|list| <[f64; N]>::try_from(list).ok());
        list.ok_or_else(|| self.not_numbers(words()))
    }

    /// One finite number.
    pub fn number(&self) -> Result<f64, Diagnostics> {
        self.numbers::<1>().map(|[number]| number)
    }

    /// Between `least` and `most` finite numbers.
    pub fn numbers_between(&self, least: usize, most: usize) -> Result<Vec<f64>, Diagnostics> {
        let list = self.list().filter(|list| (least..=most).contains(&list.len()));
        list.ok_or_else(|| self.not_numbers(format!("{least} to {most} numbers")))
    }

    /// A vector.
    pub fn vector(&self) -> Result<Vec3, Diagnostics> {
        self.numbers::<3>().map(Vec3::from)
    }

    /// A direction, as long as it was written.
    pub fn direction(&self, name: &'static str) -> Result<Vec3, Diagnostics> {
        let vector = self.vector()?;
        match vector.normalised() {
            Some(_) => Ok(vector),
            None => Err(self.error(&RobotProblem::NoDirection { element: self.of(), attribute: name })),
        }
    }

    /// True or false.
    pub fn flag(&self, name: &'static str) -> Result<bool, Diagnostics> {
        match self.text.trim() {
            "true" => Ok(true),
            "false" => Ok(false),
            _ => {
                let choices = ["true", "false"].map(str::to_owned).to_vec();
                let found = self.shown();
                Err(self.error(&RobotProblem::Choice { element: self.of(), attribute: name, found, choices }))
            }
        }
    }

    fn list(&self) -> Option<Vec<f64>> {
        self.text.split_ascii_whitespace().map(finite).collect()
    }

    fn not_numbers(&self, expected: String) -> Diagnostics {
        self.error(&RobotProblem::NotNumbers {
            element: self.of(),
            attribute: self.name.to_owned(),
            found: self.shown(),
            expected,
        })
    }
}

/// A number that is written with digits, and is finite.
fn finite(text: &str) -> Option<f64> {
    let has_digits_alone = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    let number: f64 = has_digits_alone.then(|| text.parse().ok())??;
    number.is_finite().then_some(number)
}
