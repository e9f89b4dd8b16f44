//! A study in words.

use std::fmt::Write;

use loosepin::model::{ContactId, JointId, QuantityError, QuantityId, Values};
use loosepin::study::{
    Budget, CorrelationMeasure, EpistemicSubject, Foreseen, ForeseenPromise, Study, StudyError, default_threads,
    distribution_words, foresee,
};
use loosepin::uncertainty::EpistemicVariable;
use loosepin::units::{Dimension, format_number, format_value};

use super::force_law::push_force_laws;
use super::mechanism::missing_words;
use super::trial::Trial;
use crate::console::{counted, duration};
use crate::ending::Failure;

/// The values of the model with every interval input in the middle of its interval, every number of a list at the first.
///
/// # Errors
/// They are impossible together.
pub fn middle_values(study: &Study) -> Result<Values, Failure> {
    let epistemic = study.epistemic.iter();
    let middle: Vec<(QuantityId, f64)> =
        epistemic.filter_map(|input| Some((input.quantity()?, input.variable.middle()))).collect();
    let complain =
        |error: QuantityError| loosepin::diagnostics::Complaint::error(&error, study.model.place(error.path()));
    study.model.quantities.evaluate(&middle).map_err(|error| complain(error).into())
}

/// Uncertain inputs, questions, and an estimate of the time.
///
/// # Errors
/// The study cannot be planned, or its nominal run fails.
pub fn words(study: &Study, values: &Values, tried: &Trial) -> Result<String, Failure> {
    let mut text = format!("{}\n\nof {}: {}\n", study.name, study.model_path.display(), study.model.name);
    push_inputs(&mut text, study);
    let _ = writeln!(
        text,
        "\n{} and {}",
        counted(study.asks.len(), "question", "questions"),
        counted(study.requirements.len(), "requirement", "requirements")
    );
    if !study.model.missing_for_runs.is_empty() {
        let _ = writeln!(text, "\n{}", missing_words(&study.model));
        return Ok(text);
    }
    if !study.has_questions() {
        let readings = counted(study.measured.len() + study.motion.len(), "reading", "readings");
        let _ = writeln!(text, "{readings} for identify; loosepin study needs a question");
        return Ok(text);
    }
    push_force_laws(&mut text, &study.model, values, joints_of_forces(study), &listed_laws(study));
    let Foreseen { most_runs, run_s, promise } = foresee(study).map_err(|error| match error {
        StudyError::AllFailed { reason, .. } => reason.complaint(&study.model),
        error => error.complaint(study),
    })?;
    let threads = default_threads();
    let turns = study.cycle.transient_turns;
    let _ = writeln!(
        text,
        "\nA run: {} of start-up, {} recorded, of {} each, positions to {:e} m",
        if turns == 1.0 { "1 turn".to_owned() } else { format!("{} turns", format_number(turns)) },
        format_number(study.cycle.recorded_turns),
        format_value(tried.turn_s, Dimension::TIME),
        study.sampling.tolerance_m
    );
    if let Some(promise) = promise {
        push_promise(&mut text, study, &promise);
    }
    let before = match study.budget {
        Some(Budget::Time { .. } | Budget::Rounds { .. }) if !study.accuracy.is_empty() => " before its samples grow",
        _ => "",
    };
    let runs = counted(most_runs, "run", "runs");
    let _ = match run_s.map(|run_s| run_s * most_runs as f64 / threads as f64) {
        Some(whole_s) => {
            let (time, threads) = (duration(whole_s), counted(threads, "thread", "threads"));
            let about = if whole_s < 1.0 { "" } else { "about " };
            writeln!(text, "At most {runs}{before}: {about}{time} on {threads}")
        }
        None => writeln!(text, "At most {runs}{before}; a short trial does not tell how long they take"),
    };
    Ok(text)
}

/// The joints whose force is asked about or limited.
fn joints_of_forces(study: &Study) -> impl Iterator<Item = JointId> {
    let asked = study.asks.iter().map(|ask| ask.output);
    let required = study.requirements.iter().map(|requirement| requirement.output);
    asked.chain(required).filter_map(|output| study.outputs[output].seen.force_in())
}

