//! Percentiles of statistics that are themselves random, in words.

use super::bound_words::bound_value;
use super::number::{NumberWriter, Rounding};
use super::tag::{Tag, among_percentile};
use super::wording::output_unit;
use super::wording::{deviation_words, output_words, place_words, statistic_words};
use loosepin_result::study::{BoundRecord, ResponsePoint, StudyResult};

/// Note above the percentiles.
pub(super) const PERCENTILES_MEAN: &str = "The parameters of some distributions have distributions themselves, so each statistic is random. It stays below a \
     percentile with the probability of that percentile. If other inputs are unknown, each percentile has two bounds. Numerical errors are \
     included. All other numbers on this page hold for all values of such a parameter in its range.";

/// More statistics are left to `bounds.csv`.
const MOST_STATISTICS: usize = 20;

/// `5 %` as the name of a percentile.
pub(super) fn percentile_words(percentile: f64, writer: &NumberWriter) -> String {
    format!("{} percentile", writer.about(&Tag::Given("percentile")).percent(percentile, Rounding::Nearest))
}

/// One sentence for each statistic that is no point of a curve.
pub(super) fn percentile_sentences(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    let Some(first) = result.percentiles.first() else { return Vec::new() };
    let is_single = |(_, bound): &(usize, &BoundRecord)| !matches!(bound.at, ResponsePoint::Curve { .. });
    let sentence = |(index, bound): (usize, &BoundRecord)| {
        let parts = result.percentiles.iter().filter_map(|each| {
            let bound = each.bounds.get(index)?;
            let among = among_percentile(each.percentile);
            let of_bounds = writer.about(&among);
            Some(format!(
                "{} {} to {}",
                percentile_words(each.percentile, writer),
                bound_value(&bound.lower, bound, Rounding::Down, &of_bounds),
                bound_value(&bound.upper, bound, Rounding::Up, &of_bounds)
            ))
        });
        format!(
            "{} of {} ({}, {}): {}.",
            statistic_words(bound.statistic, &output_unit(result, &bound.output), writer),
            output_words(&bound.output, &result.outputs),
            deviation_words(bound.of),
            place_words(bound.at, writer),
            parts.collect::<Vec<String>>().join(", ")
        )
    };
    first.bounds.iter().enumerate().filter(is_single).take(MOST_STATISTICS).map(sentence).collect()
}
