//! Probabilities too small to count: first-order reliability with importance sampling, and subset simulation.
//!
//! A limit state g is a function of independent standard normal numbers; the event is g <= 0. It is given in batches, as
//! `FnMut(&[Vec<f64>]) -> Result<Vec<f64>, E>`: one value for each point, in their order, so that whoever computes it may use all
//! threads; an error ends everything and is handed on. A value that is not a number is a run that failed: it may have been the
//! event or not, so that each probability has a low and a high estimate.

mod design_point;
mod importance;
mod subset;
mod worst_case;

pub use design_point::{DesignPoint, DesignSearch, design_points};
pub use importance::{ImportanceSampling, importance_sampling};
pub use subset::{SubsetSimulation, subset_simulation};
pub use worst_case::{BoxSearch, IndexExtreme, IndexRange, index_range};

/// Confidence of the interval of a [`RareEstimate`].
pub const RARE_CONFIDENCE: f64 = 0.95;

/// A small probability: the same twice where no run failed.
#[derive(Debug, Clone, PartialEq)]
pub struct RareProbability {
    /// With every failed run taken as no event.
    pub low: RareEstimate,
    /// With every failed run taken as the event.
    pub high: RareEstimate,
    /// Evaluations of the limit state.
    pub runs: usize,
    /// Runs without a number.
    pub failed: usize,
}

/// An estimate of a small probability.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RareEstimate {
    /// The estimate.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// Its interval of confidence [`RARE_CONFIDENCE`]; the upper end is 1 where nothing is known.
    pub interval: [f64; 2],
}

impl RareEstimate {
    /// Standard error over the estimate; infinite where the estimate is 0.
    pub fn coefficient_of_variation(&self) -> f64 {
        if self.value > 0.0 { self.standard_error / self.value } else { f64::INFINITY }
    }
}

/// Σ x².
fn square(point: &[f64]) -> f64 {
    point.iter().map(|x| x * x).sum()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

#[cfg(test)]
mod tests {
    //! Limit states whose probabilities are known.

    use crate::normal_cdf;

    /// A limit state and the probability of g <= 0.
    pub struct KnownLimitState {
        pub name: &'static str,
        pub dimensions: usize,
        pub limit_state: fn(&[f64]) -> f64,
        pub probability: fn() -> f64,
    }

    fn density(x: f64) -> f64 {
        (-0.5 * x * x).exp() / std::f64::consts::TAU.sqrt()
    }

    /// Simpson's rule; 2000 pieces leave an error far below the tolerance of any test here.
    fn integral(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
        let step = (to - from) / 2000.0;
        let piece = |k: usize| {
            let x = from + k as f64 * step;
            step / 6.0 * (f(x) + 4.0 * f(x + 0.5 * step) + f(x + step))
        };
        (0..2000).map(piece).sum()
    }

    pub const LIMIT_STATES: [KnownLimitState; 5] = [
        KnownLimitState {
            name: "plane",
            dimensions: 2,
            limit_state: |x| 4.2649 - 0.6 * x[0] - 0.8 * x[1],
            probability: || normal_cdf(-4.2649),
        },
        KnownLimitState {
            name: "plane in eight dimensions",
            dimensions: 8,
            limit_state: |x| 4.2649 - x.iter().sum::<f64>() / 8.0_f64.sqrt(),
            probability: || normal_cdf(-4.2649),
        },
        KnownLimitState {
            name: "sphere",
            dimensions: 3,
            limit_state: |x| 27.0 - super::square(x),
            // P(χ² > r²) with three degrees of freedom: 2 Φ(-r) + 2 r φ(r).
            probability: || 2.0 * normal_cdf(-27.0_f64.sqrt()) + 2.0 * 27.0_f64.sqrt() * density(27.0_f64.sqrt()),
        },
        KnownLimitState {
            name: "parabola bent towards the origin",
            dimensions: 2,
            limit_state: |x| 4.4 - x[0] - 0.1 * x[1] * x[1],
            probability: || integral(-9.0, 9.0, |y| density(y) * normal_cdf(0.1 * y * y - 4.4)),
        },
        KnownLimitState {
            name: "parabola bent away",
            dimensions: 2,
            limit_state: |x| 4.0 - x[0] + 0.3 * x[1] * x[1],
            probability: || integral(-9.0, 9.0, |y| density(y) * normal_cdf(-0.3 * y * y - 4.0)),
        },
    ];

    /// P. H. Waarts (2000), four branches, moved out until the event is rare: in v = (x1 + x2)/√2 and w = (x1 - x2)/√2 it is
    /// |w| >= 4.6 or |v| >= 4.5 + 0.2 w².
    pub const FOUR_BRANCHES: KnownLimitState = KnownLimitState {
        name: "four branches",
        dimensions: 2,
        limit_state: |x| {
            let [v, w] = [(x[0] + x[1]) / 2.0_f64.sqrt(), (x[0] - x[1]) / 2.0_f64.sqrt()];
            (4.5 + 0.2 * w * w - v.abs()).min(4.6 - w.abs())
        },
        probability: || {
            let inside = |w: f64| density(w) * 2.0 * normal_cdf(-4.5 - 0.2 * w * w);
            2.0 * normal_cdf(-4.6) + integral(-4.6, 4.6, inside)
        },
    };
}
