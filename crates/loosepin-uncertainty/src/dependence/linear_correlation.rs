//! From the linear correlation of two variables to that of the normal variables behind them, and back.

use core::f64::consts::PI;

use thiserror::Error;

use crate::functions::normal::normal_quantile;
use crate::variables::random_variable::RandomVariable;

/// Terms of the series in the correlation.
const TERMS: usize = 400;
/// The normal variable is integrated from minus to plus this by the trapezoidal rule, which converges faster than any power of
/// the step for smooth functions under the bell.
const REACH: f64 = 14.0;
/// Step of the trapezoidal rule.
const STEP: f64 = 1.0 / 64.0;
/// How near to ±1 the correlation of the normal variables may come.
const MAX_NORMAL: f64 = 0.999_9;

/// A linear correlation that these two distributions cannot have.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("linear correlation {wanted}; these two distributions can have {least} to {most}")]
pub struct UnattainableCorrelation {
    /// The one that is wanted.
    pub wanted: f64,
    /// The least that is accepted.
    pub least: f64,
    /// The greatest that is accepted.
    pub most: f64,
}

/// The covariance of two variables as a power series in the correlation r of the normal variables behind them:
///
/// ```text
/// Cov(r) = Σ r^k a_k b_k,   a_k = E[X(Z) He_k(Z)]/√k!,   k >= 1
/// ```
///
/// Increasing in r. What the terms left out can add is at most |r|^(K+1) √((σ_X² - Σ a_k²)(σ_Y² - Σ b_k²)). Source: F. G.
/// Mehler 1866; for marginals by transformation, M. Grigoriu, "Crossings of non-Gaussian translation processes", Journal of
/// Engineering Mechanics 110 (1984) 610-620.
#[derive(Debug)]
pub struct CorrelationSeries {
    /// a_k b_k/(σ_X σ_Y), k = 1 ...
    terms: Vec<f64>,
}

impl CorrelationSeries {
    /// The series of two variables.
    pub fn new(first: &RandomVariable, second: &RandomVariable) -> Self {
        let scale = first.standard_deviation() * second.standard_deviation();
        let (a, b) = (coefficients(first), coefficients(second));
        Self { terms: a.iter().zip(b).map(|(a, b)| a * b / scale).collect() }
    }

    /// The linear correlation of the variables where the normal ones have the correlation `normal`.
    pub fn linear(&self, normal: f64) -> f64 {
        self.terms.iter().rev().fold(0.0, |sum, term| (sum + term) * normal)
    }

    /// The correlation of the normal variables with which the variables have the linear correlation `wanted`.
    ///
    /// # Errors
    ///
    /// [`UnattainableCorrelation`] with the range that is attainable.
    pub fn normal(&self, wanted: f64) -> Result<f64, UnattainableCorrelation> {
        let [least, most] = [-MAX_NORMAL, MAX_NORMAL].map(|normal| self.linear(normal));
        if !(wanted > least && wanted < most) {
            return Err(UnattainableCorrelation { wanted, least, most });
        }
        // Increasing: halving cannot fail, and 60 halvings leave nothing.
        let (mut low, mut high) = (-MAX_NORMAL, MAX_NORMAL);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.linear(middle) < wanted {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(0.5 * (low + high))
    }
}

fn density(z: f64) -> f64 {
    libm::exp(-0.5 * z * z) / (2.0 * PI).sqrt()
}

/// a_1, a_2, ...: for steps exactly, a_k = Σ (jump) φ(z) He_(k-1)(z)/√k!, otherwise by the trapezoidal rule.
fn coefficients(variable: &RandomVariable) -> Vec<f64> {
    let mut sums = vec![0.0; TERMS];
    if let Some(atoms) = variable.atoms() {
        let mut below = 0.0;
        for pair in atoms.windows(2) {
            below += pair[0].1;
            let z = normal_quantile(below.min(1.0));
            if !z.is_finite() {
                continue;
            }
            let weight = (pair[1].0 - pair[0].0) * density(z);
            let mut polynomials = Hermite::at(z);
            for (k, sum) in sums.iter_mut().enumerate() {
                *sum += weight * polynomials.value / ((k + 1) as f64).sqrt();
                polynomials.advance();
            }
        }
        return sums;
    }
    let steps = (REACH / STEP) as i32;
    let centre = variable.mean();
    for step in -steps..=steps {
        let z = f64::from(step) * STEP;
        let weight = STEP * density(z) * (variable.at_standard_normal(z) - centre);
        let mut polynomials = Hermite::at(z);
        for sum in &mut sums {
            polynomials.advance();
            *sum += weight * polynomials.value;
        }
    }
    sums
}

/// He_k(z)/√k! one after the other: h_(k+1) = (z h_k - √k h_(k-1))/√(k+1).
struct Hermite {
    z: f64,
    order: f64,
    before: f64,
    value: f64,
}

impl Hermite {
    fn at(z: f64) -> Self {
        Self { z, order: 0.0, before: 0.0, value: 1.0 }
    }

