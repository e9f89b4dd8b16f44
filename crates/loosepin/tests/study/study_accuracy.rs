//! Studies whose samples grow until their bounds are as near as asked, and that end where a budget does.

use crate::silent::run_on;
use loosepin::model::Model;
use loosepin::study::files::{bounds_csv, runs_parquet};
use loosepin::study::result::{AccuracyRecord, AccuracyStop, StudyResult};
use loosepin::study::{Study, StudyError, StudyRun, plan_runs};
use loosepin::templates::find_template;

/// Nobody watches.
/// The four-bar of the template over a twentieth of a turn, with small samples.
fn study(lines: &str) -> Study {
    let template = find_template("four-bar").expect("the template is there");
    let text = template
        .study
        .replace("transient_turns = 2", "transient_turns = 0")
        .replace("recorded_turns = 1", "recorded_turns = 0.05")
        .replace("samples_per_turn = 180", "samples_per_turn = 40")
        .replace("outer = 16 ", "outer = 6 ")
        .replace("inner = 1024", &format!("inner = 16\n{lines}"));
    // Poses of a twentieth of a turn, and nothing that takes longer.
    let (text, _) = text.split_once("[[ask]]").expect("the template asks");
    let asks = "[[ask]]\noutput = \"rocker\"\nof = \"total\"\nreduce = \"maximum_absolute\"\nstatistics = [\"mean\", { quantile = 0.9 }]\n\
                [[ask]]\noutput = \"rocker\"\nof = \"dimensional\"\nreduce = \"rms\"\nstatistics = [\"mean\"]\n";
    let model = Model::from_text("model.toml", template.model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    Study::from_text("study.toml", &format!("{text}{asks}"), model)
        .unwrap_or_else(|diagnostics| panic!("{diagnostics}"))
}

fn run(study: &Study) -> StudyRun {
    run_on(2, study).unwrap_or_else(|error| panic!("{error}"))
}

fn accuracy(result: &StudyResult) -> &AccuracyRecord {
    result.accuracy.as_ref().expect("an accuracy was asked for")
}

/// Bounds and runs as they are written.
fn bytes(conducted: &StudyRun) -> (Vec<u8>, Vec<u8>) {
    let bounds = bounds_csv(&conducted.result).unwrap_or_else(|error| panic!("{error}"));
    (bounds, runs_parquet(&conducted.runs).unwrap_or_else(|error| panic!("{error}")))
}

#[test]
fn identity_the_samples_grow_until_the_bounds_are_as_near_as_asked() {
    let stated = run(&study(""));
    assert!(stated.result.accuracy.is_none());
    let mut wanted = study("");
    wanted.add_accuracy("rocker.mean = 0.001 deg").unwrap_or_else(|diagnostic| panic!("{diagnostic:?}"));
    let reached = run(&wanted);
    let record = accuracy(&reached.result);
    assert_eq!(record.stop, AccuracyStop::Reached, "{record:#?}");
    // Two means are asked for; the quantile is not concerned.
    assert_eq!(record.targets.len(), 2);
    assert!(record.targets.iter().all(|target| target.is_reached() && target.reached_si > 0.0));
    assert!(record.steps.len() > 1 && record.steps[0].share > 1.0, "{record:#?}");
    assert!(reached.result.counts.runs > stated.result.counts.runs);
    assert_eq!(record.runs, reached.result.counts.runs);
    assert!(reached.result.counts.inner > stated.result.counts.inner);
    // The bounds in the files say the same as the record.
    let widening = |result: &StudyResult, place: usize| {
        let bound = &result.bounds[place];
        [&bound.lower, &bound.upper].map(|end| (end.widened_si - end.value_si).abs()).into_iter().fold(0.0, f64::max)
    };
    assert_eq!(record.targets[0].reached_si, widening(&reached.result, 0));
    assert!(widening(&stated.result, 0) > record.targets[0].asked_si);
}

#[test]
fn identity_a_budget_ends_at_a_round_that_repeats() {
    let ended_at = |budget: &str| {
        let mut study = study("accuracy = \"1e-6 deg\"");
        study.set_budget(budget).unwrap_or_else(|diagnostic| panic!("{diagnostic:?}"));
        run(&study)
    };
    let by_runs = ended_at("3000");
    let record = accuracy(&by_runs.result);
    assert_eq!(record.stop, AccuracyStop::Budget);
    assert!(record.runs <= 3000 && record.runs + record.next_round_runs.expect("a round was left") > 3000);
    assert!(record.targets.iter().all(|target| !target.is_reached()));
    assert!(record.targets.iter().all(|target| target.runs_needed.is_none_or(|runs| runs > record.runs)));
    // As many rounds as it made make the same runs, and those the same bounds.
    let again = ended_at(&format!("{} rounds", record.rounds));
    assert!(bytes(&again) == bytes(&by_runs));
    // A time that is over after the first round, which is always made.
    let by_time = ended_at("1 us");
    assert_eq!(accuracy(&by_time.result).rounds, 1);
    assert!(bytes(&by_time) == bytes(&ended_at("1 round")));
}

#[test]
fn a_budget_below_the_first_round_is_refused_before_it_begins() {
    let mut study = study("");
    study.set_budget("500 runs").unwrap_or_else(|diagnostic| panic!("{diagnostic:?}"));
    let said = plan_runs(&study).expect_err("the budget is too small").diagnostic(&study).to_string();
    let due = "--budget:1:1: error[E0611]: a budget of 500 runs; the first round and what follows it take at most ";
    assert!(said.starts_with(due), "{said}");
    assert!(matches!(run_on(1, &study), Err(StudyError::BudgetTooSmall { budget: 500, .. })));
}

#[test]
fn a_budget_in_the_file_is_refused_at_its_place() {
    let study = study("budget = 500");
    let said = plan_runs(&study).expect_err("the budget is too small").diagnostic(&study);
    let place = said.place.expect("it has a place");
    let text = study.source().text();
    let line = text.lines().nth(place.line_and_column().0 - 1).expect("a line");
    assert!(line.starts_with("budget = 500"), "{line}");
    assert_eq!(&text[study.source().clamp(place.span)], "500");
}

#[test]
fn the_accuracy_that_names_most_counts_and_the_command_line_before_the_file() {
    let mut study = study("accuracy = \"0.2 deg\"");
    study.set_budget("1 round").unwrap_or_else(|diagnostic| panic!("{diagnostic:?}"));
    for text in ["rocker.mean=0.03deg", "0.05deg", "rocker.mean=0.04deg"] {
        study.add_accuracy(text).unwrap_or_else(|diagnostic| panic!("{diagnostic:?}"));
    }
    let result = run(&study).result;
    let asked: Vec<f64> = accuracy(&result).targets.iter().map(|target| target.asked_si.to_degrees()).collect();
    const ROUND_OFF_DEG: f64 = 1e-12;
    assert_eq!(asked.len(), 3);
    for (asked, due) in asked.into_iter().zip([0.04, 0.05, 0.04]) {
        assert!((asked - due).abs() < ROUND_OFF_DEG, "{asked} {due}");
    }
}
