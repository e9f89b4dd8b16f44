//! A family fitted to a sample, and how well it fits.

use thiserror::Error;

use crate::family::Tails;
use crate::functions::incomplete_gamma::digamma;
use crate::variables::distribution::Distribution;
use crate::variables::random_variable::RandomVariable;

/// The fewest values that a family is fitted to: two parameters, and something left to judge the fit by.
pub const FEWEST_FITTED: usize = 5;

/// A family of distributions that can be fitted to a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FittedFamily {
    /// Mean, and standard deviation with n - 1.
    Normal,
    /// Mean and standard deviation (with n - 1) of the logarithms.
    Lognormal,
    /// Maximum likelihood, lower end 0.
    Weibull,
    /// Maximum likelihood, lower end 0.
    Gamma,
    /// Maximum likelihood.
    Gumbel,
    /// The mean, which is the maximum likelihood, lower end 0.
    Exponential,
}

/// A fitted distribution.
#[derive(Debug, Clone, PartialEq)]
pub struct SampleFit {
    /// The distribution.
    pub distribution: Distribution,
    /// How the parameters were found.
    pub method: &'static str,
    /// How well it fits.
    pub goodness: GoodnessOfFit,
}

/// The distance of a fitted distribution from its sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GoodnessOfFit {
    /// Kolmogorov's and Smirnov's: the largest difference of the distribution functions.
    pub kolmogorov_smirnov: f64,
    /// Anderson's and Darling's A², which looks at the tails.
    pub anderson_darling: f64,
    /// Whether A² exceeds what samples of the family itself exceed in 5 % of the cases when their parameters are fitted; `None` for gamma,
    /// whose limit depends on its shape.
    pub is_rejected: Option<bool>,
}

/// Why a family cannot be fitted.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum SampleFitError {
    #[error("{count} values; a fit needs at least {FEWEST_FITTED}")]
    TooFew { count: usize },
    #[error("all values are the same; nothing can be fitted")]
    NoScatter,
    #[error("the value {value}; this family has positive values only")]
    NotPositive { value: f64 },
    #[error("no parameters were found")]
    NotFound,
}

