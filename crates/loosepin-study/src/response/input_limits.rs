//! Limits of uncertain inputs where a worst case is asked for: the ends of an interval or of a distribution; where a distribution has none, 3
//! standard deviations from its mean.

use crate::file::Study;
use loosepin_mechanics::model::QuantityId;
use loosepin_uncertainty::RandomVariable;

/// Standard deviations on either side of the mean to which a distribution without an end is taken.
pub(crate) const DEVIATIONS: f64 = 3.0;

/// Limits of an input.
#[derive(Debug, Clone)]
pub(crate) struct InputLimits {
    pub path: String,
    pub quantity: QuantityId,
    pub low_si: f64,
    pub high_si: f64,
    /// The least probability of lying there.
    pub share: f64,
}

impl Study {
    /// The limits of all random inputs and of the unknown numbers.
    pub(crate) fn input_limits(&self) -> Vec<InputLimits> {
        let random = self.random.iter().filter_map(|input| {
            let variables = input.variables(&self.epistemic, |known| known.ends().to_vec());
            let all = variables.iter().map(limits_of).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1), a.2.min(b.2)));
            let (low_si, high_si, share) = all.unwrap_or_else(|| limits_of(&input.variable));
            Some(InputLimits { path: input.path.clone(), quantity: input.quantity()?, low_si, high_si, share })
        });
        let unknown = self.epistemic.iter().filter_map(|input| {
            let [low_si, high_si] = input.variable.ends();
            Some(InputLimits { path: input.path.clone(), quantity: input.quantity()?, low_si, high_si, share: 1.0 })
        });
        random.chain(unknown).collect()
    }
}

/// The limits of a random input, and the probability of lying within them.
fn limits_of(variable: &RandomVariable) -> (f64, f64, f64) {
    let reach = DEVIATIONS * variable.standard_deviation();
    let [first, last] = [variable.quantile(0.0), variable.quantile(1.0)];
    if first.is_finite() && last.is_finite() {
        return (first, last, 1.0);
    }
    let low = if first.is_finite() { first } else { variable.mean() - reach };
    let high = if last.is_finite() { last } else { variable.mean() + reach };
    let outside = if first.is_finite() { 0.0 } else { variable.cdf(low) };
    let above = if last.is_finite() { 0.0 } else { variable.survival(high) };
    (low, high, 1.0 - outside - above)
}
