//! A statistic as a function of u, from its estimates at a few points: smoothed, interpolated, with an error.
//!
//! ```text
//! S(u) = f(u)ᵀβ + Z(u) + rough(u),   estimate_i = S(u_i) + noise_i
//! Z: Gaussian process, variance σ², correlation by the distance r = |u - u'|/ℓ:
//!    (1 + s) exp(-s), s = √3 r,                                  Matérn 3/2: one derivative,
//!    (1 + s + s²/3) exp(-s), s = √5 r,                           Matérn 5/2: two derivatives, or
//!    (1 + s + 3s²/7 + 2s³/21 + s⁴/105) exp(-s), s = 3r,          Matérn 9/2: four derivatives
//! f: polynomial of degree 2, 1 or 0;   rough and noise: independent from point to point, together with variance τσ²
//! an angle over a whole turn enters f and r as a point on a circle
//! ```
//!
//! β and σ² are estimated, smoothness, ℓ and τ chosen from a grid by restricted maximum likelihood. With common random numbers the
//! error of a smooth response is itself a smooth function of u, the likelihood takes τ = 0, and an extreme is located as precisely as
//! the points allow; where the response is chaotic it takes τ > 0, and one lucky estimate is not taken for an extreme. As long as τσ²
//! is not above the sampling variance that the replicates show, all of it is noise. Where a model with more is likelier than all of
//! these, the statistic is rough (`roughness.rs`).
//!
//! Everything is linear in the estimates once (ℓ, τ) is fixed, so that hundreds of statistics share the matrices. Source:
//! C. E. Rasmussen and C. K. I. Williams, "Gaussian processes for machine learning" (2006), sections 2.2, 2.7, 4.2.

use std::sync::{Arc, OnceLock};

use crate::search::furthest::{Ends, Furthest, furthest};
use crate::search::models::assessment::{Assessed, Assessment, Honest, cautious, least_honest};
use crate::search::models::gaussian_process::{AtPlaces, Model, ObservedPoints, Smoothness};
use crate::search::models::grid::Grid;
use crate::search::models::noise::Noise;
use crate::search::models::prediction::{Allowance, Prediction, Roughness};
use crate::search::rough::roughness::{GAIN_OF_A_PARAMETER, RoughPart, Scatter};
use crate::search::rough::suspected_kinks::{Likelihoods, SuspectedKinks};
use crate::search::search_box::{Axes, Region};
use loosepin_math::dense::dot;
use loosepin_math::{interleaved, pairwise_dots};

/// A deviation σ below this share of the range of the estimates is round-off.
const MIN_DEVIATION: f64 = 1e-12;

/// Lists of values that are computed side by side: as many as there are numbers in two vectors.
const LISTS_AT_ONCE: usize = 8;

/// Round-off of a misfit, of the order of 1e-13, is far below this.
const ROUND_OFF_OF_MISFIT: f64 = 1e-6;

/// The models of one set of points, shared by all statistics that are known there, with places at which predictions are wanted.
pub(crate) struct Smoother {
    grid: Arc<Grid>,
    /// Places of predictions: candidates, then the points themselves.
    places: Vec<Vec<f64>>,
    /// The places in the coordinates of the models, and how the axes close.
    seen_places: ObservedPoints,
    /// Whether every place lies in the unit box.
    are_inside: bool,
    axes: Axes,
    /// Predictions of each model, computed on first use.
    at_places: Vec<OnceLock<AtPlaces>>,
}

/// A statistic fitted on a smoother's points.
pub(crate) struct Fit<'a> {
    smoother: &'a Smoother,
    model: &'a Model,
    /// The whitened values, by which the mean is taken at any place.
    whitened: (Vec<f64>, Vec<f64>),
    /// The process at all places, computed on first use.
    means: OnceLock<Vec<f64>>,
    centre: f64,
    deviation: f64,
    /// Variance of what is independent from point to point, 0 where the fit passes through the estimates.
    nugget: f64,
    roughness: Option<Rough>,
    suspected_kinks: Option<SuspectedKinks<'a>>,
    kinked: OnceLock<Option<Kinked>>,
    /// -2 ln likelihood for each degree of freedom.
    misfit: f64,
}

