//! Polynomials that have been fitted to a sample. Its values never change, so that no degree is fitted twice in all rounds.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::inner_basis::DesignMatrix;
use super::sample::Sample;

/// The fits of one sample, by their matrices. A copy begins without.
#[derive(Debug, Default)]
pub(super) struct KnownFits(Mutex<Vec<KnownFit>>);

#[derive(Debug)]
struct KnownFit {
    design: Arc<DesignMatrix>,
    largest_residual: f64,
    /// The sample with these polynomials, where it is kept.
    sample: Option<Arc<Sample>>,
}

impl KnownFits {
    /// The largest residual of the polynomials of `design`; else that of `find`, which is then kept.
    pub fn largest_residual(&self, design: &Arc<DesignMatrix>, find: impl FnOnce() -> f64) -> f64 {
        let known = self.list().iter().find(|own| Arc::ptr_eq(&own.design, design)).map(|own| own.largest_residual);
        known.unwrap_or_else(|| {
            let largest_residual = find();
            self.list().push(KnownFit { design: design.clone(), largest_residual, sample: None });
            largest_residual
        })
    }

    /// The sample with the polynomials of `design`, where it was kept.
    pub fn sample(&self, design: &Arc<DesignMatrix>) -> Option<Arc<Sample>> {
        self.list().iter().find(|own| Arc::ptr_eq(&own.design, design))?.sample.clone()
    }

    /// Keeps the sample with the polynomials of `design`, whose largest residual is this.
    pub fn keep(&self, design: &Arc<DesignMatrix>, largest_residual: f64, sample: Arc<Sample>) {
        let mut list = self.list();
        list.retain(|own| !Arc::ptr_eq(&own.design, design));
        list.push(KnownFit { design: design.clone(), largest_residual, sample: Some(sample) });
    }

    fn list(&self) -> MutexGuard<'_, Vec<KnownFit>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Clone for KnownFits {
    fn clone(&self) -> Self {
        Self::default()
    }
}
