//! Motions that do not repeat themselves: how many, and how much further they go in later turns.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::limits::requirement_words;
use crate::words::wording::{count, counted, deviation_of, deviation_words, listed, output_unit, output_words};
use loosepin_result::study::{FurtherOutput, FurtherTurns, RequirementOutcome, StudyResult};

/// Outputs that are shown; all of them are in the files.
const MAX_TOLD: usize = 3;
/// Digits of what later turns add.
const DIGITS: usize = 2;

/// That motions differ from turn to turn, and what that does; `None` if all repeat themselves.
pub(crate) fn turns_sentence(result: &StudyResult, writer: &NumberWriter) -> Option<String> {
    let share = result.settled_share.filter(|share| *share < 1.0)?;
    let finished = result.counts.runs - result.counts.failed;
    let runs = share_of_runs(1.0 - share, finished, &writer.with_tag(&Tag::whole("settled", "not")));
    let first = format!("In {runs} the motion does not repeat from turn to turn");
    Some(match &result.further_turns {
        None => format!(
            "{first}: later turns may deviate more than the recorded ones. Record more turns (recorded_turns) to see how much."
        ),
        Some(further) => {
            format!("{first}. {}{}", excess_words(result, further, writer), broken_words(result, further, writer))
        }
    })
}

/// "In 5 further turns (64 runs), the largest deviation of slider grew by at most 0.1 mm (mean 0.03 mm)."
fn excess_words(result: &StudyResult, further: &FurtherTurns, writer: &NumberWriter) -> String {
    let turns = counted(u64::from(further.turns), "further turn", &writer.with_tag(&Tag::Given("further turns")));
    let runs = counted(further.runs, "run", &writer.with_tag(&Tag::Count("continued runs")));
    let mut told: Vec<&FurtherOutput> = Vec::new();
    // Parts of a deviation are in the files.
    let (whole, parts): (Vec<_>, Vec<_>) = further.outputs.iter().partition(|one| one.of.cause().is_none());
    for one in whole.into_iter().chain(parts) {
        if told.len() < MAX_TOLD && !told.iter().any(|known| known.output == one.output) {
            told.push(one);
        }
    }
    let excess = |one: &&FurtherOutput| {
        let unit = output_unit(result, &one.output);
        let what = extreme_words(one, result);
        let falls = one.reduction.moved_by_more_turns().is_some_and(|direction| direction < 0.0);
        let [went, did_not] = if falls { ["fell", "did not fall"] } else { ["grew", "did not grow"] };
        if !(one.largest_excess_si > 0.0) {
            return format!("{what} {did_not}");
        }
        let of = |part: &str, value_si: f64, rounding| {
            writer.with_tag(&Tag::further_turns(one, part)).rounded(value_si, &unit, DIGITS, rounding)
        };
        format!(
            "{what} {went} by at most {} (mean {})",
            of("largest excess", one.largest_excess_si, Rounding::Up),
            of("mean excess", one.mean_excess_si, Rounding::Nearest)
        )
    };
    let told: Vec<String> = told.iter().map(excess).collect();
    format!("In {turns} ({runs}), {}.", listed(&told))
}

/// `the largest deviation of slider`; `the smallest value of force`.
fn extreme_words(one: &FurtherOutput, result: &StudyResult) -> String {
    let which = one.reduction.description().with_article;
    if one.of.is_value() {
        format!("{which} {} of {}", one.of.noun(), output_words(&one.output, &result.outputs))
    } else {
        format!("{which} {}", deviation_of(&one.output, one.of, &result.outputs))
    }
}

/// " None of these runs left the limit of slider later." Where an output has several limits, each is named.
fn broken_words(result: &StudyResult, further: &FurtherTurns, writer: &NumberWriter) -> String {
    let of_one = |(requirement, broken): (&RequirementOutcome, &Option<u64>)| {
        let output = &requirement.output;
        let is_alone = result.requirements.iter().filter(|other| other.output == *output).count() == 1;
        let limit = if is_alone {
            output.clone()
        } else {
            format!(
                "{output} ({}, {})",
                deviation_words(requirement.of),
                requirement_words(result, requirement, &output_unit(result, output), writer)
            )
        };
        let tag = Tag::requirement(requirement, "broken later");
        Some(match (*broken)? {
            0 => format!(" None of these runs left the limit of {limit} later."),
            more => format!(
                " {} of these runs left the limit of {limit} only in the further turns: over more turns, fewer mechanisms keep it than stated.",
                writer.with_tag(&tag).count(more)
            ),
        })
    };
    result.requirements.iter().zip(&further.broken_later).filter_map(of_one).collect()
}

/// Whether runs that kept a limit left it in later turns: the shares of the requirements are too large then.
pub(crate) fn is_broken_later(result: &StudyResult) -> bool {
    let broken = result.further_turns.iter().flat_map(|further| &further.broken_later);
    broken.flatten().any(|runs| *runs > 0)
}

/// A share of runs that were counted: all of them, or in percent without digits that pretend to more, and the count where it is near an end.
pub(crate) fn share_of_runs(share: f64, runs: u64, writer: &NumberWriter) -> String {
    const NEAR_AN_END: f64 = 0.01;
    let counted_runs = (share * runs as f64).round() as u64;
    if counted_runs == runs {
        return "all runs".to_owned();
    }
    if share < NEAR_AN_END || 1.0 - share < NEAR_AN_END {
        let of = counted(runs, "run", &writer.with_tag(&Tag::Count("finished runs")));
        let tag = writer.tag().map(|tag| tag.part("runs"));
        return format!("{} of the {of}", count(counted_runs, &writer.with_optional_tag(tag.as_ref())));
    }
    format!("{} of the runs", writer.percent(share, Rounding::Nearest))
}
