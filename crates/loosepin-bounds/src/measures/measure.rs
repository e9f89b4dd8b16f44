//! A statistic at every outer point, and what the estimators of statistics have in common.

use std::fmt::Debug;

use super::margin::Margin;
use super::targets::{errors, target};
use crate::data::direction::Direction;
use crate::estimators::estimate::{Confidence, Estimate, FailureExtremes};
use crate::estimators::ordered::Ordered;
use crate::estimators::sample::Sample;
use crate::search::target::Target;
use loosepin_terms::Event;

/// How a statistic of one number follows from the runs at each outer point.
pub(crate) trait Estimator {
    /// Estimates it on the samples of all outer points.
    fn measure(&self, samples: &[&Sample], confidence: &Confidence) -> Measure;

    /// Works out what it needs of one sample, which keeps it.
    fn work_out(&self, _ordered: &Ordered<'_>, _confidence: &Confidence) {}

    /// f where the statistic is the mean of f(Y).
    fn averaged(&self) -> Option<Box<dyn Fn(f64) -> f64>> {
        None
    }
}

/// A measured quantity: its relation to the target that is searched for it, and its possible range. What is left out has the answer of a
/// statistic that is its own target and has no limit.
pub(crate) trait Measured: Debug + Send + Sync {
    /// The event whose probability it is.
    fn event(&self) -> Option<Event> {
        None
    }

    /// Whether runs are counted, so that it is flat where all of them are on one side: its margin says what lies beyond.
    fn is_counted(&self) -> bool {
        false
    }

    /// `value` moved into the range that the statistic can have at all.
    fn limited(&self, value: f64) -> f64 {
        value
    }

    /// The statistic where its target has this value.
    fn statistic_of(&self, target: f64) -> f64 {
        self.limited(target)
    }

    /// The statistic at a point as it is compared with all others: by its `target`, smoothed, or by its `estimate` there.
    fn compared(&self, target: f64, _estimate: f64) -> f64 {
        target
    }

    /// The statistic where the target, which is `attained` where the statistic is `value`, goes to `most`.
    fn reached(&self, _value: f64, _attained: f64, most: f64) -> f64 {
        most
    }

    /// The least and the greatest value of it where all responses lie between these two, with a `margin`.
    fn furthest(&self, _responses: [f64; 2], _margin: f64) -> [f64; 2] {
        [f64::NEG_INFINITY, f64::INFINITY]
    }
}

/// A statistic at every outer point.
#[derive(Debug)]
pub(crate) struct Measure {
    /// The measured quantity.
    pub of: Box<dyn Measured>,
    /// With every failed run taken as low as possible, and as high as possible.
    pub low: Vec<Estimate>,
    pub high: Vec<Estimate>,
    /// Errors of the target's values, downwards and upwards.
    pub target_errors: Vec<(f64, f64)>,
    /// Quantity that is searched: the statistic itself, or one that is smooth where the statistic is not.
    pub target: Target,
    /// Margin of counted probabilities: it has a slope where the probability is flat at 0 or 1.
    pub margin: Option<Margin>,
}

impl Measure {
    /// A statistic that is its own target.
    pub fn plain(
        of: impl Measured + 'static,
        at: impl Iterator<Item = FailureExtremes>,
        confidence: &Confidence,
    ) -> Self {
        let (low, high): (Vec<Estimate>, Vec<Estimate>) = at.map(|at| (at.low, at.high)).unzip();
        let (target, target_errors) = (target(&low, confidence), errors(&low));
        Self { of: Box::new(of), low, high, target_errors, target, margin: None }
    }

    /// This with what the replicates of the sample say of the target; unchanged if no noise is seen.
    pub fn with_replicates(mut self, replicates: Vec<Vec<f64>>) -> Self {
        if self.target.noise.variance > 0.0 {
            self.target.noise.replicates = replicates;
        }
        self
    }

    /// The estimates for the end in `direction`.
    pub fn estimates(&self, direction: Direction) -> &[Estimate] {
        direction.of(&self.low, &self.high)
    }

    /// All that is searched for its extremes.
    pub fn targets(&self) -> impl Iterator<Item = &Target> {
        [Some(&self.target), self.margin.as_ref().map(|margin| &margin.target)].into_iter().flatten()
    }

    /// [`Self::targets`], to be kept.
    pub fn into_targets(self) -> Vec<Target> {
        [Some(self.target), self.margin.map(|margin| margin.target)].into_iter().flatten().collect()
    }
}
