//! How heavy a tail is: the index ξ of the generalised Pareto distribution that its excesses resemble.
//!
//! ```text
//! P(Y > y0 + x | Y > y0) ≈ (1 + ξ x/s)^(-1/ξ);   0: exponential, 1/2: no variance from there on, 1: no mean
//! ξ = 2 - a0/(a0 - 2 a1),   a0: mean excess, a1: mean of (1 - F) x excess
//! ```
//!
//! (J. R. M. Hosking and J. R. Wallis, "Parameter and quantile estimation for the generalized Pareto distribution", Technometrics 29 (1987)
//! 339-349.) A sample that has missed a heavy tail looks light where it ends, so that its own tail is no witness. Two others are heard: the
//! upper half of the sample, whose index is known to ±0.1 from 256 runs, and the distributions of the random inputs, which are known.

use super::estimate::{Confidence, mean_of};

/// An interval of a mean is lengthened for skewness, which needs a third moment; that of a variance needs a fourth. Tails of an index below 1/3
/// and 1/4 have them.
const THIRD_MOMENT: f64 = 1.0 / 3.0;
const FOURTH_MOMENT: f64 = 1.0 / 4.0;
/// No index is taken for larger: without a mean there is no excess either.
const MAX_INDEX: f64 = 0.9;
/// Plotting positions (k - 0.35)/n.
const POSITION: f64 = 0.35;

/// Tail index for the error of a mean, for the upper tail of `sorted`, which is in increasing order; `tail` is the number of its outermost
/// values.
pub(crate) fn index_for_mean(sorted: &[f64], tail: usize, confidence: &Confidence) -> f64 {
    of_half(sorted, tail, THIRD_MOMENT).max(confidence.tail_of_inputs).min(MAX_INDEX)
}

/// The index of the error of a mean square, for both tails of values that `sorted` and `negated` have in increasing order.
pub(crate) fn index_for_mean_square(both: [&[f64]; 2], tail: usize, confidence: &Confidence) -> f64 {
    let of_sample = both.map(|sorted| of_half(sorted, tail, FOURTH_MOMENT));
    of_sample[0].max(of_sample[1]).max(confidence.tail_of_inputs).min(MAX_INDEX)
}

/// Value that one in `times` values above `from` exceeds, for the mean excess `scale`: s (m^ξ - 1)/ξ above `from` with s = (1 - ξ) scale,
/// never nearer than by an exponential tail.
pub(crate) fn beyond(from: f64, scale: f64, times: f64, index: f64) -> f64 {
    let logarithm = libm::log(times);
    let exponential = scale * logarithm;
    let heavy = if index > 0.0 { scale * (1.0 - index) * libm::expm1(index * logarithm) / index } else { 0.0 };
    from + heavy.max(exponential)
}

/// The larger index of the upper half and of the outermost values, if that of the half is at least `least`; else 0. Where a response rests at the
/// middle of a sample, as on a stop, what is above it counts as the half; fewer values than `tail` say nothing.
fn of_half(sorted: &[f64], tail: usize, least: f64) -> f64 {
    let middle = sorted.len() - sorted.len() / 2;
    let Some(&at_middle) = sorted.get(middle.saturating_sub(1)) else { return 0.0 };
    let begin = sorted.partition_point(|&value| value <= at_middle);
    let half = if sorted.len() - begin < tail { f64::NAN } else { index_above(sorted, begin) };
    if half >= least { half.max(index_above(sorted, sorted.len() - tail)) } else { 0.0 }
}

/// ξ of the values from place `begin` on, above the value before; NaN if there are too few.
fn index_above(sorted: &[f64], begin: usize) -> f64 {
    if begin == 0 || begin >= sorted.len() {
        return f64::NAN;
    }
    let (from, count) = (sorted[begin - 1], (sorted.len() - begin) as f64);
    let excesses: Vec<f64> = sorted[begin..].iter().map(|value| value - from).collect();
    let weighted = excesses.iter().enumerate();
    let of_rank = weighted.map(|(k, excess)| excess * (1.0 - (k as f64 + 1.0 - POSITION) / count));
    let (first, second) = (mean_of(&excesses), of_rank.sum::<f64>() / count);
    2.0 - first / (first - 2.0 * second)
}

/// ξ of a distribution with this quantile function from the outermost of a sample of `runs` to one of four times as many, by three quantiles whose
/// probabilities of being exceeded have one ratio (J. Pickands, "Statistical inference using extreme order statistics", Annals of Statistics 3
/// (1975) 119-131). 0 where it is lighter than exponential.
pub(crate) fn index_of_distribution(quantile_above: impl Fn(f64) -> f64, runs: usize) -> f64 {
    const SHARE: f64 = 0.125;
    let last = 0.25 / runs as f64;
    if last >= SHARE {
        return 0.0;
    }
    let ratio = (SHARE / last).sqrt();
    let [near, middle, far] = [SHARE, SHARE / ratio, last].map(quantile_above);
    let index = libm::log((far - middle) / (middle - near)) / libm::log(ratio);
    if index.is_finite() { index.max(0.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::{beyond, index_above, index_of_distribution};

    /// Quantiles of a generalised Pareto distribution, s = 1, at evenly spaced probabilities.
    fn pareto(index: f64, count: u32) -> Vec<f64> {
        let above = |k: u32| 1.0 - (f64::from(k) + 0.5) / f64::from(count);
        (0..count).map(|k| (above(k).powf(-index) - 1.0) / index).collect()
    }

    #[test]
    fn analytic_the_index_of_pareto_tails() {
        for index in [-0.5, -0.2, 0.1, 0.3] {
            let values = pareto(index, 4000);
            // Above any value the excesses of such a distribution have the same index.
            for begin in [1, 2000] {
                assert!((index_above(&values, begin) - index).abs() < 0.03, "{index} {}", index_above(&values, begin));
            }
            let quantile = |above: f64| (above.powf(-index) - 1.0) / index;
            assert!((index_of_distribution(quantile, 256) - index.max(0.0)).abs() < 1e-12);
        }
        assert!(index_above(&[1.0, 2.0], 2).is_nan());
    }

    #[test]
    fn analytic_one_of_so_many_values_lies_there() {
        // Mean excess s/(1 - ξ) = 1/0.7; P(X > x) = (1 + 0.3 x)^(-1/0.3) = 1/50.
        let at = beyond(0.0, 1.0 / 0.7, 50.0, 0.3);
        assert!(((1.0 + 0.3 * at).powf(-1.0 / 0.3) - 0.02).abs() < 1e-12, "{at}");
        assert!((beyond(2.0, 1.5, 50.0, 0.0) - 2.0 - 1.5 * 50.0_f64.ln()).abs() < 1e-12);
    }
}
