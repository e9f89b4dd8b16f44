//! The numerical error of an answer: how large it is, where it comes from, and what would reduce a large one.

use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::study::output_summary::{OutputSummary, largest, smallest};
use crate::study::place_sentence::asked_of_same;
use crate::words::bound::{error_found, has_no_end};
use crate::words::few_samples::too_few_samples;
use crate::words::wording::{capitalised, count, is_by_surrogate};
use loosepin_result::study::{BoundRecord, DeviationCurve, NumericalError, ResponsePoint, StudyResult};

/// From this share of the answer on an error is large.
const LARGE_SHARE: f64 = 0.1;
/// Largest multiple of the random samples that is advised: beyond it nobody would wait.
const MAX_TIMES: f64 = 100.0;

/// The numerical error of an answer in sentences.
pub(crate) struct ErrorWords {
    /// How large it is.
    pub size: String,
    /// What would reduce a large one, and the errors of other numbers; empty, or with a blank before it.
    pub further: String,
    /// Bounds that are not confirmed or have no end; empty, or with a blank before it.
    pub doubts: String,
}

impl ErrorWords {
    /// All of it.
    pub fn all(&self) -> String {
        format!("{}{}{}", self.size, self.further, self.doubts)
    }

    /// Its size, and what puts the answer in doubt.
    pub fn short(&self) -> String {
        format!("{}{}", self.size, self.doubts)
    }
}

pub(crate) fn error_words(result: &StudyResult, answers: &[OutputSummary<'_>], writer: &NumberWriter) -> ErrorWords {
    let mixed = || result.bounds.iter().filter(|bound| bound.treatment.is_mixed());
    let headline = answers.first();
    let error_text = headline.and_then(|summary| {
        let reduced = reduction_words(result, *summary, writer).unwrap_or_default();
        let of_several = (answers.len() > 1).then_some(("the first answer", "it"));
        let (error, (of, them), of_band) = match summary {
            OutputSummary::Bound(bound) => {
                let all = known_errors(result, bound);
                let is_of_finished_runs = |bound: &&BoundRecord| bound.guarantee.is_of_finished_runs();
                let of = match all.len() {
                    _ if all.iter().all(is_of_finished_runs) => ("the numbers over the finished runs", "them"),
                    1 => ("the bound", "it"),
                    _ => ("these numbers", "them"),
                };
                (largest_errors(&all, writer)?, of, None)
            }
            OutputSummary::Largest(..) | OutputSummary::Curve(_) => {
                let (error_si, unit) = summary.error_si().filter(|(error_si, _)| error_si.is_finite())?;
                let of_band = band_beside(result, *summary).map(|curve| {
                    let tag = Tag::curve(curve, "error");
                    writer.with_tag(&tag).error(curve.numerical_error_si, &curve.unit)
                });
                (writer.with_tag(&summary.error_tag()).error(error_si, unit), (summary.limit_words(), "it"), of_band)
            }
        };
        let (of, them) = of_several.unwrap_or((of, them));
        let of_band = of_band.map_or_else(String::new, |of_band| {
            format!(" The band at single angles has its own error, up to {of_band}, included in it.")
        });
        Some((format!("Numerical error of {of}: at most {error}, included in {them}."), reduced + &of_band))
    });
    let inner = mixed().filter(|bound| bound.guarantee.is_unconfirmed()).count();
    let endless = |bound: &&BoundRecord| [&bound.lower, &bound.upper].iter().any(|end| end.widened_si.is_infinite());
    let (size, further) = match error_text {
        Some((size, further)) if answers.len() > 1 => {
            (size, further + " The table of bounds shows those of the other answers, which are included as well.")
        }
        Some(error) => error,
        None if headline.is_some() && mixed().count() > 0 && mixed().all(|bound| endless(&bound)) => {
            ("A bound without an end has no numerical error.".to_owned(), String::new())
        }
        None => ("The table of bounds shows the numerical error of each of them.".to_owned(), String::new()),
    };
    let mut doubts = String::new();
    if inner > 0 {
        let is_answer = headline.is_some_and(|summary| summary.is_unconfirmed());
        let some = count(inner as u64, &writer.with_tag(&Tag::Count("unconfirmed bounds")));
        let all = count(mixed().count() as u64, &writer.with_tag(&Tag::Count("bounds")));
        let subject = match (is_answer, mixed().count()) {
            (true, _) if inner == 1 => "This answer".to_owned(),
            (true, _) => format!("{some} of {all} bounds, this answer included,"),
            (false, 1) => "The only bound".to_owned(),
            (false, _) => format!("{some} of {all} bounds"),
        };
        let them = if inner == 1 { "it" } else { "them" };
        let reason = if is_by_surrogate(result) {
            format!("direct runs do not confirm {them}")
        } else {
            "increase 'inner'".to_owned()
        };
        doubts.push_str(&format!(" {subject} may be too narrow: {reason}."));
    }
    let quantiles = mixed().filter(endless).filter_map(|bound| bound.statistic.probability_of_quantile());
    let quantiles: Vec<f64> = quantiles.collect();
    if let Some(reason) = too_few_samples(result, &quantiles, writer) {
        let all = mixed().count();
        let subject = match (quantiles.len(), all) {
            (_, 1) => "The only bound has".to_owned(),
            (some, _) => {
                let [some_words, all] = [(some, "bounds without an end"), (all, "bounds")]
                    .map(|(number, what)| count(number as u64, &writer.with_tag(&Tag::Count(what))));
                format!("{some_words} of {all} bounds {}", if some == 1 { "has" } else { "have" })
            }
        };
        doubts.push_str(&format!(" {subject} no end: {reason}."));
    }
    ErrorWords { size, further, doubts }
}

/// The bounds that the sentence on the number of `first` has, but for those whose error is not known.
fn known_errors<'r>(result: &'r StudyResult, first: &BoundRecord) -> Vec<&'r BoundRecord> {
    let mut all = asked_of_same(result, first);
    all.retain(|bound| {
        let is_known = bound.lower.error.total_si().max(bound.upper.error.total_si()).is_finite();
        is_known && (bound.guarantee.is_of_finished_runs() || !has_no_end(bound))
    });
    all
}

