//! The sampling error of a mean over runs: of their values, or of the squares of their distances from the mean.
//!
//! ```text
//! t/√R √(max(s², j²) + (e/n)²/R) (1 + max(γ_R, γ_N/√n, 0)),   γ: positive towards the end of the interval
//! ```
//!
//! with R replicates of n runs each, N = R n, t Student's factor, and
//!
//! * s: standard deviation of the means of the replicates;
//! * j: what steps of the response may hide. A stratified replicate hits a step k or k + 1 times. Where all hit it k times, s is 0 though
//!   k + 1 may be the next. Each gap g between neighbouring values counts as an even chance in every replicate, j² = (z/t)² Σ g²/4n²
//!   (z: the factor of a normal distribution, since j is not estimated from R numbers);
//! * e: by how much one more run would lie beyond the largest R values, which are those of the outermost stratum of every replicate. It is
//!   put where one of N runs lies with probability 1/4 (nearly), by a tail through the largest 4R values: an exponential one, or a heavier one
//!   where the upper half of the sample or a random input shows it ([`super::tail`]). The samples that missed a long tail are those with a small s;
//! * γ_R: skewness of the means of the replicates, γ_N/√n that of the mean of n independent runs whose skewness is that of all N.
//!   The mean of few values from a skewed law is low where their spread is small, so the interval must be longer on that side: N. J.
//!   Johnson, "Modified t tests and confidence intervals for asymmetrical populations", Journal of the American Statistical Association
//!   73 (1978) 536-544, whose own correction is for many values.
//!
//! No interval of a mean holds for every distribution (R. R. Bahadur and L. J. Savage, "The nonexistence of certain statistical procedures
//! in nonparametric problems", Annals of Mathematical Statistics 27 (1956) 1115-1122). What is assumed here: values that no run has
//! shown are not much further out than that tail, and a part of probability p shows itself in N >= 5/p runs.

use super::estimate::{Confidence, PowerSums, mean_of, skewness, variance_of_mean};
use super::ordered::Ordered;
use super::tail::{beyond, index_for_mean, index_for_mean_square};

/// The tail is taken through this many values a replicate, but never more than this share of all.
const TAIL_PER_REPLICATE: usize = 4;
const MAX_TAIL: f64 = 0.25;
/// One more run is put where one of this many times N runs would lie.
const EXTRAPOLATION_FACTOR: f64 = 4.0;

/// Distances from the mean over a sample to both ends of its confidence interval.
pub(crate) fn error_of_mean(ordered: &Ordered<'_>, confidence: &Confidence) -> (f64, f64) {
    let sorted = ordered.sorted();
    let means: Vec<f64> = ordered.sample.replicates().map(mean_of).collect();
    let negated: Vec<f64> = sorted.iter().rev().map(|value| -value).collect();
    let excess = [&negated, sorted].map(|sorted| {
        let index = index_for_mean(sorted, tail_length(sorted, means.len()), confidence);
        excess(sorted, means.len(), index, |value| value)
    });
    error(&means, sorted, ordered.sample.sums(), excess, confidence)
}

/// The same for the mean square of its distances from the mean, which have a tail upwards only; the tail is one of the distance.
pub(crate) fn error_of_mean_square(ordered: &Ordered<'_>, confidence: &Confidence) -> (f64, f64) {
    let sample = ordered.sample;
    let &PowerSums { count, mean, square: sum_of_squares, .. } = sample.sums();
    let square = |distance: f64| distance * distance;
    let replicates = sample.replicates().count();
    let (values, mut sorted) = (ordered.sorted(), ordered.distances(mean));
    let negated: Vec<f64> = values.iter().rev().map(|value| -value).collect();
    let index = index_for_mean_square([&negated, values], tail_length(values, replicates), confidence);
    let excess = [0.0, excess(&sorted, replicates, index, square)];
    sorted.iter_mut().for_each(|distance| *distance = square(*distance));
    let squares: Vec<f64> = sample.values().iter().map(|value| square(value - mean)).collect();
    let means: Vec<f64> = sample.replicate_ranges().map(|own| mean_of(&squares[own])).collect();
    error(&means, &sorted, &PowerSums::about(&squares, sum_of_squares / count), excess, confidence)
}

/// Both distances; `means`: those of the replicates, `sorted`: all values in increasing order, `sums`: theirs, `excess`: e downwards and
/// upwards.
fn error(means: &[f64], sorted: &[f64], sums: &PowerSums, excess: [f64; 2], confidence: &Confidence) -> (f64, f64) {
    let replicates = means.len() as f64;
    let each = sums.count / replicates;
    let spread = replicates * variance_of_mean(means);
    if !spread.is_finite() {
        return (spread, spread);
    }
    let gaps: f64 = sorted.windows(2).map(|pair| (pair[1] - pair[0]) * (pair[1] - pair[0])).sum();
    let steps = (confidence.normal / confidence.student).powi(2) * gaps / (4.0 * each * each);
    let skewness = [skewness(means), sums.skewness() / each.sqrt()];
    let towards = |sign: f64, excess: f64| {
        let unseen = (excess / each).powi(2) / replicates;
        let error = confidence.student * ((spread.max(steps) + unseen) / replicates).sqrt();
        error * (1.0 + skewness.iter().map(|skewness| sign * skewness).fold(0.0, f64::max))
    };
    (towards(-1.0, excess[0]), towards(1.0, excess[1]))
}

/// Distance, in terms of `of`, of one more run beyond the mean of the largest values, one for each replicate; 0 if these are all equal.
fn excess(sorted: &[f64], replicates: usize, index: f64, of: impl Fn(f64) -> f64) -> f64 {
    let Some((outermost, beyond)) = extrapolated_extreme(sorted, replicates, index) else { return 0.0 };
    let outermost: Vec<f64> = outermost.iter().map(|&value| of(value)).collect();
    (of(beyond) - mean_of(&outermost)).max(0.0)
}

/// So many of the largest values make the tail.
pub(super) fn tail_length(sorted: &[f64], replicates: usize) -> usize {
    (TAIL_PER_REPLICATE * replicates).min((MAX_TAIL * sorted.len() as f64) as usize)
}

/// The largest values of a sample, one for each replicate, and where one more run would lie beyond them by a tail of this `index`; `None` if
/// they are all equal, as where the response ends there.
pub(super) fn extrapolated_extreme(sorted: &[f64], replicates: usize, index: f64) -> Option<(&[f64], f64)> {
    let (count, tail) = (sorted.len(), tail_length(sorted, replicates));
    let outermost = &sorted[count - replicates.min(tail)..];
    if outermost.first()? == outermost.last()? {
        return None;
    }
    let from = sorted[count - tail - 1];
    let scale = mean_of(&sorted[count - tail..]) - from;
    Some((outermost, beyond(from, scale, EXTRAPOLATION_FACTOR * tail as f64, index)))
}
