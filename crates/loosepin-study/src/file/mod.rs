//! From the text of a study file to a study, with all its diagnostics at once.
//! A file for each table. What a study then does stands outside of this folder.

mod check;
mod description;
mod evaluated;
mod evaluated_name;
mod evidence;
mod input;
mod measurements;
mod plausible;
mod play;
mod problem;
mod questions;
mod random_inputs;
mod reader;
mod resolution;
mod sampling;
mod sizes;
mod study;
mod study_table;
mod surrogate;
mod words;

use std::path::{Path, PathBuf};
use std::sync::Arc;

pub use description::{
    Allowance, AllowedFit, AllowedInput, Budget, Correlation, CorrelationMeasure, Deviation, EpistemicInput,
    EpistemicSubject, RandomInput, RandomSubject, RareMethod, Reduction, Sampling, SpecimenRows, StatedCorrelation,
    StudySurrogate, UncertainParameter,
};
pub use evaluated::{EvaluatedModel, EvaluationProblem};
pub use evaluated_name::{NameProblem, NamedPlace, NamedQuestion};
pub use measurements::measured::MeasuredProblem;
pub use measurements::measurement::{
    Measured, MeasuredMotion, MotionError, MotionSubject, Push, ReadingScatter, SampledFeature,
};
pub use measurements::motion::MotionProblem;
pub use measurements::specimen::MIN_ROWS as MIN_SPECIMEN_ROWS;
pub use measurements::specimen_problem::SpecimenProblem;
pub use play::journal_words;
pub use problem::{MeantLimit, StudyProblem};
pub use questions::accuracy::AccuracyProblem;
pub use questions::ask::{Ask, Asked};
pub use questions::location::named_angle_rad;
use questions::promise::PromiseTable;
pub use questions::question_settings::QuestionSettings;
pub use questions::requirement::{Limit, Requirement};
pub use questions::target::AccuracyTarget;
pub use random_inputs::family::takes_mean_of_model;
pub use random_inputs::random_problem::RandomProblem;
use reader::StudyReader;
pub(super) use reader::adopt;
pub use sizes::{MAX_POSES, MAX_RUNS};
pub use study::Study;
use study_table::{STUDY_KEYS, StudyTable};
use words::READINGS;
pub(super) use words::{dimension_of_statistic, statistic_name};

use crate::model::StudyModel;
use crate::question::read_questions;
use loosepin_bounds::{PERCENTILES, PromiseSettings};
use loosepin_mechanics::model::Setting;
use loosepin_simulate::accuracy::ScatterCorrelation;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source};
use loosepin_text::document::{Entry, Reader, json_schema, parse_toml, read_source};
use loosepin_text::units::{Dimension, Rule};
use loosepin_uncertainty::CorrelationSeries;

/// The JSON Schema of a study file, for editors.
pub fn study_schema() -> serde_json::Value {
    json_schema("loosepin study", &STUDY_KEYS)
}

/// Keys at the top of study files that model files do not have.
const STUDY_MARKS: [&str; 7] = ["model", "random", "epistemic", "ask", "require", "measured", "sampling"];

/// The model that the text of a study names, as it is written; `None` if it names none, or is not TOML.
pub fn named_model(source: &Arc<Source>) -> Option<String> {
    parse_toml(source).ok()?.get_ref().get("model")?.get_ref().as_str().map(str::to_owned)
}

/// Whether a text has keys of a study at its top and no body; a text that is not TOML says nothing.
pub fn says_study(source: &Arc<Source>) -> bool {
    parse_toml(source).is_ok_and(|toml| {
        let has = |key: &str| toml.get_ref().contains_key(key);
        STUDY_MARKS.iter().any(|key| has(key)) && !has("body")
    })
}

impl Study {
    /// Reads a study file and the model file that it names, whose path is taken from the folder of the study file.
    ///
    /// # Errors
    /// Everything that is wrong with either file, each with its place.
    pub fn from_path(path: &Path) -> Result<Study, Diagnostics> {
        Study::from_source(&read_source(path)?, path, &[])
    }