    fn advance(&mut self) {
        let next = (self.z * self.value - self.order.sqrt() * self.before) / (self.order + 1.0).sqrt();
        (self.before, self.value, self.order) = (self.value, next, self.order + 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::CorrelationSeries;
    use crate::{Distribution, RandomVariable, normal_of_rank};

    fn series(first: Distribution, second: Distribution) -> CorrelationSeries {
        let variable = |distribution| RandomVariable::try_new(distribution).unwrap();
        CorrelationSeries::new(&variable(first), &variable(second))
    }

    #[test]
    fn analytic_lognormal_variables() {
        const TOLERANCE: f64 = 1e-9; // of the trapezoidal rule at a coefficient of variation of 1.2
        let of = |deviation| Distribution::Lognormal { mean: 2.5, standard_deviation: deviation };
        let series = series(of(0.7), of(3.0));
        let [a, b] = [0.7, 3.0].map(|deviation: f64| libm::log1p((deviation / 2.5) * (deviation / 2.5)));
        let scale = (libm::expm1(a) * libm::expm1(b)).sqrt();
        for normal in [-0.9, -0.3, 0.45, 0.97] {
            let exact = libm::expm1(normal * (a * b).sqrt()) / scale;
            assert!((series.linear(normal) - exact).abs() < TOLERANCE, "{normal}");
            assert!((series.normal(exact).unwrap() - normal).abs() < 1e-7, "{normal}");
        }
    }

    #[test]
    fn analytic_uniform_variables_correlate_as_their_ranks() {
        const TOLERANCE: f64 = 1e-6; // what 400 terms leave out at 0.95
        let uniform = |lower, upper| Distribution::Uniform { lower, upper };
        let series = series(uniform(0.5, 2.0), uniform(-3.0, -2.5));
        for rank in [-0.94, -0.5, 0.25, 0.9] {
            let found = series.linear(normal_of_rank(rank));
            assert!((found - rank).abs() < TOLERANCE, "{rank} {found}");
        }
    }

    #[test]
    fn analytic_two_valued_variables() {
        // Medians of both: E[signs] = (2/π) asin r (W. F. Sheppard 1899).
        const TOLERANCE: f64 = 1e-5; // what 400 terms leave out at 0.95
        let coin = |low, high| Distribution::Discrete { values: vec![low, high], probabilities: vec![0.5, 0.5] };
        let series = series(coin(0.3, 0.7), coin(-2.0, 5.0));
        for normal in [-0.95, 0.2, 0.6_f64] {
            let exact = 2.0 / core::f64::consts::PI * libm::asin(normal);
            let found = series.linear(normal);
            assert!((found - exact).abs() < TOLERANCE, "{normal} {found} {exact}");
        }
    }

    #[test]
    fn what_is_unattainable_is_refused_with_the_range() {
        let lognormal = Distribution::Lognormal { mean: 1.5, standard_deviation: 3.0 };
        let normal = Distribution::Normal { mean: 4.0, standard_deviation: 0.5 };
        let error = series(lognormal, normal).normal(0.9).unwrap_err();
        // σ/√(e^σ² - 1) of the lognormal variable, σ² = ln 5.
        let most = libm::log(5.0_f64).sqrt() / 2.0;
        assert!((error.most - most).abs() < 2e-4 && (error.least + most).abs() < 2e-4, "{error}");
    }
}
