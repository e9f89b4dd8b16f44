//! Shares of runs with their sampling errors; failed runs count as unknown.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use super::estimate::{Confidence, Estimate, FailureExtremes, variance_of_mean};
use super::sample::Sample;
use crate::data::problem::Sampling;
use loosepin_terms::Event;
use loosepin_uncertainty::clopper_pearson;

/// Below this many hits or misses a replicate the spread of the replicates says nothing.
const MIN_PER_REPLICATE: usize = 2;
/// Eight replicates of independent runs seem to be worth this many times their number at one limit in one sample of thirty, and over the
/// whole distribution as well in one of two hundred. Were every gain believed, the narrower of two intervals would always be taken, and miss twice as
/// often as stated.
const MIN_GAIN: f64 = 2.0;

/// Limits of shares that were counted, each of which is worked out once: samples of the same size have the same counts again and again.
#[derive(Debug, Default)]
pub(crate) struct ShareLimits(Mutex<BTreeMap<[u64; 3], [f64; 2]>>);

impl ShareLimits {
    /// Those of [`clopper_pearson`].
    fn of(&self, runs: f64, hits: f64, miss: f64) -> [f64; 2] {
        let list = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let key = [runs, hits, miss].map(f64::to_bits);
        let known = list().get(&key).copied();
        known.unwrap_or_else(|| {
            let limits = clopper_pearson(runs, hits, miss);
            list().insert(key, limits);
            limits
        })
    }
}

/// The probability of `event`, by the polynomials of the sample where it has some, else by counting.
pub(crate) fn probability(
    sample: &Sample,
    event: Event,
    confidence: &Confidence,
    limits: &ShareLimits,
) -> FailureExtremes {
    match sample.smooth() {
        Some(smooth) => FailureExtremes::both(smooth.probability(event, 0.0)),
        None => share_with(sample, confidence, limits, |value| event.holds(value)),
    }
}

/// The share of values with property `is_hit`: with m hits and f failures in N runs between m/N and (m + f)/N.
///
/// The error is that of the interval of Clopper and Pearson for n = p(1 - p)/v runs, v the variance of the share that the replicates
/// show: it is not 0 when nothing was hit, and holds for a single hit. Where there are fewer than two hits or misses a replicate, or where
/// the replicates are not clearly better than independent runs, here and over the whole distribution, or single runs show what the sample does not, n = N.
pub(crate) fn share(sample: &Sample, confidence: &Confidence, is_hit: impl Fn(f64) -> bool) -> FailureExtremes {
    share_with(sample, confidence, &ShareLimits::default(), is_hit)
}

/// [`share`] with `limits` that may be known from other samples.
fn share_with(
    sample: &Sample,
    confidence: &Confidence,
    limits: &ShareLimits,
    is_hit: impl Fn(f64) -> bool,
) -> FailureExtremes {
    let count = |values: &[f64]| values.iter().filter(|&&value| is_hit(value)).count();
    let shares: Vec<f64> = sample.replicates().map(|values| count(values) as f64 / values.len() as f64).collect();
    let hits = count(sample.values());
    let runs = sample.runs();
    if runs == 0 {
        return FailureExtremes::UNDEFINED;
    }
    let effective = effective_runs(sample, confidence, hits, &shares);
    let at = |hits: usize| {
        let value = hits as f64 / runs as f64;
        if runs == 1 {
            return Estimate::symmetric(value, 0.0);
        }
        let [low, high] = limits.of(effective, value * effective, confidence.miss_of_one_side());
        // Of independent runs a smaller share varies less. Of even replicates it does not: there the variance is that which they show.
        let least = if effective > runs as f64 {
            confidence.normal * (value * (1.0 - value) / effective).max(0.0).sqrt()
        } else {
            0.0
        };
        Estimate { value, below: (value - low).max(least), above: (high - value).max(least) }
    };
    FailureExtremes { low: at(hits), high: at(hits + sample.failed()) }
}

/// Runs at each value of the epistemic inputs without which no count shows that a share of at least `share` holds: where none of N runs is
/// outside, the upper limit of Clopper and Pearson for the share outside is 1 - γ^(1/N), so that N must be ln γ/ln `share` at least.
/// γ is the chance of a miss on one side at the confidence of all bounds.
pub fn least_counted_runs(share: f64, replicates: usize) -> usize {
    let confidence = Confidence::new(Sampling::default().confidence, replicates.max(2));
    (libm::log(confidence.miss_of_one_side()) / libm::log(share)).ceil() as usize
}

