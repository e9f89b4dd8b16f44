//! How near the bounds were to be and are: sentences for pages and terminals.

use super::answer::output_unit;
use super::number::{NumberWriter, Rounding};
use super::wording::{counted, deviation_words, place_words, statistic_words};
use loosepin_result::study::{AccuracyOutcome, AccuracyRecord, AccuracyStop, BudgetRecord, StudyResult};
use loosepin_text::units::format_number;

/// Digits of an error, and of a number of runs that is foreseen.
const ERROR_DIGITS: usize = 2;
/// Targets that are told one by one; the others stand in `summary.json`.
const MOST_TARGETS: usize = 12;

/// How the study ended, then target by target what is asked and what is reached, first what is not.
pub(super) fn accuracy_sentences(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    let Some(record) = &result.accuracy else { return Vec::new() };
    let mut sentences = vec![ending(record, writer)];
    let mut targets: Vec<&AccuracyOutcome> = record.targets.iter().collect();
    targets.sort_by_key(|target| target.is_reached());
    sentences.extend(targets.iter().take(MOST_TARGETS).map(|target| outcome(result, record, target, writer)));
    if targets.len() > MOST_TARGETS {
        sentences.push(format!("{} more in summary.json.", targets.len() - MOST_TARGETS));
    }
    if record.stop == AccuracyStop::Budget {
        sentences.push(format!(
            "Nothing is lost: the bounds are those of all runs that were made. With --budget \"{}\" the same runs are made again.",
            counted(u64::from(record.rounds), "round", writer)
        ));
    }
    sentences
}

fn ending(record: &AccuracyRecord, writer: &NumberWriter) -> String {
    let made =
        format!("{} and {}", counted(u64::from(record.rounds), "round", writer), counted(record.runs, "run", writer));
    let budget = match record.budget {
        BudgetRecord::Runs { runs } => counted(runs, "run", writer),
        BudgetRecord::Time { seconds } => {
            let (value, unit) = if seconds < 60.0 { (seconds, "s") } else { (seconds / 60.0, "min") };
            format!("{}{}{unit}", format_number(value), writer.space())
        }
        BudgetRecord::Rounds { rounds } => counted(u64::from(rounds), "round", writer),
    };
    let whose = if record.is_budget_stated { "the budget" } else { "the usual budget" };
    let missing = record.targets.iter().filter(|target| !target.is_reached()).count();
    match record.stop {
        AccuracyStop::Reached if record.targets.is_empty() => {
            format!("The samples as stated took {made}, within {whose} of {budget}.")
        }
        AccuracyStop::Reached => format!("All bounds are as near as asked, after {made}."),
        AccuracyStop::Budget => {
            let next =
                record.next_round_runs.map_or(String::new(), |runs| format!(", of {},", counted(runs, "run", writer)));
            let reached = if missing > 0 {
                format!("Not as near as asked: {}.", of_accuracies(missing, record.targets.len()))
            } else {
                "The samples are smaller than stated.".to_owned()
            };
            format!(
                "{reached} The study ended after {made}, since the next round{next} would have gone beyond {whose} of {budget}."
            )
        }
        AccuracyStop::Exhausted => format!(
            "Not as near as asked: {}. The study ended after {made}, since {}.",
            of_accuracies(missing, record.targets.len()),
            if record.is_learned() {
                "more runs to learn from do not help, or hardly, and direct runs at the bounds do not make up for it; the direct double \
                 loop may come nearer (direct = \"double-loop\")"
            } else {
                "more runs are not possible or do not help"
            }
        ),
    }
}

/// `2 of 3 accuracies`, `the one accuracy`.
fn of_accuracies(missing: usize, all: usize) -> String {
    if all == 1 { "the one accuracy".to_owned() } else { format!("{missing} of {all} accuracies") }
}

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
        return format!("{subject}: bounds widened by at most {}, asked {asked}.", value(target.reached_si));
    }
    if !target.reached_si.is_finite() {
        return format!("{subject}: bounds without limit, asked {asked}; too few runs finished.");
    }
    let foreseen = match target.runs_needed {
        Some(runs) => format!(
            "At the pace so far it would take about {} in place of {}.",
            counted(rounded_up(runs), "run", writer),
            writer.count(record.runs)
        ),
        None => "More runs have hardly helped so far, so that nothing can be foreseen.".to_owned(),
    };
    let surrogate = if record.is_learned() {
        format!(", {} from what the surrogate does not know", value(target.surrogate_si))
    } else {
        String::new()
    };
    format!(
        "{subject}: bounds widened by up to {}, asked {asked}; {} from the finite samples, {} from the search{surrogate}. {foreseen}",
        value(target.reached_si),
        value(target.sampling_si),
        value(target.optimisation_si),
    )
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
    use super::rounded_up;

    #[test]
    fn runs_are_rounded_upwards() {
        assert_eq!([0, 7, 99, 100, 101, 12_345].map(rounded_up), [0, 7, 99, 100, 110, 13_000]);
    }
}
