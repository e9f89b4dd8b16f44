//! Cache of the results of a sample. Its values never change, so that nothing is worked out twice, in whatever round, for whatever answer
//! it is asked.

use std::sync::{Mutex, PoisonError};

use super::estimate::{Confidence, FailureExtremes};
use loosepin_terms::Statistic;

/// A query of a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SampleQuery {
    Mean,
    Variance,
    /// At this probability.
    Quantile(f64),
    /// A statistic that has no estimator of its own.
    Sampled(Statistic),
}

/// The result of a query.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SampleResult {
    pub estimate: FailureExtremes,
    /// Slope of a quantile over the probability.
    pub slope: f64,
}

/// All cached results of one sample. A copy begins without.
#[derive(Debug, Default)]
pub(crate) struct SampleCache(Mutex<Vec<(SampleQuery, Confidence, SampleResult)>>);

impl SampleCache {
    /// The cached result; else that of `find`, which is then kept. Where two threads ask at once both may look for it: they find the same.
    pub fn or_find(
        &self,
        asked: SampleQuery,
        confidence: &Confidence,
        find: impl FnOnce() -> SampleResult,
    ) -> SampleResult {
        if let Some(found) = self.get(asked, confidence) {
            return found;
        }
        let found = find();
        self.list().push((asked, *confidence, found));
        found
    }

    /// What has been found before.
    fn get(&self, asked: SampleQuery, confidence: &Confidence) -> Option<SampleResult> {
        let list = self.list();
        let own = list.iter().find(|(own, at, _)| *own == asked && at == confidence);
        own.map(|(.., found)| *found)
    }

    fn list(&self) -> std::sync::MutexGuard<'_, Vec<(SampleQuery, Confidence, SampleResult)>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Clone for SampleCache {
    fn clone(&self) -> Self {
        Self::default()
    }
}
