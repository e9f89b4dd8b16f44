//! Estimates as something to search.

use crate::data::direction::{Direction, extreme_point, range_of};
use crate::estimators::estimate::{Confidence, Estimate};
use crate::search::models::noise::Noise;
use crate::search::target::{SEARCH_RESOLUTION, Target, TargetKind};

/// A gain below this share of the sampling error at the extreme is not worth a point.
const SHARE_OF_SAMPLING_ERROR: f64 = 0.1;

/// Noise below this share of the range of a target is none: the search never resolves it, and models with noise need not be tried.
const NEGLIGIBLE_NOISE: f64 = 1e-9;

/// Estimates as something to search the extremes of.
pub(crate) fn target(estimates: &[Estimate], confidence: &Confidence) -> Target {
    let values: Vec<f64> = estimates.iter().map(|estimate| estimate.value).collect();
    let variances: Vec<f64> = estimates.iter().map(|estimate| estimate.variance(confidence)).collect();
    let noise_variance = noise_or_zero(finite_mean(&variances), &values);
    let least = (SEARCH_RESOLUTION * range(&values)).max(f64::MIN_POSITIVE);
    let resolutions = Direction::BOTH.map(|direction| {
        let error = extreme_point(&values, direction)
            .map_or(0.0, |point| 0.5 * (estimates[point].below + estimates[point].above));
        if error.is_finite() { (SHARE_OF_SAMPLING_ERROR * error).max(least) } else { least }
    });
    let noise = Noise { variance: noise_variance, replicates: Vec::new() };
    Target { values, kind: TargetKind::Plain, noise, resolutions }
}

/// The variance of noise among `values`, 0 where it is negligible.
pub(super) fn noise_or_zero(noise_variance: f64, values: &[f64]) -> f64 {
    if noise_variance.sqrt() > NEGLIGIBLE_NOISE * range(values) { noise_variance } else { 0.0 }
}

/// Distances to both ends of the confidence intervals.
pub(super) fn errors(estimates: &[Estimate]) -> Vec<(f64, f64)> {
    estimates.iter().map(|estimate| (estimate.below, estimate.above)).collect()
}

/// Mean of the finite values; 0 if there are none.
pub(super) fn finite_mean(values: &[f64]) -> f64 {
    let (sum, count) = values
        .iter()
        .filter(|value| value.is_finite())
        .fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}

/// Greatest less least of the finite values.
pub(super) fn range(values: &[f64]) -> f64 {
    let (low, high) = range_of(values.iter().copied().filter(|value| value.is_finite()));
    (high - low).max(0.0)
}
