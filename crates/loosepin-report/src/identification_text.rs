//! The answer of an identification for a terminal: readings, plays, sums that are fixed, what to measure next; or the misfit.

use super::identification_gain::{bound_words, narrower_words};
use super::motion_identification_text::push_motion;
use super::number::{NumberWriter, Rounding};
use super::terminal_table::{push_table, table, wrapped};
use loosepin_result::identification::{
    Combination, Consistent, Culprit, FurtherReading, Gain, Identification, Misfit, Outcome, PlayBounds, Searched,
    Specimen, TestReading,
};
use loosepin_text::units::{SiUnit, counted, listed};

/// Digits of a bound.
const DIGITS: usize = 4;
/// Digits of a factor.
const FACTOR_DIGITS: usize = 4;
/// Digits of an error.
const ERROR_DIGITS: usize = 2;

/// The answer as text.
pub fn identification_text(answer: &Identification) -> String {
    let writer = NumberWriter::for_terminal(&answer.display_units);
    let mut text = format!("{}\n", answer.study);
    for specimen in &answer.specimens {
        if let Some(name) = &specimen.name {
            text.push_str(&format!("\nSpecimen {name}\n"));
        }
        push_specimen(&mut text, specimen, &writer);
    }
    for specimen in &answer.motion {
        if let Some(name) = &specimen.name {
            text.push_str(&format!("\nSpecimen {name}, motion\n"));
        }
        push_motion(&mut text, specimen, &writer);
    }
    if let Some(gain) = &answer.gain {
        push_gain(&mut text, gain, &writer);
    }
    if !answer.specimens.is_empty() || answer.gain.is_some() {
        text.push('\n');
    }
    for sentence in grounds(answer, &writer) {
        text.push_str(&format!("{}\n", wrapped(&sentence, "- ")));
    }
    text
}

/// Appends the bounds of the study before and after.
fn push_gain(text: &mut String, gain: &Gain, writer: &NumberWriter<'_>) {
    text.push_str("\nThe study before (A) and after (B)\n\n");
    for sentence in std::iter::once(&gain.headline).chain(&gain.bands) {
        text.push_str(&format!("{}\n", wrapped(sentence, "- ")));
    }
    let mut table = table(&["of", "statistic", "before", "after", "change"], &[]);
    for bound in &gain.bounds {
        table.add_row(vec![
            bound.response.clone(),
            bound.statistic.clone(),
            bound_words(bound.before_si, bound, writer),
            bound_words(bound.after_si, bound, writer),
            narrower_words(bound, writer),
        ]);
    }
    push_table(text, &table);
}

fn push_specimen(text: &mut String, specimen: &Specimen, writer: &NumberWriter<'_>) {
    let readings = &specimen.readings;
    match &specimen.outcome {
        Outcome::Consistent(known) => {
            text.push_str(&format!("\n{}\n", wrapped(&headline(readings, known, writer), "")));
            push_table(text, &plays_table(&known.plays, writer));
            let sums: Vec<String> = known
                .combinations
                .iter()
                .filter(|sum| sum.weights.iter().filter(|weight| **weight != 0.0).count() > 1)
                .map(|sum| sum_words(sum, &known.plays, writer))
                .collect();
            if !sums.is_empty() {
                text.push_str("\nSums that the readings fix\n\n");
            }
            for sum in sums {
                text.push_str(&format!("{}\n", wrapped(&sum, "- ")));
            }
            let sentences = alike_words(known, readings).into_iter().chain(further_words(known, writer));
            let sentences: Vec<String> = sentences.collect();
            if !sentences.is_empty() {
                text.push_str("\nWhat to measure next\n\n");
            }
            for sentence in sentences {
                text.push_str(&format!("{}\n", wrapped(&sentence, "- ")));
            }
            text.push_str("\nReadings, and how much each play moves them\n");
            push_table(text, &readings_table(readings, writer));
            push_table(text, &factors_table(readings, &known.plays, writer));
        }
        Outcome::Misfit(misfit) => {
            let of_all = match readings.len() {
                1 => "the reading".to_owned(),
                count => format!("all {count} readings"),
            };
            text.push_str(&format!("\nMISFIT: no values of the plays explain {of_all}\n\n"));
            for sentence in misfit_words(misfit, readings, writer) {
                text.push_str(&format!("{}\n", wrapped(&sentence, "- ")));
            }
            text.push_str("\nReadings\n");
            push_table(text, &readings_table(readings, writer));
        }
    }
}

