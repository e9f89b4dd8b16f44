//! Differences of the replicates of a sample from their mean: they show the part of a sampling error that neighbouring points share.

use super::estimate::{mean_of, variance_of_mean};
use super::sample::Sample;

/// `of` each replicate less their mean, replicate by replicate, at every one of `samples`; empty if a replicate has no finished run, or if
/// the samples have polynomials, so that there is no sampling noise.
pub(crate) fn differences(samples: &[&Sample], of: impl Fn(&[f64], usize) -> f64) -> Vec<Vec<f64>> {
    let count = samples.first().map_or(0, |sample| sample.planned_replicates());
    let is_known = |sample: &&Sample| {
        sample.smooth().is_none() && sample.planned_replicates() == count && sample.replicates().count() == count
    };
    if count < 2 || !samples.iter().all(is_known) {
        return Vec::new();
    }
    let mut differences: Vec<Vec<f64>> = (0..count).map(|_| Vec::with_capacity(samples.len())).collect();
    let mut own = Vec::with_capacity(count);
    for (point, sample) in samples.iter().enumerate() {
        own.clear();
        own.extend(sample.replicates().map(|values| of(values, point)));
        let mean = mean_of(&own);
        for (replicate, value) in differences.iter_mut().zip(&own) {
            replicate.push(value - mean);
        }
    }
    differences
}

/// How much quantiles differ by [`differences`] in shares at or below `limits`, one for each point: the share times the slope of the
/// quantile there (R. R. Bahadur, "A note on quantiles in large samples", Annals of Mathematical Statistics 37 (1966)
/// 577-580).
pub(crate) fn differences_of_quantiles(samples: &[&Sample], limits: &[f64], slopes: &[f64]) -> Vec<Vec<f64>> {
    let share = |values: &[f64], point: usize| {
        values.iter().filter(|&&value| value <= limits[point]).count() as f64 / values.len() as f64
    };
    let mut differences = differences(samples, share);
    for replicate in &mut differences {
        for (difference, slope) in replicate.iter_mut().zip(slopes) {
            *difference *= -slope;
        }
    }
    differences
}

/// The mean variance of `differences` over the points; `None` if there are none.
pub(crate) fn variance_of_replicates(differences: &[Vec<f64>]) -> Option<f64> {
    let points = differences.first()?.len();
    let of = |point: usize| -> Vec<f64> { differences.iter().map(|replicate| replicate[point]).collect() };
    Some((0..points).map(|point| variance_of_mean(&of(point))).sum::<f64>() / points as f64)
}

#[cfg(test)]
mod tests {
    use super::super::estimate::mean_of;
    use super::super::sample::Sample;
    use super::{differences, differences_of_quantiles, variance_of_replicates};

    fn sample(replicates: [[f64; 2]; 3]) -> Sample {
        Sample::new(replicates.into_iter().map(IntoIterator::into_iter))
    }

    #[test]
    fn analytic_each_replicate_differs_from_the_mean_of_all() {
        let samples = [sample([[1.0, 3.0], [4.0, 6.0], [7.0, 9.0]]), sample([[0.0, 0.0], [0.0, 0.0], [3.0, 3.0]])];
        let found = differences(&samples.each_ref(), |values, _| mean_of(values));
        assert_eq!(found, [vec![-3.0, -1.0], vec![0.0, -1.0], vec![3.0, 2.0]]);
    }

    #[test]
    fn analytic_more_runs_below_a_limit_are_a_lower_quantile() {
        // Both runs, one and none of each replicate lie at or below 3.5: half of them in the mean.
        let samples = [sample([[1.0, 3.0], [3.0, 6.0], [7.0, 9.0]])];
        let found = differences_of_quantiles(&samples.each_ref(), &[3.5], &[4.0]);
        assert_eq!(found, [[-2.0], [0.0], [2.0]]);
        // (4 + 0 + 4)/(3 · 2)
        assert!((variance_of_replicates(&found).unwrap() - 8.0 / 6.0).abs() < 1e-15);
        assert_eq!(variance_of_replicates(&[]), None);
    }

    #[test]
    fn a_replicate_without_a_finished_run_belongs_to_no_other() {
        // Each point lacks another replicate: the two that are left at each of them do not belong together.
        const FAILED: [f64; 2] = [f64::NAN; 2];
        let samples = [sample([FAILED, [4.0, 6.0], [7.0, 9.0]]), sample([[0.0, 0.0], [1.0, 1.0], FAILED])];
        assert!(differences(&samples.each_ref(), |values, _| mean_of(values)).is_empty());
    }
}
