//! A Gaussian process with a polynomial mean, for one choice of its correlation and noise.
//!
//! Everything is whitened with W = L⁻¹, V = L Lᵀ the correlation of the estimates: B = WF, and with G = (BᵀB)⁻¹
//!
//! ```text
//! P = Wᵀ(1 - B G Bᵀ)W                            σ² = yᵀP y/(n - p)
//! at a place: c = Wk, r = f - Bᵀc                mean = (c + B G r)ᵀ W y,   variance = σ² (1 - cᵀc + rᵀG r)
//! ```
//!
//! V itself is never inverted: its condition number is up to 1e13, that of L the square root of it.

use core::array::from_fn;
use std::sync::Arc;

use crate::search::models::trend::Trend;
use loosepin_math::dense::{Cholesky, dot, gram};
use loosepin_math::{FourRows, exponentials, interleaved, pairwise_dots, with_vector_instructions};
use loosepin_surrogate::{Factor, Whitened, matern_five_halves_of};

/// Largest number of points to whose factors others are appended: those of many take memory for as long as they are kept.
pub(in crate::search) const MAX_APPENDED_TO: usize = 128;

/// Places that are predicted side by side: as many as there are numbers in two vectors.
const PLACES_AT_ONCE: usize = 8;

/// How often the process can be differentiated: Matérn 1/2, 3/2, 5/2, 9/2.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Smoothness {
    Never,
    Once,
    Twice,
    FourTimes,
}

/// The correlation of the process between two places.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Kernel {
    pub smoothness: Smoothness,
    pub length_scale: f64,
}

/// Places at which predictions are wanted, with what all models of the same points share there.
pub(crate) struct ObservedPoints {
    pub places: Vec<Vec<f64>>,
    /// Distances from the points, and the terms of the polynomial, of [`PLACES_AT_ONCE`] places side by side.
    distances: Vec<Vec<[f64; PLACES_AT_ONCE]>>,
    terms: Vec<Vec<[f64; PLACES_AT_ONCE]>>,
}

impl ObservedPoints {
    /// The terms that models on `points` share at `places`.
    pub fn new(places: Vec<Vec<f64>>, points: &[Vec<f64>], trend: Trend) -> Self {
        let distances = places.chunks(PLACES_AT_ONCE).map(|own| distances_of_each(own, points)).collect();
        let terms = places.chunks(PLACES_AT_ONCE).map(|own| terms_of_each(own, trend)).collect();
        Self { places, distances, terms }
    }
}

/// Distances of at most N `places` side by side from each of `points`; those of places that are missing are zero.
fn distances_of_each<const N: usize>(places: &[Vec<f64>], points: &[Vec<f64>]) -> Vec<[f64; N]> {
    let of = |point: &Vec<f64>| from_fn(|place| places.get(place).map_or(0.0, |place| distance(point, place)));
    points.iter().map(of).collect()
}

/// Terms of the polynomial at no more than N `places` side by side; those of places that are missing are zero.
fn terms_of_each<const N: usize>(places: &[Vec<f64>], trend: Trend) -> Vec<[f64; N]> {
    let terms: Vec<Vec<f64>> = places.iter().map(|place| trend.terms(place)).collect();
    interleaved(&terms.iter().map(Vec::as_slice).collect::<Vec<_>>())
}

/// Distances of points from each other.
pub(crate) struct Distances {
    count: usize,
    /// The lower triangle with its diagonal, row behind row.
    triangle: Vec<f64>,
}

impl Distances {
    /// The distances of `points`.
    pub fn new(points: &[Vec<f64>]) -> Self {
        let of_row = |row: usize| points[..=row].iter().map(move |other| distance(&points[row], other));
        Self { count: points.len(), triangle: (0..points.len()).flat_map(of_row).collect() }
    }

    /// The distances of a point from the ones before it, and from itself.
    fn row(&self, row: usize) -> &[f64] {
        &self.triangle[row * (row + 1) / 2..(row + 1) * (row + 2) / 2]
    }
}

/// The distance of two places.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let square: f64 = a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum();
    square.sqrt()
}

