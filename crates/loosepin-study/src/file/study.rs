//! A study, checked and in SI.

use std::path::PathBuf;
use std::sync::Arc;

use super::description::{Allowance, Correlation, EpistemicInput, RandomInput, Sampling, SpecimenRows, StudySurrogate};
use crate::file::measurements::measurement::{Measured, MeasuredMotion};
use crate::file::questions::ask::Ask;
use crate::file::questions::question_settings::QuestionSettings;
use crate::file::questions::requirement::Requirement;
use crate::file::questions::target::AccuracyTarget;
use crate::model::StudyModel;
use crate::model::outputs::StudyOutput;
use loosepin_bounds::{PromiseSettings, Reading};
use loosepin_mechanics::model::Cycle;
use loosepin_result::study::{Budget, Together};
use loosepin_space::PlayDistribution;
use loosepin_text::diagnostics::{Diagnostic, Place, Source};
use loosepin_uncertainty::EpistemicParameter;

/// A study: the uncertain inputs of a model, and the questions.
#[derive(Debug, Clone)]
pub struct Study {
    /// Name of the study.
    pub name: String,
    /// The model with its nominal values.
    pub model: StudyModel,
    /// Path of the model.
    pub model_path: PathBuf,
    /// Seed of the random numbers; the same seed gives the same results.
    pub seed: u64,
    /// Recorded cycle: that of the model with the numbers that the study overrides.
    pub cycle: Cycle,
    /// How many runs, and how accurate.
    pub sampling: Sampling,
    /// The surrogate whose bounds stand beside the direct ones; `None` if none is asked for.
    pub surrogate: Option<StudySurrogate>,
    /// The promise for a share of the box; `None` if nothing is promised.
    pub promise: Option<PromiseSettings>,
    /// How an interval is read: first the reading of everything that has one, then those whose bounds stand beside; never empty.
    pub readings: Vec<Reading>,
    /// Percentiles of statistics that are wanted where a parameter of a distribution has a distribution itself.
    pub percentiles: Vec<f64>,
    /// Random inputs in file order, then the places of journals that are drawn.
    pub random: Vec<RandomInput>,
    /// Where the journals of a mechanism in space are in their play; `None` if that is not known, and in the plane, where contact forces decide.
    pub journals: Option<PlayDistribution>,
    /// How the random inputs go together; `None` if they are independent.
    pub correlation: Option<Correlation>,
    /// The rows that take the place of the distributions of all random inputs; `None` if these are as stated.
    pub specimen: Option<SpecimenRows>,
    /// Epistemic inputs in file order.
    pub epistemic: Vec<EpistemicInput>,
    /// Available outputs, in file order.
    pub outputs: Vec<StudyOutput>,
    /// Questions, in file order.
    pub asks: Vec<Ask>,
    /// Requirements, in file order.
    pub requirements: Vec<Requirement>,
    /// Readings of a backlash test, in file order: what `loosepin identify` narrows intervals by. A study does not look at them.
    pub measured: Vec<Measured>,
    /// Features of measured motions, in file order. A study does not look at them.
    pub motion: Vec<MeasuredMotion>,
    /// Allowances: inputs that are loosened as far as the requirements allow, in file order.
    pub allowances: Vec<Allowance>,
    /// How they are loosened together; `None` if each is by itself, the others as stated.
    pub together: Option<Together>,
    /// Settings from the tables of single questions.
    pub(crate) questions: QuestionSettings,
    /// How near the bounds are to be; empty where the samples are as stated.
    pub accuracy: Vec<AccuracyTarget>,
    /// Budget at which the study ends although its bounds are not yet accurate enough.
    pub budget: Option<Budget>,
    /// Points `BODY.POINT` whose paths are shown besides those of outputs.
    pub(super) paths: Vec<String>,
    /// Settings whose values the model has in place of those of its file.
    pub(super) settings: Vec<String>,
    /// Statements of the command line besides the file.
    pub(super) stated: Vec<String>,
    /// Place of the budget.
    pub(super) budget_place: Option<Place>,
    /// Likely oversights in a valid model and study.
    pub warnings: Vec<Diagnostic>,
    pub(super) source: Arc<Source>,
    pub(super) tables: Vec<Arc<Source>>,
}

impl Study {
    /// Parameters of distributions that are epistemic inputs.
    pub fn epistemic_parameters(&self) -> Vec<EpistemicParameter> {
        RandomInput::epistemic_parameters(&self.random)
    }
}
