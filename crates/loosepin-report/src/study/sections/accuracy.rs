//! Required and reached accuracy of the bounds.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::words::wording::output_unit;
use crate::words::wording::{counted, deviation_words, place_words, statistic_words};
use loosepin_result::study::{AccuracyOutcome, AccuracyRecord, AccuracyStop, Budget, StudyResult};
use loosepin_text::article::{Content, Section};
use loosepin_text::units::format_number;

/// Digits of an error, and of a number of runs that would be needed.
const ERROR_DIGITS: usize = 2;
/// Targets that are shown one by one; the others stand in `summary.json`.
const MAX_TARGETS: usize = 12;

/// The end of the study, then required and reached accuracy of each target; those that are not reached come first.
pub(crate) fn accuracy_section(result: &StudyResult, writer: &NumberWriter) -> Option<Section> {
    let record = result.accuracy.as_ref()?;
    let mut section = Section::new("accuracy", "Accuracy of the bounds");
    section.push(Content::points(sentences(result, record, writer)));
    Some(section)
}

fn sentences(result: &StudyResult, record: &AccuracyRecord, writer: &NumberWriter) -> Vec<String> {
    let mut sentences = vec![ending(record, writer)];
    let mut targets: Vec<&AccuracyOutcome> = record.targets.iter().collect();
    targets.sort_by_key(|target| target.is_reached());
    sentences.extend(targets.iter().take(MAX_TARGETS).map(|target| outcome(result, record, target, writer)));
    if targets.len() > MAX_TARGETS {
        sentences.push(format!("{} more in summary.json.", targets.len() - MAX_TARGETS));
    }
    if record.stop == AccuracyStop::Budget {
        sentences.push(format!(
            "The bounds use all runs made so far. To repeat exactly these runs: --budget \"{}\".",
            counted(u64::from(record.rounds), "round", writer)
        ));
    }
    sentences
}

fn ending(record: &AccuracyRecord, writer: &NumberWriter) -> String {
    let made =
        format!("{} and {}", counted(u64::from(record.rounds), "round", writer), counted(record.runs, "run", writer));
    let budget = match record.budget {
        Budget::Runs { runs } => counted(runs, "run", writer),
        Budget::Time { seconds } => {
            let (value, unit) = if seconds < 60.0 { (seconds, "s") } else { (seconds / 60.0, "min") };
            format!("{}{}{unit}", format_number(value), writer.space())
        }
        Budget::Rounds { rounds } => counted(u64::from(rounds), "round", writer),
    };
    let whose = if record.is_budget_stated { "the budget" } else { "the usual budget" };
    let missing = record.targets.iter().filter(|target| !target.is_reached()).count();
    match record.stop {
        AccuracyStop::Reached if record.targets.is_empty() => {
            format!("The stated samples needed {made}, within {whose} of {budget}.")
        }
        AccuracyStop::Reached => format!("All bounds reach the required accuracy after {made}."),
        AccuracyStop::Budget => {
            let next =
                record.next_round_runs.map_or(String::new(), |runs| format!(" of {}", counted(runs, "run", writer)));
            let reached = if missing > 0 {
                not_reached(missing, record.targets.len())
            } else {
                "The samples are smaller than stated.".to_owned()
            };
            format!("{reached} The study ended after {made}: the next round{next} would exceed {whose} of {budget}.")
        }
        AccuracyStop::Exhausted => format!(
            "{} The study ended after {made}: {}.",
            not_reached(missing, record.targets.len()),
            if record.is_learned() {
                "more training runs and more check runs hardly help. The direct double loop may reach it (direct = \"double-loop\")"
            } else {
                "more runs are not possible or do not help"
            }
        ),
    }
}

/// `The required accuracy is not reached.`, `2 of 3 required accuracies are not reached.`
fn not_reached(missing: usize, all: usize) -> String {
    match (missing, all) {
        (_, 1) => "The required accuracy is not reached.".to_owned(),
        (1, _) => format!("1 of {all} required accuracies is not reached."),
        _ => format!("{missing} of {all} required accuracies are not reached."),
    }
}

/// Runs that a study can make: at a thousand in a second they take eleven days.
const MAX_RUNS: u64 = 1_000_000_000;

fn outcome(result: &StudyResult, record: &AccuracyRecord, target: &AccuracyOutcome, writer: &NumberWriter) -> String {
    let value = |value_si: f64| writer.rounded(value_si, &target.unit, ERROR_DIGITS, Rounding::Up);
    let subject = format!(
        "{} of {} ({}, {})",
        statistic_words(target.statistic, &output_unit(result, &target.output), writer),
        target.output,
        deviation_words(target.of),
        place_words(target.at, writer)
    );
    let asked = writer.value_shortest(target.asked_si, &target.unit);
    if target.is_reached() {
        return format!("{subject}: error at most {}, required {asked}.", value(target.reached_si));
    }
    if !target.reached_si.is_finite() {
        return format!("{subject}: no finite error, required {asked}. Too few runs finished.");
    }
    let runs_needed = runs_needed_words(target.runs_needed, record.runs, writer);
    let surrogate =
        if record.is_learned() { format!(", surrogate {}", value(target.surrogate_si)) } else { String::new() };
    format!(
        "{subject}: error up to {} (sampling {}, search {}{surrogate}), required {asked}. {runs_needed}",
        value(target.reached_si),
        value(target.sampling_si),
        value(target.optimisation_si),
    )
}

/// How many runs would reach an accuracy, and how many were made.
fn runs_needed_words(runs_needed: Option<u64>, made: u64, writer: &NumberWriter) -> String {
    let runs = match runs_needed {
        Some(runs) if runs > MAX_RUNS => {
            format!("It is not reachable with runs: more than {} would be needed", writer.count(MAX_RUNS))
        }
        Some(runs) => format!("About {} would reach it", counted(rounded_up(runs), "run", writer)),
        None => return "More runs hardly helped so far, so the number of runs needed is not known.".to_owned(),
    };
    format!("{runs}; {} were made.", writer.count(made))
}

/// `runs` with two digits, upwards.
fn rounded_up(runs: u64) -> u64 {
    let mut unit: u64 = 1;
    while runs / unit >= 100 {
        unit *= 10;
    }
    runs.div_ceil(unit).saturating_mul(unit)
}

#[cfg(test)]
mod tests {
    use super::{rounded_up, runs_needed_words};
    use crate::numbers::number::NumberWriter;
    use loosepin_text::units::DisplayUnits;

    #[test]
    fn so_many_runs_that_nobody_makes_them_are_not_a_number() {
        let units = DisplayUnits::default();
        let words = |runs| runs_needed_words(runs, 700, &NumberWriter::for_terminal(&units));
        assert_eq!(words(Some(6300)), "About 6300\u{a0}runs would reach it; 700 were made.");
        assert_eq!(
            words(Some(40_000_000_000)),
            "It is not reachable with runs: more than 1000000000 would be needed; 700 were made."
        );
        assert!(words(None).starts_with("More runs hardly helped"));
    }

    #[test]
    fn runs_are_rounded_upwards() {
        assert_eq!([0, 7, 99, 100, 101, 12_345].map(rounded_up), [0, 7, 99, 100, 110, 13_000]);
    }
}
