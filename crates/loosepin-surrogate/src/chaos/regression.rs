//! Least squares that grows by one column at a time, with its leave-one-out error at every size.

use loosepin_math::dense::dot;

/// What is left of a column after the others are taken out, relative to itself, below which it is a combination of them.
const MIN_INDEPENDENCE: f64 = 1e-9;

/// y ~ Ψ c with Ψ = Q R, Q orthonormal (modified Gram-Schmidt, twice). The first column is constant.
#[derive(Default)]
pub(crate) struct Regression {
    /// Columns of Q.
    directions: Vec<Vec<f64>>,
    /// Columns of R⁻¹; column k has k entries.
    inverse: Vec<Vec<f64>>,
    /// Qᵀ y
    shares: Vec<f64>,
    /// y - Q Qᵀ y
    rest: Vec<f64>,
    /// Diagonal of Q Qᵀ.
    leverages: Vec<f64>,
    /// tr (ΨᵀΨ)⁻¹
    trace: f64,
    /// Σ (y - mean y)²
    total: f64,
}

impl Regression {
    pub fn new(values: &[f64]) -> Self {
        let count = values.len();
        let mut regression = Self { rest: values.to_vec(), leverages: vec![0.0; count], ..Self::default() };
        regression.add(&vec![1.0; count]);
        regression.total = dot(&regression.rest, &regression.rest);
        regression
    }

    /// Adds a column; false, and nothing is changed, where it is a combination of those that are there.
    pub fn add(&mut self, column: &[f64]) -> bool {
        let mut direction = column.to_vec();
        let mut shares = vec![0.0; self.directions.len()];
        for _ in 0..2 {
            for (share, known) in shares.iter_mut().zip(&self.directions) {
                let part = dot(known, &direction);
                *share += part;
                for (entry, value) in direction.iter_mut().zip(known) {
                    *entry -= part * value;
                }
            }
        }
        let length = dot(&direction, &direction).sqrt();
        if !(length > MIN_INDEPENDENCE * dot(column, column).sqrt()) {
            return false;
        }
        for entry in &mut direction {
            *entry /= length;
        }
        // The new column of R⁻¹ is (-R⁻¹ s / length, 1 / length).
        let mut inverse = vec![0.0; self.directions.len() + 1];
        for (known, share) in self.inverse.iter().zip(&shares) {
            for (entry, value) in inverse.iter_mut().zip(known) {
                *entry -= share * value / length;
            }
        }
        inverse[self.directions.len()] = 1.0 / length;
        self.trace += dot(&inverse, &inverse);
        let share = dot(&direction, &self.rest);
        for ((rest, leverage), entry) in self.rest.iter_mut().zip(&mut self.leverages).zip(&direction) {
            *rest -= share * entry;
            *leverage += entry * entry;
        }
        self.shares.push(share);
        self.inverse.push(inverse);
        self.directions.push(direction);
        true
    }

    /// Σ (y - Ψ c)²
    pub fn rest_square(&self) -> f64 {
        dot(&self.rest, &self.rest)
    }

    /// Mean square of the leave-one-out errors r_i/(1 - h_i), times N/(N - P) (1 + tr (ΨᵀΨ/N)⁻¹/N), over the variance of
    /// y; infinite where no run is left over.
    pub fn corrected_error(&self) -> f64 {
        let (count, size) = (self.rest.len() as f64, self.directions.len() as f64);
        if size >= count || self.total <= 0.0 {
            return f64::INFINITY;
        }
        let mut square = 0.0;
        for (rest, leverage) in self.rest.iter().zip(&self.leverages) {
            let free = 1.0 - leverage;
            if free < 1e-10 {
                return f64::INFINITY;
            }
            square += rest * rest / (free * free);
        }
        square / self.total * count / (count - size) * (1.0 + self.trace)
    }

    /// c = R⁻¹ Qᵀ y
    pub fn coefficients(&self) -> Vec<f64> {
        let mut coefficients = vec![0.0; self.inverse.len()];
        for (column, share) in self.inverse.iter().zip(&self.shares) {
            for (sum, entry) in coefficients.iter_mut().zip(column) {
                *sum += entry * share;
            }
        }
        coefficients
    }

    /// Columns of R⁻¹.
    pub fn inverse_factor(self) -> Vec<Vec<f64>> {
        self.inverse
    }
}

#[cfg(test)]
mod tests {
    use super::Regression;

    /// Twelve points of a curve that no line fits.
    fn points() -> (Vec<f64>, Vec<f64>) {
        let x: Vec<f64> = (0..12).map(|i| 0.3 + 0.17 * f64::from(i)).collect();
        let y = x.iter().map(|x| libm::sin(3.0 * x) + 0.4 * x).collect();
        (x, y)
    }

    #[test]
    fn identity_the_leave_one_out_error_is_that_of_leaving_one_out() {
        const TOLERANCE: f64 = 1e-11; // round-off
        let (x, y) = points();
        let square: Vec<f64> = x.iter().map(|x| x * x).collect();
        let mut all = Regression::new(&y);
        assert!(all.add(&x) && all.add(&square));
        let without = |left_out: usize, values: &[f64]| -> Vec<f64> {
            values.iter().enumerate().filter(|(i, _)| *i != left_out).map(|(_, value)| *value).collect()
        };
        let mut sum = 0.0;
        for i in 0..x.len() {
            let mut regression = Regression::new(&without(i, &y));
            regression.add(&without(i, &x));
            regression.add(&without(i, &square));
            let c = regression.coefficients();
            let error = y[i] - c[0] - c[1] * x[i] - c[2] * square[i];
            sum += error * error;
        }
        let correction = 12.0 / 9.0 * (1.0 + all.trace);
        let expected = correction * sum / all.total;
        assert!((all.corrected_error() - expected).abs() < TOLERANCE * expected);
    }

    #[test]
    fn a_combination_of_columns_is_not_added() {
        let (x, y) = points();
        let mut regression = Regression::new(&y);
        assert!(regression.add(&x));
        assert!(!regression.add(&x.iter().map(|x| 3.0 - 2.0 * x).collect::<Vec<_>>()));
    }
}
