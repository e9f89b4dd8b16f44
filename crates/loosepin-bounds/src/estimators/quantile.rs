//! Quantiles with errors from order statistics.

use super::estimate::{Confidence, Estimate, FailureExtremes};
use super::known::{SampleQuery, SampleResult};
use super::order_statistics::OrderStatistics;
use super::ordered::Ordered;
use super::probability::effective_runs;
use super::sample::Sample;
use loosepin_terms::between_order_statistics;

/// The quantile of the finished and failed runs at `probability`.
///
/// The value interpolates between order statistics (y_(k) at (k - 1/2)/N, A. Hazen 1914). Its error inverts a test of the
/// share below it (R. S. Woodruff, "Confidence intervals for medians and other position measures", Journal of the American
/// Statistical Association 47 (1952) 635-646) for the number of runs that [`super::probability`] takes for independent ones
/// ([`fewest_below`]); where the interval needs an order statistic that the sample does not have, it is infinite on that side.
pub(crate) fn quantile(sample: &Sample, confidence: &Confidence, probability: f64) -> FailureExtremes {
    quantile_and_slope(sample, confidence, probability).0
}

/// [`quantile`], and how fast that of the finished runs rises with the probability, from the order statistics within a standard deviation
/// of the count below it; 0 without two of them, or where polynomials give the quantile.
///
/// ```text
/// q' = N (y_(h) - y_(l))/√(k (k + 1)),   k = h - l
/// ```
///
/// The spacings of N independent runs are nearly exponential with mean q'/N, so that the square of k of them together is k (k + 1) (q'/N)²
/// on average, and q'² has nearly no bias. Runs that fill the range evenly have spacings that differ less: then it is up to k/(k + 1) too
/// small, and what is taken for noise with it.
pub(crate) fn quantile_and_slope(sample: &Sample, confidence: &Confidence, probability: f64) -> (FailureExtremes, f64) {
    quantile_of_ordered(&Ordered::new(sample), confidence, probability)
}

/// [`quantile_and_slope`]
pub(crate) fn quantile_of_ordered(
    ordered: &Ordered<'_>,
    confidence: &Confidence,
    probability: f64,
) -> (FailureExtremes, f64) {
    let find = || {
        let (estimate, slope) = find(ordered, confidence, probability);
        SampleResult { estimate, slope }
    };
    let found = ordered.sample.known().or_find(SampleQuery::Quantile(probability), confidence, find);
    (found.estimate, found.slope)
}

fn find(ordered: &Ordered<'_>, confidence: &Confidence, probability: f64) -> (FailureExtremes, f64) {
    let sample = ordered.sample;
    if sample.runs() == 0 {
        return (FailureExtremes::UNDEFINED, 0.0);
    }
    let finished = sample.values().len() as f64;
    if finished == 0.0 {
        // Every run failed: it may be anything.
        let [low, high] = [f64::NEG_INFINITY, f64::INFINITY].map(|end| Estimate::symmetric(end, 0.0));
        return (FailureExtremes { low, high }, 0.0);
    }
    if sample.runs() == 1 {
        return (FailureExtremes::both(Estimate::symmetric(sample.values()[0], 0.0)), 0.0);
    }
    let sorted = &mut OrderStatistics::new(ordered, probability);
    let central = interpolate(sorted, probability * finished);
    if let Some(smooth) = sample.smooth()
        && let Some(at) = smooth.quantile(probability, central, smooth.deviation(sample.values()))
    {
        return (FailureExtremes::both(at), 0.0);
    }
    let (runs, failed) = (sample.runs() as f64, sample.failed() as f64);
    let hits = sample.count_up_to(central);
    let shares: Vec<f64> = sample
        .replicates()
        .map(|values| values.iter().filter(|&&value| value <= central).count() as f64 / values.len() as f64)
        .collect();
    let effective = effective_runs(sample, confidence, hits, &shares);
    let [fewest_below, fewest_above] = [probability, 1.0 - probability]
        .map(|share| fewest_below(share, effective, confidence).map(|count| (count * runs / effective).floor()));
    let mut at = |below_everything: f64| {
        let value = interpolate(sorted, probability * runs - below_everything);
        let low = fewest_below.map(|count| count + 1.0 - below_everything);
        let high = fewest_above.map(|count| runs - count - below_everything);
        let low = low.map_or(f64::NEG_INFINITY, |rank| order_statistic(sorted, rank, f64::NEG_INFINITY));
        let high = high.map_or(f64::INFINITY, |rank| order_statistic(sorted, rank, f64::INFINITY));
        let below = if value.is_finite() { (value - low).max(0.0) } else { 0.0 };
        let above = if value.is_finite() { (high - value).max(0.0) } else { 0.0 };
        Estimate { value, below, above }
    };
    let either = FailureExtremes { low: at(failed), high: at(0.0) };
    (either, slope(sorted, probability))
}