/// The largest error of all: of numbers in the unit of the output, and of probabilities, which have none. `None` where no error is known.
fn largest_errors(all: &[&BoundRecord], writer: &NumberWriter) -> Option<String> {
    let largest = |is_probability: bool| {
        let own = all.iter().filter(|bound| bound.statistic.is_probability() == is_probability);
        let size_si = |bound: &BoundRecord| bound.lower.error.total_si().max(bound.upper.error.total_si());
        own.max_by(|a, b| size_si(a).total_cmp(&size_si(b))).map(|bound| error_found(bound, writer))
    };
    match (largest(false), largest(true)) {
        (Some(error), Some(of_probabilities)) => Some(format!("{error} (probabilities {of_probabilities})")),
        (error, of_probabilities) => error.or(of_probabilities),
    }
}

/// The band over the cycle of the output that a limit over the whole cycle answers for: its error is another one.
fn band_beside<'r>(result: &'r StudyResult, summary: OutputSummary<'r>) -> Option<&'r DeviationCurve> {
    let OutputSummary::Largest(bound, _) = summary else { return None };
    let is_own = |curve: &&DeviationCurve| {
        (&curve.output, curve.of) == (&bound.output, bound.of)
            && !curve.mixed.lower_si.is_empty()
            && curve.numerical_error_si.is_finite()
    };
    result.curves.iter().find(is_own)
}

/// What would reduce the error of an answer, where it is large; `None` where it is small or has no end.
fn reduction_words(result: &StudyResult, summary: OutputSummary<'_>, writer: &NumberWriter) -> Option<String> {
    let (answer_si, error_si) = match summary {
        OutputSummary::Largest(bound, _) => (bound.upper.widened_si.abs(), bound.upper.error.total_si()),
        OutputSummary::Curve(curve) => {
            (largest(&curve.mixed.upper_si).max(-smallest(&curve.mixed.lower_si)), curve.numerical_error_si)
        }
        OutputSummary::Bound(bound) => {
            let all = known_errors(result, bound);
            let of_unit =
                || all.iter().filter(|own| own.statistic.is_probability() == bound.statistic.is_probability());
            let ends = || of_unit().flat_map(|bound| [&bound.lower, &bound.upper]);
            let answer_si = ends().map(|end| end.widened_si.abs()).fold(0.0, f64::max);
            (answer_si, ends().map(|end| end.error.total_si()).fold(0.0, f64::max))
        }
    };
    if !(error_si.is_finite() && error_si > LARGE_SHARE * answer_si) {
        return None;
    }
    halving_words(result, summary, writer).or_else(|| {
        Some(if is_by_surrogate(result) {
            " This is large: more training runs (training_runs), or direct = \"double-loop\", reduce it.".to_owned()
        } else if result.accuracy.is_some() {
            " This is large: a smaller accuracy, and a budget that allows it, reduce it.".to_owned()
        } else if result.counts.inner < 2 {
            " This is large: more values of the unknown inputs (outer) reduce it.".to_owned()
        } else {
            match largest_error(result, summary) {
                Some(error) if error.sampling_si > error.optimisation_si => {
                    " This is large: most of it comes from the random samples, and more of them (inner) reduce it.".to_owned()
                }
                Some(_) => {
                    " This is large: most of it comes from the search over the unknown values, and more of them (outer) reduce it."
                        .to_owned()
                }
                None => " This is large: more random samples (inner) and more values of the unknown inputs (outer) reduce it.".to_owned(),
            }
        })
    })
}

