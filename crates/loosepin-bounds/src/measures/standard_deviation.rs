//! The standard deviation, by way of the variance: that is smooth where the deviation vanishes.

use super::measure::{Estimator, Measure, Measured};
use super::targets::{errors, target};
use crate::estimators::estimate::{Confidence, Estimate, standard_deviation};
use crate::estimators::moments::{mean, mean_of_ordered, variance, variance_of_ordered};
use crate::estimators::ordered::Ordered;
use crate::estimators::replicates::differences;
use crate::estimators::sample::Sample;

/// The standard deviation. Its target is its square.
#[derive(Debug)]
pub(crate) struct StandardDeviation;

impl Estimator for StandardDeviation {
    fn measure(&self, samples: &[&Sample], confidence: &Confidence) -> Measure {
        let variances: Vec<Estimate> = samples.iter().map(|sample| variance(sample, confidence)).collect();
        let at: Vec<Estimate> = variances.iter().copied().map(standard_deviation).collect();
        let (target, target_errors) = (target(&variances, confidence), errors(&variances));
        let means: Vec<f64> = samples.iter().map(|sample| mean(sample, confidence).value).collect();
        let square = |values: &[f64], point: usize| {
            values.iter().map(|y| (y - means[point]) * (y - means[point])).sum::<f64>() / values.len() as f64
        };
        Measure { of: Box::new(Self), low: at.clone(), high: at, target_errors, target, margin: None }
            .with_replicates(differences(samples, square))
    }

    fn work_out(&self, ordered: &Ordered<'_>, confidence: &Confidence) {
        mean_of_ordered(ordered, confidence);
        variance_of_ordered(ordered, confidence);
    }
}

impl Measured for StandardDeviation {
    fn limited(&self, value: f64) -> f64 {
        value.max(0.0)
    }

    fn statistic_of(&self, target: f64) -> f64 {
        target.max(0.0).sqrt()
    }

    fn compared(&self, target: f64, _estimate: f64) -> f64 {
        self.statistic_of(target)
    }

    fn reached(&self, _value: f64, _attained: f64, most: f64) -> f64 {
        self.statistic_of(most)
    }

    /// Half of the range at most.
    fn furthest(&self, [least, greatest]: [f64; 2], margin: f64) -> [f64; 2] {
        [0.0, 0.5 * (greatest - least) + margin]
    }
}
