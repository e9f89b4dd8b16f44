//! Remaining range of the plays by readings of a rig, in sentences.

use super::ranges::{range, stated};
use crate::numbers::number::{NumberWriter, Rounding};
use loosepin_result::identification::{
    Combination, ConsistentPlays, FurtherReading, InconsistentReading, Misfit, PlayBounds, ReadingSearch, TestReading,
};
use loosepin_text::units::{SiUnit, counted, listed};

/// Digits of a factor.
const FACTOR_DIGITS: usize = 4;
/// Digits of an error.
const ERROR_DIGITS: usize = 2;

/// The result for the plays, in one sentence.
pub(super) fn headline(readings: &[TestReading], known: &ConsistentPlays, writer: &NumberWriter<'_>) -> String {
    let fixed = known.plays.iter().filter(|play| play.is_identifiable).count();
    let plays = known.plays.len();
    let fix = if readings.len() == 1 { "fixes" } else { "fix" };
    let readings = counted(readings.len(), "reading");
    match known.plays.as_slice() {
        [only] if fixed == 1 => {
            format!("{readings} {fix} the play of {}: {}.", only.name, range(only.after_si, &only.unit, writer))
        }
        _ if fixed == plays => format!("{readings} {fix} each of {plays} plays."),
        _ if fixed == 0 => {
            let sums = counted(known.combinations.len(), "sum");
            format!("{readings} {fix} {sums} of {plays} plays, and none of the plays by itself.")
        }
        _ => format!("{readings} {fix} {fixed} of {plays} plays; of the others only sums."),
    }
}

/// The sums of several plays that the readings fix.
pub(super) fn sums_words(known: &ConsistentPlays, writer: &NumberWriter<'_>) -> Vec<String> {
    let is_of_several = |sum: &&Combination| sum.weights.iter().filter(|weight| **weight != 0.0).count() > 1;
    let sums = known.combinations.iter().filter(is_of_several);
    sums.map(|sum| sum_words(sum, &known.plays, writer)).collect()
}

/// `crank_pin + 2 coupler_pin is 0.21 mm to 0.23 mm; 0.03 mm to 0.9 mm before`.
fn sum_words(sum: &Combination, plays: &[PlayBounds], writer: &NumberWriter<'_>) -> String {
    format!(
        "{} is {}; {} before",
        terms(&sum.weights, plays, writer),
        range(sum.after_si, &sum.unit, writer),
        stated(sum.before_si, &sum.unit, writer)
    )
}

fn terms(weights: &[f64], plays: &[PlayBounds], writer: &NumberWriter<'_>) -> String {
    let mut words = String::new();
    for (weight, play) in weights.iter().zip(plays).filter(|(weight, _)| **weight != 0.0) {
        let sign = match (words.is_empty(), *weight < 0.0) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let size = weight.abs();
        let factor = if size == 1.0 {
            String::new()
        } else {
            format!("{} ", writer.rounded(size, &SiUnit::NONE, FACTOR_DIGITS, Rounding::Nearest))
        };
        words.push_str(&format!("{sign}{factor}{}", play.name));
    }
    words
}

fn names(places: &[usize], plays: &[PlayBounds]) -> String {
    let names: Vec<String> = places.iter().map(|place| plays[*place].name.clone()).collect();
    listed(&names, "and")
}

/// Readings without further information, and readings that would narrow most.
pub(super) fn next_words(known: &ConsistentPlays, readings: &[TestReading], writer: &NumberWriter<'_>) -> Vec<String> {
    alike_words(known, readings).into_iter().chain(further_words(known, writer)).collect()
}

fn alike_words(known: &ConsistentPlays, readings: &[TestReading]) -> Vec<String> {
    let which = if readings.len() == 1 { "the reading" } else { "every reading" };
    let of_group = |group: &Vec<usize>| {
        let is_equal = readings.iter().all(|reading| {
            let first = reading.factors[group[0]][1];
            group.iter().all(|play| (reading.factors[*play][1] - first).abs() <= 1e-6 * first.abs())
        });
        let how = if is_equal { "with the same factor" } else { "in the same proportion" };
        format!(
            "{} enter {which} {how}: repeats of these readings cannot separate them; only their sum is determined",
            names(group, &known.plays)
        )
    };
    known.alike.iter().map(of_group).collect()
}

