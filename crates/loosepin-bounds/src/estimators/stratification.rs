//! How much better the replicates of a sample are than independent runs, over its whole distribution.

use super::estimate::variance_of_mean;

/// Shares at which the replicates are compared: deciles.
const LEVELS: usize = 10;
/// Independent runs seem to be worth this many times their number over the nine deciles in one of fifty samples of eight replicates.
const MIN_GAIN: f64 = 2.0;
/// At one or two deciles, as where the response has few values, in one of a hundred.
const MIN_GAIN_OF_FEW_VALUES: f64 = 6.0;

/// Whether `replicates` fill the distribution of all their values, which are `sorted`, clearly more evenly than independent runs would.
///
/// ```text
/// K/Σ (V_k/v_k) ≥ 2,   v_k = F_k (1 - F_k)/N
/// ```
///
/// F_k is the share of the finished values up to the k-th decile, V_k the variance of that share as the R replicates show it, v_k that of
/// N independent runs; K of the nine deciles are different values with others above. One share has R - 1 degrees of freedom; those at nine
/// deciles together about three times as many, as the distance of Anderson and Darling between each replicate and all runs has (T. W.
/// Anderson and D. A. Darling 1952). With K below 3 the gain must be 6.
pub(super) fn is_even(sorted: &[f64], replicates: &[&[f64]]) -> bool {
    let count = sorted.len();
    let mut limits: Vec<f64> =
        (1..LEVELS).filter_map(|level| Some(sorted[(count * level / LEVELS).checked_sub(1)?])).collect();
    limits.dedup();
    let of_limit = |&limit: &f64| {
        let share =
            |values: &[f64]| values.iter().filter(|&&value| value <= limit).count() as f64 / values.len() as f64;
        let below = share(sorted);
        let shares: Vec<f64> = replicates.iter().map(|values| share(values)).collect();
        (below < 1.0).then(|| variance_of_mean(&shares) * count as f64 / (below * (1.0 - below)))
    };
    let ratios: Vec<f64> = limits.iter().filter_map(of_limit).collect();
    let due = if ratios.len() < 3 { MIN_GAIN_OF_FEW_VALUES } else { MIN_GAIN };
    !ratios.is_empty() && due * ratios.iter().sum::<f64>() <= ratios.len() as f64
}

#[cfg(test)]
mod tests {
    use super::super::sample::Sample;
    use loosepin_uncertainty::uniform;

    const SAMPLES: u64 = 200;

    /// How many of the samples of eight replicates of 32 values each seem to be even.
    fn even_ones(value: impl Fn(u64, u64, u64) -> f64) -> usize {
        let sample =
            |seed: u64| Sample::new((0..8).map(|r| (0..32).map(|i| value(seed, r, i)).collect::<Vec<_>>().into_iter()));
        (0..SAMPLES).filter(|&seed| sample(seed).is_even()).count()
    }

    #[test]
    fn analytic_one_value_in_each_stratum_is_even() {
        // The share of a replicate below a limit has a variance of at most 1/4/32², that of independent ones 1/4/32: a gain of 32 at least.
        let strata = |seed, r, i| (i as f64 + uniform(seed, 32 * r + i)) / 32.0;
        assert_eq!(even_ones(strata) as u64, SAMPLES);
        assert_eq!(even_ones(|seed, r, i| f64::from(strata(seed, r, i) < 0.4)) as u64, SAMPLES);
    }

    #[test]
    fn a_sample_of_one_value_or_none_shows_nothing() {
        assert!(!Sample::new((0..8).map(|_| [3.0; 4].into_iter())).is_even());
        assert!(!Sample::new((0..8).map(|_| [f64::NAN; 4].into_iter())).is_even());
    }
}
