//! A statistic S of which no more is known than its value for a sample, with a sampling error that needs no more.
//!
//! ```text
//! t/√R √(max(s², j²) + Σ D²/R) (1 + max(γ, 0)) + b,   γ, D, b: positive towards the end of the interval
//! ```
//!
//! with R replicates, t Student's factor, and the parts that the error of a mean has too ([`super::mean_error`]), each by what it does to S:
//!
//! * s, γ: standard deviation and skewness of S of the replicates;
//! * j: what steps of the response may hide. Each gap between neighbouring values counts as an even chance in every replicate,
//!   j² = (z/t)² Σ (R Δ)²/4 with Δ the change of S of all values where one of them is moved across the gap. Of the largest gaps it is computed;
//!   the others change S by no more for their width than the worst of these;
//! * D: the change of S where the outermost value of every replicate is put where one more run would lie, at either end of the sample;
//! * b: S of all values less the mean S of the replicates, over √R - 1. A bias that falls as 1/√n at least is no larger. It points away from
//!   the replicates, whose bias is larger.
//!
//! Where single runs show a rare event that no run of the sample does ([`super::unsampled_events`]), what it may do to S is added.

use super::estimate::{Confidence, Estimate, FailureExtremes, mean_of, skewness, variance_of_mean};
use super::known::{SampleQuery, SampleResult};
use super::mean_error::{extrapolated_extreme, tail_length};
use super::ordered::Ordered;
use super::sample::Sample;
use super::tail::index_for_mean_square;
use super::unsampled_events::UnsampledEvents;
use loosepin_math::in_order;
use loosepin_math::sort_by_number;
use loosepin_terms::Statistic;

/// Gaps across which a value is moved.
const MAX_GAPS: usize = 64;

/// `statistic` over the finished runs, with its error.
pub(crate) fn sampled(sample: &Sample, statistic: Statistic, confidence: &Confidence) -> Estimate {
    sampled_of_ordered(&Ordered::new(sample), statistic, confidence)
}

/// [`sampled`]
pub(crate) fn sampled_of_ordered(ordered: &Ordered<'_>, statistic: Statistic, confidence: &Confidence) -> Estimate {
    let find = || SampleResult { estimate: FailureExtremes::both(find(ordered, statistic, confidence)), slope: 0.0 };
    ordered.sample.known().or_find(SampleQuery::Sampled(statistic), confidence, find).estimate.low
}

fn find(ordered: &Ordered<'_>, statistic: Statistic, confidence: &Confidence) -> Estimate {
    let sorted = ordered.sorted();
    let value = statistic.of_sorted(sorted);
    if !value.is_finite() {
        return Estimate::UNDEFINED;
    }
    if ordered.sample.runs() == 1 {
        return Estimate::symmetric(value, 0.0);
    }
    let own = |values: &[f64]| statistic.of_sorted(&in_order(values.iter().copied()));
    let of_replicates: Vec<f64> = ordered.sample.replicates().map(own).collect();
    let replicates = of_replicates.len() as f64;
    let spread = replicates * variance_of_mean(&of_replicates);
    if !spread.is_finite() {
        return Estimate { value, below: f64::INFINITY, above: f64::INFINITY };
    }
    let steps = (0.5 * replicates * confidence.normal / confidence.student).powi(2)
        * square_of_moves(sorted, |changed| statistic.of_sorted(changed) - value);
    let unseen =
        changes_beyond(sorted, of_replicates.len(), confidence, |changed| statistic.of_sorted(changed) - value);
    let skewness = skewness(&of_replicates);
    let bias = (value - mean_of(&of_replicates)) / (replicates.sqrt() - 1.0);
    let of_rare = changes_of_rare(ordered, confidence, |changed| statistic.of_sorted(changed) - value);
    let towards = |sign: f64| {
        let unseen: f64 = unseen.iter().map(|change| (sign * change).max(0.0).powi(2)).sum();
        let variance = (spread.max(steps) + unseen / replicates) / replicates;
        let of_rare = of_rare.iter().map(|change| (sign * change).max(0.0)).fold(0.0, f64::max);
        confidence.student * variance.sqrt() * (1.0 + (sign * skewness).max(0.0)) + (sign * bias).max(0.0) + of_rare
    };
    Estimate { value, below: towards(-1.0), above: towards(1.0) }
}

/// The sum of the squares of `change` over samples in which one of `sorted` has been moved across a gap.
fn square_of_moves(sorted: &[f64], change: impl Fn(&[f64]) -> f64) -> f64 {
    let width = |place: usize| sorted[place + 1] - sorted[place];
    let mut gaps: Vec<usize> = (0..sorted.len() - 1).filter(|&place| width(place) > 0.0).collect();
    sort_by_number(&mut gaps, |&place| -width(place));
    let mut moved = sorted.to_vec();
    let (mut sum, mut steepest) = (0.0, 0.0_f64);
    let (largest, others) = gaps.split_at(gaps.len().min(MAX_GAPS));
    for &place in largest {
        moved[place] = sorted[place + 1];
        let change = change(&moved).abs();
        moved[place] = sorted[place];
        sum += change * change;
        steepest = steepest.max(change / width(place));
    }
    sum + steepest * steepest * others.iter().map(|&place| width(place) * width(place)).sum::<f64>()
}

