//! The sentence on the statistics of one number of a run: where its mean lies, and how far mechanisms are from there.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::{Tag, same_wording};
use crate::study::subject::subject;
use crate::words::bound::{bound_value, has_no_end};
use crate::words::failed::{finished_words, why_no_end};
use crate::words::wording::{
    capitalised, deviation_of, deviation_words, listed, output_unit, output_words, path_part, place_words,
    statistic_words,
};
use loosepin_result::study::{BoundRecord, ResponsePoint, StudyResult};
use loosepin_text::units::SiUnit;

/// The share of mechanisms whose band is told where several can be made of the quantiles.
const USUAL_SHARE: f64 = 0.95;
/// Ends of a range are written to this share of its width, or to their error where it is larger.
const RESOLVED_SHARE: f64 = 0.05;
/// Digits of how far a band reaches beyond the means.
const REACH_DIGITS: usize = 2;
/// A band that reaches less than this share as far on one side of the means as on the other is told by its ends.
const EVEN_SHARE: f64 = 1.0 / 3.0;

/// Whether two bounds are of one number of a run.
pub(super) fn is_of_same(a: &BoundRecord, b: &BoundRecord) -> bool {
    (&a.output, a.of, a.at, a.treatment, a.reading) == (&b.output, b.of, b.at, b.treatment, b.reading)
}

/// All bounds of the number of a run that `first` is of, in the order of the study.
pub(crate) fn asked_of_same<'r>(result: &'r StudyResult, first: &BoundRecord) -> Vec<&'r BoundRecord> {
    result.bounds.iter().filter(|bound| is_of_same(bound, first)).collect()
}

/// The sentence on all statistics of the number of a run that `first` is of.
pub(super) fn place_sentence(result: &StudyResult, first: &BoundRecord, writer: &NumberWriter) -> String {
    let asked = asked_of_same(result, first);
    let is_pose = matches!(first.at, ResponsePoint::Pose { .. } | ResponsePoint::Curve { .. });
    let told = Told::of(&asked).filter(|_| is_pose || asked.len() > 1);
    match told {
        Some(told) => told.sentence(result, first, writer),
        None => listing(result, first, &asked, writer),
    }
}

