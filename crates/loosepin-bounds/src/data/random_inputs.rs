//! Random inputs at given values of the epistemic ones, among which parameters of their distributions may be.

use super::problem::Problem;
use loosepin_uncertainty::{Interval, IntervalError, QuantileLevel, RandomVariable, normal_cdf};

/// Values of each uncertain parameter at which the quantiles of a distribution are looked at for their extremes.
const VALUES_OF_A_PARAMETER: usize = 5;

/// Parameters of one distribution of which every combination of values is looked at; of more only the corners are.
const MAX_PARAMETERS_IN_A_GRID: usize = 4;

impl Problem {
    /// Quantile level of each random input at a point of the unit cube.
    pub(crate) fn levels(&self, point: &[f64]) -> Vec<QuantileLevel> {
        match &self.copula {
            Some(copula) => copula.levels(point),
            None => point.iter().map(|&probability| QuantileLevel::Probability(probability)).collect(),
        }
    }

    /// The random inputs with parameters among the epistemic inputs.
    pub(crate) fn inputs_with_parameters(&self) -> Vec<usize> {
        let mut inputs: Vec<usize> = self.parameters.iter().map(|parameter| parameter.random).collect();
        inputs.sort_unstable();
        inputs.dedup();
        inputs
    }

    /// Whether an epistemic input is a parameter of a distribution and reaches the response in no other way.
    pub(crate) fn is_parameter(&self, epistemic: usize) -> bool {
        self.parameters.iter().any(|parameter| parameter.epistemic == epistemic)
    }

    /// The distribution of random input `input` at these values of the epistemic inputs; `None` if there is none.
    pub(crate) fn variable_at(&self, input: usize, epistemic: &[f64]) -> Option<RandomVariable> {
        let own = self.parameters.iter().filter(|parameter| parameter.random == input);
        let values = own.map(|parameter| (parameter.parameter, epistemic[parameter.epistemic]));
        self.random[input].with_parameters(values).ok()
    }

    /// Values of the random inputs at these levels of their distributions at `epistemic`. NaN if the parameters
    /// describe no distribution: such a run fails, and counts as unknown.
    pub(crate) fn random_at(&self, epistemic: &[f64], levels: &[QuantileLevel]) -> Vec<f64> {
        let value = |(input, &level): (usize, &QuantileLevel)| {
            if self.parameters.iter().any(|parameter| parameter.random == input) {
                self.variable_at(input, epistemic).map_or(f64::NAN, |variable| variable.at(level))
            } else {
                self.random[input].at(level)
            }
        };
        levels.iter().enumerate().map(value).collect()
    }

    /// Random input `input` cut at `cut_standard_deviations`: from the least lower to the greatest upper quantile that any of
    /// its distributions has.
    pub(crate) fn widest_cut(&self, input: usize) -> Result<Interval, IntervalError> {
        let ends = |variable: &RandomVariable| {
            [-1.0, 1.0].map(|sign| variable.quantile(normal_cdf(sign * self.cut_standard_deviations)))
        };
        let own: Vec<_> = self.parameters.iter().filter(|parameter| parameter.random == input).collect();
        if own.is_empty() {
            let [lower, upper] = ends(&self.random[input]);
            return Interval::try_new(lower, upper);
        }
        let values = if own.len() <= MAX_PARAMETERS_IN_A_GRID { VALUES_OF_A_PARAMETER } else { 2 };
        let combinations = values.saturating_pow(own.len() as u32);
        let (mut lower, mut upper) = (f64::INFINITY, f64::NEG_INFINITY);
        for combination in 0..combinations {
            let mut rest = combination;
            let parameters = own.iter().map(|parameter| {
                let fraction = (rest % values) as f64 / (values - 1) as f64;
                rest /= values;
                (parameter.parameter, self.epistemic[parameter.epistemic].at(fraction))
            });
            if let Ok(variable) = self.random[input].with_parameters(parameters) {
                let [low, high] = ends(&variable);
                (lower, upper) = (lower.min(low), upper.max(high));
            }
        }
        Interval::try_new(lower, upper)
    }
}
