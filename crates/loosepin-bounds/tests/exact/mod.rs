//! A response with exact bounds, and how bounds are held against them: what campaigns of such problems share.

use loosepin_bounds::{BoundPair, Failure, Problem, Request, Response, Sampling, Statistic};
use loosepin_uncertainty::{Distribution, Interval, RandomVariable, binomial_tail};

/// Probability of a miss that is stated for an end.
pub const STATED_MISS: f64 = 0.005;
/// Probability with which any test fails where all ends miss as often as stated.
pub const LEVEL: f64 = 0.01;
/// Differences of this share of the exact width, and of the size of the response, are round-off.
const ROUND_OFF: [f64; 2] = [1e-9, 2e-15];

pub const NORMAL: Distribution = Distribution::Normal { mean: 0.0, standard_deviation: 1.0 };
pub const UNIT: [f64; 2] = [0.0, 1.0];

/// A response of random numbers X and unknown numbers u.
pub type Function = Box<dyn Fn(&[f64], &[f64]) -> f64 + Send + Sync>;

/// A statistic with its exact bounds.
#[derive(Debug, Clone, Copy)]
pub struct Exact {
    pub statistic: Statistic,
    pub ends: [f64; 2],
}

/// A problem with exact bounds.
pub struct Case {
    pub name: &'static str,
    random: Vec<Distribution>,
    pub intervals: Vec<[f64; 2]>,
    response: Function,
    pub exact: Vec<Exact>,
    /// Of the response: round-off is a share of it.
    magnitude: f64,
    inner: usize,
}

/// How bounds met the exact ones.
#[derive(Debug, Clone, Copy)]
pub struct Met {
    pub is_missed: [bool; 2],
    /// By how much each end is short, in exact widths; negative where it is further out. An end that is not a number is infinitely short.
    pub short: [f64; 2],
    pub has_no_end: bool,
    /// Of widened over exact width; of the value, where the exact width is 0.
    pub width: f64,
}

impl Case {
    pub fn new(
        name: &'static str,
        random: &[Distribution],
        intervals: &[[f64; 2]],
        response: impl Fn(&[f64], &[f64]) -> f64 + Send + Sync + 'static,
    ) -> Self {
        let (random, intervals) = (random.to_vec(), intervals.to_vec());
        let inner = Sampling::default().inner;
        Self { name, random, intervals, response: Box::new(response), exact: Vec::new(), magnitude: 10.0, inner }
    }

    pub fn with(mut self, statistic: Statistic, ends: [f64; 2]) -> Self {
        self.exact.push(Exact { statistic, ends });
        self
    }

    pub fn with_inner(self, inner: usize) -> Self {
        Self { inner, ..self }
    }

    pub fn with_magnitude(self, magnitude: f64) -> Self {
        Self { magnitude, ..self }
    }

    /// What is asked, with a seed.
    pub fn question(&self, seed: u64) -> Problem {
        let random = self.random.iter().map(|law| RandomVariable::try_new(law.clone()).expect("a distribution"));
        let interval = |&[low, high]: &[f64; 2]| Interval::try_new(low, high).expect("an interval").into();
        let requests = self.exact.iter().map(|exact| Request { column: 0, statistic: exact.statistic }).collect();
        Problem {
            compared_columns: vec![0],
            sampling: Sampling { seed, inner: self.inner, ..Sampling::default() },
            ..Problem::new(random.collect(), self.intervals.iter().map(interval).collect(), requests)
        }
    }

    /// How `pairs`, one for each statistic, meet the exact bounds.
    pub fn met(&self, pairs: &[BoundPair]) -> Vec<Met> {
        assert_eq!(pairs.len(), self.exact.len(), "a pair of bounds for each statistic");
        self.exact.iter().zip(pairs).map(|(exact, pair)| exact.met(pair, self.magnitude)).collect()
    }
}

impl Response for Case {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        columns[0] = (self.response)(random, epistemic);
        Ok(())
    }
}

impl Exact {
    fn met(&self, pair: &BoundPair, magnitude: f64) -> Met {
        let [low, high] = self.ends;
        let width = if high > low { high - low } else { low.abs().max(f64::MIN_POSITIVE) };
        let allowed = ROUND_OFF[0].max(ROUND_OFF[1] * magnitude / width);
        let widened = [pair.lower.widened, pair.upper.widened];
        let short = [widened[0] - low, high - widened[1]];
        let short = short.map(|short| if short.is_nan() { f64::INFINITY } else { short / width });
        Met {
            is_missed: short.map(|short| short > allowed),
            short,
            has_no_end: widened.iter().any(|end| end.is_infinite()),
            width: (widened[1] - widened[0]) / width,
        }
    }
}

/// The largest number of misses of `trials` that is not less probable than `level` where an end is missed with [`STATED_MISS`].
pub fn most_misses(trials: u64, level: f64) -> u64 {
    let is_last = |misses: &u64| binomial_tail(trials, misses + 1, STATED_MISS) < level;
    (0..=trials).find(is_last).unwrap_or(trials)
}

/// The median; infinite numbers count, and of none it is not a number.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
