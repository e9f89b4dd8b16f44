//! Quantiles that too few samples show: why a bound has no end, and how many samples it takes.

use crate::numbers::number::NumberWriter;
use crate::numbers::tag::Tag;
use crate::words::wording::{count, is_by_surrogate};
use loosepin_result::study::StudyResult;

/// Why quantiles at these probabilities have no end, and what to do, without a full stop; `None` if too few samples are not the reason.
pub(crate) fn too_few_samples(result: &StudyResult, quantiles: &[f64], writer: &NumberWriter) -> Option<String> {
    let needed = quantiles.iter().filter_map(|&probability| samples_needed(probability)).max()?;
    if is_by_surrogate(result) || needed <= result.counts.inner {
        return None;
    }
    let needed = count(needed.next_power_of_two(), &writer.with_tag(&Tag::Count("random samples needed")));
    Some(format!("too few samples lie beyond a quantile. Increase 'inner' to {needed} or more"))
}

/// Samples of which a quantile can be counted, with an end on both sides at the confidence of bounds: p^n = 0.005.
fn samples_needed(probability: f64) -> Option<u64> {
    const BEYOND: f64 = 0.005;
    let inside = probability.max(1.0 - probability);
    (inside < 1.0).then(|| (BEYOND.ln() / inside.ln()).ceil() as u64)
}