/// The number of independent runs that would know the share as well.
pub(crate) fn effective_runs(sample: &Sample, confidence: &Confidence, hits: usize, shares: &[f64]) -> f64 {
    let finished = sample.values().len();
    let runs = sample.runs() as f64;
    let least = MIN_PER_REPLICATE * shares.len();
    // What no run of a stratified sample shows, none of independent ones may show.
    if hits < least || finished - hits < least || sample.unseen().is_some() {
        return runs;
    }
    let share = hits as f64 / finished as f64;
    // Student's factor instead of the normal one. A stratified replicate hits k or k + 1 times: where all hit k times, the
    // spread is 0 though k + 1 may be the next; the variance is never taken below that of an even chance between the two.
    let widened = (confidence.student / confidence.normal).powi(2) * variance_of_mean(shares);
    let runs_in_replicate = runs / shares.len() as f64;
    let least_variance = 0.25 / (runs_in_replicate * runs_in_replicate * shares.len() as f64);
    let variance = widened.max(least_variance);
    let effective = share * (1.0 - share) / variance;
    if effective >= MIN_GAIN * runs && sample.is_even() { effective } else { runs }
}

#[cfg(test)]
mod tests {
    use super::super::estimate::Confidence;
    use super::super::sample::Sample;
    use super::{effective_runs, share};
    use loosepin_uncertainty::uniform;

    #[test]
    fn analytic_failed_runs_widen_the_share_from_m_over_n_to_m_and_f_over_n() {
        let values = [vec![0.3, 2.0, f64::NAN, 5.0], vec![f64::NAN, 2.5, 0.1, 0.2]];
        let sample = Sample::new(values.into_iter().map(Vec::into_iter));
        let share = share(&sample, &Confidence::new(0.95, 2), |value| value > 1.0);
        assert_eq!((share.low.value, share.high.value), (0.375, 0.625));
        assert!(share.low.below > 0.0 && share.high.above > 0.0);
    }

    #[test]
    fn identity_no_error_is_zero_when_nothing_was_hit() {
        let sample = Sample::new((0..8).map(|_| (0..32).map(f64::from)));
        let share = share(&sample, &Confidence::new(0.95, 8), |value| value > 99.0);
        assert_eq!(share.high.value, 0.0);
        assert!(share.high.above > 0.014 && share.high.above < 0.016);
    }

    const SAMPLES: u64 = 4000;
    /// Above this count of 4,000 misses lies one of ten thousand where one of two hundred misses: 20 + 4 √20.
    const MAX_MISSES: usize = 38;

    /// How many samples of eight replicates of 32 independent values are believed to be better than independent ones about a share of 0.4,
    /// and how many intervals lie above and below it.
    fn of_independent_values(value: impl Fn(f64) -> f64, is_hit: impl Fn(f64) -> bool) -> [usize; 3] {
        let confidence = Confidence::new(0.99, 8);
        let mut found = [0; 3];
        for seed in 0..SAMPLES {
            let replicate = |r: u64| (0..32).map(|i| value(uniform(seed, 32 * r + i))).collect::<Vec<_>>().into_iter();
            let sample = Sample::new((0..8).map(replicate));
            let hits = |values: &[f64]| values.iter().filter(|&&value| is_hit(value)).count();
            let shares: Vec<f64> = sample.replicates().map(|values| hits(values) as f64 / 32.0).collect();
            let runs = effective_runs(&sample, &confidence, hits(sample.values()), &shares);
            let share = share(&sample, &confidence, &is_hit).low;
            found[0] += usize::from(runs > 256.0);
            found[1] += usize::from(share.value - share.below > 0.4);
            found[2] += usize::from(share.value + share.above < 0.4);
        }
        found
    }

    #[test]
    fn independent_runs_are_hardly_ever_believed_to_be_better_and_intervals_miss_as_stated() {
        let of_many_values = of_independent_values(|u| u, |value| value < 0.4);
        let of_two_values = of_independent_values(|u| f64::from(u < 0.4), |value| value > 0.5);
        for [believed, above, below] in [of_many_values, of_two_values] {
            assert!(100 * believed <= SAMPLES as usize, "{believed} of {SAMPLES} believed");
            assert!(above.max(below) <= MAX_MISSES, "{above} above, {below} below of {SAMPLES}");
        }
    }
}