/// What became of the plays, in one sentence.
pub(super) fn headline(readings: &[TestReading], known: &Consistent, writer: &NumberWriter<'_>) -> String {
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

fn plays_table(plays: &[PlayBounds], writer: &NumberWriter<'_>) -> comfy_table::Table {
    let mut table = table(&["play", "before", "after", "fixed by itself", "narrowed"], &[]);
    for play in plays {
        let narrowed = match play.is_narrowed() {
            [true, true] => "both ends",
            [true, false] => "lower end",
            [false, true] => "upper end",
            [false, false] => "no",
        };
        table.add_row(vec![
            play.name.clone(),
            stated(play.before_si, &play.unit, writer),
            range(play.after_si, &play.unit, writer),
            if play.is_identifiable { "yes" } else { "no" }.to_owned(),
            narrowed.to_owned(),
        ]);
    }
    table
}

fn readings_table(readings: &[TestReading], writer: &NumberWriter<'_>) -> comfy_table::Table {
    let head = ["reading", "output", "drive", "push", "dead travel", "common error", "scatter", "allowed before"];
    let mut table = table(&head, &[2, 4, 5, 6]);
    for reading in readings {
        let unit = &reading.unit;
        let error = |error_si: f64| match error_si {
            0.0 => "none".to_owned(),
            error_si => format!("± {}", writer.rounded(error_si, unit, ERROR_DIGITS, Rounding::Up)),
        };
        table.add_row(vec![
            reading.name.clone(),
            reading.output.clone(),
            writer.value_trimmed(reading.pose_rad, &SiUnit::ANGLE),
            reading.push.clone(),
            writer.value(reading.dead_travel_si, unit),
            error(reading.common_error_si),
            error(reading.independent_error_si),
            range(reading.allowed_before_si, unit, writer),
        ]);
    }
    table
}

fn factors_table(readings: &[TestReading], plays: &[PlayBounds], writer: &NumberWriter<'_>) -> comfy_table::Table {
    let head: Vec<&str> = std::iter::once("reading")
        .chain(plays.iter().map(|play| play.name.as_str()))
        .chain(["contacts give"])
        .collect();
    let numbers: Vec<usize> = (1..=plays.len()).collect();
    let mut table = table(&head, &numbers);
    for reading in readings {
        let factor = |(factors, play): (&[f64; 3], &PlayBounds)| {
            let per = |factor: f64| {
                let is_plain = reading.unit == play.unit;
                let shown = if is_plain {
                    factor
                } else {
                    writer.scaled(factor, &reading.unit) / writer.scaled(1.0, &play.unit)
                };
                writer.rounded(shown, &SiUnit::NONE, FACTOR_DIGITS, Rounding::Nearest)
            };
            let unit = if reading.unit == play.unit {
                String::new()
            } else {
                format!(" {}/{}", writer.symbol(&reading.unit), writer.symbol(&play.unit))
            };
            if factors[0] == factors[2] {
                format!("{}{unit}", per(factors[1]))
            } else {
                format!("{} to {}{unit}", per(factors[0]), per(factors[2]))
            }
        };
        let mut row = vec![reading.name.clone()];
        row.extend(reading.factors.iter().zip(plays).map(factor));
        row.push(range_digits(reading.compliance_si, &reading.unit, ERROR_DIGITS, writer));
        table.add_row(row);
    }
    table
}

/// `crank_pin + 2 coupler_pin is 0.21 mm to 0.23 mm; 0.03 mm to 0.9 mm before`.
pub(super) fn sum_words(sum: &Combination, plays: &[PlayBounds], writer: &NumberWriter<'_>) -> String {
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

pub(super) fn alike_words(known: &Consistent, readings: &[TestReading]) -> Vec<String> {
    let which = if readings.len() == 1 { "the reading" } else { "every reading" };
    let of_group = |group: &Vec<usize>| {
        let is_equal = readings.iter().all(|reading| {
            let first = reading.factors[group[0]][1];
            group.iter().all(|play| (reading.factors[*play][1] - first).abs() <= 1e-6 * first.abs())
        });
        let how = if is_equal { "with the same factor" } else { "in the same proportion" };
        format!(
            "{} enter {which} {how}: no repeat of these readings tells them apart, only their sum is fixed",
            names(group, &known.plays)
        )
    };
    known.alike.iter().map(of_group).collect()
}

pub(super) fn further_words(known: &Consistent, writer: &NumberWriter<'_>) -> Vec<String> {
    let of_searched = |searched: Searched| {
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
        format!("{among} this would narrow most: {}", test_words(further, writer)),
        format!(
            "with an error of ± {} and a result in the middle of what is possible it would leave {}",
            writer.rounded(further.error_si, &further.unit, ERROR_DIGITS, Rounding::Up),
            listed(&widths, "and")
        ),
    ];
    if !further.has_output {
        words.push(format!("the model has no output for the {} yet: give it one", further.reads));
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

pub(super) fn misfit_words(misfit: &Misfit, readings: &[TestReading], writer: &NumberWriter<'_>) -> Vec<String> {
    let of_culprit = |culprit: &Culprit| {
        let reading = &readings[culprit.reading];
        let who = if culprit.is_alone { "the intervals of the study by themselves" } else { "the other readings" };
        format!(
            "'{}' says {}, and {who} leave {}, its common error included: {} apart",
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
            format!("{} and {} contradict each other, whatever the others say", name(*first), name(*second))
        };
        words.extend(misfit.pairs.iter().map(of_pair));
        let others = if misfit.pairs.is_empty() { ", and no two of them do so by themselves" } else { "" };
        words.push(format!("whichever single reading is left out, the others still contradict one another{others}"));
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
        "the nearest values are not given: they would explain nothing. A joint that is ideal in the model may have play, an interval of \
         the study may be too narrow, friction may be larger than stated, or a reading may be wrong"
            .to_owned(),
    );
    words
}

/// What the bounds rest on.
pub(super) fn grounds(answer: &Identification, writer: &NumberWriter<'_>) -> Vec<String> {
    let percent = writer.percent(answer.confidence, Rounding::Nearest);
    let of_motion = || {
        let scatter = "the scatter of the random inputs, independent errors and chaotic motion";
        format!("the set of a motion holds the true values with {percent} confidence over {scatter}")
    };
    if answer.specimens.is_empty() {
        return vec![of_motion()];
    }
    let readings = || answer.specimens.iter().flat_map(|specimen| &specimen.readings);
    let has_scatter = readings().any(|reading| reading.independent_error_si > 0.0);
    let has_random = !answer.random_inputs.is_empty();
    let inputs = counted(answer.random_inputs.len(), "random input");
    let mut words = vec![match (has_scatter, has_random) {
        (false, false) => "all bounds hold for every value within the stated errors".to_owned(),
        (true, false) => format!("all bounds hold together with {percent} confidence over the scatter of the readings"),
        (false, true) => format!("all bounds hold together with {percent} confidence over the {inputs}"),
        (true, true) => format!(
            "all bounds hold together with {percent} confidence over the scatter of the readings and the {inputs}; over everything else \
             they hold for every value"
        ),
    }];
    let share = readings().map(|reading| reading.linearisation_share).fold(0.0, f64::max);
    words.push(format!(
        "the exact loops differ from the linear model by at most {} % of the dead travel, found at the corners of the intervals and at the \
         bounds, and doubled; the bounds include it",
        writer.rounded(100.0 * share, &SiUnit::NONE, ERROR_DIGITS, Rounding::Up)
    ));
    if !answer.motion.is_empty() {
        words.push(of_motion());
    }
    if answer.specimens.len() > 1 {
        words.push("each specimen stands for itself: its plays and lengths are its own".to_owned());
    }
    words
}

/// An interval that was stated, in the fewest digits that tell it.
pub(super) fn stated(ends_si: [f64; 2], unit: &SiUnit, writer: &NumberWriter<'_>) -> String {
    format!("{} to {}", writer.value_shortest(ends_si[0], unit), writer.value_shortest(ends_si[1], unit))
}

pub(super) fn range(ends_si: [f64; 2], unit: &SiUnit, writer: &NumberWriter<'_>) -> String {
    range_digits(ends_si, unit, DIGITS, writer)
}

/// Both ends, rounded outwards.
fn range_digits(ends_si: [f64; 2], unit: &SiUnit, digits: usize, writer: &NumberWriter<'_>) -> String {
    let [lower, upper] = [(ends_si[0], Rounding::Down), (ends_si[1], Rounding::Up)];
    let shown = |(value_si, rounding): (f64, Rounding)| {
        if value_si == 0.0 { writer.value_trimmed(0.0, unit) } else { writer.rounded(value_si, unit, digits, rounding) }
    };
    format!("{} to {}", shown(lower), shown(upper))
}
