//! Contributions to the width of a band: random inputs by Sobol' indices, epistemic ones by pinching.

use serde::{Deserialize, Serialize};

use super::bound::{ResponsePoint, Witness};
use loosepin_terms::Deviation;
use loosepin_text::units::{SiUnit, extended};

/// The contributors to one question: a number, or a whole curve (`at` is then [`ResponsePoint::Whole`], and variances and widths
/// are added over its poses).
///
/// The band is that of the mixed treatment, from the least 2.5 % to the largest 97.5 % quantile over the epistemic inputs.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Contributors {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Place in the cycle.
    pub at: ResponsePoint,
    /// Unit of the output.
    pub unit: SiUnit,
    /// Width of the band; for a curve the mean over its poses.
    #[serde(with = "extended")]
    pub band_width_si: f64,
    /// Error of the width by the model of the quantiles over the epistemic inputs.
    #[serde(with = "extended")]
    pub band_width_error_si: f64,
    /// Values of the epistemic inputs at which indices were computed, the middle first.
    pub points: Vec<Witness>,
    /// Pairs of sample points at each of them; those left out, since a run has no value, over all of them.
    pub pairs: u64,
    /// Pairs left out over all points.
    pub left_out: u64,
    /// Confidence of the errors of indices.
    #[serde(with = "extended")]
    pub confidence: f64,
    /// Random inputs, largest part of the band first.
    pub random: Vec<RandomContributor>,
    /// Epistemic inputs, largest part of the band first; those that nobody can measure last.
    pub epistemic: Vec<EpistemicContributor>,
}

/// A share of the variance, at several values of the epistemic inputs.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct ShareRange {
    /// In the middle of the epistemic inputs.
    #[serde(with = "extended")]
    pub centre: f64,
    /// Half the width of its interval of confidence.
    #[serde(with = "extended")]
    pub error: f64,
    /// The least over the values that were tried, less its error, not below 0.
    #[serde(with = "extended")]
    pub lower: f64,
    /// The largest over the values that were tried, with its error, not above 1.
    #[serde(with = "extended")]
    pub upper: f64,
}

/// A random input, or several that are correlated.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct RandomContributor {
    /// Path, or paths of a correlated group.
    pub paths: Vec<String>,
    /// First-order index: the share of the variance that is its alone.
    pub first: ShareRange,
    /// Total index: the share of the variance that would go with it.
    pub total: ShareRange,
    /// The share of the band that would go if it did not scatter, 0 to 1: the scatter taken to shrink with the square root of the
    /// variance that is left.
    #[serde(with = "extended")]
    pub band_share: f64,
    /// Its share of the variance by the quasi-static answer without play, linear; `None` if there is no such answer.
    #[serde(with = "extended")]
    pub quasi_static_share: Option<f64>,
}

/// An epistemic input.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct EpistemicContributor {
    /// Path.
    pub path: String,
    /// The least and the largest share of the band that would go if its value were known, 0 to 1, over the values that it may turn
    /// out to have.
    #[serde(with = "extended")]
    pub band_share: [f64; 2],
    /// Error of both, by the model of the quantiles.
    #[serde(with = "extended")]
    pub error: f64,
    /// The share of its joint in the quasi-static worst case of all clearances; `None` for what is no clearance.
    #[serde(with = "extended")]
    pub quasi_static_share: Option<f64>,
    /// Whether a measurement can find its value. Where the pins sit in their play is another place at each instant: such an input is the last one.
    #[serde(default = "is_measurable", skip_serializing_if = "is_set")]
    pub can_be_measured: bool,
}

/// What is the case where nothing is said.
fn is_measurable() -> bool {
    true
}

/// Whether nothing has to be said.
fn is_set(value: &bool) -> bool {
    *value
}

impl RandomContributor {
    /// Whether `band_share` is estimated from the share of the variance by linear scatter without play: no runs gave a total index.
    pub fn is_linear_estimate(&self) -> bool {
        self.band_share.is_finite() && self.total.centre.is_nan()
    }
}

// Shares that no runs have shown are no numbers. Two records in which the same shares are missing are equal.

fn same(one: f64, other: f64) -> bool {
    one == other || (one.is_nan() && other.is_nan())
}

impl PartialEq for ShareRange {
    fn eq(&self, other: &Self) -> bool {
        let numbers = |range: &Self| [range.centre, range.error, range.lower, range.upper];
        numbers(self).into_iter().zip(numbers(other)).all(|(one, other)| same(one, other))
    }
}

impl PartialEq for RandomContributor {
    fn eq(&self, other: &Self) -> bool {
        (&self.paths, self.first, self.total) == (&other.paths, other.first, other.total)
            && same(self.band_share, other.band_share)
            && self.quasi_static_share == other.quasi_static_share
    }
}

impl PartialEq for EpistemicContributor {
    fn eq(&self, other: &Self) -> bool {
        let numbers = |input: &Self| [input.band_share[0], input.band_share[1], input.error];
        (&self.path, self.quasi_static_share, self.can_be_measured)
            == (&other.path, other.quasi_static_share, other.can_be_measured)
            && numbers(self).into_iter().zip(numbers(other)).all(|(one, other)| same(one, other))
    }
}

impl PartialEq for Contributors {
    fn eq(&self, other: &Self) -> bool {
        let numbers = |own: &Self| [own.band_width_si, own.band_width_error_si, own.confidence];
        (&self.output, self.of, &self.at, &self.unit) == (&other.output, other.of, &other.at, &other.unit)
            && numbers(self).into_iter().zip(numbers(other)).all(|(one, other)| same(one, other))
            && (&self.points, self.pairs, self.left_out) == (&other.points, other.pairs, other.left_out)
            && (&self.random, &self.epistemic) == (&other.random, &other.epistemic)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_that_are_missing_in_both_are_the_same() {
        let missing = ShareRange { centre: f64::NAN, error: f64::NAN, lower: f64::NAN, upper: f64::NAN };
        let own = |band_share| RandomContributor {
            paths: vec!["parameter.rod_length".to_owned()],
            first: missing,
            total: missing,
            band_share,
            quasi_static_share: None,
        };
        assert_eq!(own(0.25), own(0.25));
        assert_ne!(own(0.25), own(0.5));
        assert_ne!(own(0.25), own(f64::NAN));
        assert_ne!(missing, ShareRange { centre: 0.5, ..missing });
    }
}