/// Statistics that say where a number is and how far it scatters.
struct Told<'r> {
    mean: Option<&'r BoundRecord>,
    /// The quantiles that are nearest to the ends of the usual band, with their probabilities.
    low: Option<(&'r BoundRecord, f64)>,
    high: Option<(&'r BoundRecord, f64)>,
    standard_deviation: Option<&'r BoundRecord>,
    others: Vec<&'r BoundRecord>,
}

impl<'r> Told<'r> {
    /// `None` where neither a mean nor a quantile was asked for, and where a bound has no end: then the reason stands with it.
    fn of(asked: &[&'r BoundRecord]) -> Option<Self> {
        if asked.iter().any(|bound| has_no_end(bound) || bound.guarantee.is_of_finished_runs()) {
            return None;
        }
        let tail = 0.5 * (1.0 - USUAL_SHARE);
        let quantiles = || asked.iter().filter_map(|bound| Some((*bound, bound.statistic.probability_of_quantile()?)));
        let nearest = |side: fn(f64) -> bool, to: f64| {
            let distance = |(_, probability): &(&BoundRecord, f64)| (probability - to).abs();
            quantiles().filter(|(_, probability)| side(*probability)).min_by(|a, b| distance(a).total_cmp(&distance(b)))
        };
        let low = nearest(|probability| probability < 0.5, tail);
        let high = nearest(|probability| probability > 0.5, 1.0 - tail);
        let mean = asked.iter().copied().find(|bound| bound.statistic.is_mean());
        let standard_deviation = asked.iter().copied().find(|bound| bound.statistic.is_root_of_variance());
        if mean.is_none() && low.is_none() && high.is_none() {
            return None;
        }
        let known = [mean, standard_deviation, low.map(|(bound, _)| bound), high.map(|(bound, _)| bound)];
        let is_told = |bound: &&BoundRecord| known.iter().flatten().any(|known| std::ptr::eq(*known, *bound));
        let others = asked.iter().copied().filter(|bound| !is_told(bound)).collect();
        Some(Self { mean, low, high, standard_deviation, others })
    }

    fn sentence(&self, result: &StudyResult, first: &BoundRecord, writer: &NumberWriter) -> String {
        let place = place_words(first.at, writer);
        let is_pose = matches!(first.at, ResponsePoint::Pose { .. } | ResponsePoint::Curve { .. });
        let is_named = is_pose && path_part(&first.output, &result.outputs).is_none();
        // One quantile alone is no range that has a side.
        let has_range = self.mean.is_some() || self.low.is_some() && self.high.is_some();
        let is_beside_ideal = is_named && has_range && !first.of.is_value();
        let what = if is_beside_ideal || is_named && first.of.is_value() {
            subject(result, &first.output, first.of).name
        } else {
            deviation_of(&first.output, first.of, &result.outputs)
        };
        let head =
            if is_pose { format!("{}, the {what}", capitalised(&place)) } else { format!("The {what} ({place})") };
        let range = Range { is_beside_ideal, writer };
        let main = match self.mean {
            Some(mean) => format!("{head} is on average {}{}.", range.of_mean(mean), self.scatter(mean, &range)),
            None => self.without_mean(&head, &range),
        };
        let unit = output_unit(result, &first.output);
        let others: Vec<String> = self.others.iter().map(|bound| ends_sentence(result, bound, &unit, writer)).collect();
        if others.is_empty() { main } else { format!("{main} {}.", capitalised(&listed(&others))) }
    }

    /// How far mechanisms are from their mean, behind the words on it.
    fn scatter(&self, mean: &BoundRecord, range: &Range<'_>) -> String {
        match (self.low, self.high) {
            (Some((low, low_probability)), Some((high, high_probability))) => {
                let share = range.share(high_probability - low_probability);
                let beyond_si =
                    [mean.lower.widened_si - low.lower.widened_si, high.upper.widened_si - mean.upper.widened_si];
                let most_si = beyond_si[0].max(beyond_si[1]);
                if beyond_si.iter().all(|side_si| *side_si > EVEN_SHARE * most_si) {
                    let from = if range.is_point(mean) { "that" } else { "this range" };
                    let reach = range.reach(mean, most_si);
                    return format!(", and {share} of mechanisms lie within ±{reach} of {from}");
                }
                format!(", and {share} of mechanisms lie {}", range.of_ends(low, high))
            }
            (None, Some((high, probability))) => {
                let [most, share] = [range.upper(high), range.share(probability)];
                format!(", and {}at most {most} in {share} of mechanisms", range.signed_subject())
            }
            (Some((low, probability)), None) => {
                let [least, share] = [range.lower(low), range.share(1.0 - probability)];
                format!(", and {}at least {least} in {share} of mechanisms", range.signed_subject())
            }
            (None, None) => self.standard_deviation.map_or_else(String::new, |spread| {
                format!(", with a standard deviation of at most {}", range.upper(spread))
            }),
        }
    }

    fn without_mean(&self, head: &str, range: &Range<'_>) -> String {
        match (self.low, self.high) {
            (Some((low, low_probability)), Some((high, high_probability))) => format!(
                "{head} lies {} in at least {} of mechanisms.",
                range.of_ends(low, high),
                range.share(high_probability - low_probability)
            ),
            (Some((low, probability)), None) => {
                let [least, share] = [range.lower(low), range.share(1.0 - probability)];
                format!("{head} is at least {least} in at least {share} of mechanisms.")
            }
            (None, high) => high.map_or_else(String::new, |(high, probability)| {
                let [most, share] = [range.upper(high), range.share(probability)];
                format!("{head} is at most {most} in at least {share} of mechanisms.")
            }),
        }
    }
}

/// How the numbers of a sentence are written: ranges rounded outwards, and the side of the ideal value on which they lie.
struct Range<'w> {
    is_beside_ideal: bool,
    writer: &'w NumberWriter<'w>,
}

impl Range<'_> {
    /// Subject of a number with a sign, behind a range without.
    fn signed_subject(&self) -> &'static str {
        if self.is_beside_ideal { "the deviation is " } else { "" }
    }

    fn share(&self, share: f64) -> String {
        self.writer.with_tag(&Tag::Given("probability")).percent(share, Rounding::Down)
    }

    fn lower(&self, bound: &BoundRecord) -> String {
        bound_value(&bound.lower, bound, Rounding::Down, self.writer)
    }

    fn upper(&self, bound: &BoundRecord) -> String {
        bound_value(&bound.upper, bound, Rounding::Up, self.writer)
    }

    fn of_mean(&self, mean: &BoundRecord) -> String {
        self.of_ends(mean, mean)
    }

    /// Whether both ends of a bound read the same.
    fn is_point(&self, bound: &BoundRecord) -> bool {
        same_wording(&self.end(bound, 0, bound, 1.0), &self.end(bound, 1, bound, 1.0))
    }

    /// How far mechanisms are beyond the means.
    fn reach(&self, mean: &BoundRecord, reach_si: f64) -> String {
        let tag = Tag::bound(mean, "reach of the band beyond");
        self.writer.with_tag(&tag).rounded(reach_si, &mean.unit, REACH_DIGITS, Rounding::Up)
    }

    /// From the lower end of `low` to the upper end of `high`.
    fn of_ends(&self, low: &BoundRecord, high: &BoundRecord) -> String {
        let [low_si, high_si] = [low.lower.widened_si, high.upper.widened_si];
        let ends = |sign: f64| [self.end(low, 0, high, sign), self.end(high, 1, low, sign)];
        if !self.is_beside_ideal {
            let [from, to] = ends(1.0);
            return if same_wording(&from, &to) { from } else { format!("between {from} and {to}") };
        }
        let one_side = |from: &str, to: &str, side: &str| {
            let range = if same_wording(from, to) { from.to_owned() } else { format!("{from} to {to}") };
            format!("{range} {side} its ideal value")
        };
        if low_si >= 0.0 {
            let [from, to] = ends(1.0);
            one_side(&from, &to, "above")
        } else if high_si <= 0.0 {
            let [far, near] = ends(-1.0);
            one_side(&near, &far, "below")
        } else {
            let [below, above] = [self.end(low, 0, high, -1.0), self.end(high, 1, low, 1.0)];
            format!("between {below} below and {above} above its ideal value")
        }
    }

    /// The lower (0) or upper (1) end of `bound` times `sign`, rounded outwards of the range to the other end, that of `other`.
    fn end(&self, bound: &BoundRecord, end: usize, other: &BoundRecord, sign: f64) -> String {
        let ends = |bound: &'_ BoundRecord| [bound.lower.clone(), bound.upper.clone()];
        let (own, other) = (&ends(bound)[end], &ends(other)[1 - end]);
        let width_si = (own.widened_si - other.widened_si).abs();
        let resolved_si = own.error.total_si().max(RESOLVED_SHARE * width_si);
        let (name, rounding) = [("lower", Rounding::Down), ("upper", Rounding::Up)][end];
        // The distance from the ideal value has no sign, and is another number to whom compares them.
        let (part, rounding) = match (sign < 0.0, rounding) {
            (false, rounding) => (name.to_owned(), rounding),
            (true, Rounding::Down) => (format!("{name} distance"), Rounding::Up),
            (true, _) => (format!("{name} distance"), Rounding::Down),
        };
        let tag = Tag::bound(bound, &part);
        self.writer.with_tag(&tag).for_sentence(sign * own.widened_si, resolved_si, &bound.unit, rounding)
    }
}

