//! Prediction of a statistic at a place, and its error.

/// A prediction from the three parts of a statistic over u: what is smooth, what is rough and belongs to the response, and what is noise
/// of sampling, which is no part of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Prediction {
    /// The smooth part.
    pub mean: f64,
    /// Its standard deviation.
    pub deviation: f64,
    /// The rough part, whose mean is 0; none if it was not requested.
    pub roughness: Roughness,
}

/// The part of a statistic that differs from one u to the next without a rule that the points could show.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Roughness {
    /// Its standard deviation ω over u.
    pub deviation: f64,
    /// Difference between the upper end of its one-sided interval of 95 % and the prediction.
    pub error: f64,
    /// Factors of both errors for the deviations below and above the smooth part.
    pub distrust: [f64; 2],
}

/// Allowance for the error of a prediction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Allowance {
    deviations: f64,
    concedes_roughness: bool,
}

/// The model's error bar in what is hoped for, in standard deviations.
const HOPED: f64 = 2.5;

/// The model's error bar in what is conceded: a model that is wrong about its own error near an extreme costs a bound that is too
/// narrow, where in the search it costs a point.
const CONCEDED: f64 = 4.0;

/// The greatest of 10,000 independent normal numbers lies at 3.85 on average, and in 99 % not further than 0.9 beyond it.
const GREATEST: f64 = 3.85;
const BEYOND_GREATEST: f64 = 0.9;

impl Allowance {
    /// The expected value, without allowance.
    pub const NONE: Self = Self { deviations: 0.0, concedes_roughness: false };
    /// One deviation of the smooth part.
    pub const ONE: Self = Self { deviations: 1.0, concedes_roughness: false };
    /// Optimistic allowance of the search: the rough part is left out.
    pub const HOPED: Self = Self { deviations: HOPED, concedes_roughness: false };
    /// Allowance for the error of the smooth part.
    pub const CONCEDED_TREND: Self = Self { deviations: CONCEDED, concedes_roughness: false };
    /// Allowance for the error of the whole prediction.
    pub const CONCESSION: Self = Self { deviations: CONCEDED, concedes_roughness: true };

    /// Standard deviations of the smooth part.
    pub fn deviations(self) -> f64 {
        self.deviations
    }

    /// Whether it asks for the rough part, which takes time.
    pub fn concedes_roughness(self) -> bool {
        self.concedes_roughness
    }
}

impl Prediction {
    /// The statistic where the model errs by `allowance` towards `sign`:
    ///
    /// ```text
    /// mean ± (3.85 ω + sqrt((4 s)² + (0.9 ω)² + (3.85 δω)²))
    /// ```
    ///
    /// with ω and its error δω enlarged by the distrust of this side, and s the deviation of the smooth part: the greatest of many cells is nearly certain, and adds; what is uncertain of it, of ω
    /// and of the smooth part errs independently.
    pub fn moved(&self, allowance: Allowance, sign: f64) -> f64 {
        let smooth = allowance.deviations * self.deviation;
        if !allowance.concedes_roughness || self.roughness.deviation == 0.0 && self.roughness.error == 0.0 {
            return self.mean + sign * smooth;
        }
        let Roughness { deviation, error, distrust } = self.roughness;
        let distrust = distrust[usize::from(sign > 0.0)];
        let (deviation, error) = (distrust * deviation, distrust * error);
        let (own, of_estimate) = (BEYOND_GREATEST * deviation, GREATEST * error);
        self.mean + sign * (GREATEST * deviation + (smooth * smooth + own * own + of_estimate * of_estimate).sqrt())
    }
}
