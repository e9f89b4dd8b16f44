//! Description of a study.

use loosepin_mechanics::model::{ContactId, JointId, Model, QuantityError, QuantityId, Values};
use loosepin_study::{
    Budget, CorrelationMeasure, CostEstimate, EpistemicInput, EpistemicSubject, PLAY, PromiseCost, Study, StudyError,
    default_threads, distribution_words, estimate_cost, journal_words,
};
use loosepin_text::article::{Article, Content, Fact, Section};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics};
use loosepin_text::units::{Dimension, counted_or_no, duration_words, format_number, format_value};
use loosepin_uncertainty::EpistemicVariable;

use super::force_law::force_laws;
use super::mechanism::missing;
use super::trial::TrialResult;

/// The values of the model with every unknown input in the middle of its interval or, of a list, at the first member.
///
/// # Errors
/// They are impossible together.
pub fn middle_values(study: &Study) -> Result<Values, Diagnostics> {
    let epistemic = study.epistemic.iter();
    let middle: Vec<(QuantityId, f64)> =
        epistemic.filter_map(|input| Some((input.quantity()?, input.variable.middle()))).collect();
    let report = |error: QuantityError| Diagnostic::error(&error, study.model.place(error.path()));
    study.model.quantities().evaluate(&middle).map_err(|error| report(error).into())
}

/// Uncertain inputs, questions, and an estimate of the time.
///
/// # Errors
/// The study cannot be planned, or its nominal run fails.
pub fn article(study: &Study, model: &Model, values: &Values, tried: &TrialResult) -> Result<Article, Diagnostics> {
    let is_complete = model.missing_for_runs.is_empty();
    let for_identify = (is_complete && !study.has_questions()).then(|| {
        let readings = counted_or_no(study.measured.len() + study.motion.len(), "reading", "readings");
        format!("{readings} for identify; loosepin study needs a question")
    });
    let mut sections = vec![of_model(study), inputs(study)];
    sections.push(Section::of_sentences("questions", [questions(study)].into_iter().chain(for_identify)));
    if !is_complete {
        sections.push(missing(model));
    } else if study.has_questions() {
        sections.extend(force_laws(model, values, joints_with_force_bound(study), &listed_laws(study)));
        sections.push(plan(study, tried)?);
    }
    Ok(Article { title: study.name.clone(), sections })
}

/// As [`article`], of a study of a mechanism in space.
///
/// # Errors
/// The study cannot be planned, or its nominal motion does not close.
pub fn article_in_space(study: &Study) -> Result<Article, Diagnostics> {
    let mut sections = vec![of_model(study), inputs(study), Section::of_sentences("questions", [questions(study)])];
    if study.has_questions() {
        let positions = study.cycle.recorded_turns * study.cycle.samples_per_turn as f64;
        let journals = match study.journals {
            Some(_) => "the journals keep the places that are drawn for the run",
            None => "at each the journals are anywhere in their play",
        };
        let positions = format_number(positions.round());
        let run = format!("A run: {positions} positions, loops closed exactly, without dynamics; {journals}");
        sections.push(planned(study, run)?);
    }
    Ok(Article { title: study.name.clone(), sections })
}

fn of_model(study: &Study) -> Section {
    let words = format!("of {}: {}", study.model_path.display(), study.model.name());
    Section::of_sentences("model", [words])
}

fn questions(study: &Study) -> String {
    format!(
        "{} and {}",
        counted_or_no(study.asks.len(), "question", "questions"),
        counted_or_no(study.requirements.len(), "requirement", "requirements")
    )
}

/// A run, what is promised, and how long all runs take.
fn plan(study: &Study, tried: &TrialResult) -> Result<Section, Diagnostics> {
    let run = format!(
        "A run: {} of start-up, {} recorded, of {} each, positions to {:e} m",
        counted_turns(study.cycle.transient_turns),
        format_number(study.cycle.recorded_turns),
        format_value(tried.turn_s, Dimension::TIME),
        study.sampling.tolerance_m
    );
    planned(study, run)
}

/// `run` in words, what is promised, and how long all runs take.
fn planned(study: &Study, run: String) -> Result<Section, Diagnostics> {
    let CostEstimate { most_runs, search_runs, run_s, promise } = estimate_cost(study).map_err(|error| {
        let of_model = match &error {
            StudyError::AllFailed { reason, .. } => study.model.diagnostic_of_run(reason),
            _ => None,
        };
        of_model.unwrap_or_else(|| error.diagnostic(study))
    })?;
    let time = time_words(study, most_runs, run_s);
    let search = (search_runs > 0).then(|| search_words(study, (most_runs, search_runs), run_s));
    let costs = [Some(time), search].into_iter().flatten();
    let Some(promise) = promise else { return Ok(Section::of_sentences("plan", [run].into_iter().chain(costs))) };
    let mut section = Section::of_sentences("plan", [run]);
    section.push(Content::sentences([promise_words(study, &promise)].into_iter().chain(costs)));
    Ok(section)
}

fn counted_turns(turns: f64) -> String {
    if turns == 1.0 { "1 turn".to_owned() } else { format!("{} turns", format_number(turns)) }
}

