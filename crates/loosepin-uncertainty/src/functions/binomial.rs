//! The binomial distribution: exact limits of a share that was counted.

use crate::functions::incomplete_beta::{incomplete_beta, inverse_incomplete_beta};

/// P(K >= `hits`) where K counts the hits of `runs` independent runs, each a hit with `probability`.
///
/// ```text
/// P(K >= k) = I_p(k, n - k + 1)
/// ```
///
/// Abramowitz and Stegun (1964), 26.5.24.
pub fn binomial_tail(runs: u64, hits: u64, probability: f64) -> f64 {
    if hits == 0 {
        return 1.0;
    }
    if hits > runs {
        return 0.0;
    }
    incomplete_beta(hits as f64, (runs - hits + 1) as f64, probability, 1.0 - probability)
}

/// Lower and upper limit of the probability of a hit after `hits` in `runs` independent runs. Each fails with probability `miss` at
/// most, whatever the probability is.
///
/// ```text
/// P(K >= k) = miss at the lower limit,   P(K <= k) = miss at the upper limit
/// ```
///
/// C. J. Clopper and E. S. Pearson, "The use of confidence or fiducial limits illustrated in the case of the binomial", Biometrika 26
/// (1934) 404-413, in the form of the beta distribution, so that the numbers need not be whole ones.
pub fn clopper_pearson(runs: f64, hits: f64, miss: f64) -> [f64; 2] {
    let rest = runs - hits;
    let lower = if hits > 0.0 { inverse_incomplete_beta(hits, rest + 1.0, miss, 1.0 - miss).0 } else { 0.0 };
    let upper = if rest > 0.0 { inverse_incomplete_beta(hits + 1.0, rest, 1.0 - miss, miss).0 } else { 1.0 };
    [lower, upper]
}

#[cfg(test)]
mod tests {
    use super::{binomial_tail, clopper_pearson};

    /// The terms of the binomial distribution one by one, each from the one before.
    fn summed_tail(runs: u64, hits: u64, probability: f64) -> f64 {
        let mut term = (1.0 - probability).powi(runs as i32);
        let mut sum = 0.0;
        for k in 0..=runs {
            if k >= hits {
                sum += term;
            }
            term *= (runs - k) as f64 / (k + 1) as f64 * probability / (1.0 - probability);
        }
        sum
    }

    #[test]
    fn analytic_the_tail_is_the_sum_of_its_terms() {
        const RELATIVE_TOLERANCE: f64 = 1e-11; // 256 terms, each rounded
        for (runs, probability) in [(7, 0.3), (64, 0.02), (256, 0.9)] {
            for hits in 0..=runs {
                let (found, sum) = (binomial_tail(runs, hits, probability), summed_tail(runs, hits, probability));
                assert!((found - sum).abs() <= RELATIVE_TOLERANCE * sum, "{runs} {hits} {found} {sum}");
            }
            assert_eq!(binomial_tail(runs, runs + 1, probability), 0.0);
        }
    }

    #[test]
    fn analytic_limits_after_no_hit_and_after_hits_alone() {
        // (1 - p)^n = miss
        const TOLERANCE: f64 = 1e-12;
        let bound = 1.0 - 0.01_f64.powf(1.0 / 256.0);
        let [lower, upper] = clopper_pearson(256.0, 0.0, 0.01);
        assert!(lower == 0.0 && (upper - bound).abs() < TOLERANCE, "{upper}");
        let [lower, upper] = clopper_pearson(256.0, 256.0, 0.01);
        assert!((lower - (1.0 - bound)).abs() < TOLERANCE && upper == 1.0, "{lower}");
    }

    #[test]
    fn identity_at_its_limits_a_count_is_as_improbable_as_stated() {
        const RELATIVE_TOLERANCE: f64 = 1e-9;
        for (runs, hits, miss) in [(20, 3, 0.01), (256, 1, 0.001), (1000, 977, 0.05)] {
            let [lower, upper] = clopper_pearson(runs as f64, hits as f64, miss);
            let at_lower = binomial_tail(runs, hits, lower);
            let at_upper = 1.0 - binomial_tail(runs, hits + 1, upper);
            assert!((at_lower / miss - 1.0).abs() < RELATIVE_TOLERANCE, "{at_lower}");
            assert!((at_upper / miss - 1.0).abs() < RELATIVE_TOLERANCE, "{at_upper}");
        }
    }

    #[test]
    fn published_limits_of_two_hits_in_twenty() {
        // Two-sided 95 % limits of 2 in 20, in every table of Clopper and Pearson's: 1.23 % and 31.70 %.
        let [lower, upper] = clopper_pearson(20.0, 2.0, 0.025);
        assert!((lower - 0.0123).abs() < 5e-5 && (upper - 0.3170).abs() < 5e-5, "{lower} {upper}");
    }
}
