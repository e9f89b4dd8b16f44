//! Counts, energy and impacts over all runs.

use super::material::Material;
use crate::file::EpistemicInput;
use crate::response::extras::{JointExtras, RunExtras};
use loosepin_bounds::{Gaps, Purpose};
use loosepin_math::sort_ascending;
use loosepin_result::study::{EnergyResiduals, GapRecord, HistogramBin, JointImpacts, PurposeRuns, RunCounts};

/// A motion counts as periodic when no pose changed by more than this over the last turn: share of the size, or rad.
pub const SETTLED: f64 = 1e-6;

/// Bars of the histogram of energy residuals in a decade.
const BARS_PER_DECADE: f64 = 2.0;

/// Extras of all finished runs.
fn finished<'m>(material: &'m Material<'_>) -> impl Iterator<Item = RunExtras> + 'm {
    let table = material.table;
    (0..table.len()).filter(|&run| table.failure(run).is_none()).map(|run| material.response.extras(table.values(run)))
}

/// How many runs of which kind.
pub fn counts(material: &Material<'_>) -> RunCounts {
    RunCounts {
        runs: material.table.len() as u64,
        failed: material.table.failed() as u64,
        by_purpose: by_purpose(material),
        outer: material.bounds.outer_points.len() as u64,
        inner: if material.study.random.is_empty() { 1 } else { material.sampling.inner as u64 },
        replicates: if material.study.random.is_empty() { 1 } else { material.sampling.replicates as u64 },
        rounds: u64::from(material.bounds.rounds),
    }
}

/// How finely the box of the epistemic inputs was seen.
pub fn gaps(material: &Material<'_>) -> Option<GapRecord> {
    let Gaps { between_points, between_runs } = material.bounds.gaps?;
    let is_wide = |input: &&EpistemicInput| input.variable.range().is_some_and(|range| range.lower() < range.upper());
    let axes = material.study.epistemic.iter().filter(is_wide).count() as u64;
    Some(GapRecord { between_points, between_runs, axes })
}

/// The runs by what they were for.
fn by_purpose(material: &Material<'_>) -> Vec<PurposeRuns> {
    let runs = |of: Purpose| {
        let inputs = material.table.inputs().iter();
        PurposeRuns { purpose: of, runs: inputs.filter(|inputs| inputs.purpose == of).count() as u64 }
    };
    Purpose::ALL.into_iter().map(runs).filter(|counted| counted.runs > 0).collect()
}

/// Share of the finished runs whose motion repeated itself over the last turn.
pub fn settled_share(material: &Material<'_>) -> Option<f64> {
    let changes: Vec<f64> =
        finished(material).map(|extras| extras.change_over_last_turn).filter(|change| change.is_finite()).collect();
    let settled = changes.iter().filter(|change| **change < SETTLED).count();
    (!changes.is_empty()).then(|| settled as f64 / changes.len() as f64)
}

/// The energy residuals of the finished runs: each run's own check.
pub fn energy(material: &Material<'_>) -> Option<EnergyResiduals> {
    let mut residuals: Vec<f64> =
        finished(material).map(|extras| extras.energy_residual).filter(|residual| residual.is_finite()).collect();
    sort_ascending(&mut residuals);
    let quantile =
        |share: f64| residuals[((residuals.len() as f64 * share).ceil() as usize).clamp(1, residuals.len()) - 1];
    if residuals.is_empty() {
        return None;
    }
    let bar = |residual: f64| (residual.max(1e-17).log10() * BARS_PER_DECADE).floor() as i64;
    let (first, last) = (bar(residuals[0]), bar(residuals[residuals.len() - 1]));
    let edge = |index: i64| 10.0_f64.powf(index as f64 / BARS_PER_DECADE);
    let histogram = (first..=last)
        .map(|index| HistogramBin {
            from: edge(index),
            to: edge(index + 1),
            count: residuals.iter().filter(|&&residual| bar(residual) == index).count() as u64,
        })
        .collect();
    Some(EnergyResiduals {
        median: quantile(0.5),
        quantile_90: quantile(0.9),
        quantile_99: quantile(0.99),
        maximum: residuals[residuals.len() - 1],
        histogram,
    })
}

/// Impacts in each joint with play over all finished runs.
pub fn impacts(material: &Material<'_>) -> Vec<JointImpacts> {
    let runs: Vec<RunExtras> = finished(material).collect();
    let turns = material.study.cycle.recorded_turns;
    let joints = material.response.joints().iter().enumerate();
    if runs.is_empty() {
        return Vec::new();
    }
    joints
        .map(|(index, joint)| {
            let all: Vec<_> = runs.iter().map(|run| run.joints[index]).collect();
            let range = |value: &dyn Fn(&JointExtras) -> f64| {
                all.iter().map(value).fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| [l.min(v), h.max(v)])
            };
            let known = |range: [f64; 2]| (range[0] <= range[1]).then_some(range);
            let mut per_turn: Vec<f64> = all.iter().map(|joint| (joint.contacts - joint.floored) / turns).collect();
            sort_ascending(&mut per_turn);
            let impacts: f64 = all.iter().map(|joint| joint.contacts - joint.floored).sum();
            let beyond: f64 = all.iter().map(|joint| joint.beyond_validity).sum();
            JointImpacts {
                joint: joint.clone(),
                laws: material.response.laws_of_play(index),
                impacts_per_turn: [per_turn[0], per_turn[per_turn.len() / 2], per_turn[per_turn.len() - 1]],
                nominal_restitution: known(range(&|joint| joint.nominal_restitution)),
                delivered_restitution: known(range(&|joint| joint.delivered_restitution)),
                share_outside_validity: (beyond.is_finite() && impacts > 0.0).then(|| beyond / impacts),
                largest_penetration_share: all.iter().map(|joint| joint.largest_penetration_share).fold(0.0, f64::max),
                peak_force_n: all.iter().map(|joint| joint.peak_force_n).fold(0.0, f64::max),
                floored_contacts: all.iter().map(|joint| joint.floored).sum::<f64>() as u64,
            }
        })
        .collect()
}
