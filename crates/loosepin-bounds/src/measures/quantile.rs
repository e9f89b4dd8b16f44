//! A quantile, estimated by the order of the runs.

use super::measure::{Estimator, Measure, Measured};
use super::targets::noise_or_zero;
use crate::estimators::estimate::{Confidence, FailureExtremes};
use crate::estimators::ordered::Ordered;
use crate::estimators::quantile::{quantile_and_slope, quantile_of_ordered};
use crate::estimators::replicates::{differences_of_quantiles, variance_of_replicates};
use crate::estimators::sample::Sample;

/// The quantile at this probability.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Quantile(pub f64);

impl Estimator for Quantile {
    fn measure(&self, samples: &[&Sample], confidence: &Confidence) -> Measure {
        let found = samples.iter().map(|sample| quantile_and_slope(sample, confidence, self.0));
        let (at, slopes): (Vec<FailureExtremes>, Vec<f64>) = found.unzip();
        let mut measure = Measure::plain(*self, at.into_iter(), confidence);
        // Far out an interval has no end on one side: the noise is that of the replicates, where these are known.
        let replicates = differences_of_quantiles(samples, &measure.target.values, &slopes);
        // Stratified samples may have the same share below it in all replicates: that says nothing.
        if let Some(variance) = variance_of_replicates(&replicates).filter(|variance| *variance > 0.0) {
            measure.target.noise.variance = noise_or_zero(variance, &measure.target.values);
        }
        measure.with_replicates(replicates)
    }

    fn work_out(&self, ordered: &Ordered<'_>, confidence: &Confidence) {
        quantile_of_ordered(ordered, confidence, self.0);
    }
}

impl Measured for Quantile {
    fn furthest(&self, [least, greatest]: [f64; 2], margin: f64) -> [f64; 2] {
        [least - margin, greatest + margin]
    }
}