impl Smoother {
    /// The models of `grid`, which is that of `points` of the unit box; predictions are wanted at `candidates` and at the points themselves.
    pub fn new(grid: Arc<Grid>, points: Vec<Vec<f64>>, candidates: &[Vec<f64>], axes: &Axes) -> Self {
        let places: Vec<Vec<f64>> = candidates.iter().cloned().chain(points).collect();
        let seen = places.iter().map(|place| axes.embed(place)).collect();
        let seen_places = ObservedPoints::new(seen, &grid.seen, grid.trend);
        let whole = Region::whole(places[0].len());
        let are_inside = places.iter().all(|place| whole.holds(place));
        let at_places = (0..grid.most_models()).map(|_| OnceLock::new()).collect();
        Self { grid, places, seen_places, are_inside, axes: axes.clone(), at_places }
    }

    /// [`Self::new`] with a grid of its own; models that pass beside the values take part where it `may_pass_beside`. `None` if there are
    /// too few points for any model.
    #[cfg(test)]
    pub fn try_new(points: Vec<Vec<f64>>, candidates: &[Vec<f64>], may_pass_beside: bool, axes: &Axes) -> Option<Self> {
        let grid = Grid::try_new(&points, may_pass_beside, axes, &[])?;
        Some(Self::new(Arc::new(grid), points, candidates, axes))
    }

    /// What is the same for all values of a model at the places.
    fn at_places(&self, model: &Model) -> &AtPlaces {
        self.at_places[model.place()].get_or_init(|| model.at_places(&self.seen_places))
    }