impl Kernel {
    /// Correlations of points at these `distances` from each other, row by row, the lower triangle from row `first` on; the rest is zero.
    pub fn covariance(&self, distances: &Distances, first: usize) -> Vec<f64> {
        let count = distances.count;
        let mut covariance = Vec::with_capacity(count * count);
        covariance.resize(first * count, 0.0);
        for row in first..count {
            covariance.extend(self.at_distances(distances.row(row)));
            covariance.resize((row + 1) * count, 0.0);
        }
        covariance
    }

    /// s over r.
    fn factor(&self) -> f64 {
        match self.smoothness {
            Smoothness::Never => 1.0,
            Smoothness::Once => 3.0_f64.sqrt(),
            Smoothness::Twice => 5.0_f64.sqrt(),
            Smoothness::FourTimes => 3.0,
        }
    }

    /// The slopes of the correlations of places at these distances, each divided by its distance:
    ///
    /// ```text
    /// (dk/ds)/s · (s/d)²,   (dk/ds)/s = -exp(-s)/s,  -exp(-s),  -(1 + s)/3 exp(-s),  -(1 + s + 2s²/5 + s³/15)/7 exp(-s)
    /// ```
    ///
    /// The first has a kink at distance 0, and is taken for level there.
    fn slopes_at_distances(&self, distances: &[f64]) -> Vec<f64> {
        let scale = self.factor() / self.length_scale;
        let negated: Vec<f64> = distances.iter().map(|distance| -(scale * distance)).collect();
        let mut slopes = vec![0.0; distances.len()];
        exponentials(&negated, &mut slopes);
        for (slope, negated) in slopes.iter_mut().zip(&negated) {
            let s = -negated;
            *slope *= -scale
                * scale
                * match self.smoothness {
                    Smoothness::Never if s == 0.0 => 0.0,
                    Smoothness::Never => 1.0 / s,
                    Smoothness::Once => 1.0,
                    Smoothness::Twice => (1.0 + s) / 3.0,
                    Smoothness::FourTimes => (1.0 + s * (1.0 + s * (0.4 + s / 15.0))) / 7.0,
                };
        }
        slopes
    }

    /// Correlations of places at these distances.
    fn at_distances(&self, distances: &[f64]) -> Vec<f64> {
        let factor = self.factor();
        let negated: Vec<f64> = distances.iter().map(|distance| -(factor * (distance / self.length_scale))).collect();
        let mut correlations = vec![0.0; distances.len()];
        exponentials(&negated, &mut correlations);
        // Every smoothness has a loop of its own, which vectors do.
        with_vector_instructions(
            #[inline(always)]
            || {
                let each = correlations.iter_mut().zip(&negated).map(|(decay, negated)| (-negated, decay));
                match self.smoothness {
                    Smoothness::Never => {}
                    Smoothness::Once => {
                        for (s, decay) in each {
                            *decay *= 1.0 + s;
                        }
                    }
                    Smoothness::Twice => {
                        for (s, decay) in each {
                            *decay = matern_five_halves_of(s, *decay);
                        }
                    }
                    Smoothness::FourTimes => {
                        for (s, decay) in each {
                            *decay *= 1.0 + s * (1.0 + s * (3.0 / 7.0 + s * (2.0 / 21.0 + s / 105.0)));
                        }
                    }
                }
            },
        );
        correlations
    }
}

/// A Gaussian process for one choice of points, correlation and noise; estimates come later.
pub(crate) struct Model {
    place: usize,
    points: Vec<Vec<f64>>,
    trend: Trend,
    kernel: Kernel,
    noise_ratio: f64,
    /// W and B
    whitened: Whitened,
    /// G
    trend_covariance: FourRows,
    /// P_ii
    projection_diagonal: Vec<f64>,
    /// ln det V + ln det FᵀV⁻¹F
    ln_determinants: f64,
}

/// Predictions at many places, as far as the estimates have no part in them.
pub(crate) struct AtPlaces {
    /// c and r of each place, a row each.
    correlations: FourRows,
    rest: FourRows,
    /// For σ = 1.
    deviations: Vec<f64>,
}

/// Correlations of a place with the points.
struct Prediction {
    /// c = W k
    correlations: Vec<f64>,
    /// r = f - Bᵀc
    rest: Vec<f64>,
    /// For σ = 1.
    variance: f64,
}

