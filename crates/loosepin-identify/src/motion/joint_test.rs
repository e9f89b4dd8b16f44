//! The joint test of all features at one value of the unknowns.
//!
//! Under the true value the measurement is one further draw X_0 beside `n` runs X_1 … X_n, independent and of one distribution: any order of
//! them is equally probable. The distance is d_i = f(X_i; {X_0 … X_n}), where f takes median, scatter on both sides, and covariance from all
//! n + 1 draws, the measurement among them, and does not depend on their order. Another order of the draws therefore only changes the order
//! of the distances: any order of d_0 … d_n is equally probable, and the share of distances at least as large as d_0 is α or less with
//! probability α at most, whatever the distribution of the features (full conformal inference; V. Vovk, A. Gammerman, G. Shafer,
//! "Algorithmic Learning in a Random World", 2005). This is exact without common errors. With them X_0 is the measurement at the shares of its
//! errors that the runs alone would choose: that other shares would be kept is looked for in the tests, not proven. Scales of the runs alone would not do: the measurement would be the only draw that
//! does not widen them.

use super::scatter::{Observation, Scatter};
use super::sided::SidedForm;

/// Standard deviations from the mean within which a measurement is kept whatever its rank: draws that do not scatter differ by round-off.
const CENTRAL: f64 = 1e-3;
/// What α (n + 1) may lack of a whole number: 1 - 0.9 is a little below 0.1.
const ROUND_OFF: f64 = 1e-9;
/// Ranks that are rejected: twice as many as the fewest that can be.
const RANKS: f64 = 2.0;

/// Outcome of the test.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Verdict {
    pub is_consistent: bool,
    /// Distance of the measurement over the distance that is just kept.
    pub distance: f64,
}

/// Runs among which the measurement has a rank that can be rejected, with some to spare, as a number that may be too large.
pub(crate) fn runs_for(alpha: f64) -> f64 {
    (RANKS / alpha).round() - 1.0
}

/// Largest rank that is rejected among `runs` draws and the measurement: α (n + 1), rounded down.
pub(crate) fn due(alpha: f64, runs: usize) -> usize {
    (alpha * (runs + 1) as f64 + ROUND_OFF).floor() as usize
}

/// Tests whether `seen` may be a draw like `runs`, at the level `alpha`; places choose the features that count.
pub(crate) fn joint_test(runs: &[Vec<f64>], places: &[usize], seen: &Observation, alpha: f64) -> Verdict {
    let seen = seen.of(places);
    let chosen: Vec<Vec<f64>> = runs.iter().map(|run| places.iter().map(|place| run[*place]).collect()).collect();
    let Some(scatter) = Scatter::new(&chosen, &seen) else {
        return Verdict { is_consistent: true, distance: 0.0 };
    };
    let form = SidedForm::new(&scatter.rows, &scatter.is_log, &seen.errors);
    let shares = scatter.nearest_shares(&seen, &|values| form.distance(values));
    let nearest = scatter.scaled(&seen.corrected_values(&shares));
    let Scatter { rows, is_log, failed, .. } = scatter;
    let own = form.distance(&nearest);
    // A single run has no rank. Of several, those that failed have one.
    if runs.len() < 2 {
        return Verdict { is_consistent: own <= 1.0, distance: own };
    }
    let mut distances: Vec<f64> = rows.iter().map(|row| form.distance(row)).collect();
    distances.sort_by(|a, b| b.total_cmp(a));
    // With so many draws further off the measurement is kept.
    let due = due(alpha, runs.len());
    let kept = distances[due.saturating_sub(1 + failed).min(distances.len() - 1)];
    let distance = own / kept;
    let mut all = rows;
    all.push(nearest);
    let form = SidedForm::new(&all, &is_log, &seen.errors);
    let own = form.distance(&all[all.len() - 1]);
    let further = all[..all.len() - 1].iter().filter(|row| form.distance(row) >= own).count() + failed;
    let is_consistent = further + 1 > due || own <= CENTRAL;
    // The form with the measurement differs from that of the runs alone: the verdict is that of the first.
    let distance = if is_consistent { distance.min(1.0) } else { distance.max(1.0 + f64::EPSILON) };
    Verdict { is_consistent, distance }
}

#[cfg(test)]
mod tests {
    use super::super::scatter::Observation;
    use super::{due, joint_test};
    use loosepin_study::MotionError;
    use loosepin_uncertainty::{hash, normal, uniform};

    const NONE: MotionError = MotionError { size: 0.0, is_share: false };

