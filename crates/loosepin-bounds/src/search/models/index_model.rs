//! Models of the index of a probability.

use crate::estimators::index::compressed;
use crate::search::models::local::{LocalFits, LocalSmoothers};
use crate::search::models::noise::Noise;
use crate::search::models::prediction::{Allowance, Prediction};

/// A model of an index.
pub(crate) struct IndexModel<'a> {
    fit: LocalFits<'a>,
    /// Whether of x, rather than of z.
    is_compressed: bool,
}

/// Prediction of an index: of x or of z.
#[derive(Debug, Clone, Copy)]
pub(crate) struct IndexForecast {
    pub prediction: Prediction,
    /// Whether of x.
    pub is_compressed: bool,
}

impl IndexForecast {
    /// The index where the model errs by `allowance` towards `sign`.
    pub fn moved(self, allowance: Allowance, sign: f64) -> f64 {
        let moved = self.prediction.moved(allowance, sign);
        if self.is_compressed { moved } else { compressed(moved) }
    }
}

impl<'a> IndexModel<'a> {
    /// Whether the index has no kinks, according to its values.
    pub fn is_smoothest(&self) -> bool {
        self.fit.is_smoothest()
    }

    /// Models the `indices` at the points of `smoother`, in the scale in which they are likelier: the likelihood of x under a model of
    /// z is that of z times the slopes dz/dx = cosh x (E. Snelson, C. E. Rasmussen and Z. Ghahramani, "Warped Gaussian processes",
    /// Advances in Neural Information Processing Systems 16, 2004).
    pub fn new(smoother: &'a LocalSmoothers, indices: &[f64]) -> Self {
        let z: Vec<f64> = indices.iter().map(|&index| libm::sinh(index)).collect();
        let (of_x, of_z) = (smoother.fit(indices, &Noise::NONE), smoother.fit(&z, &Noise::NONE));
        let slopes = indices.iter().map(|&index| libm::log(libm::cosh(index))).sum::<f64>() / indices.len() as f64;
        let is_compressed = of_x.misfit() < of_z.misfit() - 2.0 * slopes;
        Self { fit: if is_compressed { of_x } else { of_z }, is_compressed }
    }

    /// Prediction at `place`.
    pub fn at(&self, place: &[f64], allowance: Allowance) -> IndexForecast {
        self.forecast(self.fit.at(place, allowance))
    }

    /// [`Self::at`] each of `places`.
    pub fn at_each(&self, places: &[Vec<f64>], allowance: Allowance) -> Vec<IndexForecast> {
        self.fit.at_each(places, allowance).into_iter().map(|found| self.forecast(found)).collect()
    }

    /// As [`LocalFits::moved_and_slopes`], of x.
    pub fn moved_and_slopes(&self, place: &[f64], allowance: Allowance, sign: f64) -> (f64, Vec<f64>) {
        let (moved, mut slopes) = self.fit.moved_and_slopes(place, allowance, sign);
        if self.is_compressed {
            return (moved, slopes);
        }
        // dx/dz
        let slope = 1.0 / (1.0 + moved * moved).sqrt();
        slopes.iter_mut().for_each(|own| *own *= slope);
        (compressed(moved), slopes)
    }

    /// Predictions at every one of [`Self::places`].
    pub fn at_places(&self, allowance: Allowance) -> impl Iterator<Item = IndexForecast> {
        self.fit.at_places(allowance).map(|found| self.forecast(found))
    }

    /// The candidates, then the points.
    pub fn places(&self) -> &[Vec<f64>] {
        self.fit.places()
    }

    fn forecast(&self, prediction: Prediction) -> IndexForecast {
        IndexForecast { prediction, is_compressed: self.is_compressed }
    }
}
