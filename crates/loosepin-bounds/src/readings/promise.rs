//! A promise that needs no model of S: how many values of u it takes, and what is promised.
//!
//! Of n values of u, independent and uniform in the box, the greatest one-sided limit is B = max U(u_i). With confidence 1 - β the
//! statistic exceeds B in a share of the box of at most ε. `docs/theory/promise.md` has the proof.
//!
//! R. Tempo, E. W. Bai and F. Dabbene, "Probabilistic robustness analysis: explicit bounds for the minimum number of samples", Systems &
//! Control Letters 30 (1997) 237-242, for limits that never fail. G. Calafiore and M. C. Campi, "The scenario approach to robust control
//! design", IEEE Transactions on Automatic Control 51 (2006) 742-753.

use crate::data::direction::Direction;
use loosepin_terms::{Event, Side, Statistic};
use loosepin_uncertainty::{binomial_tail, clopper_pearson};

/// Runs at the values of u, and how probably the limit that they give fails.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum InnerRuns {
    /// The statistic itself is known at each u: nothing is random.
    Exact,
    /// Runs of its own at each u: limits fail independently of each other.
    Independent {
        /// Probability γ that a limit fails, at most.
        miss: f64,
    },
    /// The same random numbers at every u: limits fail together.
    Common {
        /// Probability γ that a limit fails, at most.
        miss: f64,
        /// Share a of the worst values of u at which they fail together, of which the proof takes account.
        together: f64,
    },
}

impl InnerRuns {
    /// Values of u so that with `confidence` at least `share` of the box keeps the bound; `None` if no number of them suffices.
    ///
    /// ```text
    /// exact          n >= ln β / ln(1 - ε)
    /// independent    n >= ln β / ln(1 - ε (1 - γ))
    /// common         n >= ln(β - γ/a) / ln(1 - ε (1 - a))
    /// ```
    ///
    /// ε = 1 - share, β = 1 - confidence.
    pub fn values_needed(self, share: f64, confidence: f64) -> Option<usize> {
        self.values_for(share, 1.0 - confidence)
    }

    /// As [`InnerRuns::values_needed`], for a promise that fails with probability `miss_all` at most.
    pub(crate) fn values_for(self, share: f64, miss_all: f64) -> Option<usize> {
        let beyond = 1.0 - share;
        let (spent, hit) = match self {
            Self::Exact => (0.0, beyond),
            Self::Independent { miss } => (0.0, beyond * (1.0 - miss)),
            Self::Common { miss, together } => (miss / together, beyond * (1.0 - together)),
        };
        let left = miss_all - spent;
        let is_possible = left > 0.0 && left < 1.0 && hit > 0.0 && hit < 1.0;
        is_possible.then(|| (libm::log(left) / libm::log1p(-hit)).ceil() as usize)
    }
}

/// One-sided limit of a statistic at one u, from independent runs there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OneSidedLimit {
    direction: Direction,
    kind: LimitKind,
    range: [f64; 2],
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum LimitKind {
    /// Order statistic of this rank, counted from 1.
    Rank(usize),
    /// By the hits of an event in `runs` runs; with a miss of 0 the share itself.
    Hits { event: Event, runs: u64, miss: f64 },
}

impl OneSidedLimit {
    /// The limit of `statistic` from `runs` runs that fails with probability `miss` at most; with a miss of 0 the statistic of the only
    /// run. `None` if the runs are too few, or where no runs bound the statistic: a mean without a known range has no limit at
    /// all (R. R. Bahadur and L. J. Savage, Annals of Mathematical Statistics 27 (1956) 1115-1122).
    pub fn new(statistic: Statistic, side: Side, runs: usize, miss: f64) -> Option<Self> {
        let kind = match statistic.event() {
            Some(event) => LimitKind::Hits { event, runs: runs as u64, miss },
            None => {
                let probability = statistic.probability_of_quantile()?;
                LimitKind::Rank(if miss == 0.0 { 1 } else { rank(probability, side, runs as u64, miss)? })
            }
        };
        Some(Self { direction: side.into(), kind, range: statistic.range() })
    }