impl Model {
    /// The model at `place` of a grid on `points` with the `covariance` of its kernel, whose polynomial has these `terms` there (row by
    /// row); `None` if V is singular to round-off. The points may have been appended to those of a factor that is `known`.
    pub fn try_new(
        place: usize,
        points: &[Vec<f64>],
        mut covariance: Vec<f64>,
        (trend, terms): (Trend, &[f64]),
        kernel: Kernel,
        noise_ratio: f64,
        known: Option<&Factor>,
    ) -> Option<Self> {
        let count = points.len();
        let size = terms.len() / count;
        for i in 0..count {
            covariance[i * count + i] += noise_ratio;
        }
        let columns: Vec<Vec<f64>> =
            (0..size).map(|column| terms.chunks(size).map(|row| row[column]).collect()).collect();
        let factor = match known {
            Some(known) => known.appended(covariance, count)?,
            None => Factor::try_new(covariance, count)?,
        };
        let factor = if count > MAX_APPENDED_TO { factor.closed() } else { factor };
        let whitened = Whitened::of_factor(Arc::new(factor), count, &columns);
        let by_point: Vec<f64> = (0..count).flat_map(|i| whitened.trend.iter().map(move |column| column[i])).collect();
        let information = Cholesky::new(gram(&by_point, size), size)?;
        let trend_covariance = FourRows::new(&information.inverse(), size);
        // Rows of WᵀB give the part of P_ii that the polynomial takes away.
        let projected = whitened.projected_trend();
        let mut projection_diagonal = whitened.whitening().column_squares();
        for (first, entries) in (0..count).step_by(PLACES_AT_ONCE).zip(projection_diagonal.chunks_mut(PLACES_AT_ONCE)) {
            let of = |column: &Vec<f64>| from_fn(|row| column.get(first + row).copied().unwrap_or(0.0));
            let rows: Vec<[f64; PLACES_AT_ONCE]> = projected.iter().map(of).collect();
            let taken = pairwise_dots(&rows, &trend_covariance.multiply_each(&rows));
            entries.iter_mut().zip(taken).for_each(|(entry, taken)| *entry -= taken);
        }
        Some(Self {
            place,
            points: points.to_vec(),
            trend,
            kernel,
            noise_ratio,
            trend_covariance,
            projection_diagonal,
            ln_determinants: whitened.ln_determinant + information.ln_determinant(),
            whitened,
        })
    }

    /// V factorised.
    pub fn factor(&self) -> &Arc<Factor> {
        self.whitened.factor()
    }

    /// Its place in its grid.
    pub fn place(&self) -> usize {
        self.place
    }

    /// How often the process can be differentiated.
    pub fn smoothness(&self) -> Smoothness {
        self.kernel.smoothness
    }

    /// τ
    pub fn noise_ratio(&self) -> f64 {
        self.noise_ratio
    }

    /// ln det V + ln det FᵀV⁻¹F
    pub fn ln_determinants(&self) -> f64 {
        self.ln_determinants
    }

    /// The errors of predicting each estimate from all the others, divided by their standard deviations for σ = 1, from
    /// [`Self::whitened_rest`]: (P y)_i/√P_ii. S. Sundararajan and S. S. Keerthi, "Predictive approaches for choosing hyperparameters in
    /// Gaussian processes", Neural Computation 13 (2001) 1103-1118. A function that is rougher in one place than in others
    /// shows itself here.
    pub fn errors(&self, rest: &[f64]) -> Vec<f64> {
        let projected = self.whitened.whitening().multiply_transposed(rest);
        let of = |(error, diagonal): (&f64, &f64)| if *diagonal > 0.0 { error / diagonal.sqrt() } else { 0.0 };
        projected.iter().zip(&self.projection_diagonal).map(of).collect()
    }

    /// The largest error of predicting an estimate from all the others, in its own unit, from [`Self::whitened_rest`]: (P y)_i/P_ii.
    pub fn largest_error(&self, rest: &[f64]) -> f64 {
        let projected = self.whitened.whitening().multiply_transposed(rest);
        let of = |(error, diagonal): (&f64, &f64)| if *diagonal > 0.0 { (error / diagonal).abs() } else { 0.0 };
        projected.iter().zip(&self.projection_diagonal).map(of).fold(0.0, f64::max)
    }