/// The x with P(at most x of n runs lie below the quantile at p) = Φ(-z), z the normal factor of `confidence`, that of a binomial distribution; `None` if even no run below it
/// is likelier than that.
///
/// ```text
/// x = n p - z σ + (1 - 2p)(z² - 1)/6 - 1/2,   σ² = n p (1 - p)
/// ```
///
/// (E. A. Cornish and R. A. Fisher, "Moments and cumulants in the specification of distributions", Revue de l'Institut International de
/// Statistique 5 (1938) 307-320, to the skewness, with the correction for continuity.) It is above 0 also where n p is near 0, so that the
/// share (1 - p)ⁿ of no run at all is asked for first.
fn fewest_below(probability: f64, runs: f64, confidence: &Confidence) -> Option<f64> {
    if runs * libm::log1p(-probability) > libm::log(confidence.miss_of_one_side()) {
        return None;
    }
    let factor = confidence.normal;
    let deviation = (runs * probability * (1.0 - probability)).sqrt();
    let skewed = (1.0 - 2.0 * probability) * (factor * factor - 1.0) / 6.0;
    let count = runs * probability - factor * deviation + skewed - 0.5;
    (count >= 0.0).then_some(count)
}

/// The slope of [`quantile_and_slope`].
fn slope(sorted: &mut OrderStatistics<'_>, probability: f64) -> f64 {
    let runs = sorted.count() as f64;
    if sorted.count() < 2 {
        return 0.0;
    }
    let rank = (probability * runs - 0.5).clamp(0.0, runs - 1.0);
    let reach = (runs * probability * (1.0 - probability)).sqrt().max(1.0);
    let low = (rank - reach).floor().max(0.0) as usize;
    let high = (rank + reach).ceil().min(runs - 1.0) as usize;
    let spacings = (high - low) as f64;
    runs * (sorted.at(high) - sorted.at(low)) / (spacings * (spacings + 1.0)).sqrt()
}

/// The value at `rank` = N p; infinite where the rank lies among failed runs.
fn interpolate(sorted: &mut OrderStatistics<'_>, rank: f64) -> f64 {
    between_order_statistics(sorted.count(), rank, |place| sorted.at(place))
}

/// Order statistic `rank`, counted from 1; `beyond` where there is none.
fn order_statistic(sorted: &mut OrderStatistics<'_>, rank: f64, beyond: f64) -> f64 {
    if rank >= 1.0 && rank <= sorted.count() as f64 { sorted.at(rank as usize - 1) } else { beyond }
}

#[cfg(test)]
mod tests {
    use super::super::estimate::Confidence;
    use super::super::sample::Sample;
    use super::{quantile, quantile_and_slope};
    use loosepin_uncertainty::hash;

