//! The mean, estimated over the finished runs.

use super::measure::{Estimator, Measure, Measured};
use crate::estimators::estimate::{Confidence, FailureExtremes, mean_of};
use crate::estimators::moments::{mean, mean_of_ordered};
use crate::estimators::ordered::Ordered;
use crate::estimators::replicates::differences;
use crate::estimators::sample::Sample;

/// The mean.
#[derive(Debug)]
pub(crate) struct Mean;

impl Estimator for Mean {
    fn measure(&self, samples: &[&Sample], confidence: &Confidence) -> Measure {
        let at = samples.iter().map(|sample| FailureExtremes::both(mean(sample, confidence)));
        Measure::plain(Self, at, confidence).with_replicates(differences(samples, |values, _| mean_of(values)))
    }

    fn work_out(&self, ordered: &Ordered<'_>, confidence: &Confidence) {
        mean_of_ordered(ordered, confidence);
    }

    fn averaged(&self) -> Option<Box<dyn Fn(f64) -> f64>> {
        Some(Box::new(|value| value))
    }
}

impl Measured for Mean {
    fn furthest(&self, [least, greatest]: [f64; 2], margin: f64) -> [f64; 2] {
        [least - margin, greatest + margin]
    }
}
