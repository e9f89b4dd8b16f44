//! A study of a model whose inputs are parameters without any distribution: arguments of a program state it, no file.

use super::description::{EpistemicInput, EpistemicSubject, Sampling};
use super::reader::StudyReader;
use super::sampling::SamplingTable;
use super::sizes::MAX_POSES;
use super::study::Study;
use super::words::{REDUCTIONS, words};
use crate::file::questions::ask::Ask;
use crate::file::questions::location::POSES;
use crate::file::questions::output::{COMPONENT, DEVIATION, OUTPUT};
use crate::file::questions::promise::PromiseTable;
use crate::file::questions::question_settings::QuestionSettings;
use crate::response::limits::{MAX_COLUMNS, MAX_RECORDED_TURNS, MAX_TURNS};
use loosepin_bounds::{PERCENTILES, PromiseSettings};
use loosepin_mechanics::model::{LawError, Model, NormalDescription, PathError, QuantityError, measured_argument};
use loosepin_text::diagnostics::{Code, Diagnostic, Diagnostics, Problem, Source, nearest_name, problems};
use loosepin_text::document::{Entry, Kind, Reader, Reads, parse_toml};
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};
use loosepin_uncertainty::{EpistemicVariable, Interval, IntervalError};
use std::path::PathBuf;

record! {
    /// an output that is evaluated
    pub(super) lenient struct EvaluatedTable for Reads, exactly one of [at, poses, reduce];
    required output: Entry<'t> as OUTPUT;
    optional component: Entry<'t> as COMPONENT;
    required of: Entry<'t> as DEVIATION;
    /// the whole curve over the cycle
    optional at: Entry<'t> = Kind::Choice(&["cycle"]), "\"cycle\"";
    optional poses: Entry<'t> as POSES;
    /// one number calculated from the whole curve
    optional reduce: Entry<'t> = Kind::Choice(&words(&REDUCTIONS)), "\"maximum_absolute\"";
}

record! {
    /// what is evaluated
    struct EvaluationTable for Reads;
    /// outputs under names of the caller
    required outputs: Entry<'t> = Kind::Tables { keys: &EvaluatedTable::KEYS, except: &[] }, "";
}

