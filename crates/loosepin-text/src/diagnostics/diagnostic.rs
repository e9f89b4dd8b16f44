//! One diagnostic, and all diagnostics of a file.

use std::collections::HashSet;
use std::fmt::{self, Display};
use std::io;

use serde::Serialize;

use super::visible::visible;
use super::{Code, Place};

/// Something wrong that can be reported: `Display` says what is wrong, both numbers with units, the rule.
pub trait Problem: Display {
    /// The code that does not change between versions.
    fn code(&self) -> Code;
    /// The way out, if one is known.
    fn hint(&self) -> Option<String> {
        None
    }
}

/// How grave a diagnostic is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Severity {
    /// The file can be used.
    Warning,
    /// The file cannot be used.
    Error,
}

impl Display for Severity {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Severity::Warning => "warning",
            Severity::Error => "error",
        })
    }
}

/// A second place that matters to a diagnostic.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The place.
    pub place: Place,
    /// Text beside the place.
    pub text: String,
}

/// A file that the operating system refused to open or read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RefusedFile {
    /// Its path as it was given.
    pub path: String,
    /// Why.
    pub reason: io::ErrorKind,
    /// The number that the operating system gave, if it gave one.
    pub os_code: Option<i32>,
}

/// One diagnostic.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// The code that does not change between versions.
    pub code: Code,
    /// How grave it is.
    pub severity: Severity,
    /// The error, and the rule.
    pub message: String,
    /// The way out.
    pub hint: Option<String>,
    /// Place; absent if no file is at fault.
    pub place: Option<Place>,
    /// Other places that matter.
    pub labels: Vec<Label>,
    /// The file that cannot be read, if that is the error: the text of the message says the same in words.
    pub refused_file: Option<Box<RefusedFile>>,
}

impl Diagnostic {
    /// An error at a place.
    pub fn error(problem: &dyn Problem, place: Option<Place>) -> Diagnostic {
        Diagnostic {
            code: problem.code(),
            severity: Severity::Error,
            message: visible(&problem.to_string()).into_owned(),
            hint: problem.hint().map(|hint| visible(&hint).into_owned()),
            place,
            labels: Vec::new(),
            refused_file: None,
        }
    }

    /// A warning at a place.
    pub fn warning(problem: &dyn Problem, place: Option<Place>) -> Diagnostic {
        Diagnostic { severity: Severity::Warning, ..Diagnostic::error(problem, place) }
    }

    /// The diagnostic with a second place.
    pub fn with_label(mut self, place: Place, text: impl Into<String>) -> Diagnostic {
        self.labels.push(Label { place, text: visible(&text.into()).into_owned() });
        self
    }

    fn sort_key(&self) -> (&str, usize) {
        self.place.as_ref().map_or(("", 0), |place| (place.source.name(), place.span.start))
    }
}

/// All diagnostics about a file, in the order of their places.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
}

impl Diagnostics {
    /// No diagnostic.
    pub fn new() -> Diagnostics {
        Diagnostics::default()
    }

    /// One error.
    pub fn one(problem: &dyn Problem, place: Option<Place>) -> Diagnostics {
        Diagnostics { list: vec![Diagnostic::error(problem, place)] }
    }

    /// Adds a diagnostic.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        self.list.push(diagnostic);
    }

    /// Adds all of another's.
    pub fn extend(&mut self, other: Diagnostics) {
        self.list.extend(other.list);
    }

    /// Removes diagnostics whose text was seen before, and adds the others' texts to `seen`: a model may be read twice, by itself and for
    /// its study.
    pub fn remove_repeats(&mut self, seen: &mut HashSet<String>) {
        self.list.retain(|diagnostic| seen.insert(diagnostic.to_string()));
    }

    /// Whether any of them is an error.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// The diagnostics, by file and place.
    pub fn sorted(&self) -> Vec<&Diagnostic> {
        let mut sorted: Vec<&Diagnostic> = self.list.iter().collect();
        sorted.sort_by(|one, other| one.sort_key().cmp(&other.sort_key()));
        sorted
    }
}

impl From<Diagnostic> for Diagnostics {
    fn from(diagnostic: Diagnostic) -> Diagnostics {
        Diagnostics { list: vec![diagnostic] }
    }
}

impl FromIterator<Diagnostic> for Diagnostics {
    fn from_iter<I: IntoIterator<Item = Diagnostic>>(diagnostics: I) -> Diagnostics {
        Diagnostics { list: diagnostics.into_iter().collect() }
    }
}

impl std::error::Error for Diagnostics {}
