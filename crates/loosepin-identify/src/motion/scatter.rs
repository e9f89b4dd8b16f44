//! Scatter of the runs at one value of the unknowns, and the place of a measurement in it.

use loosepin_math::dense::Cholesky;
use loosepin_study::MotionError;

/// Least share of the mean, and of the common error, that counts as a standard deviation: what does not scatter must be met to this.
const MIN_DEVIATION: f64 = 1e-6;
/// Rounds in which the common errors are fitted one after the other.
const ROUNDS: usize = 20;
/// Equal parts of the interval of a common error at whose ends the distance is looked at, before the golden section.
const LOOKS: usize = 16;
/// Steps of a golden section.
const SECTIONS: usize = 60;

/// A measurement.
#[derive(Debug, Clone)]
pub(crate) struct Observation {
    /// Mean over the repeats of each feature, SI.
    pub values_si: Vec<f64>,
    /// Common error of each feature.
    pub errors: Vec<MotionError>,
    /// Instrument of each feature.
    pub instruments: Vec<usize>,
}

impl Observation {
    /// The true values where the common error of each instrument is `shares` of its largest.
    pub fn corrected_values(&self, shares: &[f64]) -> Vec<f64> {
        let of = |place: usize| self.true_value(place, shares[self.instruments[place]]);
        (0..self.values_si.len()).map(of).collect()
    }

    /// True value of a feature where its common error is `share` of its largest.
    fn true_value(&self, place: usize, share: f64) -> f64 {
        let (value_si, error) = (self.values_si[place], self.errors[place]);
        if error.is_share { value_si / (1.0 + share * error.size) } else { value_si - share * error.size }
    }

    /// True values of a feature that its common error allows, SI.
    pub fn found_si(&self, place: usize) -> [f64; 2] {
        let ends = [-1.0, 1.0].map(|share| self.true_value(place, share));
        [ends[0].min(ends[1]), ends[0].max(ends[1])]
    }

    /// Number of instruments.
    pub fn instrument_count(&self) -> usize {
        self.instruments.iter().max().map_or(0, |last| last + 1)
    }

    /// Instruments that have a common error.
    pub fn movable(&self) -> Vec<usize> {
        let has_error = |instrument: &usize| {
            (0..self.errors.len()).any(|k| self.instruments[k] == *instrument && self.errors[k].size > 0.0)
        };
        (0..self.instrument_count()).filter(has_error).collect()
    }

    /// The observation of these features alone.
    pub fn of(&self, places: &[usize]) -> Self {
        Self {
            values_si: places.iter().map(|place| self.values_si[*place]).collect(),
            errors: places.iter().map(|place| self.errors[*place]).collect(),
            instruments: places.iter().map(|place| self.instruments[*place]).collect(),
        }
    }
}

/// Finished runs in the scale of comparison: logarithms of features that are positive.
pub(crate) struct Scatter {
    pub rows: Vec<Vec<f64>>,
    /// Whether logarithms are taken, for each feature.
    pub is_log: Vec<bool>,
    pub form: Form,
    /// Runs that failed.
    pub failed: usize,
}

impl Scatter {
    /// `None` if all runs failed.
    pub fn new(runs: &[Vec<f64>], seen: &Observation) -> Option<Self> {
        let rows: Vec<&Vec<f64>> = runs.iter().filter(|run| run.iter().all(|value| value.is_finite())).collect();
        let failed = runs.len() - rows.len();
        if rows.is_empty() {
            return None;
        }
        // A share of an error is a difference of logarithms; all draws are treated alike.
        let is_positive = |place: usize| {
            rows.iter().all(|row| row[place] > 0.0) && seen.found_si(place)[0] > 0.0 && seen.values_si[place] > 0.0
        };
        let is_log: Vec<bool> = (0..seen.values_si.len()).map(is_positive).collect();
        let rows: Vec<Vec<f64>> = rows.iter().map(|row| scaled(row, &is_log)).collect();
        let form = Form::new(&rows, &is_log, &seen.errors);
        Some(Self { rows, is_log, form, failed })
    }

    /// Values in the scale of comparison.
    pub fn scaled(&self, values: &[f64]) -> Vec<f64> {
        scaled(values, &self.is_log)
    }

