//! The summary of each output: one sentence each, the output that matters most first.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::study::place_sentence::{is_of_same, place_sentence};
use crate::study::subject::{Subject, subject};
use crate::words::failed::why_quantile_has_no_end;
use crate::words::few_samples::too_few_samples;
use crate::words::wording::output_words;
use loosepin_result::study::{BoundRecord, Deviation, DeviationCurve, Reduction, ResponsePoint, StudyResult, Verdict};
use loosepin_text::units::{SiUnit, distinct};

/// Digits of a bound in a sentence.
const SENTENCE_DIGITS: usize = 2;
/// Places of one output of which a sentence has the statistics, at most; the table has all.
const MAX_PLACES: usize = 3;
/// Further digits where both ends of a range are nearly the same, at most.
const MAX_MORE_DIGITS: f64 = 6.0;

/// The bound or the curve that answers for an output.
#[derive(Clone, Copy)]
pub(crate) enum OutputSummary<'r> {
    /// A quantile of the largest deviation, with its probability.
    Largest(&'r BoundRecord, f64),
    /// The band over the cycle.
    Curve(&'r DeviationCurve),
    /// Any other bound, the first of its number: the sentence has all that were asked for of this.
    Bound(&'r BoundRecord),
}

/// The summaries of outputs that have an answer: outputs whose requirement is not met first, then those whose requirement is undecided, then
/// the others; of these what holds over the whole cycle before curves, and both before other statistics; then in the order of the study.
pub(crate) fn output_summaries(result: &StudyResult) -> Vec<OutputSummary<'_>> {
    let rank = |name: &str| {
        let verdicts = result.requirements.iter().filter(|own| own.output == name).map(|own| own.verdict);
        verdicts.map(severity).min().unwrap_or(severity(Verdict::Met))
    };
    let asked = result.bounds.iter().map(|bound| &bound.output[..]);
    let names = distinct(asked.chain(result.curves.iter().map(|curve| &curve.output[..])));
    let mut summaries: Vec<OutputSummary<'_>> = names.into_iter().flat_map(|name| of_output(result, name)).collect();
    summaries.sort_by_key(|summary| (rank(summary.output()), summary.kind()));
    summaries
}

fn severity(verdict: Verdict) -> u8 {
    match verdict {
        Verdict::NotMet => 0,
        Verdict::Undecided => 1,
        Verdict::Promised | Verdict::Met => 2,
    }
}

/// What answers for an output: the total before its parts, the largest value over the cycle before the curve. Where neither was asked for: every
/// place at which statistics were asked for, with all of them.
fn of_output<'r>(result: &'r StudyResult, name: &str) -> Vec<OutputSummary<'r>> {
    let bounds = || result.bounds.iter().filter(|bound| bound.output == name && bound.treatment.is_mixed());
    let largest = || {
        let of_deviation = bounds().filter(|bound| !bound.of.is_value());
        of_deviation.filter_map(|bound| Some(OutputSummary::Largest(bound, probability_of_largest(bound)?)))
    };
    let curves = || result.curves.iter().filter(|curve| curve.output == name && !curve.mixed.lower_si.is_empty());
    let whole = || largest().chain(curves().map(OutputSummary::Curve));
    let total = whole().find(|summary| summary.of() == Deviation::of_all_causes());
    if let Some(summary) = total.or_else(|| whole().next()) {
        return vec![summary];
    }
    let mut firsts: Vec<&BoundRecord> = Vec::new();
    for bound in bounds() {
        if !firsts.iter().any(|first| is_of_same(first, bound)) {
            firsts.push(bound);
        }
    }
    firsts.into_iter().take(MAX_PLACES).map(OutputSummary::Bound).collect()
}

/// The first quantile of a largest total deviation that is asked for, with its probability.
pub(crate) fn main_bound(bounds: &[BoundRecord]) -> Option<(&BoundRecord, f64)> {
    let mut total = bounds.iter().filter(|bound| bound.treatment.is_mixed() && bound.of == Deviation::of_all_causes());
    total.find_map(|bound| Some((bound, probability_of_largest(bound)?)))
}

/// The probability of a bound that is a quantile, above the median and known, of the largest magnitude over the cycle.
fn probability_of_largest(bound: &BoundRecord) -> Option<f64> {
    let probability = bound.statistic.probability_of_quantile()?;
    let is_largest = bound.at == (ResponsePoint::Reduced { reduction: Reduction::largest_magnitude() });
    (is_largest && probability > 0.5 && bound.upper.widened_si.is_finite()).then_some(probability)
}