    /// Score that is compared over all u: the greater, the further out is the limit. `values` are those of all runs at one u; where one of
    /// them failed, nothing is known there.
    pub fn score(&self, values: &mut [f64]) -> f64 {
        if values.iter().any(|value| !value.is_finite()) {
            return f64::INFINITY;
        }
        let found = match self.kind {
            LimitKind::Rank(rank) => *values.select_nth_unstable_by(rank - 1, f64::total_cmp).1,
            LimitKind::Hits { event, .. } => values.iter().filter(|&&value| event.holds(value)).count() as f64,
        };
        self.direction.sign() * found
    }

    /// The limit of a score.
    pub fn of_score(&self, score: f64) -> f64 {
        let [least, most] = self.range;
        if score == f64::INFINITY {
            return self.direction.of(least, most);
        }
        let found = self.direction.sign() * score;
        match self.kind {
            LimitKind::Rank(_) => found,
            LimitKind::Hits { runs, miss: 0.0, .. } => found / runs as f64,
            LimitKind::Hits { runs, miss, .. } => clopper_pearson(runs as f64, found, miss)[self.direction.index()],
        }
    }
}

/// The nearest order statistic that is on the wrong side of the quantile at `probability` with probability `miss` at most. Above:
///
/// ```text
/// Y_(r) < q_p  only if at least r of N runs lie below q_p:   P <= P(Bin(N, p) >= r)
/// ```
///
/// It holds for any distribution, with jumps or without. Below it is the same for -Y.
fn rank(probability: f64, side: Side, runs: u64, miss: f64) -> Option<usize> {
    let of_upper = |probability: f64| {
        let fails = |rank: u64| binomial_tail(runs, rank, probability) > miss;
        if fails(runs) {
            return None;
        }
        // The least rank that does not fail: it fails below and not above.
        let (mut low, mut high) = (0, runs);
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            if fails(middle) { low = middle } else { high = middle }
        }
        Some(high as usize)
    };
    match side {
        Side::Upper => of_upper(probability),
        Side::Lower => of_upper(1.0 - probability).map(|rank| runs as usize + 1 - rank),
    }
}

/// Runs at each u without which a quantile at `probability` has no limit on `side` that fails with probability `miss` at most:
/// p^N <= γ.
pub(crate) fn least_runs(probability: f64, side: Side, miss: f64) -> usize {
    let inside = match side {
        Side::Upper => libm::log(probability),
        Side::Lower => libm::log1p(-probability),
    };
    (libm::log(miss) / inside).ceil() as usize
}

#[cfg(test)]
mod tests {
    use super::{InnerRuns, OneSidedLimit, least_runs};
    use loosepin_terms::{Side, Statistic};
    use loosepin_uncertainty::{hash, uniform};

    const INDEPENDENT: InnerRuns = InnerRuns::Independent { miss: 0.01 };
    const COMMON: InnerRuns = InnerRuns::Common { miss: 0.001, together: 0.18 };

    #[test]
    fn published_numbers_of_values() {
        // Tempo, Bai and Dabbene (1997): ln(1/0.01)/ln(1/0.99) = 458.2.
        assert_eq!(InnerRuns::Exact.values_needed(0.99, 0.99), Some(459));
        assert_eq!(InnerRuns::Exact.values_needed(0.999, 0.999), Some(6905));
    }

    #[test]
    fn analytic_numbers_of_values_where_limits_may_fail() {
        assert_eq!(INDEPENDENT.values_needed(0.99, 0.99), Some(463));
        assert_eq!(COMMON.values_needed(0.99, 0.99), Some(658));
        // γ/a = β: nothing is left for the values of u.
        assert_eq!(InnerRuns::Common { miss: 0.01, together: 0.5 }.values_needed(0.99, 0.99), None);
        assert_eq!(INDEPENDENT.values_needed(1.0, 0.99), None);
    }

    #[test]
    fn analytic_it_is_the_least_number_that_suffices() {
        // (1 - hit)^n <= β, and not for one less: multiplied out.
        for (inner, spent, hit) in
            [(InnerRuns::Exact, 0.0, 0.01), (INDEPENDENT, 0.0, 0.0099), (COMMON, 0.001 / 0.18, 0.0082)]
        {
            let values = inner.values_needed(0.99, 0.99).unwrap();
            let fails = |values: usize| spent + (0..values).fold(1.0, |left, _| left * (1.0 - hit));
            assert!(fails(values) <= 0.01 && fails(values - 1) > 0.01, "{inner:?} {values}");
        }
    }

