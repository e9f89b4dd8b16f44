//! Motions that do not repeat themselves: how many, and how much further they go in later turns.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{count, counted, deviation_of, listed, output_unit, output_words};
use loosepin_result::study::{Deviation, FurtherOutput, FurtherTurns, Reduction, RequirementOutcome, StudyResult};

/// Outputs that are shown; all of them are in the files.
const MAX_TOLD: usize = 3;
/// Digits of what later turns add.
const DIGITS: usize = 2;

/// That motions differ from turn to turn, and what that does; `None` if all repeat themselves.
pub(crate) fn turns_sentence(result: &StudyResult, writer: &NumberWriter) -> Option<String> {
    let share = result.settled_share.filter(|share| *share < 1.0)?;
    let finished = result.counts.runs - result.counts.failed;
    let runs = share_of_runs(1.0 - share, finished, &writer.with_tag(&Tag::whole("settled", "not")));
    let first = format!("In {runs} the motion does not repeat itself from turn to turn");
    Some(match &result.further_turns {
        None => format!(
            "{first}: other turns than the recorded ones may deviate more. Record more turns (recorded_turns) to see how much."
        ),
        Some(further) => {
            format!("{first}. {}{}", excess_words(result, further, writer), broken_words(result, further, writer))
        }
    })
}

/// "64 of these runs were continued for 5 turns. They exceed the largest deviation of slider by 0.03 mm on average and 0.1 mm at most."
fn excess_words(result: &StudyResult, further: &FurtherTurns, writer: &NumberWriter) -> String {
    let turns = counted(u64::from(further.turns), "turn", &writer.with_tag(&Tag::Given("further turns")));
    let runs = count(further.runs, &writer.with_tag(&Tag::Count("continued runs")));
    let mut told: Vec<&FurtherOutput> = Vec::new();
    // Parts of a deviation are in the files.
    let (whole, parts): (Vec<_>, Vec<_>) =
        further.outputs.iter().partition(|one| matches!(one.of, Deviation::Value | Deviation::Total));
    for one in whole.into_iter().chain(parts) {
        if told.len() < MAX_TOLD && !told.iter().any(|known| known.output == one.output) {
            told.push(one);
        }
    }
    let [were, they, exceed, do_not] = match further.runs {
        1 => ["was", "It", "exceeds", "does not"],
        _ => ["were", "They", "exceed", "do not"],
    };
    let exceeds = |one: &&FurtherOutput| {
        let unit = output_unit(result, &one.output);
        let what = extreme_words(one, result);
        if !(one.largest_excess_si > 0.0) {
            return format!("{do_not} exceed {what}");
        }
        let of = |part: &str, value_si: f64, rounding| {
            writer.with_tag(&Tag::further_turns(one, part)).rounded(value_si, &unit, DIGITS, rounding)
        };
        format!(
            "{exceed} {what} by {} on average and {} at most",
            of("mean excess", one.mean_excess_si, Rounding::Nearest),
            of("largest excess", one.largest_excess_si, Rounding::Up)
        )
    };
    let told: Vec<String> = told.iter().map(exceeds).collect();
    format!("{runs} of these runs {were} continued for {turns}. {they} {}.", listed(&told))
}

/// `the largest deviation of slider`; `the smallest value of force`.
fn extreme_words(one: &FurtherOutput, result: &StudyResult) -> String {
    let which = match one.reduction {
        Reduction::Maximum | Reduction::MaximumAbsolute => "the largest",
        Reduction::Minimum => "the smallest",
        Reduction::Range => "the peak-to-peak",
        Reduction::RootMeanSquare | Reduction::Mean => "the mean",
    };
    match one.of {
        Deviation::Value => format!("{which} value of {}", output_words(&one.output, &result.outputs)),
        of => format!("{which} {}", deviation_of(&one.output, of, &result.outputs)),
    }
}

/// " None of them leaves the limit of slider only then."
fn broken_words(result: &StudyResult, further: &FurtherTurns, writer: &NumberWriter) -> String {
    let of_one = |(requirement, broken): (&RequirementOutcome, &Option<u64>)| {
        let tag = Tag::requirement(requirement, "broken later");
        let (who, leaves) = match (*broken)? {
            0 => ("None".to_owned(), "leaves"),
            1 => (writer.with_tag(&tag).count(1), "leaves"),
            more => (writer.with_tag(&tag).count(more), "leave"),
        };
        Some(format!(" {who} of them {leaves} the limit of {} only in these turns.", requirement.output))
    };
    result.requirements.iter().zip(&further.broken_later).filter_map(of_one).collect()
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
