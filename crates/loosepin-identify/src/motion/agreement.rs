//! Likelihood of a measurement for one mechanism, whose true features are known.
//!
//! ```text
//! p(y | f) = Π over instruments of 1/2 ∫ Π_k N(x_k(y_k, s); f_k, σ_k) |dx_k/dy_k| ds    over s in [-1, 1]
//! ```
//!
//! x_k is what was measured without the common error s e_k of its instrument, f_k the true feature of the mechanism, σ_k the standard
//! deviation of its independent error, that of one repeat over the root of their number. N is the normal density.

use super::scatter::Observation;
use loosepin_math::legendre_rule;
use loosepin_study::{MeasuredMotion, MotionError};
use std::f64::consts::{LN_2, TAU};

/// Points of the integral over a common error.
const POINTS: usize = 96;
/// Standard deviations of a common error on either side of its nearest value that are integrated over.
const REACH: f64 = 10.0;
/// Steps towards the nearest common error.
const STEPS: usize = 30;

/// Likelihood of a measurement for a mechanism.
pub(crate) struct Agreement<'o> {
    seen: &'o Observation,
    /// Independent error of the mean of each feature.
    scatters: Vec<MotionError>,
    rule: Vec<(f64, f64)>,
}

impl<'o> Agreement<'o> {
    /// Fails if a feature would have to be met exactly, with the features concerned: those without independent error, but for one of each
    /// instrument that has a common error.
    pub fn new(seen: &'o Observation, features: &[&MeasuredMotion]) -> Result<Self, Vec<usize>> {
        let of = |feature: &&MeasuredMotion| {
            let MotionError { size, is_share } = feature.scatter;
            MotionError { size: size / (feature.repeats as f64).sqrt(), is_share }
        };
        let scatters: Vec<MotionError> = features.iter().map(of).collect();
        let is_exact = |place: &usize| scatters[*place].size == 0.0;
        let exact: Vec<usize> = (0..scatters.len()).filter(is_exact).collect();
        let is_held = |place: &usize| {
            let others = exact.iter().filter(|other| seen.instruments[**other] == seen.instruments[*place]).count();
            seen.errors[*place].size == 0.0 || others > 1
        };
        let held: Vec<usize> = exact.iter().copied().filter(is_held).collect();
        if held.is_empty() { Ok(Self { seen, scatters, rule: legendre_rule(POINTS) }) } else { Err(held) }
    }

    /// ln p(y | `features`), -∞ where the run failed.
    pub fn log_likelihood(&self, features: &[f64]) -> f64 {
        if features.iter().any(|value| !value.is_finite()) {
            return f64::NEG_INFINITY;
        }
        (0..self.seen.instrument_count()).map(|instrument| self.of_instrument(instrument, features)).sum()
    }

    fn of_instrument(&self, instrument: usize, features: &[f64]) -> f64 {
        let own: Vec<usize> = (0..features.len()).filter(|k| self.seen.instruments[*k] == instrument).collect();
        let has_error = |k: &&usize| self.seen.errors[**k].size > 0.0;
        if !own.iter().any(|k| has_error(&k)) {
            return self.log_density(&own, features, 0.0);
        }
        if let Some(exact) = own.iter().find(|k| self.scatters[**k].size == 0.0) {
            return self.of_exact(*exact, &own, features);
        }
        // The nearest common error, by Newton's method on the sum of squares of which each is nearly a parabola.
        let (mut nearest, mut curvature) = (0.0_f64, 0.0);
        for _ in 0..STEPS {
            let (mut slope, mut second) = (0.0, 0.0);
            for k in &own {
                let deviation = self.deviation(*k, features);
                let [value, change] = self.true_value(*k, nearest);
                slope += (value - features[*k]) * change / (deviation * deviation);
                second += change * change / (deviation * deviation);
            }
            curvature = second;
            let step = slope / second;
            if !step.is_finite() {
                break;
            }
            nearest = (nearest - step).clamp(-1.0, 1.0);
        }
        let reach = REACH / f64::sqrt(curvature);
        let reach = if reach.is_finite() { reach } else { 2.0 };
        let [low, high] = [(nearest - reach).max(-1.0), (nearest + reach).min(1.0)];
        let of_node = |(node, weight): &(f64, f64)| {
            let share = 0.5 * (low + high + node * (high - low));
            self.log_density(&own, features, share) + (weight * (high - low)).ln()
        };
        let logs: Vec<f64> = self.rule.iter().map(of_node).collect();
        let most = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if most == f64::NEG_INFINITY {
            return most;
        }
        most + logs.iter().map(|log| (log - most).exp()).sum::<f64>().ln() - LN_2
    }

    /// Of an instrument one of whose features has no independent error: its common error is what makes that one true.
    fn of_exact(&self, exact: usize, own: &[usize], features: &[f64]) -> f64 {
        let (measured, true_si, error) = (self.seen.values_si[exact], features[exact], self.seen.errors[exact]);
        let size = if error.is_share { error.size * true_si } else { error.size };
        let share = (measured - true_si) / size;
        if !(share.abs() <= 1.0) {
            return f64::NEG_INFINITY;
        }
        let others: Vec<usize> = own.iter().copied().filter(|k| *k != exact).collect();
        self.log_density(&others, features, share) - LN_2 - size.abs().ln()
    }