    #[test]
    fn identity_the_rank_keeps_its_miss_in_simulated_samples() {
        // Y uniform: the quantile at p is p. Misses of 20,000 samples against γ with four standard deviations.
        const SAMPLES: u64 = 20_000;
        for (probability, side, runs, miss) in [
            (0.9, Side::Upper, 64, 0.05),
            (0.9, Side::Lower, 64, 0.05),
            (0.3, Side::Upper, 100, 0.01),
            (0.975, Side::Upper, 256, 0.01),
        ] {
            let limit = OneSidedLimit::new(Statistic::Quantile(probability), side, runs, miss).unwrap();
            let misses = (0..SAMPLES).filter(|&sample| {
                let mut values: Vec<f64> = (0..runs as u64).map(|run| uniform(hash(7, sample), run)).collect();
                let found = limit.of_score(limit.score(&mut values));
                if side == Side::Upper { found < probability } else { found > probability }
            });
            let (misses, due) = (misses.count() as f64, miss * SAMPLES as f64);
            assert!(misses <= due + 4.0 * due.sqrt(), "{probability} {side:?}: {misses} misses, {due} allowed");
            // A rank nearer by one would miss more often than it may.
            assert!(misses >= 0.1 * due, "{probability} {side:?}: {misses} misses of {due} allowed");
        }
    }

    #[test]
    fn identity_a_limit_of_a_probability_keeps_its_miss_in_simulated_samples() {
        const SAMPLES: u64 = 20_000;
        const MISS: f64 = 0.02;
        for (probability, side) in [(0.05, Side::Upper), (0.05, Side::Lower), (0.6, Side::Upper)] {
            let limit = OneSidedLimit::new(Statistic::ProbabilityBelow(probability), side, 128, MISS).unwrap();
            let misses = (0..SAMPLES).filter(|&sample| {
                let mut values: Vec<f64> = (0..128).map(|run| uniform(hash(11, sample), run)).collect();
                let found = limit.of_score(limit.score(&mut values));
                if side == Side::Upper { found < probability } else { found > probability }
            });
            let (misses, due) = (misses.count() as f64, MISS * SAMPLES as f64);
            assert!(misses <= due + 4.0 * due.sqrt(), "{probability} {side:?}: {misses} misses, {due} allowed");
        }
    }

    #[test]
    fn analytic_too_few_runs_have_no_limit_of_a_quantile() {
        // 0.975^182 = 0.00998.
        assert_eq!(least_runs(0.975, Side::Upper, 0.01), 182);
        let limit = |runs| OneSidedLimit::new(Statistic::Quantile(0.975), Side::Upper, runs, 0.01);
        assert_eq!((limit(181), limit(182).is_some()), (None, true));
        assert_eq!(least_runs(0.975, Side::Lower, 0.01), 2);
    }

    #[test]
    fn no_runs_bound_a_mean() {
        for statistic in [Statistic::Mean, Statistic::StandardDeviation, Statistic::Cdf] {
            assert_eq!(OneSidedLimit::new(statistic, Side::Upper, 1 << 20, 0.01), None);
        }
    }

    #[test]
    fn a_failed_run_leaves_nothing_known() {
        for (statistic, side, end) in [
            (Statistic::Quantile(0.5), Side::Upper, f64::INFINITY),
            (Statistic::Quantile(0.5), Side::Lower, f64::NEG_INFINITY),
            (Statistic::ProbabilityAbove(0.5), Side::Upper, 1.0),
            (Statistic::ProbabilityAbove(0.5), Side::Lower, 0.0),
        ] {
            let limit = OneSidedLimit::new(statistic, side, 16, 0.01).unwrap();
            let mut values = [0.25; 16];
            assert_ne!(limit.of_score(limit.score(&mut values)), f64::NAN);
            values[7] = f64::NAN;
            assert_eq!(limit.of_score(limit.score(&mut values)), end);
        }
    }
}
