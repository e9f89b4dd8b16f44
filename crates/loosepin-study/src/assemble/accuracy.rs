//! Reached accuracy of the bounds.

use super::material::Material;
use crate::file::Ask;
use crate::planning::goals::{RoundsEnd, targets};
use loosepin_bounds::{Assessment, RefinementStatus, Statistic};
use loosepin_result::study::{AccuracyOutcome, AccuracyRecord, AccuracyStep, AccuracyStop, BoundEnd};

/// Errors fall at least with this power of the number of runs where anything is to be foreseen, and at most with the other one.
const MIN_PACE: f64 = 0.1;
const MAX_PACE: f64 = 1.5;
/// The power where nothing has been seen yet: that of independent runs.
const USUAL_PACE: f64 = 0.5;

/// Reached accuracy and budget; `None` if neither was stated.
pub fn accuracy(material: &Material<'_>, ended: &RoundsEnd) -> Option<AccuracyRecord> {
    let budget = ended.budget?;
    let plan = material.response.plan();
    let outcomes: Vec<AccuracyOutcome> = targets(material.study, plan)
        .filter_map(|(ask, statistic, asked)| outcome(material, ask, statistic, asked, ended))
        .collect();
    let stop = match (ended.standing, ended.left) {
        (_, Some(_)) => AccuracyStop::Budget,
        (RefinementStatus::Exhausted, None) => AccuracyStop::Exhausted,
        (RefinementStatus::Growing | RefinementStatus::Reached, None) => AccuracyStop::Reached,
    };
    let step = |assessment: &Assessment| AccuracyStep {
        rounds: assessment.rounds,
        runs: assessment.runs as u64,
        outer: assessment.outer as u64,
        inner: assessment.inner as u64,
        training: assessment.training as u64,
        confirming: assessment.confirming as u64,
        share: assessment.share,
    };
    Some(AccuracyRecord {
        // Limits that other columns set may have brought near what the rounds did not.
        stop: if !outcomes.is_empty() && outcomes.iter().all(AccuracyOutcome::is_reached) {
            AccuracyStop::Reached
        } else {
            stop
        },
        budget,
        is_budget_stated: material.study.budget.is_some(),
        rounds: ended.rounds,
        runs: ended.runs as u64,
        next_round_runs: ended.left.map(|runs| runs as u64),
        targets: outcomes,
        steps: ended.history.iter().map(step).collect(),
    })
}

/// The bounds of a statistic against the requested accuracy: the pose that is furthest from it.
fn outcome(
    material: &Material<'_>,
    ask: &Ask,
    statistic: Statistic,
    asked_si: f64,
    ended: &RoundsEnd,
) -> Option<AccuracyOutcome> {
    let widening = |column: usize, end: &BoundEnd| {
        // Failed runs leave no bound of a mean: what was asked for is how well that of the finished runs is known.
        let is_of_finished_runs = material.pair(column, statistic).is_some_and(|pair| pair.unbounded_by_failures);
        let widening_si =
            if is_of_finished_runs { end.error.total_si() } else { (end.widened_si - end.value_si).abs() };
        if widening_si.is_nan() { f64::INFINITY } else { widening_si }
    };
    // What has no bound is as far from the target as can be.
    let ends = ask.columns.iter().map(|&column| (column, material.ends_or_unknown(column, statistic)));
    let ends = ends.flat_map(|(column, ends)| ends.map(|end| (column, end)));
    let (column, end) = ends.max_by(|(a, own), (b, other)| widening(*a, own).total_cmp(&widening(*b, other)))?;
    let reached_si = widening(column, &end);
    Some(AccuracyOutcome {
        output: material.name_of(column),
        of: ask.deviation,
        at: material.point_of(column, ask.location.is_cycle()),
        statistic,
        unit: material.unit_of_statistic(column, statistic),
        asked_si,
        reached_si,
        sampling_si: end.error.sampling_si,
        optimisation_si: end.error.optimisation_si,
        surrogate_si: end.error.surrogate_si,
        runs_needed: if reached_si > asked_si { runs_needed(reached_si / asked_si, ended) } else { None },
    })
}

/// Runs at which an error that is `share` times too large would not be: error ~ runs^-p, p from the first and the last size of the
/// samples, that of independent runs where there was one size only.
fn runs_needed(share: f64, ended: &RoundsEnd) -> Option<u64> {
    let pace = match (ended.history.first(), ended.history.last()) {
        (Some(first), Some(last)) if last.runs > first.runs && first.share.is_finite() => {
            let pace = (first.share / last.share).ln() / (last.runs as f64 / first.runs as f64).ln();
            if pace < MIN_PACE {
                return None;
            }
            pace.min(MAX_PACE)
        }
        _ => USUAL_PACE,
    };
    let needed = ended.runs as f64 * share.powf(1.0 / pace);
    (needed < u64::MAX as f64).then_some(needed.ceil() as u64)
}

#[cfg(test)]
mod tests {
    use super::{RoundsEnd, runs_needed};
    use loosepin_bounds::{Assessment, RefinementStatus};

    fn ended(sizes: &[(usize, f64)]) -> RoundsEnd {
        let assessment = |&(runs, share): &(usize, f64)| Assessment {
            rounds: 3,
            runs,
            outer: 12,
            inner: 64,
            training: 0,
            confirming: 0,
            share,
            sampling_share: share,
            optimisation_share: 0.5 * share,
        };
        let runs = sizes.last().map_or(700, |(runs, _)| *runs);
        let history = sizes.iter().map(assessment).collect();
        RoundsEnd { standing: RefinementStatus::Growing, left: Some(90), rounds: 3, runs, history, budget: None }
    }

    #[test]
    fn analytic_runs_needed_by_the_power_seen() {
        // Four times the runs, a third of the error: p = ln 3/ln 4, and an error 2.5 times too large needs 2.5^(1/p) times the runs.
        let factor = 2.5_f64.powf(4_f64.ln() / 3_f64.ln());
        let expected = (12_000.0 * factor).ceil() as u64;
        let found = runs_needed(2.5, &ended(&[(3000, 7.5), (12_000, 2.5)])).unwrap();
        assert!(found.abs_diff(expected) <= 1, "{found} {expected}");
        // Nothing seen yet: that of independent runs.
        assert_eq!(runs_needed(3.0, &ended(&[])), Some(6300));
        // More runs that did not help tell nothing.
        assert_eq!(runs_needed(3.0, &ended(&[(3000, 3.1), (12_000, 3.0)])), None);
        assert_eq!(runs_needed(f64::INFINITY, &ended(&[])), None);
    }
}
