//! Estimates with confidence intervals.

use loosepin_uncertainty::{normal_cdf, normal_quantile, student_factor};

/// Factors that turn a standard error into the half-width of a confidence interval, and prior knowledge of tails.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Confidence {
    /// Student's factor for the spread of the replicates.
    pub student: f64,
    /// The factor of a normal distribution, for counts.
    pub normal: f64,
    /// Index of the heaviest tail of the random inputs ([`super::tail`]), at least 0.
    pub tail_of_inputs: f64,
}

impl Confidence {
    /// Factors at `level` in (0, 1) for a spread of `replicates` >= 2.
    pub fn new(level: f64, replicates: usize) -> Self {
        let (student, normal) = (student_factor(level, replicates - 1), normal_quantile(0.5 + 0.5 * level));
        Self { student, normal, tail_of_inputs: 0.0 }
    }

    /// The same where the heaviest tail of the random inputs has this index.
    pub fn with_tail_of_inputs(self, tail_of_inputs: f64) -> Self {
        Self { tail_of_inputs, ..self }
    }

    /// Probability that an interval misses on one side.
    pub fn miss_of_one_side(&self) -> f64 {
        normal_cdf(-self.normal)
    }
}

/// An estimate with the distances to both ends of its confidence interval, >= 0, infinite where nothing is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Estimate {
    pub value: f64,
    pub below: f64,
    pub above: f64,
}

impl Estimate {
    /// An undefined estimate: no run finished, or the sum of the numbers overflows.
    pub const UNDEFINED: Self = Self { value: f64::NAN, below: f64::INFINITY, above: f64::INFINITY };

    pub fn symmetric(value: f64, error: f64) -> Self {
        Self { value, below: error, above: error }
    }

    /// The lower end of the confidence interval.
    pub fn lower_limit(&self) -> f64 {
        self.value - self.below
    }

    /// The variance that the confidence interval corresponds to.
    pub fn variance(&self, confidence: &Confidence) -> f64 {
        let half_width = 0.5 * (self.below + self.above) / confidence.student;
        half_width * half_width
    }
}

/// An estimate with every failed run taken as low as possible, and as high as possible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FailureExtremes {
    pub low: Estimate,
    pub high: Estimate,
}

impl FailureExtremes {
    /// An undefined estimate.
    pub const UNDEFINED: Self = Self { low: Estimate::UNDEFINED, high: Estimate::UNDEFINED };

    /// An estimate that does not depend on failed runs.
    pub fn both(estimate: Estimate) -> Self {
        Self { low: estimate, high: estimate }
    }
}

/// Distances from the mean of `values` (one number a replicate) to both ends of its confidence interval, where nothing is known but these
/// values: t s/√R each way, lengthened by the factor 1 + |γ| towards which their skewness γ points, since the sample that missed a long
/// tail is the one whose spread is too small. Where the runs themselves are known: [`super::mean_error`].
pub(crate) fn replicate_error(values: &[f64], confidence: &Confidence) -> (f64, f64) {
    let error = confidence.student * variance_of_mean(values).sqrt();
    let skewness = skewness(values);
    (error * (1.0 + (-skewness).max(0.0)), error * (1.0 + skewness.max(0.0)))
}

/// Mean of `values`; NaN if there are none.
pub(crate) fn mean_of(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Sums of powers of the distances of some values from their mean.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PowerSums {
    pub count: f64,
    pub mean: f64,
    /// Of squares.
    pub square: f64,
    /// Of cubes.
    pub cube: f64,
}

impl PowerSums {
    /// Power sums of `values`.
    pub fn of(values: &[f64]) -> Self {
        Self::about(values, mean_of(values))
    }

    /// Power sums of `values`, whose `mean` is known.
    pub fn about(values: &[f64], mean: f64) -> Self {
        let (square, cube) = values.iter().map(|value| value - mean).fold((0.0, 0.0), |(square, cube), deviation| {
            (square + deviation * deviation, cube + deviation * deviation * deviation)
        });
        Self { count: values.len() as f64, mean, square, cube }
    }

    /// Standard deviation of the values, over their number; NaN if there are none.
    pub fn deviation(&self) -> f64 {
        (self.square / self.count).sqrt()
    }

    /// Skewness of the values, 0 where they do not differ.
    pub fn skewness(&self) -> f64 {
        let variance = self.square / self.count;
        let skewness = self.cube / (self.count * variance * variance.sqrt());
        if skewness.is_finite() { skewness } else { 0.0 }
    }
}

/// Skewness of `values`, 0 where they do not differ.
pub(crate) fn skewness(values: &[f64]) -> f64 {
    PowerSums::of(values).skewness()
}

/// Variance of the mean of `values` (one number a replicate), infinite for fewer than two.
pub(crate) fn variance_of_mean(values: &[f64]) -> f64 {
    let count = values.len() as f64;
    if values.len() < 2 {
        return f64::INFINITY;
    }
    let mean = mean_of(values);
    values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / (count * (count - 1.0))
}

/// The variance `value` with the errors `below` and `above`, taken as those of its cube root: of normal values that is nearly normal (E. B.
/// Wilson and M. M. Hilferty, "The distribution of chi-square", Proceedings of the National Academy of Sciences 17 (1931) 684-688).
/// So the error is longer upwards, and does not grow without bounds as that of the logarithm does.
pub(crate) fn variance_with_error(value: f64, (below, above): (f64, f64)) -> Estimate {
    if !value.is_finite() {
        return Estimate::UNDEFINED;
    }
    if value <= 0.0 || !below.is_finite() || !above.is_finite() {
        return Estimate { value, below, above };
    }
    let [low, high] = [-below, above].map(|error| (1.0 + error / (3.0 * value)).max(0.0).powi(3));
    Estimate { value, below: value * (1.0 - low), above: value * (high - 1.0) }
}

/// Standard deviation, from an estimate of the variance.
pub(crate) fn standard_deviation(variance: Estimate) -> Estimate {
    let value = variance.value.max(0.0).sqrt();
    Estimate {
        value,
        below: value - (variance.value - variance.below).max(0.0).sqrt(),
        above: (variance.value + variance.above).max(0.0).sqrt() - value,
    }
}