    /// As [`Study::from_path`], with the values of settings `path=value` in place of those of the model file.
    ///
    /// # Errors
    /// As for [`Study::from_path`]; settings that the model does not take; a setting of an unknown (epistemic) input.
    pub fn from_path_with_settings(path: &Path, set: &[String]) -> Result<Study, Diagnostics> {
        let mut study = Study::from_source(&read_source(path)?, path, set)?;
        let is_set = |input: &&EpistemicInput| set.iter().any(|text| Setting::is_of(text, &input.path));
        if let Some(input) = study.epistemic.iter().find(is_set) {
            return Err(Diagnostics::one(&StudyProblem::SetsUnknown { path: input.path.clone() }, None));
        }
        study.state_settings(set);
        Ok(study)
    }

    /// Reads a study from text as if it stood in the file `name`: the model that it names is opened, its path taken from the
    /// folder of `name`.
    ///
    /// # Errors
    /// Everything that is wrong with the text or the model file, each with its place.
    pub fn from_text_at(name: &str, text: &str) -> Result<Study, Diagnostics> {
        Study::from_source(&Source::new(name, text), Path::new(name), &[])
    }

    fn from_source(source: &Arc<Source>, path: &Path, set: &[String]) -> Result<Study, Diagnostics> {
        let folder = path.parent().unwrap_or(Path::new(""));
        read(source, Stage::Complete, |written| {
            let model_path = folder.join(written);
            let file = read_source(&model_path)?;
            if says_study(&file) {
                let problem = StudyProblem::ModelIsStudy {
                    file: written.to_owned(),
                    is_itself: std::fs::canonicalize(&model_path).ok() == std::fs::canonicalize(path).ok(),
                };
                return Err(Diagnostics::one(&problem, None));
            }
            let model = StudyModel::from_source(file)?;
            Ok((if set.is_empty() { model } else { model.with_settings(set)? }, model_path))
        })
    }

    /// Reads a study of `model` from text that is reported as `name`. The model that the text names is not opened.
    ///
    /// # Errors
    /// Everything that is wrong with the text, each with its place.
    pub fn from_text(name: &str, text: &str, model: impl Into<StudyModel>) -> Result<Study, Diagnostics> {
        read(&Source::new(name, text), Stage::Complete, |written| Ok((model.into(), PathBuf::from(written))))
    }

    /// Reads a study of `model`, which stands at `model_path`, from a text with its name and, where [`Source::with_files`] gave
    /// them, the tables that it may name: no other file is opened then, and the model that the text names is not opened either.
    ///
    /// # Errors
    /// Everything that is wrong with the text, each with its place.
    pub fn of_model(
        source: &Arc<Source>,
        model: impl Into<StudyModel>,
        model_path: &Path,
    ) -> Result<Study, Diagnostics> {
        read(source, Stage::Complete, |_| Ok((model.into(), model_path.to_owned())))
    }

    /// As [`Study::of_model`], of a study that is still being written: it may have no uncertain input and no question yet. Such a study has an
    /// ideal motion; before it runs, it is read by [`Study::of_model`].
    ///
    /// # Errors
    /// As for [`Study::of_model`].
    pub fn draft_of_model(
        source: &Arc<Source>,
        model: impl Into<StudyModel>,
        model_path: &Path,
    ) -> Result<Study, Diagnostics> {
        read(source, Stage::Draft, |_| Ok((model.into(), model_path.to_owned())))
    }

    /// Whether `loosepin study` has something to answer. A study of readings of a rig may have nothing: it is for `loosepin identify`.
    pub fn has_questions(&self) -> bool {
        !self.asks.is_empty() || !self.requirements.is_empty()
    }

    /// Whether somebody asks what only runs answer. Requirements are judged by `loosepin motion` as well.
    pub fn needs_runs(&self) -> bool {
        !self.asks.is_empty() || !self.measured.is_empty() || !self.motion.is_empty()
    }

    /// The file that the study was read from.
    pub fn source(&self) -> &Arc<Source> {
        &self.source
    }

    /// Points whose paths are shown besides those of outputs.
    pub fn paths(&self) -> &[String] {
        &self.paths
    }

    /// Settings `path=value` whose values stand in place of those of the model file.
    pub fn settings(&self) -> &[String] {
        &self.settings
    }

