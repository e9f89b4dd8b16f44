//! Bands at single values of the epistemic inputs that were run: what would be if one knew the value.

use std::collections::HashMap;

use super::material::Material;
use crate::columns::{BAND, PlannedAsk};
use loosepin_bounds::Purpose;
use loosepin_result::study::{CurveRange, ValueBand};

/// Values for which a result has bands, at most: the first ones of the plan fill the box.
const MOST_VALUES: usize = 64;
/// Fewer runs show no quantile.
const FEWEST_RUNS: usize = 16;
/// Digits that are kept: finer than any screen.
const DIGITS: usize = 6;

/// Quantiles of the runs at each value, counted pose by pose, within `mixed`, which holds for all of them. Nothing where no input is
/// epistemic.
pub fn value_bands(material: &Material<'_>, planned: &PlannedAsk, mixed: &CurveRange) -> Vec<ValueBand> {
    if material.study.epistemic.is_empty() {
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
    let of_value = |epistemic: &&[f64]| {
        let key: Vec<u64> = epistemic.iter().map(|value| value.to_bits()).collect();
        let own = runs.get(&key).filter(|own| own.len() >= FEWEST_RUNS)?;
        let mut band = CurveRange::default();
        for (pose, &column) in planned.columns.iter().enumerate() {
            let mut values: Vec<f64> = own.iter().map(|&run| material.table.values(run)[column]).collect();
            values.retain(|value| value.is_finite());
            values.sort_by(f64::total_cmp);
            // What is counted at one value cannot leave what holds for all of them but by chance.
            let [low, high] = [&mixed.lower_si, &mixed.upper_si].map(|end| end.get(pose).copied().unwrap_or(f64::NAN));
            let [lower, upper] = BAND.map(|probability| quantile(&values, probability)).map(|value| {
                // What is not a number stays none: `max` would make it a limit.
                if value.is_nan() { value } else { rounded(value.max(low).min(high)) }
            });
            band.lower_si.push(lower);
            band.upper_si.push(upper);
        }
        Some(ValueBand { at: material.witness(epistemic), runs: own.len() as u64, band })
    };
    order.iter().filter_map(of_value).take(MOST_VALUES).collect()
}

/// The quantile of sorted values, between neighbours linearly (definition 7 of Hyndman and Fan 1996); not a number where there is none.
fn quantile(sorted: &[f64], probability: f64) -> f64 {
    let place = probability * sorted.len().saturating_sub(1) as f64;
    let below = place.floor() as usize;
    let share = place - below as f64;
    match (sorted.get(below), sorted.get(below + 1)) {
        (Some(low), Some(high)) => low + share * (high - low),
        (Some(low), None) => *low,
        _ => f64::NAN,
    }
}

fn rounded(value: f64) -> f64 {
    format!("{:.*e}", DIGITS - 1, value).parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::quantile;

    #[test]
    fn analytic_quantiles_between_neighbours() {
        let values: Vec<f64> = (0..=40).map(f64::from).collect();
        assert_eq!([0.0, 0.025, 0.5, 1.0].map(|probability| quantile(&values, probability)), [0.0, 1.0, 20.0, 40.0]);
        assert_eq!(quantile(&[3.0, 4.0], 0.25), 3.25);
        assert!(quantile(&[], 0.5).is_nan());
    }
}
