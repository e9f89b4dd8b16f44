//! Polynomials that have been fitted to a sample. Its values never change, so that a fit that is kept is not made again.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::inner_basis::DesignMatrix;

/// Quality of a fit with polynomials of its degree.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Assessment {
    /// Largest residual at any run.
    pub largest_residual: f64,
    /// An error of the mean that degrees are compared by.
    pub error: f64,
}

/// The fits of one sample, by their matrices; `S` is a sample with polynomials. A copy begins without.
#[derive(Debug)]
pub(crate) struct FitCache<S>(Mutex<Vec<CachedFit<S>>>);

#[derive(Debug)]
struct CachedFit<S> {
    design: Arc<DesignMatrix>,
    assessment: Assessment,
    /// The sample with these polynomials, where it is kept.
    sample: Option<Arc<S>>,
}

impl<S> FitCache<S> {
    /// The assessment of the polynomials of `design`; else that of `find`, which is then kept.
    pub fn assessment(&self, design: &Arc<DesignMatrix>, find: impl FnOnce() -> Assessment) -> Assessment {
        let known = self.list().iter().find(|own| Arc::ptr_eq(&own.design, design)).map(|own| own.assessment);
        known.unwrap_or_else(|| {
            let assessment = find();
            self.list().push(CachedFit { design: design.clone(), assessment, sample: None });
            assessment
        })
    }

    /// The sample with the polynomials of `design`, where it was kept.
    pub fn sample(&self, design: &Arc<DesignMatrix>) -> Option<Arc<S>> {
        self.list().iter().find(|own| Arc::ptr_eq(&own.design, design))?.sample.clone()
    }

    /// Keeps the sample with the polynomials of `design`, of which this is known.
    pub fn keep(&self, design: &Arc<DesignMatrix>, assessment: Assessment, sample: Arc<S>) {
        let mut list = self.list();
        list.retain(|own| !Arc::ptr_eq(&own.design, design));
        list.push(CachedFit { design: design.clone(), assessment, sample: Some(sample) });
    }

    fn list(&self) -> MutexGuard<'_, Vec<CachedFit<S>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<S> Default for FitCache<S> {
    fn default() -> Self {
        Self(Mutex::new(Vec::new()))
    }
}

impl<S> Clone for FitCache<S> {
    fn clone(&self) -> Self {
        Self::default()
    }
}
