//! One complaint, and all complaints of a file.

use std::collections::HashSet;
use std::fmt::{self, Display};

use serde::Serialize;

use super::visible::visible;
use super::{Code, Place};

/// Something wrong that can be complained about: `Display` says what is wrong, both numbers with units, the rule.
pub trait Problem: Display {
    /// The code that does not change between versions.
    fn code(&self) -> Code;
    /// The way out, if one is known.
    fn hint(&self) -> Option<String> {
        None
    }
}

/// How grave a complaint is.
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

/// A second place that matters to a complaint.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The place.
    pub place: Place,
    /// Text beside the place.
    pub text: String,
}

/// One complaint.
#[derive(Debug, Clone, PartialEq)]
pub struct Complaint {
    /// The code that does not change between versions.
    pub code: Code,
    /// How grave it is.
    pub severity: Severity,
    /// The error, and the rule.
    pub message: String,
    /// The way out.
    pub hint: Option<String>,
    /// Where; absent where no file is at fault.
    pub place: Option<Place>,
    /// Other places that matter.
    pub labels: Vec<Label>,
}

impl Complaint {
    /// An error at a place.
    pub fn error(problem: &dyn Problem, place: Option<Place>) -> Complaint {
        Complaint {
            code: problem.code(),
            severity: Severity::Error,
            message: visible(&problem.to_string()).into_owned(),
            hint: problem.hint().map(|hint| visible(&hint).into_owned()),
            place,
            labels: Vec::new(),
        }
    }

    /// A warning at a place.
    pub fn warning(problem: &dyn Problem, place: Option<Place>) -> Complaint {
        Complaint { severity: Severity::Warning, ..Complaint::error(problem, place) }
    }

    /// The complaint with a second place.
    pub fn with_label(mut self, place: Place, text: impl Into<String>) -> Complaint {
        self.labels.push(Label { place, text: visible(&text.into()).into_owned() });
        self
    }

    fn sort_key(&self) -> (&str, usize) {
        self.place.as_ref().map_or(("", 0), |place| (place.source.name(), place.span.start))
    }
}

/// All complaints about a file, in the order of their places.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Complaints {
    list: Vec<Complaint>,
}

impl Complaints {
    /// No complaint.
    pub fn new() -> Complaints {
        Complaints::default()
    }

    /// One error.
    pub fn one(problem: &dyn Problem, place: Option<Place>) -> Complaints {
        Complaints { list: vec![Complaint::error(problem, place)] }
    }

    /// Adds a complaint.
    pub fn push(&mut self, complaint: Complaint) {
        self.list.push(complaint);
    }

    /// Adds all of another's.
    pub fn extend(&mut self, other: Complaints) {
        self.list.extend(other.list);
    }

    /// Removes complaints whose text was seen before, and adds the others' texts to `seen`: a model may be read twice, by itself and for
    /// its study.
    pub fn remove_repeats(&mut self, seen: &mut HashSet<String>) {
        self.list.retain(|complaint| seen.insert(complaint.to_string()));
    }

    /// Whether any of them is an error.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|complaint| complaint.severity == Severity::Error)
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// The complaints, by file and place.
    pub fn sorted(&self) -> Vec<&Complaint> {
        let mut sorted: Vec<&Complaint> = self.list.iter().collect();
        sorted.sort_by(|one, other| one.sort_key().cmp(&other.sort_key()));
        sorted
    }
}

impl From<Complaint> for Complaints {
    fn from(complaint: Complaint) -> Complaints {
        Complaints { list: vec![complaint] }
    }
}

impl FromIterator<Complaint> for Complaints {
    fn from_iter<I: IntoIterator<Item = Complaint>>(complaints: I) -> Complaints {
        Complaints { list: complaints.into_iter().collect() }
    }
}

impl std::error::Error for Complaints {}