    /// The variance of what the values have beside the process, estimated from the residuals τ P y at the points and their degrees of
    /// freedom tr τP:
    ///
    /// ```text
    /// |τ P y|²/(τ tr P)
    /// ```
    ///
    /// Its expectation is τσ² where the process is right. It is quadratic in the values and says what they have even where τ is not
    /// the likeliest ratio.
    pub fn nugget(&self, values: &[f64]) -> f64 {
        let projected = self.projected(values);
        let trace: f64 = self.projection_diagonal.iter().sum();
        self.noise_ratio * dot(&projected, &projected) / trace
    }

    /// [`Self::nugget`] of N lists of values side by side.
    pub fn nuggets_of_each<const N: usize>(&self, values: &[[f64; N]]) -> [f64; N] {
        let projected = self.whitened.whitening().multiply_transposed_each(&self.whitened_rest_of_each(values));
        let trace: f64 = self.projection_diagonal.iter().sum();
        pairwise_dots(&projected, &projected).map(|square| self.noise_ratio * square / trace)
    }

    /// tr τP: how many degrees of freedom [`Self::nugget`] has.
    pub fn nugget_degrees_of_freedom(&self) -> f64 {
        self.noise_ratio * self.projection_diagonal.iter().sum::<f64>()
    }

    /// P y
    fn projected(&self, values: &[f64]) -> Vec<f64> {
        self.whitened.whitening().multiply_transposed(&self.whitened_rest(values))
    }

    /// (1 - B G Bᵀ) W y, whose square is yᵀP y.
    pub fn whitened_rest(&self, values: &[f64]) -> Vec<f64> {
        if is_zero(values) {
            return values.to_vec();
        }
        let mut rest = self.whitened.whitening().multiply(values);
        let shares = self.trend_covariance.multiply(&self.whitened.products(&rest));
        self.whitened.subtract_trend(&mut rest, &shares);
        rest
    }

    /// [`Self::whitened_rest`] of N lists of values side by side.
    pub fn whitened_rest_of_each<const N: usize>(&self, values: &[[f64; N]]) -> Vec<[f64; N]> {
        let mut rest = self.whitened.whitening().multiply_each(values);
        let shares = self.trend_covariance.multiply_each(&self.whitened.products_of_each(&rest));
        self.whitened.subtract_trends(&mut rest, &shares);
        rest
    }

    /// W y, and G Bᵀ W y: what the mean at any place takes of `values`.
    pub fn whitened(&self, values: &[f64]) -> (Vec<f64>, Vec<f64>) {
        if is_zero(values) {
            return (values.to_vec(), vec![0.0; self.whitened.trend.len()]);
        }
        let white = self.whitened.whitening().multiply(values);
        let of_trend = self.trend_covariance.multiply(&self.whitened.products(&white));
        (white, of_trend)
    }

    /// Mean, and deviation for σ = 1, of the process at `place`, from [`Self::whitened`] estimates.
    pub fn mean_and_deviation(&self, place: &[f64], (white, of_trend): (&[f64], &[f64])) -> (f64, f64) {
        let Prediction { correlations, rest, variance } = self.predict(place);
        (dot(&correlations, white) + dot(&rest, of_trend), variance.sqrt())
    }

    /// [`Self::mean_and_deviation`] at each of `places`, which takes a third of the time and has the same bits.
    pub fn means_and_deviations(&self, places: &[Vec<f64>], whitened: (&[f64], &[f64])) -> Vec<(f64, f64)> {
        let of = |some: &[Vec<f64>]| {
            if some.len() > PLACES_AT_ONCE / 2 {
                self.predict_each::<PLACES_AT_ONCE>(some, whitened)
            } else {
                self.predict_each::<{ PLACES_AT_ONCE / 2 }>(some, whitened)
            }
        };
        places.chunks(PLACES_AT_ONCE).flat_map(of).collect()
    }