    /// Arguments of the command line that state settings, accuracy, budget, failed runs and paths beside the file.
    pub fn stated(&self) -> &[String] {
        &self.stated
    }

    /// Place of the budget: in the file or on the command line.
    pub fn budget_place(&self) -> Option<&Place> {
        self.budget_place.as_ref()
    }

    /// Linear correlations of the values of random inputs, for what is computed to first order.
    pub fn linear_correlations(&self) -> Vec<ScatterCorrelation> {
        let stated = self.correlation.iter().flat_map(|correlation| &correlation.stated);
        stated
            .filter_map(|each| {
                let [first, second] = [each.first, each.second].map(|input| &self.random[input]);
                let linear = match each.measure {
                    CorrelationMeasure::Linear => each.value,
                    CorrelationMeasure::Rank => {
                        CorrelationSeries::new(&first.variable, &second.variable).linear(each.normal)
                    }
                };
                Some(ScatterCorrelation { first: first.quantity()?, second: second.quantity()?, linear })
            })
            .chain(self.correlations_of_rows())
            .collect()
    }

    /// The CSV files that were read with it: inputs like the file itself.
    pub fn tables(&self) -> &[Arc<Source>] {
        &self.tables
    }
}

/// Whether a study must be able to run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    /// It has uncertain inputs and questions.
    Complete,
    /// Either may be missing.
    Draft,
}

fn read(
    source: &Arc<Source>,
    stage: Stage,
    open_model: impl FnOnce(&str) -> Result<(StudyModel, PathBuf), Diagnostics>,
) -> Result<Study, Diagnostics> {
    let toml = parse_toml(source)?;
    let mut reader = Reader::new(source);
    let root = reader.root(toml.get_ref(), &STUDY_KEYS);
    let root = StudyTable::of(&mut reader, root).expect("every key has a value, or may have none");
    let opened = root.model.as_ref().and_then(|entry| {
        let written = reader.text(entry)?;
        match open_model(written) {
            Ok(opened) => Some(opened),
            Err(diagnostics) => {
                adopt(&mut reader, &diagnostics, entry.span);
                None
            }
        }
    });
    // Without the model no path, dimension or output of the study can be checked.
    let Some((model, model_path)) = opened else { return Err(reader.diagnostics) };
    let PromiseTable { share, confidence, inner, .. } = PromiseTable::read_or_usual(&mut reader, root.promise.as_ref());
    let promise_settings = PromiseSettings { share, confidence, inner };
    let mut file = StudyReader::new(reader, model, promise_settings, root.specimen.is_some());
    let [random, epistemic] = [&root.random, &root.epistemic].map(Option::as_ref);
    let cycle = file.cycle(root.cycle.as_ref());
    let (mut sampling, sampling_table) = file.sampling(root.sampling.as_ref());
    let written_accuracies = file.accuracies(sampling_table.accuracy.as_ref());
    let written_budget = file.budget(sampling_table.budget.as_ref());
    if let Some(entry) = random {
        file.read_random(entry);
    }
    if let Some(entry) = epistemic {
        file.read_epistemic(entry);
    }
    file.read_journals(root.journals.as_ref());
    file.add_play();
    let correlation = file.read_correlations(root.correlation.as_ref());
    let (correlation, specimen) = file.read_specimen([root.specimen.as_ref(), random], correlation);
    file.read_reading(root.reading.as_ref());
    let percentiles = file.percentiles(root.percentiles.as_ref());
    let (asks, of_asks) = file.read_asks(root.ask.as_ref());
    let mut accuracy = file.targets(written_accuracies, &asks, None);
    accuracy.extend(of_asks);
    let requirements = file.read_requirements(root.require.as_ref());
    file.suffice_for_requirements(root.require.as_ref(), &sampling_table, &requirements, &mut sampling);
    let (measured, motion) = file.read_measured(root.measured.as_ref(), &cycle);
    let allowances = file.read_allowances(root.allow.as_ref(), [random, epistemic], root.require.is_some());
    let together = file.together(root.allow_together.as_ref(), &allowances);
    let promise = file.promise([root.promise.as_ref(), root.allow.as_ref()], &asks, &requirements);
    let surrogate = file.read_surrogate(root.surrogate.as_ref(), (sampling.replicates, sampling.inner), &asks);
    if root.specimen.is_some() && surrogate.is_some() {
        file.refuse_surrogate(root.surrogate.as_ref());
    }
    let questions = read_questions(&root.table, &mut file.reader);
    if stage == Stage::Complete {
        file.check_complete(&root);
    }
    file.check_whole(&root);
    if !file.reader.diagnostics.has_errors() {
        file.check_tolerance(&sampling_table, sampling.tolerance_m);
        file.check_scatter(&root);
        file.warn_of_tails(&root);
        // Where samples grow, or a surrogate takes their place, `inner` does not say how many there will be.
        if accuracy.is_empty() && surrogate.is_none() {
            file.warn_of_quantiles(&root, &asks, &sampling);
        }
    }
    if file.reader.diagnostics.has_errors() {
        return Err(file.reader.diagnostics);
    }
    let (budget, budget_place) = written_budget.unzip();
    let mut warnings: Vec<Diagnostic> = file.model.warnings().to_vec();
    warnings.extend(file.reader.diagnostics.sorted().into_iter().cloned());
    Ok(Study {
        name: root.name.unwrap_or_default(),
        model: file.model,
        model_path,
        seed: root.seed,
        cycle,
        sampling,
        surrogate,
        promise,
        readings: file.readings,
        percentiles,
        random: file.random,
        journals: file.journals,
        correlation,
        specimen,
        epistemic: file.epistemic,
        outputs: file.outputs,
        asks,
        requirements,
        measured,
        motion,
        allowances,
        together,
        questions,
        accuracy,
        budget,
        paths: Vec::new(),
        settings: Vec::new(),
        stated: Vec::new(),
        budget_place,
        warnings,
        source: file.reader.source,
        tables: file.tables,
    })
}