    /// Two features that go together, one of them with a long tail.
    fn draw(key: u64) -> Vec<f64> {
        let z = normal(key, 0);
        vec![z + 0.1 * normal(key, 1), (0.8 * z).exp() + 0.05 * uniform(key, 2)]
    }

    fn rejected(trials: u64, errors: [MotionError; 2], wrong: impl Fn(&mut [f64], u64)) -> usize {
        let is_rejected = |trial: &u64| {
            let runs: Vec<Vec<f64>> = (0..199).map(|run| draw(hash(*trial, run))).collect();
            let mut values_si = draw(hash(*trial, 1_000_000));
            wrong(&mut values_si, *trial);
            let seen = Observation { values_si, errors: errors.to_vec(), instruments: vec![0, 0] };
            !joint_test(&runs, &[0, 1], &seen, 0.01).is_consistent
        };
        (0..trials).filter(is_rejected).count()
    }

    #[test]
    fn analytic_the_truth_is_rejected_once_in_a_hundred() {
        // 2/200 of draws: 40 of 4000, standard deviation 6.3.
        let found = rejected(4000, [NONE; 2], |_, _| {});
        assert!((15..=65).contains(&found), "{found}");
    }

    #[test]
    fn identity_a_common_error_within_its_interval_is_no_ground_for_more_rejections() {
        let error = MotionError { size: 0.3, is_share: false };
        let found = rejected(1000, [error; 2], |values, trial| {
            let share = 2.0 * uniform(hash(trial, 7), 0) - 1.0;
            values.iter_mut().for_each(|value| *value += 0.3 * share);
        });
        assert!(found <= 20, "{found}");
    }

    #[test]
    fn analytic_two_features_contradict_each_other_where_each_alone_is_usual() {
        // The first is 0 and the second e^0.8: one standard deviation each, ten of their difference.
        let found = rejected(200, [NONE; 2], |values, _| values.copy_from_slice(&[0.0, 0.8_f64.exp()]));
        assert!(found > 190, "{found}");
        // A common error that moves both alike cannot explain it.
        let error = MotionError { size: 0.3, is_share: false };
        assert!(rejected(200, [error; 2], |values, _| values.copy_from_slice(&[0.0, 0.8_f64.exp()])) > 100);
    }

    #[test]
    fn identity_ranks_that_are_rejected_are_those_of_whole_numbers() {
        // Confidence as its digits: (1 - digits/scale)·(n + 1), divided as integers.
        let all: [(u64, u64); 14] = [
            (5, 10),
            (6, 10),
            (7, 10),
            (75, 100),
            (8, 10),
            (9, 10),
            (93, 100),
            (95, 100),
            (99, 100),
            (995, 1000),
            (999, 1000),
            (9995, 10_000),
            (9999, 10_000),
            (99_998, 100_000),
        ];
        for (digits, scale) in all {
            let alpha = 1.0 - digits as f64 / scale as f64;
            for ranks in 1..=scale.min(400) {
                let count = ranks * 250;
                assert_eq!(due(alpha, count as usize - 1) as u64, (scale - digits) * count / scale, "{digits}/{scale}");
            }
            // The number of runs of an identification: a whole number of ranks wherever 2/α is whole.
            let runs = super::runs_for(alpha) as u64;
            assert_eq!(due(alpha, runs as usize) as u64, (scale - digits) * (runs + 1) / scale, "{digits}/{scale}");
            if 2 * scale % (scale - digits) == 0 {
                assert_eq!((runs + 1, due(alpha, runs as usize)), (2 * scale / (scale - digits), 2));
            }
        }
    }

    #[test]
    fn identity_a_value_at_which_nearly_all_runs_fail_is_kept() {
        let seen = Observation { values_si: vec![5.0], errors: vec![NONE], instruments: vec![0] };
        let runs = |failed: usize| -> Vec<Vec<f64>> {
            (0..199_u64).map(|run| vec![if (run as usize) < failed { f64::NAN } else { normal(run, 0) }]).collect()
        };
        // Rank 2 of 200 is rejected: one run that failed is not enough, two are, and so are all but one.
        for (failed, is_kept) in [(0, false), (1, false), (2, true), (197, true), (198, true), (199, true)] {
            let verdict = joint_test(&runs(failed), &[0], &seen, 0.01);
            assert_eq!(verdict.is_consistent, is_kept, "{failed} failed");
            assert!(if is_kept { verdict.distance <= 1.0 } else { verdict.distance > 1.0 }, "{failed}: {verdict:?}");
        }
    }
}
