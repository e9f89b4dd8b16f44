//! Bands at single values of the epistemic inputs that were run: what would be if one knew the value.

use std::collections::HashMap;

use super::material::Material;
use crate::file::{Ask, EpistemicInput};
use crate::response::columns::BAND;
use loosepin_bounds::{Purpose, between_order_statistics};
use loosepin_result::study::{CurveRange, ValueBand};
use loosepin_uncertainty::EpistemicVariable;
use rayon::prelude::*;

/// Values for which a result has bands, at most: the first ones of the plan.
const MAX_VALUES: usize = 64;
/// With fewer runs the ends of the band lie beyond the extreme ones: 1/0.025.
const FEWEST_RUNS: usize = 40;
/// Digits that are kept: finer than any screen.
const DIGITS: usize = 6;

/// Quantiles of the finished runs at each value, counted pose by pose, within `mixed`, which holds for all of them. Empty if no input is
/// epistemic, or where one has masses: there `mixed` holds for the shares of its values, not at each.
pub fn value_bands(material: &Material<'_>, ask: &Ask, mixed: &CurveRange) -> Vec<ValueBand> {
    let epistemic = &material.study.epistemic;
    let has_masses = |input: &EpistemicInput| {
        matches!(input.variable, EpistemicVariable::Evidence(_) | EpistemicVariable::SecondOrder(_))
    };
    if epistemic.is_empty() || epistemic.iter().any(has_masses) {
        return Vec::new();
    }
    let mut order: Vec<&[f64]> = Vec::new();
    let mut runs: HashMap<Vec<u64>, Vec<usize>> = HashMap::new();
    for (run, inputs) in material.table.inputs().iter().enumerate() {
        if inputs.purpose != Purpose::DoubleLoop || material.table.failure(run).is_some() {
            continue;
        }
        let key = inputs.epistemic.iter().map(|value| value.to_bits()).collect();
        let own = runs.entry(key).or_default();
        if own.is_empty() {
            order.push(&inputs.epistemic);
        }
        own.push(run);
    }
    let mut meant: Vec<(&[f64], &Vec<usize>)> = Vec::new();
    for epistemic in order {
        let key: Vec<u64> = epistemic.iter().map(|value| value.to_bits()).collect();
        meant.extend(runs.get(&key).filter(|own| own.len() >= FEWEST_RUNS).map(|own| (epistemic, own)));
    }
    meant.truncate(MAX_VALUES);
    let of_value = |&(epistemic, own): &(&[f64], &Vec<usize>)| {
        let mut band = CurveRange::default();
        let mut values = Vec::with_capacity(own.len());
        for (pose, &column) in ask.columns.iter().enumerate() {
            values.clear();
            values.extend(own.iter().map(|&run| material.table.values(run)[column]).filter(|value| value.is_finite()));
            // What is counted at one value cannot leave what holds for all of them but by chance.
            let [low, high] = [&mixed.lower_si, &mixed.upper_si].map(|end| end.get(pose).copied().unwrap_or(f64::NAN));
            let mut values = InPart::new(&mut values);
            let [lower, upper] = BAND.map(|probability| values.quantile(probability)).map(|value| {
                // What is not a number stays none: `max` would make it a limit.
                if value.is_nan() { value } else { rounded(value).max(low).min(high) }
            });
            band.lower_si.push(lower);
            band.upper_si.push(upper);
        }
        ValueBand { at: material.witness(epistemic), runs: own.len() as u64, band }
    };
    meant.par_iter().map(of_value).collect()
}

/// Values of which quantiles are asked for, mostly from below: all but a few of them need no order.
struct InPart<'v> {
    values: &'v mut [f64],
    /// So many of them, at the beginning, are the least.
    least: usize,
}

impl<'v> InPart<'v> {
    fn new(values: &'v mut [f64]) -> Self {
        Self { values, least: 0 }
    }

    /// The quantile as bounds have it; NaN if there are too few values for it.
    fn quantile(&mut self, probability: f64) -> f64 {
        let count = self.values.len();
        let value = between_order_statistics(count, probability * count as f64, |place| self.at(place));
        if value.is_finite() { value } else { f64::NAN }
    }

    /// The value at `place` in increasing order.
    fn at(&mut self, place: usize) -> f64 {
        if place < self.least {
            return *self.values[..self.least].select_nth_unstable_by(place, f64::total_cmp).1;
        }
        let (_, found, _) = self.values[self.least..].select_nth_unstable_by(place - self.least, f64::total_cmp);
        self.least = place + 1;
        *found
    }
}

fn rounded(value: f64) -> f64 {
    format!("{:.*e}", DIGITS - 1, value).parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::InPart;

    #[test]
    fn analytic_quantiles_between_neighbours() {
        // The k-th of 40 stands at (k - 1/2)/40: the share 0.025 between the first, at 0.0125, and the second, at 0.0375.
        // In another order than theirs.
        let mut values: Vec<f64> = (1..=40).map(|k| f64::from(1 + 7 * k % 40)).collect();
        let mut values = InPart::new(&mut values);
        // From below, then from above.
        let found = [0.025, 0.5, 0.975, 0.25, 0.25, 0.975].map(|probability| values.quantile(probability));
        for (found, due) in found.into_iter().zip([1.5, 20.5, 39.5, 10.5, 10.5, 39.5]) {
            assert!((found - due).abs() < 1e-12, "{found} {due}");
        }
        assert!(InPart::new(&mut []).quantile(0.5).is_nan());
    }
}