impl<'r> OutputSummary<'r> {
    /// Name of the output.
    pub fn output(self) -> &'r str {
        match self {
            Self::Largest(bound, _) | Self::Bound(bound) => &bound.output,
            Self::Curve(curve) => &curve.output,
        }
    }

    /// Which deviation of it.
    fn of(self) -> Deviation {
        match self {
            Self::Largest(bound, _) | Self::Bound(bound) => bound.of,
            Self::Curve(curve) => curve.of,
        }
    }

    fn kind(self) -> u8 {
        match self {
            Self::Largest(..) => 0,
            Self::Curve(_) => 1,
            Self::Bound(_) => 2,
        }
    }

    /// Its numerical error, with the unit; `None` of a bound that the table shows.
    pub fn error_si(self) -> Option<(f64, &'r SiUnit)> {
        match self {
            Self::Largest(bound, _) => Some((bound.upper.error.total_si(), &bound.unit)),
            Self::Curve(curve) => Some((curve.numerical_error_si, &curve.unit)),
            Self::Bound(_) => None,
        }
    }

    /// Tag of its numerical error.
    pub fn error_tag(self) -> Tag {
        match self {
            Self::Largest(bound, _) | Self::Bound(bound) => Tag::bound(bound, "upper error"),
            Self::Curve(curve) => Tag::curve(curve, "error"),
        }
    }

    /// Words for the bound of this error.
    pub fn limit_words(self) -> &'static str {
        match self {
            Self::Largest(..) => "the limit over the whole cycle",
            Self::Curve(_) => "the band over the cycle",
            Self::Bound(_) => "the bound",
        }
    }

    /// Whether it is a bound that nothing confirms.
    pub fn is_unconfirmed(self) -> bool {
        match self {
            Self::Largest(bound, _) | Self::Bound(bound) => bound.guarantee.is_unconfirmed(),
            Self::Curve(_) => false,
        }
    }

    /// The sentence.
    pub fn sentence(self, result: &StudyResult, writer: &NumberWriter) -> String {
        match self {
            Self::Largest(bound, probability) => largest_sentence(result, bound, probability, writer),
            Self::Curve(curve) => curve_sentence(result, curve, writer),
            Self::Bound(bound) => place_sentence(result, bound, writer),
        }
    }
}

fn largest_sentence(result: &StudyResult, bound: &BoundRecord, probability: f64, writer: &NumberWriter) -> String {
    let Subject { name, from, is_distance } = subject(result, &bound.output, bound.of);
    format!(
        "The {name} stays within {}{} {from} over the whole cycle in at least {} of mechanisms.",
        if is_distance { "" } else { "±" },
        writer.with_tag(&Tag::bound(bound, "upper")).for_sentence(
            bound.upper.widened_si,
            bound.upper.error.total_si(),
            &bound.unit,
            Rounding::Up
        ),
        writer.with_tag(&Tag::Given("probability")).percent(probability, Rounding::Down)
    )
}

fn curve_sentence(result: &StudyResult, curve: &DeviationCurve, writer: &NumberWriter) -> String {
    let (lowest, highest) = (smallest(&curve.mixed.lower_si), largest(&curve.mixed.upper_si));
    let magnitude = highest.abs().max(lowest.abs());
    let share = writer
        .with_tag(&Tag::Given("probability"))
        .percent(curve.probabilities[1] - curve.probabilities[0], Rounding::Nearest);
    let mixed = Tag::curve(curve, "mixed");
    let of_reach = mixed.part("reach");
    let reach =
        |writer: &NumberWriter| writer.for_sentence(magnitude, curve.numerical_error_si, &curve.unit, Rounding::Up);
    let drive = &result.cycle.drive;
    if !(lowest.is_finite() && highest.is_finite()) {
        let subject = output_words(&curve.output, &result.outputs);
        let reason = too_few_samples(result, &curve.probabilities, writer);
        let failed = || why_quantile_has_no_end(result, &curve.probabilities, writer).map(str::to_owned);
        let reason = reason.or_else(failed).unwrap_or_else(|| "some quantiles have none".to_owned());
        return format!("At each angle of {drive}, the {subject} has no bound: {reason}.");
    }
    let is_even = lowest < 0.0 && highest > 0.0 && (highest.abs() - lowest.abs()).abs() <= 0.1 * magnitude;
    let Subject { name, from, is_distance } = subject(result, &curve.output, curve.of);
    let range = if is_distance {
        format!("within {}", reach(&writer.with_tag(&of_reach)))
    } else if is_even && !curve.of.is_value() {
        format!("within ±{}", reach(&writer.with_tag(&of_reach)))
    } else {
        between(lowest, highest, &curve.unit, &writer.with_tag(&mixed))
    };
    let stays = if curve.of.is_value() { format!("lies {range}") } else { format!("stays {range} {from}") };
    format!("At each angle of {drive}, the {name} {stays} in at least {share} of mechanisms.")
}

/// Both ends, rounded outwards, with enough digits that rounding hardly widens the interval.
pub(crate) fn between(lowest_si: f64, highest_si: f64, unit: &SiUnit, writer: &NumberWriter) -> String {
    let more = (lowest_si.abs().max(highest_si.abs()) / (highest_si - lowest_si)).log10().floor();
    let digits = SENTENCE_DIGITS + if more.is_finite() { more.clamp(0.0, MAX_MORE_DIGITS) as usize } else { 0 };
    let [lowest, highest] = ["lowest", "highest"].map(|part| writer.tag().map(|tag| tag.part(part)));
    format!(
        "between {} and {}",
        writer.with_optional_tag(lowest.as_ref()).rounded(lowest_si, unit, digits, Rounding::Down),
        writer.with_optional_tag(highest.as_ref()).rounded(highest_si, unit, digits, Rounding::Up)
    )
}

pub(crate) fn smallest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}