/// The largest error among the bounds of an answer.
fn largest_error(result: &StudyResult, summary: OutputSummary<'_>) -> Option<NumericalError> {
    match summary {
        OutputSummary::Largest(bound, _) => Some(bound.upper.error),
        OutputSummary::Bound(bound) => {
            let errors = known_errors(result, bound).into_iter().map(|own| larger(own.lower.error, own.upper.error));
            errors.reduce(larger)
        }
        OutputSummary::Curve(curve) => {
            let errors = bounds_of_curve(result, curve).map(|bound| larger(bound.lower.error, bound.upper.error));
            errors.filter(|error| error.total_si().is_finite()).reduce(larger)
        }
    }
}

fn larger(a: NumericalError, b: NumericalError) -> NumericalError {
    if b.total_si() > a.total_si() { b } else { a }
}

/// The bounds at the poses of a curve that are the ends of its band.
fn bounds_of_curve<'r>(result: &'r StudyResult, curve: &'r DeviationCurve) -> impl Iterator<Item = &'r BoundRecord> {
    result.bounds.iter().filter(|bound| {
        (&bound.output, bound.of) == (&curve.output, curve.of)
            && bound.treatment.is_mixed()
            && matches!(bound.at, ResponsePoint::Curve { .. })
            && bound.statistic.probability_of_quantile().is_some_and(|p| curve.probabilities.contains(&p))
    })
}

/// What would halve a large error: random samples, or nothing that more runs do. An answer here is a quantile, and its sampling error falls as
/// 1/sqrt(inner); that of the search over the unknown values falls with `outer` as the statistic is smooth, which is not known beforehand.
fn halving_words(result: &StudyResult, summary: OutputSummary<'_>, writer: &NumberWriter) -> Option<String> {
    // Where an accuracy was stated, the record of it tells.
    if is_by_surrogate(result) || result.accuracy.is_some() || result.counts.inner < 2 {
        return None;
    }
    let (bound, end, error) = furthest(result, summary)?;
    let total_si = error.total_si();
    if error.surrogate_si > 0.0 || !total_si.is_finite() {
        return None;
    }
    let (sampling_si, search_si) = (error.sampling_si, error.optimisation_si);
    let more = |times: f64| {
        let inner = ((result.counts.inner as f64 * times).ceil() as u64).next_power_of_two();
        let runs = result.counts.runs as f64 * inner as f64 / result.counts.inner as f64;
        let inner = count(inner, &writer.with_tag(&Tag::Count("random samples that would halve the error")));
        let runs = count(two_digits(runs), &writer.with_tag(&Tag::Count("runs that would halve the error")));
        (format!("about {runs} runs"), format!("set inner = {inner}"))
    };
    // sampling/sqrt(times) + search = (sampling + search)/2.
    let times = (2.0 * sampling_si / (sampling_si - search_si)).powi(2);
    if sampling_si > search_si && times <= MAX_TIMES {
        let (runs, setting) = more(times);
        return Some(format!(" {} halve it ({setting}).", capitalised(&runs)));
    }
    let part = |part: &str, error_si: f64| {
        writer.with_tag(&Tag::bound(bound, &format!("{end} error {part}"))).error(error_si, &bound.unit)
    };
    let mut words = format!(
        " Of this, {} comes from the search over the unknown values (a larger outer reduces it slowly)",
        part("search", search_si)
    );
    if sampling_si > LARGE_SHARE * total_si {
        let (runs, setting) = more(4.0);
        words.push_str(&format!(
            ", and {} from the random samples ({runs} halve this part: {setting})",
            part("sampling", sampling_si)
        ));
    }
    Some(words + ".")
}

/// A count of two digits, not below `runs`.
fn two_digits(runs: f64) -> u64 {
    let unit = 10_f64.powf((runs.log10() - 1.0).floor().max(0.0));
    ((runs / unit).ceil() * unit) as u64
}

/// The bound whose error is reported, which end of it, and the error.
fn furthest<'r>(
    result: &'r StudyResult,
    summary: OutputSummary<'r>,
) -> Option<(&'r BoundRecord, &'static str, NumericalError)> {
    match summary {
        OutputSummary::Largest(bound, _) => Some((bound, "upper", bound.upper.error)),
        // A statistic may be a probability, of which nobody knows how its error falls.
        OutputSummary::Bound(_) => None,
        OutputSummary::Curve(curve) => {
            let ends =
                |bound: &'r BoundRecord| [(bound, "lower", bound.lower.error), (bound, "upper", bound.upper.error)];
            let ends = bounds_of_curve(result, curve).flat_map(ends);
            let largest = ends.max_by(|(_, _, a), (_, _, b)| a.total_si().total_cmp(&b.total_si()));
            // Where the band is narrowed to the limit over the whole cycle, parts of what it was before are none of its error.
            largest.filter(|(_, _, error)| error.total_si() <= curve.numerical_error_si)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::two_digits;

    #[test]
    fn counts_that_are_advised_have_two_digits() {
        assert_eq!([66_688.0, 67_000.0, 8.0, 99.5, 99_100.0].map(two_digits), [67_000, 67_000, 8, 100, 100_000]);
    }
}