    /// ln of the densities of features whose common error is `share` of its largest.
    fn log_density(&self, own: &[usize], features: &[f64], share: f64) -> f64 {
        let of = |k: &usize| {
            let deviation = self.deviation(*k, features);
            let z = (self.true_value(*k, share)[0] - features[*k]) / deviation;
            let error = self.seen.errors[*k];
            let stretched = if error.is_share { 1.0 + share * error.size } else { 1.0 };
            -0.5 * z * z - 0.5 * TAU.ln() - (deviation * stretched).ln()
        };
        let sum: f64 = own.iter().map(of).sum();
        // A share of a feature that is 0 has no independent error, and nothing else agrees with it.
        if sum.is_nan() { f64::NEG_INFINITY } else { sum }
    }

    /// Standard deviation of the independent error of a feature.
    fn deviation(&self, place: usize, features: &[f64]) -> f64 {
        let scatter = self.scatters[place];
        if scatter.is_share { scatter.size * features[place].abs() } else { scatter.size }
    }

    /// What was measured without its common error, and how that changes with the share of the error.
    fn true_value(&self, place: usize, share: f64) -> [f64; 2] {
        let (measured, error) = (self.seen.values_si[place], self.seen.errors[place]);
        if error.is_share {
            let stretched = 1.0 + share * error.size;
            [measured / stretched, -measured * error.size / (stretched * stretched)]
        } else {
            [measured - share * error.size, -error.size]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Agreement;
    use crate::motion::scatter::Observation;
    use loosepin_math::legendre_rule;
    use loosepin_study::MotionError;
    use loosepin_uncertainty::normal_cdf;
    use std::f64::consts::TAU;

    fn error(size: f64, is_share: bool) -> MotionError {
        MotionError { size, is_share }
    }

    fn likelihood(seen: &Observation, scatters: &[MotionError], features: &[f64]) -> f64 {
        Agreement { seen, scatters: scatters.to_vec(), rule: legendre_rule(super::POINTS) }
            .log_likelihood(features)
            .exp()
    }

    fn normal_density(x: f64, deviation: f64) -> f64 {
        (-0.5 * (x / deviation).powi(2)).exp() / (TAU.sqrt() * deviation)
    }

    /// ∫ over [-1, 1] by the rule of the middles.
    fn middles(of: impl Fn(f64) -> f64) -> f64 {
        let count = 400_000;
        (0..count).map(|k| of(-1.0 + (2.0 * k as f64 + 1.0) / f64::from(count))).sum::<f64>() * 2.0 / f64::from(count)
    }

    #[test]
    fn analytic_one_feature_with_a_common_error_is_a_smeared_step() {
        for (error_si, deviation, true_si) in [(0.3, 0.1, 5.2), (0.3, 0.004, 4.81), (0.3, 0.004, 4.69), (2.0, 3.0, 1.0)]
        {
            let seen = Observation { values_si: vec![5.0], errors: vec![error(error_si, false)], instruments: vec![0] };
            let found = likelihood(&seen, &[error(deviation, false)], &[true_si]);
            let ends = [-1.0, 1.0].map(|sign| normal_cdf((5.0 - true_si + sign * error_si) / deviation));
            let exact = (ends[1] - ends[0]) / (2.0 * error_si);
            assert!((found / exact - 1.0).abs() < 1e-6, "{found} {exact}");
        }
    }

    #[test]
    fn peer_shares_of_two_features_of_one_instrument_as_by_the_rule_of_the_middles() {
        let (values, true_si, e) = ([10.3, -4.1], [10.0, -4.0], [0.05, 0.02]);
        let seen = Observation {
            values_si: values.to_vec(),
            errors: e.map(|size| error(size, true)).to_vec(),
            instruments: vec![0, 0],
        };
        let scatters = [error(0.01, true), error(0.03, false)];
        let found = likelihood(&seen, &scatters, &true_si);
        let deviations = [0.1, 0.03];
        let at = |s: f64, k: usize| {
            let stretched = 1.0 + s * e[k];
            normal_density(values[k] / stretched - true_si[k], deviations[k]) / stretched
        };
        let exact = 0.5 * middles(|s| at(s, 0) * at(s, 1));
        assert!((found / exact - 1.0).abs() < 1e-8, "{found} {exact}");
    }

    #[test]
    fn analytic_a_feature_without_independent_error_chooses_the_common_one() {
        // y = f (1 + 0.05 s) with y = 10.2, f = 10: s = 0.4, dy/ds = 0.5; the other one is off by 4.05/1.008 - 4.
        let seen = Observation {
            values_si: vec![10.2, 4.05],
            errors: vec![error(0.05, true), error(0.02, true)],
            instruments: vec![0, 0],
        };
        let scatters = [error(0.0, false), error(0.03, false)];
        let found = likelihood(&seen, &scatters, &[10.0, 4.0]);
        let exact = 0.5 / 0.5 * normal_density(4.05 / 1.008 - 4.0, 0.03) / 1.008;
        assert!((found / exact - 1.0).abs() < 1e-12, "{found} {exact}");
        // s = 2 is none.
        assert_eq!(likelihood(&seen, &scatters, &[9.2, 4.0]), 0.0);
        assert_eq!(likelihood(&seen, &scatters, &[f64::NAN, 4.0]), 0.0);
    }
}
