//! Places of the two texts, changes of them, and what is wrong in them.

use loosepin::diagnostics::Severity;
use serde::Serialize;

/// Which of the two texts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Document {
    /// The mechanism.
    Model,
    /// Its uncertain inputs and its questions.
    Study,
}

/// A stretch of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Stretch {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// First UTF-16 unit.
    pub from: usize,
    /// Behind the last UTF-16 unit.
    pub to: usize,
}

/// A second place that matters to a diagnostic.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LabelView {
    /// The text; `None` if it is none of the two.
    pub document: Option<Document>,
    /// Range in the document.
    #[serde(flatten)]
    pub stretch: Option<Stretch>,
    /// Its text.
    pub text: String,
}

/// Something wrong, or worth a warning.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DiagnosticView {
    /// The text at fault; `None` if it is none of the two.
    pub document: Option<Document>,
    /// Path of the file at fault.
    pub path: Option<String>,
    /// For `explain`.
    pub code: &'static str,
    /// How grave it is.
    pub severity: Severity,
    /// The problem.
    pub message: String,
    /// The way out.
    pub hint: Option<String>,
    /// Range.
    #[serde(flatten)]
    pub stretch: Option<Stretch>,
    /// Other places.
    pub labels: Vec<LabelView>,
    /// A change that mends it, where one is known.
    pub fix: Option<Fix>,
}

/// A stretch of a text that is replaced.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Change {
    /// The text.
    pub document: Document,
    /// First UTF-16 unit that goes.
    pub from: usize,
    /// Behind the last UTF-16 unit that goes.
    pub to: usize,
    /// The replacement.
    pub insert: String,
}

/// A change that mends a diagnostic.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fix {
    /// It.
    #[serde(flatten)]
    pub change: Change,
    /// Its effect, in words.
    pub words: String,
}