    #[test]
    fn analytic_the_square_of_the_slope_of_independent_runs_has_no_bias() {
        // The spacings of N uniform numbers are those of N + 1 exponential ones over their sum: q'² is N²/((N + 1)(N + 2)) on average.
        // Five of them: without the correction it would be 1.2 times that.
        const SAMPLES: u64 = 4000;
        const RUNS: u64 = 16;
        let of = |seed: u64| {
            let number = |i: u64| (hash(seed, i) >> 11) as f64 / (1_u64 << 53) as f64;
            let values: Vec<f64> = (0..RUNS).map(number).collect();
            let sample = Sample::new(values.chunks(4).map(|own| own.iter().copied()));
            quantile_and_slope(&sample, &Confidence::new(0.99, 4), 0.5).1
        };
        let mean = (0..SAMPLES).map(|seed| of(seed).powi(2)).sum::<f64>() / SAMPLES as f64;
        let expected = (RUNS * RUNS) as f64 / ((RUNS + 1) * (RUNS + 2)) as f64;
        // The square of five spacings has a deviation of 0.9: 4.5 of the mean.
        assert!((mean / expected - 1.0).abs() < 0.065, "{mean}, not {expected}");
        let one = Sample::new((0..2).map(|_| [3.0].into_iter()));
        assert_eq!(quantile_and_slope(&one, &Confidence::new(0.99, 2), 0.9).1, 0.0);
    }

    fn evenly(count: u32) -> Sample {
        Sample::new((0..8).map(|r| (0..count / 8).map(move |i| (f64::from(8 * i + r) + 0.5) / f64::from(count))))
    }

    #[test]
    fn analytic_quantiles_of_evenly_spaced_numbers() {
        const TOLERANCE: f64 = 1e-12;
        let confidence = Confidence::new(0.95, 8);
        for probability in [0.1, 0.5, 0.975] {
            let at = quantile(&evenly(1024), &confidence, probability);
            assert!((at.low.value - probability).abs() < TOLERANCE, "{probability} {}", at.low.value);
            assert_eq!(at.low, at.high);
            assert!(at.low.above > 0.0 && at.low.above < 0.02 && at.low.below > 0.0);
        }
    }

    #[test]
    fn an_extreme_quantile_that_the_sample_cannot_resolve_has_an_infinite_error() {
        // 0.999²⁵⁶ = 77 % and 0.9999²⁵⁶ = 97 % of such samples have no run beyond it.
        for (confidence, probability) in [(0.95, 0.999), (0.99, 0.9999), (0.999, 0.99999)] {
            let at = quantile(&evenly(256), &Confidence::new(confidence, 8), probability);
            assert!(at.high.above.is_infinite() && at.high.below.is_finite() && at.high.value.is_finite());
            let at = quantile(&evenly(256), &Confidence::new(confidence, 8), 1.0 - probability);
            assert!(at.low.below.is_infinite() && at.low.above.is_finite() && at.low.value.is_finite());
        }
    }

    #[test]
    fn analytic_where_every_run_failed_the_quantile_may_be_anything() {
        for runs in [1, 12] {
            let sample = Sample::new((0..2).map(|_| (0..runs).map(|_| f64::NAN)));
            let at = quantile(&sample, &Confidence::new(0.95, 2), 0.3);
            assert_eq!((at.low.value, at.high.value), (f64::NEG_INFINITY, f64::INFINITY));
        }
    }

    #[test]
    fn analytic_failed_runs_move_the_quantile_either_way() {
        // 90 values 1..90 and 10 failures: the median lies between rank 40 and rank 50.
        let sample =
            Sample::new((0..2).map(|r| (0..50).map(move |i| if i < 45 { f64::from(2 * i + r + 1) } else { f64::NAN })));
        let at = quantile(&sample, &Confidence::new(0.95, 2), 0.5);
        assert_eq!((at.low.value, at.high.value), (40.5, 50.5));
        let at = quantile(&sample, &Confidence::new(0.95, 2), 0.95);
        assert_eq!(at.high.value, f64::INFINITY);
    }
}
