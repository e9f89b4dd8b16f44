//! A statistic of which no more is known than its value for a sample, and for each replicate.

use super::measure::{Estimator, Measure, Measured};
use crate::estimators::estimate::{Confidence, FailureExtremes};
use crate::estimators::ordered::Ordered;
use crate::estimators::replicates::differences;
use crate::estimators::sample::Sample;
use crate::estimators::sampled::{sampled, sampled_of_ordered};
use loosepin_math::in_order;
use loosepin_terms::Statistic;

/// A statistic that has no estimator of its own; it lies where it states that it does.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sampled(pub Statistic);

impl Estimator for Sampled {
    fn measure(&self, samples: &[&Sample], confidence: &Confidence) -> Measure {
        let at = samples.iter().map(|sample| FailureExtremes::both(sampled(sample, self.0, confidence)));
        let of = |values: &[f64], _| self.0.of_sorted(&in_order(values.iter().copied()));
        Measure::plain(*self, at, confidence).with_replicates(differences(samples, of))
    }

    fn work_out(&self, ordered: &Ordered<'_>, confidence: &Confidence) {
        sampled_of_ordered(ordered, self.0, confidence);
    }
}

impl Measured for Sampled {
    fn limited(&self, value: f64) -> f64 {
        let [least, greatest] = self.0.range();
        value.clamp(least, greatest)
    }

    fn furthest(&self, responses: [f64; 2], margin: f64) -> [f64; 2] {
        let [least, greatest] = self.0.range_within(responses);
        [least - margin, greatest + margin]
    }
}
