//! Values that may have kinks between the points.
//!
//! A smooth model that has met no kink expects none: its deviation falls with a high power of the distance from the points, an error beside
//! a kink with the distance itself. Two signs tell that values may have kinks, both in -2 ln likelihood of the models without noise:
//!
//! ```text
//! least of those with one derivative - least of all < 30, or
//! the same < 80, and the likeliest model with four derivatives predicts some estimate from the others 2.75 of its deviations off
//! ```
//!
//! Smooth curves of 32 points over a square have 70 to 145 and no such error, curves with kinks 0 to 130. What is conceded to them is that of a process
//! with kinks everywhere, Matérn 1/2, whose deviation s(u) grows with the root of the distance:
//!
//! ```text
//! mean(u) ± min(2.5 s(u), 2 max |e_i|),   e_i: errors of predicting each estimate from the others by the likeliest model with four derivatives
//! ```

use crate::search::models::assessment::Assessed;
use crate::search::models::gaussian_process::{Model, Smoothness};
use crate::search::rough::roughness::Scatter;
use loosepin_math::dense::dot;

/// Below the first difference values may have kinks whatever their errors, from the second on they are taken for smooth.
const DOUBTFUL: f64 = 30.0;
const SMOOTH: f64 = 80.0;

/// The largest error of predicting an estimate from the others that is expected of smooth values, over the 2.5 deviations of [`Scatter`].
const EXPECTED_DISTRUST: f64 = 1.1;

/// Noise looks like kinks, and what is conceded for it holds beside kinks too. It does not where its deviation is below this share of the largest
/// error of predicting an estimate from the others.
const MAX_SHARE_OF_NOISE: f64 = 0.01;

/// Between the points values with kinks may lie beside a model by this many times the largest error of predicting an estimate from the others:
/// where an estimate is left out the gap is twice as wide.
const MARGIN: f64 = 2.0;

/// Values that may have kinks by the likelihoods of their models.
pub(in crate::search) struct SuspectedKinks<'m> {
    /// Less their mean, and less the polynomial as well.
    values: Vec<f64>,
    residual: Vec<f64>,
    freedom: f64,
    /// Least variance that is no round-off.
    floor: f64,
    /// Standard deviation of their sampling noise.
    of_noise: f64,
    /// Whether they are suspected whatever their errors.
    is_doubtful: bool,
    /// The likeliest model with four derivatives.
    smoothest: Assessed<'m>,
}

/// Log-likelihood of the likeliest model with one derivative, relative to the likeliest of those without noise.
pub(in crate::search) struct Likelihoods<'m> {
    excess: f64,
    smoothest: Assessed<'m>,
}

impl<'m> Likelihoods<'m> {
    /// The likelihoods of all `assessed` models; `None` if the values are as smooth as they should be.
    pub fn of(assessed: &[Assessed<'m>]) -> Option<Self> {
        let least = |smoothness: Smoothness| {
            let own = assessed.iter().filter(|own| !own.is_noisy() && own.model.smoothness() == smoothness);
            own.min_by(|a, b| a.misfit.total_cmp(&b.misfit)).copied()
        };
        let (once, smoothest) = (least(Smoothness::Once)?.misfit, least(Smoothness::FourTimes)?);
        let twice = least(Smoothness::Twice).map_or(f64::INFINITY, |own| own.misfit);
        let excess = once - once.min(twice).min(smoothest.misfit);
        (excess < SMOOTH).then_some(Self { excess, smoothest })
    }

    /// Adds the `values` of the points, less their mean, and their `residual` of the polynomial, with `freedom` degrees of freedom; no
    /// variance lies below `floor`, and `of_noise` is the standard deviation of their sampling noise.
    pub fn with(
        self,
        values: Vec<f64>,
        residual: Vec<f64>,
        (freedom, floor, of_noise): (f64, f64, f64),
    ) -> SuspectedKinks<'m> {
        let Self { excess, smoothest } = self;
        SuspectedKinks { values, residual, freedom, floor, of_noise, is_doubtful: excess < DOUBTFUL, smoothest }
    }
}