    /// Fits `values` (one for each point) with their sampling noise.
    pub fn fit(&self, values: &[f64], noise: &Noise) -> Fit<'_> {
        let own = Prepared::new(self, values, noise);
        let assessment = self.assess(&own);
        self.fitted(own, assessment)
    }

    /// [`Self::fit`] of each of several lists of values, with the means at all places. What is done for lists side by side takes a third of the
    /// time and has the same bits.
    pub fn fit_all(&self, all: &[(&[f64], &Noise)]) -> Vec<Fit<'_>> {
        let prepared: Vec<Prepared<'_>> =
            all.iter().map(|(values, noise)| Prepared::new(self, values, noise)).collect();
        let together: Vec<usize> = (0..all.len()).filter(|&index| !prepared[index].is_constant).collect();
        let mut assessments: Vec<Option<Assessment<'_>>> = all.iter().map(|_| None).collect();
        let found = self.assess_all(&together.iter().map(|&index| &prepared[index]).collect::<Vec<_>>());
        for (index, found) in together.into_iter().zip(found) {
            assessments[index] = Some(found);
        }
        let mut fits = Vec::with_capacity(all.len());
        for (own, assessment) in prepared.into_iter().zip(assessments) {
            let assessment = assessment.unwrap_or_else(|| self.assess(&own));
            fits.push(self.fitted(own, assessment));
        }
        self.find_means(&fits);
        fits
    }

    /// Means of `fits` at all places, those of the same model side by side.
    fn find_means(&self, fits: &[Fit<'_>]) {
        let mut groups: Vec<(&Model, Vec<&Fit<'_>>)> = Vec::new();
        for fit in fits {
            match groups.iter_mut().find(|(model, _)| core::ptr::eq(*model, fit.model)) {
                Some((_, own)) => own.push(fit),
                None => groups.push((fit.model, vec![fit])),
            }
        }
        for (model, own) in groups.into_iter().filter(|(_, own)| own.len() > 1) {
            let at = self.at_places(model);
            for some in own.chunks(LISTS_AT_ONCE).filter(|some| some.len() > 1) {
                if some.len() > LISTS_AT_ONCE / 2 {
                    find_means_of_each::<LISTS_AT_ONCE>(at, some);
                } else {
                    find_means_of_each::<{ LISTS_AT_ONCE / 2 }>(at, some);
                }
            }
        }
    }

    /// The fit of the model that is taken.
    fn fitted<'m>(&'m self, own: Prepared<'_>, assessment: Assessment<'m>) -> Fit<'m> {
        let Prepared { values, centre, residual, is_constant, freedom, floor, of_noise, noise, .. } = own;
        let may_be_rough = !noise.replicates.is_empty();
        let likelihoods = if is_constant { None } else { Likelihoods::of(&assessment.assessed) };
        let (smooth, mut rough): (Vec<Assessed<'_>>, Vec<Assessed<'_>>) =
            assessment.assessed.into_iter().partition(|own| !own.is_noisy() || own.nugget() <= of_noise);
        let honest = if may_be_rough { least_honest(&rough, &residual, freedom) } else { None };
        let rough = honest.and_then(|Honest { index, errors, .. }| {
            let scatter = Scatter::new(&self.grid.seen, &self.grid.regressors, &errors, freedom);
            let own = rough.swap_remove(index);
            let stated = own.misfit + scatter.price + GAIN_OF_A_PARAMETER;
            // What must be stated of a smooth model is never likelier than what is likeliest: mostly that tells already.
            let likeliest = smooth.iter().fold(f64::INFINITY, |least, own| least.min(own.misfit));
            let least = || least_honest(&smooth, &residual, freedom).map_or(f64::INFINITY, |own| own.misfit);
            (stated < likeliest - ROUND_OFF_OF_MISFIT || stated < least()).then_some((own, scatter))
        });
        let is_rough = rough.is_some();
        let (own, scatter) = rough.unwrap_or_else(|| {
            // Models without noise are always allowed: where none is chosen, no misfit is a number.
            let unknown = || {
                let model = &self.grid.level(0)[0];
                Assessed { model, variance: f64::INFINITY, misfit: f64::INFINITY }
            };
            let own = cautious(smooth).unwrap_or_else(unknown);
            let scatter = Scatter::even(&own.errors(&residual), freedom);
            (own, scatter)
        });
        let mut fit = Fit {
            smoother: self,
            model: own.model,
            whitened: own.model.whitened(&values),
            means: OnceLock::new(),
            centre,
            deviation: own.variance.sqrt() * scatter.distrust,
            nugget: if own.is_noisy() { own.nugget() } else { 0.0 },
            // With the variance that is stated in the place of the likeliest one.
            misfit: (own.misfit + scatter.price) / freedom,
            roughness: None,
            suspected_kinks: None,
            kinked: OnceLock::new(),
        };
        let noise_deviation = noise.variance.sqrt();
        fit.suspected_kinks =
            likelihoods.map(|own| own.with(values, residual.clone(), (freedom, floor, noise_deviation)));
        if is_rough {
            let (part, at_places) = (OnceLock::new(), OnceLock::new());
            fit.roughness = Some(Rough { residual, replicates: noise.replicates.clone(), scatter, part, at_places });
        }
        fit
    }

    /// All models that are worth it, held against the values of `own`.
    fn assess(&self, own: &Prepared<'_>) -> Assessment<'_> {
        let mut assessment = own.assessment();
        while let Some(level) = assessment.next_level() {
            for model in self.grid.level(level) {
                let rest = model.whitened_rest(&own.residual);
                assessment.take(model, dot(&rest, &rest));
            }
            assessment.end_level();
        }
        assessment
    }

    /// [`Self::assess`] of all lists of values, model by model.
    fn assess_all(&self, all: &[&Prepared<'_>]) -> Vec<Assessment<'_>> {
        let residuals: Vec<Vec<[f64; LISTS_AT_ONCE]>> = all
            .chunks(LISTS_AT_ONCE)
            .map(|some| interleaved(&some.iter().map(|own| &own.residual[..]).collect::<Vec<_>>()))
            .collect();
        let mut assessments: Vec<Assessment<'_>> = all.iter().map(|own| own.assessment()).collect();
        for level in 0..self.grid.levels() {
            let is_open = |own: &Assessment<'_>| own.next_level() == Some(level);
            if !assessments.iter().any(is_open) {
                break;
            }
            for model in self.grid.level(level) {
                for (residuals, some) in residuals.iter().zip(assessments.chunks_mut(LISTS_AT_ONCE)) {
                    if !some.iter().any(is_open) {
                        continue;
                    }
                    let rest = model.whitened_rest_of_each(residuals);
                    let squares = pairwise_dots(&rest, &rest);
                    for (own, square) in some.iter_mut().zip(squares).filter(|(own, _)| is_open(own)) {
                        own.take(model, square);
                    }
                }
            }
            assessments.iter_mut().filter(|own| is_open(own)).for_each(Assessment::end_level);
        }
        assessments
    }
}

/// Means of at most N `fits` of the same model at its places.
fn find_means_of_each<const N: usize>(at: &AtPlaces, fits: &[&Fit<'_>]) {
    let white: Vec<&[f64]> = fits.iter().map(|fit| &fit.whitened.0[..]).collect();
    let of_trend: Vec<&[f64]> = fits.iter().map(|fit| &fit.whitened.1[..]).collect();
    let means = at.means_of_each::<N>(&interleaved(&white), &interleaved(&of_trend));
    for (list, fit) in fits.iter().enumerate() {
        fit.means.get_or_init(|| means.iter().map(|own| own[list]).collect());
    }
}

/// Values to be fitted.
struct Prepared<'v> {
    /// Less `centre`, and less the polynomial as well.
    values: Vec<f64>,
    residual: Vec<f64>,
    centre: f64,
    /// Whether they are the same everywhere.
    is_constant: bool,
    freedom: f64,
    /// Least variance that is no round-off.
    floor: f64,
    noise: &'v Noise,
    /// Its variance where it is no round-off.
    of_noise: f64,
    /// Noise ratios that are tried.
    levels: usize,
}

impl<'v> Prepared<'v> {
    fn new(smoother: &Smoother, values: &[f64], noise: &'v Noise) -> Self {
        let count = values.len();
        // What is the same everywhere is met without round-off, and takes no time.
        let is_constant = values.iter().all(|value| *value == values[0]);
        let centre = if is_constant { values[0] } else { values.iter().sum::<f64>() / count as f64 };
        let values: Vec<f64> = values.iter().map(|value| value - centre).collect();
        let range = values.iter().fold(0.0_f64, |range, value| range.max(value.abs()));
        let residual = smoother.grid.residual(&values);
        let freedom = (count - smoother.grid.terms.len() / count) as f64;
        let floor = (MIN_DEVIATION * range).powi(2);
        let of_noise = if noise.variance > floor { noise.variance } else { 0.0 };
        // What polynomials in the random inputs give exactly is smooth in u as well.
        let has_noise = !noise.replicates.is_empty() || of_noise > 0.0;
        let levels = if has_noise { smoother.grid.levels() } else { 1 };
        Self { values, residual, centre, is_constant, freedom, floor, noise, of_noise, levels }
    }

    fn assessment<'m>(&self) -> Assessment<'m> {
        Assessment::new(self.levels, self.freedom, self.floor)
    }
}

/// Inputs of the rough part, which is computed on request.
struct Rough {
    residual: Vec<f64>,
    replicates: Vec<Vec<f64>>,
    scatter: Scatter,
    part: OnceLock<RoughPart>,
    /// At all places of the smoother.
    at_places: OnceLock<Vec<Roughness>>,
}

impl Rough {
    fn part(&self, fit: &Fit<'_>) -> &RoughPart {
        self.part.get_or_init(|| {
            let replicates: Vec<Vec<f64>> = self.replicates.iter().map(|own| fit.smoother.grid.residual(own)).collect();
            RoughPart::new(fit.model, &self.residual, &replicates, self.scatter.clone())
        })
    }

    fn at_places(&self, fit: &Fit<'_>) -> &[Roughness] {
        self.at_places.get_or_init(|| self.part(fit).at_places(&fit.smoother.seen_places.places))
    }
}

/// A process with kinks everywhere, fitted to the values of a [`Fit`].
pub(crate) struct Kinked {
    /// At every place of the fit.
    means: Vec<f64>,
    /// σ
    deviation: f64,
    /// The most that the values may lie beside it.
    pub largest_miss: f64,
}

impl Fit<'_> {
    /// The process with kinks everywhere fitted to the same values, computed on first use; `None` if they are known to be smooth, or noisy.
    pub fn with_kinks(&self) -> Option<&Kinked> {
        self.kinked.get_or_init(|| self.find_with_kinks()).as_ref()
    }

    fn find_with_kinks(&self) -> Option<Kinked> {
        let suspected = self.suspected_kinks.as_ref().filter(|suspected| suspected.are_confirmed())?;
        let model = self.smoother.grid.with_kinks()?;
        let (white, of_trend) = model.whitened(suspected.values());
        let means = self.smoother.at_places(model).means((&white, &of_trend));
        Some(Kinked { means, deviation: suspected.deviation(model), largest_miss: suspected.largest_miss() })
    }

    /// Predictions of `kinked`, fitted to the same values, at every one of [`Self::places`].
    pub fn kinked_at_places<'s>(&'s self, kinked: &'s Kinked) -> impl Iterator<Item = Prediction> + 's {
        let deviations = self.smoother.grid.with_kinks().map(|model| self.smoother.at_places(model).deviations());
        let of = |(mean, deviation): (&f64, &f64)| Prediction {
            mean: self.centre + mean,
            deviation: kinked.deviation * deviation,
            roughness: Roughness::default(),
        };
        kinked.means.iter().zip(deviations.into_iter().flatten()).map(of)
    }

    /// Whether it smooths the values instead of interpolating them.
    pub fn is_regressing(&self) -> bool {
        self.nugget > 0.0
    }

    /// Variance of the sampling noise between the points, 0 where the fit passes through the estimates.
    pub fn noise_variance(&self) -> f64 {
        self.roughness.as_ref().map_or(self.nugget, |rough| rough.part(self).noise_variance())
    }

    /// The share of sampling noise in what the values differ by from one point to the next; the rest is rough, and belongs to them.
    pub fn noise_share(&self) -> f64 {
        self.roughness.as_ref().map_or(1.0, |rough| rough.part(self).noise_share())
    }

    /// Whether it passes through the values and they are those of something as smooth as the smoothest processes.
    pub fn is_smoothest(&self) -> bool {
        !self.is_regressing() && self.model.smoothness() == Smoothness::FourTimes
    }

    /// Whether the values have a rough part.
    pub fn is_rough(&self) -> bool {
        self.roughness.is_some()
    }

    /// -2 ln likelihood of the values for each degree of freedom: what models of the same values in other scales are compared by, each
    /// with twice the mean logarithm of the slope of its scale.
    pub fn misfit(&self) -> f64 {
        self.misfit
    }

    /// Whether all of [`Fit::places`] lie in `region`, as far as a test without a look at each shows.
    pub fn are_all_in(&self, region: &Region) -> bool {
        self.smoother.are_inside && region.is_whole()
    }

    /// Places of [`Fit::at_places`].
    pub fn places(&self) -> &[Vec<f64>] {
        &self.smoother.places
    }

    /// Predictions of S at every place, with what an allowance asks for: first the candidates, then the points.
    pub fn at_places(&self, allowance: Allowance) -> impl Iterator<Item = Prediction> {
        let rough = self.roughness.as_ref().filter(|_| allowance.concedes_roughness());
        let rough = rough.map(|rough| rough.at_places(self));
        let of = move |(place, at)| match rough {
            Some(rough) => Prediction { roughness: rough[place], ..at },
            None => at,
        };
        self.smooth_at_places().enumerate().map(of)
    }

    /// The same without what is rough.
    pub fn smooth_at_places(&self) -> impl Iterator<Item = Prediction> {
        let (means, deviations) = self.at_all();
        let (centre, own) = (self.centre, self.deviation);
        let of = move |(mean, deviation): (&f64, &f64)| Prediction {
            mean: centre + mean,
            deviation: own * deviation,
            roughness: Roughness::default(),
        };
        means.iter().zip(deviations).map(of)
    }

    /// The most that the smooth part is where its model errs by `allowance` towards `sign`, upwards in this direction, and the most that is
    /// expected, over all places; each with the first place that has it.
    pub fn furthest(&self, allowance: Allowance, sign: f64) -> [Furthest; 2] {
        let (means, deviations) = self.at_all();
        let ends = Ends { centre: self.centre, scale: self.deviation, many: allowance.deviations(), sign };
        furthest(means, deviations, ends)
    }

    /// Means of the process, and its deviations for σ = 1, at every place.
    fn at_all(&self) -> (&[f64], &[f64]) {
        let at = self.smoother.at_places(self.model);
        (self.means.get_or_init(|| at.means((&self.whitened.0, &self.whitened.1))), at.deviations())
    }

    /// Prediction of S at `place`, with what an allowance asks for.
    pub fn at(&self, place: &[f64], allowance: Allowance) -> Prediction {
        let seen = self.smoother.axes.embed(place);
        let found = self.model.mean_and_deviation(&seen, (&self.whitened.0, &self.whitened.1));
        let rough = self.roughness.as_ref().filter(|_| allowance.concedes_roughness());
        let roughness = rough.map_or_else(Roughness::default, |rough| rough.part(self).at(&seen));
        Prediction { mean: self.centre + found.0, deviation: self.deviation * found.1, roughness }
    }

    /// [`Self::at`] each of `places`.
    pub fn at_each(&self, places: &[Vec<f64>], allowance: Allowance) -> Vec<Prediction> {
        let seen: Vec<Vec<f64>> = places.iter().map(|place| self.smoother.axes.embed(place)).collect();
        let found = self.model.means_and_deviations(&seen, (&self.whitened.0, &self.whitened.1));
        let rough = self.roughness.as_ref().filter(|_| allowance.concedes_roughness());
        let of = |(seen, found): (&Vec<f64>, (f64, f64))| {
            let roughness = rough.map_or_else(Roughness::default, |rough| rough.part(self).at(seen));
            Prediction { mean: self.centre + found.0, deviation: self.deviation * found.1, roughness }
        };
        seen.iter().zip(found).map(of).collect()
    }

    /// The smooth part of S at `place` where its model errs by `allowance` towards `sign`, with how this changes along each axis.
    pub fn moved_and_slopes(&self, place: &[f64], allowance: Allowance, sign: f64) -> (f64, Vec<f64>) {
        let axes = &self.smoother.axes;
        let many = sign * allowance.deviations() * self.deviation;
        let whitened = (&self.whitened.0[..], &self.whitened.1[..]);
        let (moved, seen_slopes) = self.model.moved_and_slopes(&axes.embed(place), whitened, many);
        (self.centre + moved, axes.slopes(place, &seen_slopes))
    }
}

#[cfg(test)]
mod tests {
    use super::Smoother;
    use crate::search::design::{candidates, first_points};
    use crate::search::models::noise::Noise;
    use crate::search::models::prediction::{Allowance, Prediction};
    use crate::search::search_box::Axes;
    use loosepin_uncertainty::{hash, normal_quantile};

    #[test]
    fn analytic_a_quadratic_is_met_everywhere_to_round_off() {
        const TOLERANCE: f64 = 1e-9;
        let points = first_points(5, 3, 40).unwrap();
        let function = |u: &[f64]| 0.3 + u[0] * u[1] - 2.0 * u[2] * u[2] + 0.7 * u[1];
        let values: Vec<f64> = points.iter().map(|u| function(u)).collect();
        let smoother = Smoother::try_new(points, &candidates(3).unwrap(), true, &Axes::open(3)).unwrap();
        let fit = smoother.fit(&values, &Noise::NONE);
        for (place, Prediction { mean, deviation, .. }) in fit.places().iter().zip(fit.at_places(Allowance::ONE)) {
            assert!((mean - function(place)).abs() < TOLERANCE && deviation < TOLERANCE, "{mean} {deviation}");
        }
    }

    #[test]
    fn identity_a_smooth_function_lies_within_the_stated_deviation() {
        // Share of places within two deviations; a Gaussian process would have 0.95, chosen grid and all.
        const MIN_SHARE: f64 = 0.9;
        const MAX_DEVIATION: f64 = 0.05; // of a function with range 2.6
        let points = first_points(7, 2, 32).unwrap();
        let function = |u: &[f64]| (4.0 * u[0]).sin() + 0.6 * (3.0 * u[1] + u[0]).cos();
        let values: Vec<f64> = points.iter().map(|u| function(u)).collect();
        let smoother = Smoother::try_new(points, &candidates(2).unwrap(), true, &Axes::open(2)).unwrap();
        let fit = smoother.fit(&values, &Noise::NONE);
        let places = fit.places().len() as f64;
        let within = fit
            .places()
            .iter()
            .zip(fit.at_places(Allowance::ONE))
            .filter(|(place, Prediction { mean, deviation, .. })| {
                (mean - function(place)).abs() <= 2.0 * deviation + 1e-9
            })
            .count() as f64;
        assert!(within / places > MIN_SHARE, "{}", within / places);
        let largest = fit.at_places(Allowance::ONE).fold(0.0_f64, |largest, at| largest.max(at.deviation));
        assert!(largest < MAX_DEVIATION, "{largest}");
    }

    #[test]
    fn identity_noise_is_smoothed_and_the_absence_of_noise_is_not() {
        let points = first_points(9, 1, 40).unwrap();
        let noise = |i: usize| 0.2 * normal_quantile((hash(3, i as u64) >> 11) as f64 / (1_u64 << 53) as f64);
        let noisy: Vec<f64> = points.iter().enumerate().map(|(i, u)| u[0] * u[0] + noise(i)).collect();
        let exact: Vec<f64> = points.iter().map(|u| (5.0 * u[0]).exp()).collect();
        let smoother = Smoother::try_new(points, &candidates(1).unwrap(), true, &Axes::open(1)).unwrap();
        let fit = smoother.fit(&noisy, &Noise { variance: 0.04, ..Noise::NONE });
        assert!(fit.noise_variance() > 0.0);
        // At the ends a parabola through 40 points is known to 0.2 √(9/40) = 0.1.
        const TOLERANCE: f64 = 0.3;
        let worst = fit
            .places()
            .iter()
            .zip(fit.at_places(Allowance::ONE))
            .fold(0.0_f64, |worst, (u, at)| worst.max((at.mean - u[0] * u[0]).abs()));
        assert!(worst < TOLERANCE, "{worst}");
        assert_eq!(smoother.fit(&exact, &Noise { variance: 0.04, ..Noise::NONE }).noise_variance(), 0.0);
    }

    /// A normal number of its own for each seed and place.
    fn number(seed: u64, place: u64) -> f64 {
        normal_quantile(((hash(seed, place) >> 11) as f64 + 0.5) / (1_u64 << 53) as f64)
    }

    /// The errors of `points` means with a standard deviation of `noise`, each of 16 replicates, and what the replicates have beside them.
    fn sampled(seed: u64, points: usize, noise: f64) -> (Vec<f64>, Vec<Vec<f64>>) {
        const REPLICATES: u64 = 16;
        let own = |replicate: u64, point: usize| noise * 4.0 * number(seed, replicate * 1000 + point as u64);
        let mean = |point: usize| (0..REPLICATES).map(|k| own(k, point)).sum::<f64>() / REPLICATES as f64;
        let errors: Vec<f64> = (0..points).map(mean).collect();
        let beside = |k: u64| (0..points).map(|i| own(k, i) - errors[i]).collect();
        let replicates = (0..REPLICATES).map(beside).collect();
        (errors, replicates)
    }

    #[test]
    fn analytic_what_is_rough_is_conceded_to_the_greatest_of_ten_thousand_cells() {
        const ROUGHNESS: f64 = 0.05;
        const CELLS: u64 = 100; // along each axis
        const SEEDS: u64 = 40;
        // 0.99 are to hold: more than two of 40 miss with probability 0.007.
        const MAX_MISSES: usize = 2;
        let trend = |u: &[f64]| 0.3 * (3.0 * u[0]).sin() + 0.2 * u[1] * u[1];
        let (mut misses, mut found, mut conceded) = (0, 0.0, 0.0);
        for seed in 0..SEEDS {
            let rough = |u: &[f64]| {
                let [x, y] = [u[0], u[1]].map(|x| ((x * CELLS as f64) as u64).min(CELLS - 1));
                trend(u) + ROUGHNESS * number(seed, x * CELLS + y)
            };
            let points = first_points(seed, 2, 64).unwrap();
            let values: Vec<f64> = points.iter().map(|u| rough(u)).collect();
            let smoother = Smoother::try_new(points, &candidates(2).unwrap(), true, &Axes::open(2)).unwrap();
            // Every replicate shows the same: nothing is sampled.
            let noise = Noise { variance: 0.0, replicates: vec![vec![0.0; values.len()]; 2] };
            let fit = smoother.fit(&values, &noise);
            let most = fit
                .at_places(Allowance::CONCESSION)
                .map(|at| at.moved(Allowance::CONCESSION, 1.0))
                .fold(f64::NEG_INFINITY, f64::max);
            let middles = (0..CELLS * CELLS).map(|i| [i % CELLS, i / CELLS].map(|x| (x as f64 + 0.5) / CELLS as f64));
            let greatest = middles.map(|u| rough(&u)).fold(f64::NEG_INFINITY, f64::max);
            misses += usize::from(most < greatest);
            found += fit.at(&[0.5, 0.5], Allowance::CONCESSION).roughness.deviation / SEEDS as f64;
            conceded += (most - greatest) / SEEDS as f64;
        }
        assert!(misses <= MAX_MISSES, "{misses} of {SEEDS}");
        // The mean of 40 deviations from about 50 degrees of freedom: to 0.1/√40 of itself.
        assert!((found / ROUGHNESS - 1.0).abs() < 0.1, "{found}");
        // In a corner 64 points leave 0.55 ω of the smooth part open, and four times that is conceded.
        assert!(conceded < 4.0 * ROUGHNESS, "{conceded}");
    }

    #[test]
    fn analytic_noise_that_replicates_show_is_no_roughness() {
        const NOISE: f64 = 0.2;
        const SEEDS: u64 = 20;
        let (mut found, mut rough) = (0.0, 0);
        for seed in 0..SEEDS {
            let points = first_points(seed, 1, 40).unwrap();
            let (errors, replicates) = sampled(seed, points.len(), NOISE);
            let values: Vec<f64> = points.iter().zip(errors).map(|(u, error)| u[0] * u[0] + error).collect();
            let smoother = Smoother::try_new(points, &candidates(1).unwrap(), true, &Axes::open(1)).unwrap();
            // Less than there is, so that a model with more is taken for rough if it is taken.
            let noise = Noise { variance: 0.1 * NOISE * NOISE, replicates };
            let fit = smoother.fit(&values, &noise);
            rough += usize::from(fit.is_rough());
            found += fit.at(&[0.5], Allowance::CONCESSION).roughness.deviation / SEEDS as f64;
        }
        assert!(rough > 0, "no model takes any of it for rough");
        assert!(found < 0.5 * NOISE, "{found}");
    }

    #[test]
    fn analytic_the_share_of_noise_is_told_from_roughness_by_the_replicates() {
        // A standard deviation of 0.1 belongs to the response and one of 0.05 to the sample: a share of 0.2.
        const ROUGHNESS: f64 = 0.1;
        const NOISE: f64 = 0.05;
        const SEEDS: u64 = 20;
        // Of a share from 36 degrees of freedom, in the mean of 20.
        const TOLERANCE: f64 = 0.05;
        let (mut share, mut rough) = (0.0, 0);
        for seed in 0..SEEDS {
            let points = first_points(seed, 1, 40).unwrap();
            let (errors, replicates) = sampled(seed, points.len(), NOISE);
            let of = |i: usize, u: &[f64]| u[0] * u[0] + errors[i] + ROUGHNESS * number(seed + 1000, i as u64);
            let values: Vec<f64> = points.iter().enumerate().map(|(i, u)| of(i, u)).collect();
            let smoother = Smoother::try_new(points, &candidates(1).unwrap(), true, &Axes::open(1)).unwrap();
            let fit = smoother.fit(&values, &Noise { variance: NOISE * NOISE, replicates });
            assert!(fit.is_regressing() && fit.noise_variance() <= 2.0 * NOISE * NOISE, "{}", fit.noise_variance());
            if fit.is_rough() {
                rough += 1;
                share += fit.noise_share();
            }
        }
        assert!(rough > SEEDS / 2, "{rough}");
        let share = share / rough as f64;
        assert!((share - 0.2).abs() < TOLERANCE, "{share}");
    }

    #[test]
    fn identity_lists_that_are_fitted_together_have_the_bits_of_each_by_itself() {
        const NOISE: f64 = 0.05;
        let points = first_points(3, 2, 40).unwrap();
        let (errors, replicates) = sampled(3, points.len(), NOISE);
        let smooth: Vec<f64> = points.iter().map(|u| (2.0 * u[0]).sin() + u[1] * u[1]).collect();
        let noisy = |size: f64| smooth.iter().zip(&errors).map(|(value, error)| size * (value + error)).collect();
        let known = Noise { variance: NOISE * NOISE, replicates };
        let too_little = Noise { variance: 0.01 * NOISE * NOISE, ..known.clone() };
        let lists: Vec<(Vec<f64>, Noise)> = vec![
            (noisy(1.0), known.clone()),
            (vec![3.5; points.len()], Noise::NONE),
            (smooth.clone(), Noise::NONE),
            (noisy(1.0), too_little.clone()),
            (errors.clone(), known.clone()),
            (noisy(1e6), known),
            (errors.clone(), too_little),
        ];
        let smoother = Smoother::try_new(points, &candidates(2).unwrap(), true, &Axes::open(2)).unwrap();
        let together: Vec<(&[f64], &Noise)> = lists.iter().map(|(values, noise)| (&values[..], noise)).collect();
        let found = smoother.fit_all(&together);
        assert_eq!(found.len(), lists.len());
        for (fit, (values, noise)) in found.iter().zip(&lists) {
            let alone = smoother.fit(values, noise);
            assert_eq!(fit.model.place(), alone.model.place());
            assert_eq!(fit.misfit().to_bits(), alone.misfit().to_bits());
            let all = |fit: &super::Fit<'_>| fit.at_places(Allowance::CONCESSION).collect::<Vec<Prediction>>();
            assert_eq!(all(fit), all(&alone));
        }
        // Of both kinds there are some.
        assert!(found.iter().any(|fit| fit.is_rough()) && found.iter().any(|fit| !fit.is_regressing()));
    }
}
