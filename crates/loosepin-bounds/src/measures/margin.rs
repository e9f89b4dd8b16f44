//! The margin of a counted probability: it guides the search where no run counts, or every run.

use super::targets::{finite_mean, range};
use crate::estimators::estimate::{Confidence, Estimate, mean_of};
use crate::estimators::moments::{mean, variance};
use crate::estimators::replicates::differences;
use crate::estimators::sample::Sample;
use crate::search::models::noise::Noise;
use crate::search::target::{Target, TargetKind};
use loosepin_terms::Event;

/// The distance of a column's mean from a limit, in its standard deviations; grows with the probability of the event.
///
/// ```text
/// above: (m - L)/s   below, up to: (L - m)/s   beyond: (m² - L²)/(D s), D = L + max |m|
/// ```
///
/// where s² = deviation² + (1e-3 of the range of m and the largest deviation together)², so that it exists for a response that does
/// not scatter.
#[derive(Debug)]
pub(crate) struct Margin {
    pub target: Target,
    event: Event,
    means: Vec<f64>,
    spreads: Vec<f64>,
    size: f64,
}

impl Margin {
    /// The margin of the probability of `event`; `None` if no run scatters and no mean differs.
    pub fn new(samples: &[&Sample], event: Event, confidence: &Confidence) -> Option<Self> {
        let estimates: Vec<Estimate> = samples.iter().map(|sample| mean(sample, confidence)).collect();
        let means: Vec<f64> = estimates.iter().map(|estimate| estimate.value).collect();
        let deviations: Vec<f64> =
            samples.iter().map(|sample| variance(sample, confidence).value.max(0.0).sqrt()).collect();
        let range = range(&means) + deviations.iter().fold(0.0, |most: f64, deviation| most.max(*deviation));
        if range <= 0.0 || !range.is_finite() {
            return None;
        }
        let least = 1e-3 * range;
        let spreads: Vec<f64> =
            deviations.iter().map(|deviation| (deviation * deviation + least * least).sqrt()).collect();
        let largest = means.iter().filter(|mean| mean.is_finite()).fold(0.0, |most: f64, mean| most.max(mean.abs()));
        let size = match event {
            Event::Beyond(limit) => limit + largest,
            _ => 1.0,
        };
        let values: Vec<f64> = means
            .iter()
            .zip(&spreads)
            .map(|(mean, spread)| match event {
                Event::Above(limit) => (mean - limit) / spread,
                Event::Below(limit) | Event::UpTo(limit) => (limit - mean) / spread,
                Event::Beyond(limit) => (mean * mean - limit * limit) / (size * spread),
            })
            .collect();
        let noise: Vec<f64> = estimates
            .iter()
            .zip(&spreads)
            .map(|(estimate, spread)| estimate.variance(confidence) / (spread * spread))
            .collect();
        let nearest =
            values.iter().filter(|value| value.is_finite()).fold(f64::INFINITY, |least, value| least.min(value.abs()));
        // Far from the limit a change of the margin changes next to nothing.
        let resolutions = [0.02 * (1.0 + nearest * nearest); 2];
        let of_mean = differences(samples, |values, point| mean_of(values) / spreads[point]);
        let noise = Noise { variance: finite_mean(&noise), replicates: of_mean };
        let target = Target { values, kind: TargetKind::Plain, noise, resolutions };
        Some(Self { target, event, means, spreads, size })
    }

    /// Shift of the sample at `point` that makes its margin equal to `margin`.
    pub fn shift(&self, point: usize, margin: f64) -> f64 {
        let (mean, spread) = (self.means[point], self.spreads[point]);
        match self.event {
            Event::Above(limit) => limit + margin * spread - mean,
            Event::Below(limit) | Event::UpTo(limit) => limit - margin * spread - mean,
            Event::Beyond(limit) => {
                let magnitude = (limit * limit + margin * self.size * spread).max(0.0).sqrt();
                if mean < 0.0 { -magnitude - mean } else { magnitude - mean }
            }
        }
    }
}