impl StudyReader {
    /// How intervals are read, one or several side by side; questions depend on it.
    fn read_reading(&mut self, written: Option<&Entry<'_>>) {
        let Some(written) = written else { return };
        if written.is_text() {
            self.readings =
                self.reader.choice(written, &READINGS).map_or_else(|| self.readings.clone(), |own| vec![own]);
            return;
        }
        let Some(entries) = self.reader.list(written) else { return };
        if entries.is_empty() {
            self.report(&StudyProblem::Empty { entry: written.path.describe() }, written);
            return;
        }
        let mut found = Vec::new();
        for entry in &entries {
            let Some(reading) = self.reader.choice(entry, &READINGS) else { continue };
            if found.contains(&reading) {
                let value = READINGS.iter().find(|known| known.1 == reading).map_or("", |known| known.0);
                let (entry_words, value) = (written.path.describe(), format!("\"{value}\""));
                self.report(&StudyProblem::MemberTwice { entry: entry_words, value }, entry);
            }
            found.push(reading);
        }
        if !found.is_empty() {
            self.readings = found;
        }
    }

    /// Percentiles of statistics that are themselves random.
    fn percentiles(&mut self, written: Option<&Entry<'_>>) -> Vec<f64> {
        let Some(written) = written else { return PERCENTILES.to_vec() };
        let Some(entries) = self.reader.list(written) else { return Vec::new() };
        if entries.is_empty() {
            self.report(&StudyProblem::Empty { entry: written.path.describe() }, written);
        }
        let is_second_order = |input: &EpistemicInput| input.variable.is_second_order();
        // Where an input is wrong it may be the one with a distribution.
        if !self.reader.diagnostics.has_errors() && !self.epistemic.iter().any(is_second_order) {
            let problem = StudyProblem::PercentilesOfNothing { entry: written.path.describe() };
            let place = self.reader.place(written.key_span);
            self.reader.diagnostics.push(Diagnostic::warning(&problem, Some(place)));
        }
        let mut percentiles: Vec<f64> = Vec::new();
        for entry in &entries {
            let Some(percentile) = self.reader.measured(entry, Dimension::NUMBER, Rule::Probability) else { continue };
            if percentiles.contains(&percentile) {
                self.member_twice(written, percentile, Dimension::NUMBER, entry);
            }
            percentiles.push(percentile);
        }
        percentiles
    }
}