    /// The same at N places at most.
    fn predict_each<const N: usize>(
        &self,
        places: &[Vec<f64>],
        (white, of_trend): (&[f64], &[f64]),
    ) -> Vec<(f64, f64)> {
        let known = self.kernel.at_distances(distances_of_each::<N>(places, &self.points).as_flattened());
        let (own, rest) = self.whitened.at_places(known.as_chunks().0, &terms_of_each::<N>(places, self.trend));
        let of_rest = pairwise_dots(&rest, &self.trend_covariance.multiply_each(&rest));
        let of_own = pairwise_dots(&own, &own);
        let [of_white, of_polynomial] = [(&own, white), (&rest, of_trend)].map(|(own, values)| {
            let values: Vec<[f64; N]> = values.iter().map(|value| [*value; N]).collect();
            pairwise_dots(own, &values)
        });
        let at = |place: usize| {
            let variance = 1.0 - of_own[place] + of_rest[place];
            (of_white[place] + of_polynomial[place], variance.max(0.0).sqrt())
        };
        (0..places.len()).map(at).collect()
    }

    /// The mean of the process at `place` and so `many` of its deviations for σ = 1, from [`Self::whitened`] estimates, with how this sum
    /// changes along each coordinate. With m many deviations and s one of them,
    ///
    /// ```text
    /// b = G Bᵀ W y + (m/s) G r,   slope_i = ∂k/∂x_i · Wᵀ(W y - (m/s) c - B b) + ∂f/∂x_i · b
    /// ```
    pub fn moved_and_slopes(&self, place: &[f64], whitened: (&[f64], &[f64]), many: f64) -> (f64, Vec<f64>) {
        let (white, of_trend) = whitened;
        let distances = self.distances(place);
        let Prediction { correlations, rest, variance } = self.predict_at(place, &distances);
        let deviation = variance.sqrt();
        let moved = dot(&correlations, white) + dot(&rest, of_trend) + many * deviation;
        // At a point that the model meets the deviation has a kink.
        let share = if deviation > 0.0 { many / deviation } else { 0.0 };
        let of_rest = self.trend_covariance.multiply(&rest);
        let of_trend: Vec<f64> = of_trend.iter().zip(&of_rest).map(|(own, rest)| own + share * rest).collect();
        let mut white: Vec<f64> = white.iter().zip(&correlations).map(|(own, known)| own - share * known).collect();
        self.whitened.subtract_trend(&mut white, &of_trend);
        let weights = self.whitened.whitening().multiply_transposed(&white);
        let mut slopes = self.trend.slopes(place, &of_trend);
        let by_distance = self.kernel.slopes_at_distances(&distances);
        for ((point, weight), by_distance) in self.points.iter().zip(&weights).zip(&by_distance) {
            for (slope, (x, own)) in slopes.iter_mut().zip(place.iter().zip(point)) {
                *slope += weight * by_distance * (x - own);
            }
        }
        (moved, slopes)
    }

    fn distances(&self, place: &[f64]) -> Vec<f64> {
        self.points.iter().map(|point| distance(point, place)).collect()
    }

    fn predict(&self, place: &[f64]) -> Prediction {
        self.predict_at(place, &self.distances(place))
    }

    /// The same where the distances from the points are known.
    fn predict_at(&self, place: &[f64], distances: &[f64]) -> Prediction {
        let known = self.kernel.at_distances(distances);
        let (correlations, rest) = self.whitened.at_place(&known, &self.trend.terms(place));
        let variance = 1.0 - dot(&correlations, &correlations) + dot(&rest, &self.trend_covariance.multiply(&rest));
        Prediction { correlations, rest, variance: variance.max(0.0) }
    }

    /// Predictions at all `seen` places, as far as the estimates have no part in them.
    pub fn at_places(&self, seen: &ObservedPoints) -> AtPlaces {
        let (places, count, size) = (seen.places.len(), self.points.len(), self.whitened.trend.len());
        let mut correlations = Vec::with_capacity(places.div_ceil(4) * count);
        let mut rest = Vec::with_capacity(places.div_ceil(4) * size);
        let mut deviations = Vec::with_capacity(places);
        let at_once = seen.distances.iter().zip(&seen.terms);
        for ((distances, terms), first) in at_once.zip((0..places).step_by(PLACES_AT_ONCE)) {
            let known = self.kernel.at_distances(distances.as_flattened());
            let (own, own_rest) = self.whitened.at_places(known.as_chunks().0, terms);
            let of_rest = pairwise_dots(&own_rest, &self.trend_covariance.multiply_each(&own_rest));
            let of_own = pairwise_dots(&own, &own);
            let variances = of_own.into_iter().zip(of_rest).map(|(own, rest)| 1.0 - own + rest);
            let own_places = (places - first).min(PLACES_AT_ONCE);
            deviations.extend(variances.take(own_places).map(|variance| variance.max(0.0).sqrt()));
            for first in (0..own_places).step_by(4) {
                let four = |entry: &[f64; PLACES_AT_ONCE]| from_fn(|place| entry[first + place]);
                correlations.extend(own.iter().map(four));
                rest.extend(own_rest.iter().map(four));
            }
        }
        let correlations = FourRows::from_interleaved_rows(places, count, correlations);
        AtPlaces { correlations, rest: FourRows::from_interleaved_rows(places, size, rest), deviations }
    }
}

