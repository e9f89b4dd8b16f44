//! What narrower intervals gain: the study before and after, beside each other.

use super::compare::{NOTHING_IN_COMMON, compare_studies};
use super::number::{NumberWriter, Rounding};
use super::wording::{output_unit, response_words, statistic_words};
use loosepin_result::identification::{Gain, GainedBound};
use loosepin_result::study::{BoundRecord, ResponsePoint, StudyResult, Treatment};

/// Digits of a bound.
const DIGITS: usize = 4;

/// The bounds of the same study with its intervals before and after an identification.
pub fn identification_gain(before: &StudyResult, after: &StudyResult) -> Gain {
    let writer = NumberWriter::for_terminal(&before.display_units);
    let compared = compare_studies(before, after);
    let is_shown =
        |bound: &&BoundRecord| bound.treatment == Treatment::Mixed && !matches!(bound.at, ResponsePoint::Curve { .. });
    let is_same = |a: &BoundRecord, b: &BoundRecord| {
        a.output == b.output && a.of == b.of && a.at == b.at && a.statistic == b.statistic && a.reading == b.reading
    };
    let gained = |bound: &BoundRecord| {
        let other = after.bounds.iter().filter(is_shown).find(|other| is_same(bound, other))?;
        let ends = |bound: &BoundRecord| [bound.lower.widened_si, bound.upper.widened_si];
        Some(GainedBound {
            response: response_words(before, (&bound.output, bound.of, bound.at), &writer),
            statistic: statistic_words(bound.statistic, &output_unit(before, &bound.output), &writer),
            unit: bound.unit.clone(),
            is_probability: bound.statistic.is_probability(),
            before_si: ends(bound),
            after_si: ends(other),
        })
    };
    // On a terminal a space that does not break is one that cannot be searched for.
    let plain = |text: &String| text.replace('\u{a0}', " ");
    let bounds: Vec<GainedBound> = before.bounds.iter().filter(is_shown).filter_map(gained).collect();
    let headline = match bounds.first() {
        Some(first) if compared.headline == NOTHING_IN_COMMON => {
            let [a, b] = [first.before_si, first.after_si].map(|ends_si| bound_words(ends_si, first, &writer));
            format!("The {} of {} is {a} in A, {b} in B.", first.statistic, first.response)
        }
        _ => plain(&compared.headline),
    };
    Gain {
        headline,
        bands: compared.bands.iter().map(|band| plain(&format!("{}. {}", band.title, band.words))).collect(),
        bounds,
        runs: [before.counts.runs, after.counts.runs],
    }
}

/// Both ends of a bound, rounded outwards.
pub(super) fn bound_words(ends_si: [f64; 2], bound: &GainedBound, writer: &NumberWriter<'_>) -> String {
    let [lower, upper] = [(ends_si[0], Rounding::Down), (ends_si[1], Rounding::Up)].map(|(value_si, rounding)| {
        if bound.is_probability {
            writer.percent(value_si, rounding)
        } else {
            writer.rounded(value_si, &bound.unit, DIGITS, rounding)
        }
    });
    format!("{lower} to {upper}")
}

/// How much narrower a bound is; nothing where it is of one value.
pub(super) fn narrower_words(bound: &GainedBound, writer: &NumberWriter<'_>) -> String {
    let [before, after] = [bound.before_si, bound.after_si].map(|ends| ends[1] - ends[0]);
    if !(before > 0.0) || !after.is_finite() {
        return String::new();
    }
    let change = 1.0 - after / before;
    let side = if change >= 0.0 { "narrower" } else { "wider" };
    format!("{} {side}", writer.percent(change.abs(), Rounding::Nearest))
}
