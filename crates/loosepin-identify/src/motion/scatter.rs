//! What runs at one value of the unknowns scatter by, and where a measurement stands among them.

use loosepin_study::MotionError;

/// Least share of the mean, and of the common error, that counts as a standard deviation: what does not scatter must be met to this.
const LEAST_DEVIATION: f64 = 1e-6;
/// Rounds in which the common errors are fitted one after the other.
const ROUNDS: usize = 20;
/// Steps of a golden section.
const SECTIONS: usize = 60;

/// What was measured.
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
    pub fn without_error(&self, shares: &[f64]) -> Vec<f64> {
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

/// Runs that ended, as they are compared: logarithms of features that are positive.
pub(crate) struct Scatter {
    pub rows: Vec<Vec<f64>>,
    /// Of each feature whether logarithms are taken.
    pub is_log: Vec<bool>,
    pub form: Form,
    /// Runs that failed.
    pub failed: usize,
}

impl Scatter {
    /// Nothing where all runs failed.
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

    /// Values as they are compared.
    pub fn scaled(&self, values: &[f64]) -> Vec<f64> {
        scaled(values, &self.is_log)
    }

    /// Shares of the common errors, in [-1, 1], at which the measurement is nearest to the runs: one after the other, since the distance is
    /// convex in each.
    pub fn nearest_shares(&self, seen: &Observation) -> Vec<f64> {
        let mut shares = vec![0.0; seen.instrument_count()];
        let movable = seen.movable();
        for _ in 0..if movable.len() > 1 { ROUNDS } else { 1 } {
            let before = shares.clone();
            for &instrument in &movable {
                let mut at = |share: f64| {
                    shares[instrument] = share;
                    self.form.distance(&self.scaled(&seen.without_error(&shares)))
                };
                let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
                let [mut low, mut high] = [-1.0, 1.0];
                for _ in 0..SECTIONS {
                    let [left, right] = [high - golden * (high - low), low + golden * (high - low)];
                    if at(left) <= at(right) { high = right } else { low = left }
                }
                let best = [-1.0, 0.5 * (low + high), 1.0].into_iter().min_by(|a, b| at(*a).total_cmp(&at(*b)));
                shares[instrument] = best.unwrap_or(0.0);
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
    pub factor: Vec<Vec<f64>>,
}

impl Form {
    pub fn new(rows: &[Vec<f64>], is_log: &[bool], errors: &[MotionError]) -> Self {
        let (count, features) = (rows.len() as f64, is_log.len());
        let mean: Vec<f64> = (0..features).map(|k| rows.iter().map(|row| row[k]).sum::<f64>() / count).collect();
        let mut factor = vec![vec![0.0; features]; features];
        for i in 0..features {
            let error = if errors[i].is_share { 0.0 } else { errors[i].size };
            let size = if is_log[i] { 1.0 } else { mean[i].abs().max(error) };
            let least = LEAST_DEVIATION * size + f64::MIN_POSITIVE.sqrt();
            for j in 0..=i {
                let sum: f64 = rows.iter().map(|row| (row[i] - mean[i]) * (row[j] - mean[j])).sum();
                let covariance = sum / (count - 1.0).max(1.0) + if i == j { least * least } else { 0.0 };
                let inner: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
                factor[i][j] = if i == j {
                    (covariance - inner).max(least * least).sqrt()
                } else {
                    (covariance - inner) / factor[j][j]
                };
            }
        }
        Self { mean, factor }
    }

    /// Mahalanobis distance.
    pub fn distance(&self, values: &[f64]) -> f64 {
        let off: Vec<f64> = values.iter().zip(&self.mean).map(|(value, mean)| value - mean).collect();
        self.solved(&off).iter().map(|value| value * value).sum::<f64>().sqrt()
    }

    /// L⁻¹ of a difference of values.
    pub fn solved(&self, off: &[f64]) -> Vec<f64> {
        let mut solved: Vec<f64> = Vec::with_capacity(off.len());
        for (i, row) in self.factor.iter().enumerate() {
            let inner: f64 = row.iter().zip(&solved).map(|(factor, known)| factor * known).sum();
            solved.push((off[i] - inner) / row[i]);
        }
        solved
    }
}