impl AtPlaces {
    /// Means at the places in their order, from [`Model::whitened`] estimates.
    pub fn means(&self, (white, of_trend): (&[f64], &[f64])) -> Vec<f64> {
        if is_zero(white) {
            return vec![0.0; self.deviations.len()];
        }
        let mut means = self.correlations.multiply(white);
        for (mean, of_polynomial) in means.iter_mut().zip(self.rest.multiply(of_trend)) {
            *mean += of_polynomial;
        }
        means
    }

    /// [`Self::means`] of N lists of estimates side by side.
    pub fn means_of_each<const N: usize>(&self, white: &[[f64; N]], of_trend: &[[f64; N]]) -> Vec<[f64; N]> {
        let mut means = self.correlations.multiply_each(white);
        for (means, of_polynomial) in means.iter_mut().zip(self.rest.multiply_each(of_trend)) {
            for (mean, of_polynomial) in means.iter_mut().zip(of_polynomial) {
                *mean += of_polynomial;
            }
        }
        means
    }

    /// Deviations for σ = 1 at the places in their order.
    pub fn deviations(&self) -> &[f64] {
        &self.deviations
    }
}

/// Whether there is nothing to be whitened, as of a quantity that is the same everywhere.
fn is_zero(values: &[f64]) -> bool {
    values.iter().all(|value| *value == 0.0)
}

#[cfg(test)]
mod tests {
    use super::{Distances, Kernel, Model, Smoothness};
    use crate::search::design::first_points;
    use crate::search::models::trend::Trend;

    #[test]
    fn identity_slopes_of_every_kernel_are_those_of_differences() {
        const STEP: f64 = 1e-5;
        // Of central differences, of values about 1: round-off over the step.
        const TOLERANCE: f64 = 1e-5;
        let points = first_points(3, 2, 24).unwrap();
        let (trend, terms, _) = Trend::for_points(&points, 0).unwrap();
        let values: Vec<f64> = points.iter().map(|u| (5.0 * u[0]).sin() + (4.0 * u[1] * u[0]).cos()).collect();
        for smoothness in [Smoothness::Never, Smoothness::Once, Smoothness::Twice, Smoothness::FourTimes] {
            let kernel = Kernel { smoothness, length_scale: 0.45 };
            let covariance = kernel.covariance(&Distances::new(&points), 0);
            let model = Model::try_new(0, &points, covariance, (trend, &terms), kernel, 1e-4, None).unwrap();
            let (white, of_trend) = model.whitened(&values);
            for (place, many) in [([0.3, 0.2], 0.0), ([0.85, 0.95], 3.0), ([0.05, 0.6], -2.0)] {
                let at = |place: &[f64]| {
                    let (mean, deviation) = model.mean_and_deviation(place, (&white, &of_trend));
                    mean + many * deviation
                };
                let (moved, slopes) = model.moved_and_slopes(&place, (&white, &of_trend), many);
                assert!((moved - at(&place)).abs() < 1e-12, "{smoothness:?}: {moved}");
                for (axis, slope) in slopes.iter().enumerate() {
                    let [mut before, mut behind] = [place; 2];
                    before[axis] -= STEP;
                    behind[axis] += STEP;
                    let expected = (at(&behind) - at(&before)) / (2.0 * STEP);
                    assert!((slope - expected).abs() < TOLERANCE, "{smoothness:?}, {axis}: {slope} {expected}");
                }
            }
        }
    }
}