/// How long all runs take on this machine.
fn time_words(study: &Study, most_runs: usize, run_s: Option<f64>) -> String {
    let before = match study.budget {
        Some(Budget::Time { .. } | Budget::Rounds { .. }) if !study.accuracy.is_empty() => " before its samples grow",
        _ => "",
    };
    let runs = counted_or_no(most_runs, "run", "runs");
    match run_s {
        Some(run_s) => {
            let threads = counted_or_no(default_threads(), "thread", "threads");
            format!("At most {runs}{before}: {} on {threads}", about_words(run_s, most_runs))
        }
        None => format!("At most {runs}{before}; their time could not be estimated by a short test"),
    }
}

/// How long some runs take, `about 3 min`.
fn about_words(run_s: f64, runs: usize) -> String {
    let whole_s = run_s * runs as f64 / default_threads() as f64;
    let about = if whole_s < 1.0 { "" } else { "about " };
    format!("{about}{}", duration_words(whole_s))
}

/// What the search for the loosest values takes of it, which comes after the bounds.
fn search_words(study: &Study, (most_runs, search_runs): (usize, usize), run_s: Option<f64>) -> String {
    let bounds = most_runs.saturating_sub(search_runs);
    let time = run_s.map_or(String::new(), |run_s| format!(", {}", about_words(run_s, bounds)));
    let bounds = format!("The bounds come first, at most {}{time}", counted_or_no(bounds, "run", "runs"));
    let has_proofs = study.model.deviation_proofs().is_some();
    let motion = if has_proofs { "; loosepin motion gives values without dynamics at once" } else { "" };
    format!("{bounds}; the others seek the loosest values of [allow]{motion}")
}

/// The joints whose force is asked about or limited.
fn joints_with_force_bound(study: &Study) -> impl Iterator<Item = JointId> {
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
fn promise_words(study: &Study, promise: &PromiseCost) -> String {
    let PromiseCost { ends, boxes, values, inner, runs } = *promise;
    let settings = study.promise.unwrap_or_default();
    let boxes = if boxes == 1 { String::new() } else { format!(" in each of {boxes} boxes") };
    format!(
        "A promise of {} for {} of the box with {} confidence: {values} values{boxes}, {} at each, {}",
        counted_or_no(ends, "bound", "bounds"),
        format_percent(settings.share),
        format_percent(settings.confidence),
        counted_or_no(inner, "run", "runs"),
        counted_or_no(runs, "run", "runs"),
    )
}

fn format_percent(share: f64) -> String {
    format!("{} %", format_number(100.0 * share))
}

/// Random inputs with their distributions, and unknown inputs as intervals, lists and other structures.
fn inputs(study: &Study) -> Section {
    let of_model = study.random.iter().filter(|input| input.quantity().is_some());
    let random = of_model.map(|input| {
        let shown = distribution_words(input.variable.distribution(), input.dimension(&study.model));
        let origin = input.origin.as_ref().map_or(String::new(), |origin| format!("; {origin}"));
        Fact::new(&input.path, [format!("{shown}{origin}")])
    });
    let journals = study.journals.map(|distribution| Fact::new(PLAY, [journal_words(distribution).to_owned()]));
    let random: Vec<Fact> = random.chain(journals).collect();
    let correlations = study.correlation.iter().flat_map(|correlation| &correlation.stated).map(|each| {
        let [first, second] = [each.first, each.second].map(|input| &study.random[input].path);
        let measure = match each.measure {
            CorrelationMeasure::Rank => "rank",
            CorrelationMeasure::Linear => "linear",
        };
        Fact::nameless(format!("{first} with {second}: {measure} correlation {}", format_number(each.value)))
    });
    let unknown = study.epistemic.iter().map(|input| Fact::new(&input.path, [known_words(study, input)]));
    let heading = counted_or_no(random.len(), "random input", "random inputs");
    let mut section = Section::of_facts("inputs", heading, random.into_iter().chain(correlations));
    section.push(Content::Heading(unknown_heading(study).into()));
    section.push_close(Content::Facts(unknown.collect()));
    section
}

fn unknown_heading(study: &Study) -> String {
    let lists = study.epistemic.iter().filter(|input| input.interval().is_none()).count();
    let intervals = counted_or_no(study.epistemic.len() - lists, "unknown input", "unknown inputs");
    let of_lists = counted_or_no(lists, "input from a list", "inputs from lists");
    match (lists < study.epistemic.len(), lists > 0) {
        (true, true) => format!("{intervals}, {of_lists}"),
        (false, true) => of_lists,
        (_, false) => intervals,
    }
}

/// Description of an input.
fn known_words(study: &Study, input: &EpistemicInput) -> String {
    if matches!(input.subject, EpistemicSubject::Play) {
        return "journals anywhere in their play, at each position".to_owned();
    }
    if let Some(of) = input.members_written(&study.model) {
        return format!("any of {}", of.join(", "));
    }
    let [lower, upper] = input.variable.ends().map(|end| input.written(&study.model, end));
    let how = match &input.variable {
        EpistemicVariable::Evidence(evidence) if evidence.is_scattering() => "scattering somehow ".to_owned(),
        EpistemicVariable::Evidence(evidence) => {
            format!("in {} with masses, ", counted_or_no(evidence.elements().len(), "interval", "intervals"))
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