problems! {
    /// What is wrong with an argument of an evaluation.
    #[derive(Debug, Clone, PartialEq)]
    pub enum EvaluationProblem {
        Path { error: PathError } => Problem::code(error), says("inputs: {error}"), hint_of(error.hint());
        Rule { error: QuantityError } => Problem::code(error), says("inputs: {error}"), hint_of(error.hint());
        Law { error: LawError } => Problem::code(error), says("inputs: {error}"), hint_of(error.hint());
        LawName { path: String, found: String, nearest: Option<String> } => Code::UnknownChoice,
            says("inputs: '{path}' is '{found}', which is no contact law"),
            hint_of(nearest.as_ref().map(|nearest| format!("did you mean '{nearest}'?")));
        NoNominal { path: String, error: IntervalError } => Code::BreaksRule,
            says("inputs: '{path}' has no value in the model: {error}");
        Turns { argument: &'static str, turns: f64, most: f64 } => Code::BreaksRule,
            says("{argument} {turns:?}; must be at most {most}");
        Poses { samples: usize, turns: f64 } => Code::AskNotPossible,
            says("samples {samples} in each of {turns} turns; a curve must have at most {MAX_POSES} poses"),
            hint("ask for fewer samples; 180 in a turn give a good curve");
        Columns { columns: usize } => Code::TooMany,
            says("outputs: they need {columns} numbers of each run; must be at most {MAX_COLUMNS}"),
            hint("ask for fewer curves, fewer poses or fewer samples");
    }
}

/// What is evaluated of a model.
#[derive(Debug, Clone)]
pub struct EvaluatedModel {
    /// The model, whose values are those of the drawing.
    pub model: Model,
    /// Paths of the numbers that are chosen for each run.
    pub inputs: Vec<String>,
    /// Paths of contact laws, each with the name of the law that takes its place.
    pub laws: Vec<[String; 2]>,
    /// The outputs as TOML: a table `outputs` with a table of the keys of a question for each name.
    pub outputs: String,
    /// Tolerance of positions with its unit.
    pub tolerance: String,
}

impl Study {
    /// The study whose runs are those of `evaluated`: each input is unknown, at the value of the model where no other is chosen, so that
    /// the drawing that deviations are measured from is that of the model. Questions are in the order of the outputs.
    ///
    /// # Errors
    /// Everything that is wrong with an argument, by its name; no place is named, since no file was written.
    pub fn of_evaluated(evaluated: &EvaluatedModel) -> Result<Self, Diagnostics> {
        let EvaluatedModel { model, inputs, laws, outputs, tolerance } = evaluated;
        let mut diagnostics = Diagnostics::new();
        let mut model = model.clone();
        for [path, law] in laws {
            match with_law_named(&model, path, law) {
                Ok(changed) => model = changed,
                Err(problem) => diagnostics.push(Diagnostic::error(&problem, None)),
            }
        }
        let mut epistemic = Vec::new();
        for path in inputs {
            match input(&model, path) {
                Ok(input) => epistemic.push(input),
                Err(problem) => diagnostics.push(Diagnostic::error(&problem, None)),
            }
        }
        let tolerance_m = measured_argument("tolerance", tolerance, Dimension::LENGTH, Rule::Positive);
        let tolerance_m = tolerance_m.map_err(|diagnostic| diagnostics.push(placeless(&diagnostic)));
        let source = Source::new("outputs", outputs);
        let toml = parse_toml(&source)?;
        let mut reader = Reader::new(&source);
        let root = reader.root(toml.get_ref(), &EvaluationTable::KEYS);
        let root = EvaluationTable::of(&mut reader, root);
        let PromiseTable { share, confidence, inner, .. } = PromiseTable::read_or_usual(&mut reader, None);
        let mut file = StudyReader::new(reader, model.into(), PromiseSettings { share, confidence, inner }, false);
        let (Sampling { outer, inner, replicates, most_failed, .. }, _): (Sampling, SamplingTable<'_>) =
            file.sampling(None);
        let asks = root.map_or_else(Vec::new, |root| file.read_evaluated(&root.outputs));
        let cycle = file.model.cycle();
        for (argument, turns, most) in [
            ("turns", cycle.recorded_turns, MAX_RECORDED_TURNS),
            ("transient and turns together", cycle.transient_turns + cycle.recorded_turns, MAX_TURNS),
        ] {
            if turns > most {
                let problem = EvaluationProblem::Turns { argument, turns, most };
                diagnostics.push(Diagnostic::error(&problem, None));
            }
        }
        let (samples, turns) = (cycle.samples_per_turn, cycle.recorded_turns);
        let has_curve = asks.iter().any(|ask| ask.location.is_cycle());
        if has_curve && turns * samples as f64 > MAX_POSES as f64 {
            diagnostics.push(Diagnostic::error(&EvaluationProblem::Poses { samples, turns }, None));
        }
        let numbers = asks.iter().map(|ask| ask.location.numbers((turns * samples as f64).ceil() as usize));
        let columns = numbers.fold(0, usize::saturating_add);
        if columns > MAX_COLUMNS {
            diagnostics.push(Diagnostic::error(&EvaluationProblem::Columns { columns }, None));
        }
        diagnostics.extend(file.reader.diagnostics.sorted().into_iter().map(placeless).collect());
        let tolerance_m = match tolerance_m {
            Ok(tolerance_m) if !diagnostics.has_errors() => tolerance_m,
            _ => return Err(diagnostics),
        };
        Ok(Self {
            name: file.model.name().to_owned(),
            model_path: PathBuf::new(),
            seed: 1,
            cycle,
            sampling: Sampling { outer, inner, replicates, tolerance_m, most_failed },
            surrogate: None,
            promise: None,
            readings: file.readings,
            percentiles: PERCENTILES.to_vec(),
            random: Vec::new(),
            journals: None,
            correlation: None,
            specimen: None,
            epistemic,
            outputs: file.outputs,
            asks,
            requirements: Vec::new(),
            measured: Vec::new(),
            motion: Vec::new(),
            allowances: Vec::new(),
            together: None,
            questions: QuestionSettings::default(),
            accuracy: Vec::new(),
            budget: None,
            paths: Vec::new(),
            settings: Vec::new(),
            stated: Vec::new(),
            budget_place: None,
            warnings: Vec::new(),
            source: file.reader.source,
            tables: Vec::new(),
            model: file.model,
        })
    }
}

impl StudyReader {
    /// Reads outputs under names; `None` of those that are wrong.
    fn read_evaluated(&mut self, written: &Entry<'_>) -> Vec<Ask> {
        let entries = self.reader.any_keys(written);
        entries.iter().filter_map(|entry| self.evaluated(entry)).collect()
    }

    fn evaluated(&mut self, entry: &Entry<'_>) -> Option<Ask> {
        let table = EvaluatedTable::read(self, entry)?;
        let output = self.output(&table.table, &table.output, &table.component);
        let deviation = self.deviation(table.of.as_ref(), output);
        let places = [&table.at, &table.poses, &table.reduce];
        let location = self.location(places, output.zip(deviation))?;
        let location = self.place_of_wear(places, output, location)?;
        Some(Ask::of_values(output?, deviation?, location))
    }
}

/// The input with this path, at its value in the model.
fn input(model: &Model, path: &str) -> Result<EpistemicInput, EvaluationProblem> {
    let quantity = model.find(path).map_err(|error| EvaluationProblem::Path { error })?;
    let nominal_si = model.quantities.nominal()[quantity];
    let point = Interval::try_new(nominal_si, nominal_si);
    let variable = point.map_err(|error| EvaluationProblem::NoNominal { path: path.to_owned(), error })?;
    let (path, subject) = (path.to_owned(), EpistemicSubject::Quantity(quantity));
    Ok(EpistemicInput { path, subject, variable: EpistemicVariable::Interval(variable) })
}

/// `model` with another contact law at `path`.
fn with_law_named(model: &Model, path: &str, name: &str) -> Result<Model, EvaluationProblem> {
    let contact = match model.contact_of_law(path) {
        Some(contact) => contact.map_err(|error| EvaluationProblem::Path { error })?,
        None => {
            return Err(model
                .find(path)
                .err()
                .map_or_else(|| no_law(path, name), |error| EvaluationProblem::Path { error }));
        }
    };
    let law = NormalDescription::all().find(|law| law.name() == name).ok_or_else(|| no_law(path, name))?;
    model.with_law(contact, law).map_err(|error| EvaluationProblem::Law { error })
}

fn no_law(path: &str, name: &str) -> EvaluationProblem {
    let nearest = nearest_name(name, NormalDescription::all().map(|law| law.name())).map(str::to_owned);
    EvaluationProblem::LawName { path: path.to_owned(), found: name.to_owned(), nearest }
}

/// A diagnostic without its place: nobody wrote the text that it is in.
fn placeless(diagnostic: &Diagnostic) -> Diagnostic {
    Diagnostic { place: None, labels: Vec::new(), ..diagnostic.clone() }
}