/// A sentence on statistics of which each is told by itself.
fn listing(result: &StudyResult, first: &BoundRecord, asked: &[&BoundRecord], writer: &NumberWriter) -> String {
    let unit = output_unit(result, &first.output);
    let output = output_words(&first.output, &result.outputs);
    let place = format!("{}, {}", deviation_words(first.of), place_words(first.at, writer));
    if let [only] = asked {
        let words = statistic_words(only.statistic, &unit, writer);
        return format!("The {words} of {output} ({place}) {}.", ends_words(result, only, writer));
    }
    let parts: Vec<String> = asked.iter().map(|bound| ends_sentence(result, bound, &unit, writer)).collect();
    format!("For {output} ({place}), {}.", listed(&parts))
}

/// "the mean lies between 1 and 2 mm".
fn ends_sentence(result: &StudyResult, bound: &BoundRecord, unit: &SiUnit, writer: &NumberWriter) -> String {
    format!("the {} {}", statistic_words(bound.statistic, unit, writer), ends_words(result, bound, writer))
}

/// "lies between 1 and 2 mm", or "is 100 %" where both ends are shown as one number. An end that is infinite is none, and the reason stands
/// with it where failed runs are the reason.
fn ends_words(result: &StudyResult, bound: &BoundRecord, writer: &NumberWriter) -> String {
    let why = why_no_end(result, bound, writer).map_or_else(String::new, |why| format!(", since {why}"));
    if bound.guarantee.is_of_finished_runs() {
        let found = finished_words(bound, [" (over the finished runs it lies between ", " and "], writer);
        return format!("has no bound{why}{}", found.map_or_else(String::new, |found| found + ")"));
    }
    let lower = bound_value(&bound.lower, bound, Rounding::Down, writer);
    let upper = bound_value(&bound.upper, bound, Rounding::Up, writer);
    match (bound.lower.widened_si.is_infinite(), bound.upper.widened_si.is_infinite()) {
        (true, true) => return format!("has no bound{why}"),
        (false, true) => return format!("is at least {lower} and has no upper bound{why}"),
        (true, false) => return format!("is at most {upper} and has no lower bound{why}"),
        (false, false) => {}
    }
    if same_wording(&lower, &upper) { format!("is {lower}") } else { format!("lies between {lower} and {upper}") }
}