impl SuspectedKinks<'_> {
    /// Whether the leave-one-out errors of the estimates show the same kinks, and are not noise.
    pub fn are_confirmed(&self) -> bool {
        let distrust = || Scatter::even(&self.smoothest.errors(&self.residual), self.freedom).distrust;
        (self.is_doubtful || distrust() > EXPECTED_DISTRUST)
            && self.of_noise <= MAX_SHARE_OF_NOISE * self.largest_error()
    }

    /// The values, less their mean.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The largest distance between them and a model, between the points.
    pub fn largest_miss(&self) -> f64 {
        MARGIN * self.largest_error()
    }

    /// The largest error of predicting an estimate from the others.
    fn largest_error(&self) -> f64 {
        let model = self.smoothest.model;
        model.largest_error(&model.whitened_rest(&self.residual))
    }

    /// The standard deviation of the process of `model`, as it must be stated.
    pub fn deviation(&self, model: &Model) -> f64 {
        let rest = model.whitened_rest(&self.residual);
        let variance = (dot(&rest, &rest) / self.freedom).max(self.floor);
        // The misfit is that of a model that nobody compares.
        let own = Assessed { model, variance, misfit: f64::NAN };
        variance.sqrt() * Scatter::even(&own.errors(&self.residual), self.freedom).distrust
    }
}

#[cfg(test)]
mod tests {
    use crate::search::design::{candidates, first_points};
    use crate::search::models::noise::Noise;
    use crate::search::models::prediction::Allowance;
    use crate::search::models::smoother::Smoother;
    use crate::search::search_box::Axes;

    /// Points of the search of a curve over a square.
    const POINTS: usize = 32;
    const PHASES: u32 = 40;

    /// A valley whose bottom lies between the points, along a line that turns and moves with the phase from 0 to 1, beside a wave.
    fn valley(u: &[f64], phase: f64) -> f64 {
        let (slope, place) = (0.4 + phase, 0.3 + 0.6 * phase);
        (2.0 * u[0] + phase).sin() + 0.8 * (u[1] + slope * (u[0] - 0.5) - place).abs()
    }

    fn wave(u: &[f64], phase: f64) -> f64 {
        (2.5 * u[0] - 1.5 * u[1] + 6.0 * phase).sin() + 0.5 * (3.0 * u[1] + 12.0 * phase).sin()
    }

    /// Lowest possible value of a function with kinks by the fit of each phase, relative to its values; `None` if the function counts as
    /// smooth. Then its least value of a fine grid.
    fn least(function: impl Fn(&[f64], f64) -> f64) -> Vec<(Option<f64>, f64)> {
        let points = first_points(7, 2, POINTS).unwrap();
        let smoother = Smoother::try_new(points.clone(), &candidates(2).unwrap(), true, &Axes::open(2)).unwrap();
        let of = |phase: u32| {
            let phase = f64::from(phase) / f64::from(PHASES);
            let values: Vec<f64> = points.iter().map(|u| function(u, phase)).collect();
            let fit = smoother.fit(&values, &Noise::NONE);
            let reach = fit.with_kinks().map(|kinked| {
                let most = |at: crate::search::models::prediction::Prediction| {
                    at.mean - (Allowance::HOPED.deviations() * at.deviation).min(kinked.largest_miss)
                };
                fit.kinked_at_places(kinked).map(most).fold(f64::INFINITY, f64::min)
            });
            let grid = (0..=200).flat_map(|i| (0..=200).map(move |j| [i, j].map(|x| f64::from(x) / 200.0)));
            (reach, grid.map(|u| function(&u, phase)).fold(f64::INFINITY, f64::min))
        };
        (0..PHASES).map(of).collect()
    }

    #[test]
    fn analytic_valleys_between_the_points_are_conceded() {
        // Of depths up to 2. Each may be missed in 0.5 %.
        const MOST: f64 = 0.5;
        for (phase, (reach, least)) in least(valley).into_iter().enumerate() {
            let reach = reach.unwrap_or_else(|| panic!("phase {phase} is taken for smooth"));
            assert!(reach <= least && reach > least - MOST, "phase {phase}: {reach} {least}");
        }
    }

    #[test]
    fn identity_waves_have_no_kinks() {
        assert!(least(wave).iter().all(|(reach, _)| reach.is_none()));
    }
}