impl FittedFamily {
    /// All families with their names in study files.
    pub const ALL: [(&'static str, Self); 6] = [
        ("normal", Self::Normal),
        ("lognormal", Self::Lognormal),
        ("weibull", Self::Weibull),
        ("gamma", Self::Gamma),
        ("gumbel", Self::Gumbel),
        ("exponential", Self::Exponential),
    ];

    /// Fits the family to `values`, which are in increasing order.
    ///
    /// # Errors
    ///
    /// [`SampleFitError`] where there is no fit.
    pub fn fit(self, values: &[f64]) -> Result<SampleFit, SampleFitError> {
        let (Some(&least), Some(&greatest), true) = (values.first(), values.last(), values.len() >= FEWEST_FITTED)
        else {
            return Err(SampleFitError::TooFew { count: values.len() });
        };
        if !(least < greatest) {
            return Err(SampleFitError::NoScatter);
        }
        if !matches!(self, Self::Normal | Self::Gumbel) && !(least > 0.0) {
            return Err(SampleFitError::NotPositive { value: least });
        }
        // In units of the scatter or of the mean, so that the searches see numbers about 1.
        let (distribution, method) = match self {
            Self::Normal => {
                let (mean, standard_deviation) = moments(values);
                (Distribution::Normal { mean, standard_deviation }, "mean, standard deviation with n - 1")
            }
            Self::Lognormal => {
                let logarithms: Vec<f64> = values.iter().map(|&value| libm::log(value)).collect();
                let (location, scale) = moments(&logarithms);
                let mean = libm::exp(location + 0.5 * scale * scale);
                let standard_deviation = mean * libm::expm1(scale * scale).sqrt();
                (Distribution::Lognormal { mean, standard_deviation }, "moments of the logarithms, with n - 1")
            }
            Self::Weibull => (weibull(values)?, MAXIMUM_LIKELIHOOD),
            Self::Gamma => (gamma(values)?, MAXIMUM_LIKELIHOOD),
            Self::Gumbel => (gumbel(values)?, MAXIMUM_LIKELIHOOD),
            Self::Exponential => {
                let mean = values.iter().sum::<f64>() / values.len() as f64;
                (Distribution::Exponential { mean, lower: 0.0 }, MAXIMUM_LIKELIHOOD)
            }
        };
        let variable = RandomVariable::try_new(distribution).map_err(|_| SampleFitError::NotFound)?;
        let goodness = self.goodness(&variable, values);
        Ok(SampleFit { distribution: variable.distribution().clone(), method, goodness })
    }

    /// D = sup |F_n - F| and A² = -n - Σ (2 i - 1) (ln F(x_i) + ln(1 - F(x_(n+1-i))))/n; what A² is held against is from R. B.
    /// D'Agostino and M. A. Stephens, "Goodness-of-fit techniques" (1986), tables 4.7, 4.14 and 4.17, 5 %, parameters fitted.
    fn goodness(self, variable: &RandomVariable, values: &[f64]) -> GoodnessOfFit {
        let n = values.len() as f64;
        let tails: Vec<Tails> =
            values.iter().map(|&x| Tails { below: variable.cdf(x), above: variable.survival(x) }).collect();
        let (mut distance, mut sum) = (0.0_f64, 0.0);
        for (index, at) in tails.iter().enumerate() {
            let before = index as f64;
            distance = distance.max(at.below - before / n).max((before + 1.0) / n - at.below);
            let opposite = &tails[tails.len() - 1 - index];
            sum += (2.0 * before + 1.0) * (libm::log(at.below) + libm::log(opposite.above));
        }
        let anderson_darling = -n - sum / n;
        let limit = match self {
            Self::Normal | Self::Lognormal => Some((1.0 + 0.75 / n + 2.25 / (n * n), 0.752)),
            Self::Weibull | Self::Gumbel => Some((1.0 + 0.2 / n.sqrt(), 0.757)),
            Self::Exponential => Some((1.0 + 0.6 / n, 1.321)),
            Self::Gamma => None,
        };
        let is_rejected = limit.map(|(factor, limit)| anderson_darling * factor > limit);
        GoodnessOfFit { kolmogorov_smirnov: distance, anderson_darling, is_rejected }
    }
}

const MAXIMUM_LIKELIHOOD: &str = "maximum likelihood";

/// Mean, and standard deviation with n - 1.
fn moments(values: &[f64]) -> (f64, f64) {
    let (first, n) = (values[0], values.len() as f64);
    let mean = first + values.iter().map(|value| value - first).sum::<f64>() / n;
    let squares: f64 = values.iter().map(|value| (value - mean) * (value - mean)).sum();
    (mean, (squares / (n - 1.0)).sqrt())
}

/// The root of an increasing function of a positive number, by halving on a logarithmic scale.
fn root(increasing: impl Fn(f64) -> f64) -> Result<f64, SampleFitError> {
    const REACH: f64 = 30.0; // e^±30
    let (mut low, mut high) = (-REACH, REACH);
    if increasing(libm::exp(low)) > 0.0 || !(increasing(libm::exp(high)) > 0.0) {
        return Err(SampleFitError::NotFound);
    }
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if increasing(libm::exp(middle)) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(libm::exp(0.5 * (low + high)))
}

/// Shape k with Σ x^k ln x/Σ x^k - 1/k = mean of ln x; scale = (mean of x^k)^(1/k).
fn weibull(values: &[f64]) -> Result<Distribution, SampleFitError> {
    let n = values.len() as f64;
    // Relative to the greatest value, so that no power overflows.
    let greatest = values[values.len() - 1];
    let logarithms: Vec<f64> = values.iter().map(|value| libm::log(value / greatest)).collect();
    let mean = logarithms.iter().sum::<f64>() / n;
    let sums = |shape: f64| {
        logarithms.iter().fold((0.0, 0.0), |(power, weighted), logarithm| {
            let term = libm::exp(shape * logarithm);
            (power + term, weighted + term * logarithm)
        })
    };
    let shape = root(|shape| {
        let (power, weighted) = sums(shape);
        weighted / power - 1.0 / shape - mean
    })?;
    let scale = greatest * libm::pow(sums(shape).0 / n, 1.0 / shape);
    Ok(Distribution::Weibull { shape, scale, lower: 0.0 })
}

/// Shape k with ln k - ψ(k) = ln(mean of x) - mean of ln x; scale = mean/k.
fn gamma(values: &[f64]) -> Result<Distribution, SampleFitError> {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let excess = -values.iter().map(|value| libm::log(value / mean)).sum::<f64>() / n;
    let shape = root(|shape| excess - (libm::log(shape) - digamma(shape)))?;
    Ok(Distribution::Gamma { shape, scale: mean / shape, lower: 0.0 })
}

/// Scale s with s = mean - Σ x e^(-x/s)/Σ e^(-x/s); mode = -s ln(mean of e^(-x/s)).
fn gumbel(values: &[f64]) -> Result<Distribution, SampleFitError> {
    let (first, n) = (values[0], values.len() as f64);
    let (mean, deviation) = moments(values);
    let offsets: Vec<f64> = values.iter().map(|value| (value - first) / deviation).collect();
    let centre = (mean - first) / deviation;
    let sums = |scale: f64| {
        offsets.iter().fold((0.0, 0.0), |(sum, weighted), offset| {
            let term = libm::exp(-offset / scale);
            (sum + term, weighted + term * offset)
        })
    };
    let scale = root(|scale| {
        let (sum, weighted) = sums(scale);
        scale - centre + weighted / sum
    })?;
    let mode = first - deviation * scale * libm::log(sums(scale).0 / n);
    Ok(Distribution::Gumbel { mode, scale: deviation * scale })
}

#[cfg(test)]
mod tests;
