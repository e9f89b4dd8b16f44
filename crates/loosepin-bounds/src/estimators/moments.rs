//! Mean and variance with their sampling errors.

use super::estimate::{Confidence, Estimate, FailureExtremes, mean_of, variance_of_mean, variance_with_error};
use super::known::{SampleQuery, SampleResult};
use super::mean_error::{error_of_mean, error_of_mean_square};
use super::ordered::Ordered;
use super::sample::Sample;
use super::unsampled_events::UnsampledEvents;

/// Mean over the finished runs, with its error ([`super::mean_error`]).
pub(crate) fn mean(sample: &Sample, confidence: &Confidence) -> Estimate {
    mean_of_ordered(&Ordered::new(sample), confidence)
}

/// [`mean`]
pub(crate) fn mean_of_ordered(ordered: &Ordered<'_>, confidence: &Confidence) -> Estimate {
    once(ordered, SampleQuery::Mean, confidence, find_mean)
}

fn find_mean(ordered: &Ordered<'_>, confidence: &Confidence) -> Estimate {
    let sample = ordered.sample;
    if let Some(smooth) = sample.smooth() {
        return with_unseen(
            sample,
            confidence,
            smooth.mean(sample.values(), confidence),
            UnsampledEvents::added_to_mean,
        );
    }
    let value = sample.sums().mean;
    if !value.is_finite() {
        return Estimate::UNDEFINED;
    }
    if sample.runs() == 1 {
        return Estimate::symmetric(value, 0.0);
    }
    let (below, above) = error_of_mean(ordered, confidence);
    with_unseen(sample, confidence, Estimate { value, below, above }, UnsampledEvents::added_to_mean)
}

/// Unbiased variance over the finished runs.
///
/// With m the mean of all N values and m_r that of replicate r, E[(y - m)²] falls short of the variance by Var(m), which
/// the replicates show: v = 1/N Σ(y - m)² + Σ(m_r - m)²/(R(R - 1)). For independent points that is the usual N - 1, for
/// scrambled nets, whose mean is far better known, nearly N. The error is that of the mean of (y - m)² ([`super::mean_error`]), by the
/// cube root of v, and that of what it falls short by, (m - μ)², which lies between 0 and t² Var(m). A coin has (y - m)² = 1/4 in every
/// run, so that the second is the only one.
pub(crate) fn variance(sample: &Sample, confidence: &Confidence) -> Estimate {
    variance_of_ordered(&Ordered::new(sample), confidence)
}

/// [`variance`]
pub(crate) fn variance_of_ordered(ordered: &Ordered<'_>, confidence: &Confidence) -> Estimate {
    once(ordered, SampleQuery::Variance, confidence, find_variance)
}

fn find_variance(ordered: &Ordered<'_>, confidence: &Confidence) -> Estimate {
    let sample = ordered.sample;
    if let Some(smooth) = sample.smooth() {
        return with_unseen(
            sample,
            confidence,
            smooth.variance(sample.values(), confidence),
            UnsampledEvents::added_to_variance,
        );
    }
    if sample.values().is_empty() {
        return Estimate::UNDEFINED;
    }
    if sample.runs() == 1 {
        return Estimate::symmetric(0.0, 0.0);
    }
    let sums = sample.sums();
    let means: Vec<f64> = sample.replicates().map(mean_of).collect();
    let shortfall = variance_of_mean(&means);
    let error = error_of_mean_square(ordered, confidence);
    let Estimate { value, below, above } = variance_with_error(sums.square / sums.count + shortfall, error);
    let above = above + (confidence.student.powi(2) - 1.0).max(0.0) * shortfall;
    with_unseen(
        sample,
        confidence,
        Estimate { value, below: below + shortfall, above },
        UnsampledEvents::added_to_variance,
    )
}

/// `estimate` with what rare events that the sample does not show may add to its error.
fn with_unseen(
    sample: &Sample,
    confidence: &Confidence,
    estimate: Estimate,
    add: impl Fn(&UnsampledEvents, Estimate, usize, &Confidence) -> Estimate,
) -> Estimate {
    sample.unseen().map_or(estimate, |unseen| add(&unseen, estimate, sample.runs(), confidence))
}

/// What `find` finds where it is not known yet. Failed runs have no part in it.
fn once(
    ordered: &Ordered<'_>,
    asked: SampleQuery,
    confidence: &Confidence,
    find: impl FnOnce(&Ordered<'_>, &Confidence) -> Estimate,
) -> Estimate {
    let find = || SampleResult { estimate: FailureExtremes::both(find(ordered, confidence)), slope: 0.0 };
    ordered.sample.known().or_find(asked, confidence, find).estimate.low
}

#[cfg(test)]
mod tests {
    use super::super::estimate::{Confidence, standard_deviation};
    use super::super::sample::Sample;
    use super::{mean, variance};

    const TOLERANCE: f64 = 1e-12; // rounding

    fn sample() -> Sample {
        Sample::new([vec![1.0, 4.0, f64::NAN], vec![2.0, 9.0, 3.0]].into_iter().map(Vec::into_iter))
    }

    #[test]
    fn analytic_moments_of_five_numbers() {
        let confidence = Confidence { student: 2.0, normal: 1.0, tail_of_inputs: 0.0 };
        let mean = mean(&sample(), &confidence);
        assert!((mean.value - 3.8).abs() < TOLERANCE);
        // means 2.5 and 14/3: standard error half their distance; the skewness of the five, over √2.5, lengthens the upper end
        let skewness = 112.32 / 5.0 / (38.8_f64 / 5.0).powf(1.5);
        assert!((mean.below - 2.0 * 13.0 / 12.0).abs() < TOLERANCE);
        assert!((mean.above - 2.0 * 13.0 / 12.0 * (1.0 + skewness / 2.5_f64.sqrt())).abs() < TOLERANCE, "{mean:?}");
        let variance = variance(&sample(), &confidence);
        assert!((variance.value - (38.8 / 5.0 + (13.0_f64 / 12.0).powi(2))).abs() < TOLERANCE);
        let deviation = standard_deviation(variance);
        assert!((deviation.value.powi(2) - variance.value).abs() < TOLERANCE);
        assert!(((deviation.value + deviation.above).powi(2) - variance.value - variance.above).abs() < 1e-9);
    }

    #[test]
    fn nothing_finished_is_undefined() {
        let confidence = Confidence::new(0.95, 8);
        let empty = Sample::new([[f64::NAN].into_iter()].into_iter());
        assert!(mean(&empty, &confidence).value.is_nan());
        assert!(variance(&empty, &confidence).above.is_infinite());
    }
}