    /// Shares of the common errors, in [-1, 1], at which the measurement is nearest to the runs by `distance`: one after the other. The
    /// distance may fall more than once along a share: it is looked at evenly first.
    pub fn nearest_shares(&self, seen: &Observation, distance: &dyn Fn(&[f64]) -> f64) -> Vec<f64> {
        let mut shares = vec![0.0; seen.instrument_count()];
        let movable = seen.movable();
        for _ in 0..if movable.len() > 1 { ROUNDS } else { 1 } {
            let before = shares.clone();
            for &instrument in &movable {
                let mut at = |share: f64| {
                    shares[instrument] = share;
                    distance(&self.scaled(&seen.corrected_values(&shares)))
                };
                let even = |k: usize| -1.0 + 2.0 * k as f64 / LOOKS as f64;
                let mut best = (f64::INFINITY, 0);
                for look in 0..=LOOKS {
                    let found = at(even(look));
                    if found < best.0 {
                        best = (found, look);
                    }
                }
                let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
                let [mut low, mut high] = [even(best.1.saturating_sub(1)), even((best.1 + 1).min(LOOKS))];
                for _ in 0..SECTIONS {
                    let [left, right] = [high - golden * (high - low), low + golden * (high - low)];
                    if at(left) <= at(right) { high = right } else { low = left }
                }
                let candidates = [even(best.1), 0.5 * (low + high)];
                let nearest = candidates.into_iter().min_by(|a, b| at(*a).total_cmp(&at(*b)));
                shares[instrument] = nearest.unwrap_or(0.0);
            }
            if shares == before {
                break;
            }
        }
        shares
    }
}

fn scaled(values: &[f64], is_log: &[bool]) -> Vec<f64> {
    values.iter().zip(is_log).map(|(value, is_log)| if *is_log { value.ln() } else { *value }).collect()
}

/// Mean and covariance of draws, the covariance as its Cholesky factor.
pub(crate) struct Form {
    pub mean: Vec<f64>,
    pub factor: Cholesky,
}

impl Form {
    pub fn new(rows: &[Vec<f64>], is_log: &[bool], errors: &[MotionError]) -> Self {
        let (count, features) = (rows.len() as f64, is_log.len());
        let mean: Vec<f64> = (0..features).map(|k| rows.iter().map(|row| row[k]).sum::<f64>() / count).collect();
        let least: Vec<f64> = (0..features).map(|k| least_deviation(mean[k], is_log[k], errors[k])).collect();
        let covariance = |i: usize, j: usize| {
            let sum: f64 = rows.iter().map(|row| (row[i] - mean[i]) * (row[j] - mean[j])).sum();
            sum / (count - 1.0).max(1.0) + if i == j { least[i] * least[i] } else { 0.0 }
        };
        let squares: Vec<f64> = least.iter().map(|least| least * least).collect();
        let factor = Cholesky::with_raised_pivots(&symmetric(features, covariance), &squares);
        Self { mean, factor }
    }

    /// Mahalanobis distance.
    pub fn distance(&self, values: &[f64]) -> f64 {
        let off: Vec<f64> = values.iter().zip(&self.mean).map(|(value, mean)| value - mean).collect();
        self.whiten(&off).iter().map(|value| value * value).sum::<f64>().sqrt()
    }

    /// L⁻¹ of a difference of values.
    pub fn whiten(&self, off: &[f64]) -> Vec<f64> {
        let mut white = off.to_vec();
        self.factor.solve_lower(&mut white);
        white
    }
}

/// Least standard deviation of a feature that counts.
pub(crate) fn least_deviation(mean: f64, is_log: bool, error: MotionError) -> f64 {
    let error = if error.is_share { 0.0 } else { error.size };
    let size = if is_log { 1.0 } else { mean.abs().max(error) };
    MIN_DEVIATION * size + f64::MIN_POSITIVE.sqrt()
}

/// The lower triangle of a symmetric matrix, row by row; the rest is zero.
pub(crate) fn symmetric(order: usize, entry: impl Fn(usize, usize) -> f64) -> Vec<f64> {
    (0..order * order).map(|at| if at % order <= at / order { entry(at / order, at % order) } else { 0.0 }).collect()
}