fn further_words(known: &ConsistentPlays, writer: &NumberWriter<'_>) -> Vec<String> {
    let of_searched = |searched: ReadingSearch| {
        format!("of the {} that looked best among {}", searched.in_full, counted(searched.candidates, "reading"))
    };
    let Some(further) = &known.further else {
        let none = |searched| {
            let among = of_searched(searched);
            format!("none {among} would narrow the plays by more than 5 %, with the errors of these readings")
        };
        return known.searched.map(none).into_iter().collect();
    };
    let among = known.searched.map_or_else(|| format!("of {}", counted(further.candidates, "reading")), of_searched);
    let widths: Vec<String> = known
        .plays
        .iter()
        .zip(&further.widths_si)
        .map(|(play, width_si)| {
            let now_si = play.after_si[1] - play.after_si[0];
            format!(
                "{} {} wide instead of {}",
                play.name,
                writer.rounded(*width_si, &play.unit, 3, Rounding::Up),
                writer.rounded(now_si, &play.unit, 3, Rounding::Up)
            )
        })
        .collect();
    let mut words = vec![
        format!("{among}, this reading would narrow the plays most: {}", test_words(further, writer)),
        format!(
            "with an error of ± {} and a result in the middle of the possible range, it would leave {}",
            writer.rounded(further.error_si, &further.unit, ERROR_DIGITS, Rounding::Up),
            listed(&widths, "and")
        ),
    ];
    if !further.has_output {
        words.push(format!("the model has no output for the {} yet: add one", further.reads));
    }
    words
}

/// A reading that could be made, in words.
fn test_words(further: &FurtherReading, writer: &NumberWriter<'_>) -> String {
    let push = match further.direction_rad {
        Some(direction_rad) => {
            format!("push {} along {}", further.pushed, writer.value_trimmed(direction_rad, &SiUnit::ANGLE))
        }
        None => format!("turn {} with a moment", further.pushed),
    };
    let pose = writer.value_trimmed(further.pose_rad, &SiUnit::ANGLE);
    format!("lock the drive at {pose}, {push}, read {}", further.reads)
}

/// Why no values of the plays explain the readings.
pub(super) fn misfit_words(misfit: &Misfit, readings: &[TestReading], writer: &NumberWriter<'_>) -> Vec<String> {
    let of_culprit = |culprit: &InconsistentReading| {
        let reading = &readings[culprit.reading];
        let who = if culprit.is_alone { "the intervals of the study alone" } else { "the other readings" };
        format!(
            "'{}' gives {}, but {who} permit {}, common error included: a gap of {}",
            reading.name,
            range(culprit.found_si, &reading.unit, writer),
            range(culprit.expected_si, &reading.unit, writer),
            writer.rounded(culprit.apart_si, &reading.unit, ERROR_DIGITS, Rounding::Nearest)
        )
    };
    let mut words: Vec<String> = misfit.culprits.iter().map(of_culprit).collect();
    if misfit.culprits.is_empty() {
        let name = |reading: usize| format!("'{}'", readings[reading].name);
        let of_pair = |[first, second]: &[usize; 2]| {
            format!("{} and {} contradict each other, whatever the other readings are", name(*first), name(*second))
        };
        words.extend(misfit.pairs.iter().map(of_pair));
        let others = if misfit.pairs.is_empty() { ", and no two of them alone do so" } else { "" };
        words.push(format!("without any single reading, the others still contradict one another{others}"));
    }
    if let Some(error_factor) = misfit.error_factor {
        let strained: Vec<String> =
            misfit.strained.iter().map(|reading| format!("'{}'", readings[*reading].name)).collect();
        let which =
            if strained.is_empty() { String::new() } else { format!("; it rests on {}", listed(&strained, "and")) };
        words.push(format!(
            "all errors would have to be {} times as large{which}",
            writer.rounded(error_factor, &SiUnit::NONE, 3, Rounding::Up)
        ));
    }
    words.push(
        "the nearest values are not shown, because they do not explain the readings. Possible reasons: a joint that is ideal in the model has play, an interval of the study is too narrow, friction is larger than stated, or a reading is wrong"
            .to_owned(),
    );
    words
}