/// The contacts whose law comes from a list.
fn listed_laws(study: &Study) -> Vec<ContactId> {
    let contact = |subject: &EpistemicSubject| match subject {
        EpistemicSubject::Law { contact, .. } => Some(*contact),
        _ => None,
    };
    study.epistemic.iter().filter_map(|input| contact(&input.subject)).collect()
}

/// What is promised, and what it costs.
fn push_promise(text: &mut String, study: &Study, promise: &ForeseenPromise) {
    let ForeseenPromise { ends, boxes, values, inner, runs } = *promise;
    let settings = study.promise.unwrap_or_default();
    let boxes = if boxes == 1 { String::new() } else { format!(" in each of {boxes} boxes") };
    let _ = writeln!(
        text,
        "\nA promise of {} for {} of the box with {} confidence: {values} values{boxes}, {} at each, {}",
        counted(ends, "bound", "bounds"),
        format_percent(settings.share),
        format_percent(settings.confidence),
        counted(inner, "run", "runs"),
        counted(runs, "run", "runs"),
    );
}

fn format_percent(share: f64) -> String {
    format!("{} %", format_number(100.0 * share))
}

fn push_inputs(text: &mut String, study: &Study) {
    let paths = study.random.iter().map(|input| &input.path).chain(study.epistemic.iter().map(|input| &input.path));
    let width = paths.map(|path| path.chars().count()).max().unwrap_or(0);
    let dimension = |id: QuantityId| study.model.quantities[id].dimension;
    let _ = writeln!(text, "\n{}", counted(study.random.len(), "random input", "random inputs"));
    for input in &study.random {
        let shown = distribution_words(input.variable.distribution(), dimension(input.quantity));
        let origin = input.origin.as_ref().map_or(String::new(), |origin| format!("; {origin}"));
        let _ = writeln!(text, "  {:width$}  {shown}{origin}", input.path);
    }
    for each in study.correlation.iter().flat_map(|correlation| &correlation.stated) {
        let [first, second] = [each.first, each.second].map(|input| &study.random[input].path);
        let measure = match each.measure {
            CorrelationMeasure::Rank => "rank",
            CorrelationMeasure::Linear => "linear",
        };
        let _ = writeln!(text, "  {first} with {second}: {measure} correlation {}", format_number(each.value));
    }
    let lists = study.epistemic.iter().filter(|input| input.interval().is_none()).count();
    let has_lists = lists > 0;
    let intervals = counted(study.epistemic.len() - lists, "interval input", "interval inputs");
    let lists = counted(lists, "input from a list", "inputs from lists");
    let _ = match (study.epistemic.iter().any(|input| input.interval().is_some()), has_lists) {
        (true, true) => writeln!(text, "\n{intervals}, {lists}"),
        (false, true) => writeln!(text, "\n{lists}"),
        (_, false) => writeln!(text, "\n{intervals}"),
    };
    for input in &study.epistemic {
        let known = match input.members_written(&study.model) {
            Some(of) => format!("any of {}", of.join(", ")),
            None => {
                let [lower, upper] = input.variable.ends().map(|end| input.written(&study.model, end));
                let how = match &input.variable {
                    EpistemicVariable::Evidence(evidence) if evidence.is_scattering() => {
                        "scattering somehow ".to_owned()
                    }
                    EpistemicVariable::Evidence(evidence) => {
                        format!("in {} with masses, ", counted(evidence.elements().len(), "interval", "intervals"))
                    }
                    EpistemicVariable::SecondOrder(parameter) => {
                        let dimension = input.dimension(&study.model);
                        format!("{}, looked at ", distribution_words(parameter.variable().distribution(), dimension))
                    }
                    EpistemicVariable::Periodic(_) => "on a circle, ".to_owned(),
                    EpistemicVariable::Fuzzy(_) => "fuzzy, ".to_owned(),
                    _ => String::new(),
                };
                format!("{how}between {lower} and {upper}")
            }
        };
        let _ = writeln!(text, "  {:width$}  {known}", input.path);
    }
}
