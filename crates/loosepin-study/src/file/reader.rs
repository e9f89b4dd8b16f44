//! A study being read: its parts so far, and notes for the checks at the end.

use super::description::{EpistemicInput, RandomInput};
use super::problem::StudyProblem;
use crate::model::StudyModel;
use crate::model::outputs::StudyOutput;
use loosepin_bounds::{PromiseSettings, Reading};
use loosepin_result::study::Deviation;
use loosepin_space::PlayDistribution;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Problem, Source, Span};
use loosepin_text::document::{Entry, Reader, Reads};
use loosepin_text::units::Dimension;
use loosepin_uncertainty::{EpistemicVariable, Parameter};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// A study in the making.
pub struct StudyReader {
    pub reader: Reader,
    pub model: StudyModel,
    /// Outputs of the model.
    pub outputs: Vec<StudyOutput>,
    pub random: Vec<RandomInput>,
    /// Where the journals of a model in space are in their play, where they are drawn.
    pub journals: Option<PlayDistribution>,
    pub epistemic: Vec<EpistemicInput>,
    /// The one that answers first; never empty.
    pub readings: Vec<Reading>,
    pub tables: Vec<Arc<Source>>,
    /// Parameters of the distribution being read.
    pub parameters: Parameters,
    /// Angles at which single numbers are asked for or required, rad: by output, deviation and the bits of the angle in names.
    pub poses: HashMap<((usize, Deviation), u64), Vec<f64>>,
    /// How large a promise is, where something is promised.
    pub promise: PromiseSettings,
    /// Names of the questions so far.
    pub questions: HashSet<String>,
    /// Whether rows of a joint sample take the place of distributions.
    pub has_rows: bool,
}

impl Reads for StudyReader {
    fn document(&mut self) -> &mut Reader {
        &mut self.reader
    }
}

impl StudyReader {
    /// Nothing of a study of `model` read yet.
    pub fn new(reader: Reader, model: StudyModel, promise: PromiseSettings, has_rows: bool) -> Self {
        Self {
            reader,
            outputs: model.outputs(),
            model,
            random: Vec::new(),
            journals: None,
            epistemic: Vec::new(),
            readings: vec![Reading::FixedButUnknown],
            tables: Vec::new(),
            parameters: Parameters::default(),
            poses: HashMap::new(),
            promise,
            questions: HashSet::new(),
            has_rows,
        }
    }

    /// Reports an entry.
    pub fn report(&mut self, problem: &StudyProblem, entry: &Entry<'_>) {
        self.reader.report(problem, entry.span);
    }

    /// Reports a problem at a place; returns `None`.
    pub fn refused<T>(&mut self, problem: &dyn Problem, span: Span) -> Option<T> {
        self.reader.report(problem, span);
        None
    }
}

/// Takes over the diagnostics about another file; one that has no place, since that file could not be read, stands at `span`, where
/// it is named.
pub fn adopt(reader: &mut Reader, diagnostics: &Diagnostics, span: Span) {
    for diagnostic in diagnostics.sorted() {
        let place = diagnostic.place.clone().unwrap_or_else(|| reader.place(span));
        reader.diagnostics.push(Diagnostic { place: Some(place), ..diagnostic.clone() });
    }
}

/// Which values stand for the uncertain parameters while a distribution is read.
#[derive(Debug, Clone, Copy)]
pub enum Pass {
    /// A corner of their box: bit k chooses the upper end of the k-th one.
    Corner(usize),
    /// The middle of each.
    Middle,
}

/// The uncertain parameters of the distribution that is being read.
#[derive(Debug)]
pub struct Parameters {
    pub pass: Pass,
    pub found: Vec<(Parameter, Dimension, EpistemicVariable)>,
    /// The value in the model of the quantity that scatters, SI: its mean where none is written.
    pub nominal_si: Option<f64>,
    /// Whether the distribution of one of them is being read: the numbers of that one are numbers.
    pub is_inner: bool,
}

impl Default for Parameters {
    fn default() -> Self {
        Self { pass: Pass::Middle, found: Vec::new(), nominal_si: None, is_inner: false }
    }
}
