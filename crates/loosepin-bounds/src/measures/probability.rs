//! The probability of an event: counted, or by its index where the response is smooth in the random inputs.

use super::margin::Margin;
use super::measure::{Estimator, Measure, Measured};
use super::smooth_probability::{SmoothProbability, index_target};
use super::targets::{errors, target};
use crate::estimators::estimate::{Confidence, Estimate};
use crate::estimators::probability::{ShareLimits, probability};
use crate::estimators::replicates::differences;
use crate::estimators::sample::Sample;
use loosepin_terms::Event;

/// Gain of a counted probability that is worth a point, at least.
const PROBABILITY_RESOLUTION: f64 = 1e-3;

/// The probability of this event.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Probability(pub Event);

impl Probability {
    /// [`Estimator::measure`] with `limits` that may be known from other events.
    pub fn measure_with(&self, samples: &[&Sample], confidence: &Confidence, limits: &ShareLimits) -> Measure {
        let event = self.0;
        let at = samples.iter().map(|sample| probability(sample, event, confidence, limits));
        let (low, high): (Vec<Estimate>, Vec<Estimate>) = at.map(|at| (at.low, at.high)).unzip();
        if let Some(target) = index_target(samples, event, &low, confidence) {
            let target_errors = vec![(0.0, 0.0); low.len()];
            return Measure { of: Box::new(SmoothProbability(event)), low, high, target_errors, target, margin: None };
        }
        let mut target = target(&low, confidence);
        target.resolutions = target.resolutions.map(|resolution| resolution.max(PROBABILITY_RESOLUTION));
        let margin = Margin::new(samples, event, confidence);
        let share =
            |values: &[f64], _| values.iter().filter(|&&value| event.holds(value)).count() as f64 / values.len() as f64;
        Measure { of: Box::new(*self), target_errors: errors(&low), low, high, target, margin }
            .with_replicates(differences(samples, share))
    }
}

impl Estimator for Probability {
    fn measure(&self, samples: &[&Sample], confidence: &Confidence) -> Measure {
        self.measure_with(samples, confidence, &ShareLimits::default())
    }

    fn averaged(&self) -> Option<Box<dyn Fn(f64) -> f64>> {
        let event = self.0;
        Some(Box::new(move |value| if event.holds(value) { 1.0 } else { 0.0 }))
    }
}

impl Measured for Probability {
    fn event(&self) -> Option<Event> {
        Some(self.0)
    }

    fn is_counted(&self) -> bool {
        true
    }

    fn limited(&self, value: f64) -> f64 {
        value.clamp(0.0, 1.0)
    }
}