/// `change` where the outermost values of the sample, one for each replicate, are put further out: below, and above.
fn changes_beyond(
    sorted: &[f64],
    replicates: usize,
    confidence: &Confidence,
    change: impl Fn(&[f64]) -> f64,
) -> [f64; 2] {
    let negated: Vec<f64> = sorted.iter().rev().map(|value| -value).collect();
    // A statistic of any kind may be as a mean square.
    let index = index_for_mean_square([&negated, sorted], tail_length(sorted, replicates), confidence);
    let further = |sorted: &[f64]| -> Option<Vec<f64>> {
        let (outermost, beyond) = extrapolated_extreme(sorted, replicates, index)?;
        let kept = sorted.len() - outermost.len();
        let moved = outermost.iter().map(|value| value.max(beyond));
        Some(sorted[..kept].iter().copied().chain(moved).collect())
    };
    let below = further(&negated).map(|values| in_order(values.iter().map(|value| -value)));
    [below, further(sorted)].map(|changed| changed.map_or(0.0, |values| change(&values)))
}

/// `change` where as many values as may have a rare event that no run shows jump as far as one of a single run: the outermost, either way.
fn changes_of_rare(ordered: &Ordered<'_>, confidence: &Confidence, change: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    let (Some(unseen), sorted) = (ordered.sample.unseen(), ordered.sorted()) else { return Vec::new() };
    let count = UnsampledEvents::most_runs(sorted.len(), confidence);
    let jumped = |own: std::ops::Range<usize>, by: f64| {
        let values = sorted.iter().enumerate();
        in_order(values.map(|(place, value)| if own.contains(&place) { value + by } else { *value }))
    };
    let (lowest, highest) = (0..count, sorted.len() - count..sorted.len());
    let jumps = [lowest, highest].into_iter().flat_map(|own| [-unseen.below, unseen.above].map(|by| (own.clone(), by)));
    jumps.map(|(own, by)| change(&jumped(own, by))).collect()
}

#[cfg(test)]
mod tests {
    use super::super::estimate::{Confidence, Estimate};
    use super::super::moments::mean;
    use super::super::sample::Sample;
    use super::sampled;
    use loosepin_terms::Statistic;
    use loosepin_uncertainty::{hash, normal_quantile, uniform};

    const REPLICATES: usize = 4;

    #[test]
    fn identity_of_a_mean_it_is_the_error_that_means_have() {
        const ROUND_OFF: f64 = 1e-9;
        let confidence = Confidence::new(0.99, REPLICATES);
        // No skewness; and replicates that are all the same, so that gaps and tails alone make the error.
        let rows = [[-3.0, -1.0, 1.0, 3.0], [-2.0, -0.5, 0.5, 2.0], [-2.5, -0.75, 0.75, 2.5], [-3.5, -1.5, 1.5, 3.5]];
        for rows in [rows, [rows[0]; 4], [[-4.0, -2.0, 1.5, 3.0], rows[1], [-1.0, 0.5, 2.0, 5.0], rows[3]]] {
            let sample = Sample::new(rows.into_iter().map(IntoIterator::into_iter));
            let (known, found) = (mean(&sample, &confidence), sampled(&sample, Statistic::Mean, &confidence));
            assert!((known.value - found.value).abs() < ROUND_OFF);
            // The skewness of the values themselves is no part of it.
            assert!(found.below <= known.below + ROUND_OFF && found.below > 0.8 * known.below, "{known:?} {found:?}");
            assert!(found.above <= known.above + ROUND_OFF && found.above > 0.8 * known.above, "{known:?} {found:?}");
        }
    }

    #[test]
    fn analytic_the_deviation_of_normal_values_lies_in_its_interval_as_often_as_stated() {
        const SAMPLES: u64 = 2000;
        const RUNS: u64 = 32;
        let confidence = Confidence::new(0.95, REPLICATES);
        let of = |seed: u64| -> Estimate {
            let value = |run: u64| 0.3 + 2.5 * normal_quantile(uniform(hash(17, seed), run));
            let own = |replicate: u64| (0..RUNS).map(move |k| value(replicate * RUNS + k));
            sampled(&Sample::new((0..REPLICATES as u64).map(own)), Statistic::StandardDeviation, &confidence)
        };
        let is_missed = |at: &Estimate| at.value + at.above < 2.5 || at.value - at.below > 2.5;
        let misses = (0..SAMPLES).map(of).filter(is_missed).count() as f64;
        let due = 0.05 * SAMPLES as f64;
        assert!(misses <= due + 4.0 * due.sqrt(), "{misses} misses, {due} allowed");
        // It is not so wide that it says nothing: half of the width that a normal law gives would miss far more often.
        assert!(misses > 0.02 * due, "{misses} misses");
    }

    #[test]
    fn a_single_run_has_no_error_and_none_no_value() {
        let confidence = Confidence::new(0.99, 2);
        let one = Sample::new([[2.5].into_iter()].into_iter());
        assert_eq!(sampled(&one, Statistic::Mean, &confidence), Estimate::symmetric(2.5, 0.0));
        let none = Sample::new([[f64::NAN, f64::NAN].into_iter()].into_iter());
        assert!(sampled(&none, Statistic::Mean, &confidence).value.is_nan());
        // Without a second replicate the error is not known.
        let alone = Sample::new([[2.5, 3.5].into_iter()].into_iter());
        assert_eq!(sampled(&alone, Statistic::Mean, &confidence).above, f64::INFINITY);
    }

    #[test]
    fn replicates_that_are_all_the_same_have_an_error_nevertheless() {
        // A coin: each replicate hits it 8 times of 16, and one might have hit it 9 times.
        let sample = Sample::new((0..4).map(|_| (0..16).map(|k| if k < 8 { 0.0 } else { 1.0 })));
        let found = sampled(&sample, Statistic::StandardDeviation, &Confidence::new(0.99, 4));
        assert!(found.value == 0.5 && found.below > 0.0 && found.above > 0.0, "{found:?}");
    }
}
