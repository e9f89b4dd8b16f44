//! Polynomials that have been fitted to a sample. Its values never change, so that a fit that is kept is not made again.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::inner_basis::DesignMatrix;

/// The fits of one sample, by their matrices; `S` is a sample with polynomials. A copy begins without.
#[derive(Debug)]
pub(super) struct KnownFits<S>(Mutex<Vec<KnownFit<S>>>);

#[derive(Debug)]
struct KnownFit<S> {
    design: Arc<DesignMatrix>,
    largest_residual: f64,
    /// The sample with these polynomials, where it is kept.
    sample: Option<Arc<S>>,
}

impl<S> KnownFits<S> {
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
    pub fn sample(&self, design: &Arc<DesignMatrix>) -> Option<Arc<S>> {
        self.list().iter().find(|own| Arc::ptr_eq(&own.design, design))?.sample.clone()
    }

    /// Keeps the sample with the polynomials of `design`, whose largest residual is this.
    pub fn keep(&self, design: &Arc<DesignMatrix>, largest_residual: f64, sample: Arc<S>) {
        let mut list = self.list();
        list.retain(|own| !Arc::ptr_eq(&own.design, design));
        list.push(KnownFit { design: design.clone(), largest_residual, sample: Some(sample) });
    }

    fn list(&self) -> MutexGuard<'_, Vec<KnownFit<S>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<S> Default for KnownFits<S> {
    fn default() -> Self {
        Self(Mutex::new(Vec::new()))
    }
}

impl<S> Clone for KnownFits<S> {
    fn clone(&self) -> Self {
        Self::default()
    }
}
