//! A problem with exact bounds.

use loosepin_bounds::{Failure, Problem as Question, Request, Response, Sampling, Statistic};
use loosepin_uncertainty::{Distribution, Interval, RandomVariable};

/// A response of random numbers X and unknown numbers u.
pub type Function = Box<dyn Fn(&[f64], &[f64]) -> f64 + Send + Sync>;
/// What moves with u.
pub type Location = Box<dyn Fn(&[f64]) -> f64 + Send + Sync>;

/// A statistic with its exact ends.
#[derive(Debug, Clone, Copy)]
pub struct Exact {
    pub statistic: Statistic,
    pub ends: [f64; 2],
}

pub struct Problem {
    /// Number of standard normal inputs.
    pub random: usize,
    pub intervals: Vec<[f64; 2]>,
    pub response: Function,
    /// What is looked at to tell whether the problem is visible, with its ends and the scatter of a run beside it.
    pub location: Location,
    pub location_ends: [f64; 2],
    pub scatter: f64,
    /// Probability of what happens in the fewest mechanisms.
    pub rarest: f64,
    pub exact: Vec<Exact>,
    /// Of the response: round-off is a share of it.
    pub magnitude: f64,
}

impl Problem {
    /// What is asked, with a seed.
    pub fn question(&self, seed: u64) -> Question {
        let normal = Distribution::Normal { mean: 0.0, standard_deviation: 1.0 };
        let normal = RandomVariable::try_new(normal).expect("a distribution");
        let interval = |&[low, high]: &[f64; 2]| Interval::try_new(low, high).expect("an interval").into();
        let requests = self.exact.iter().map(|exact| Request { column: 0, statistic: exact.statistic }).collect();
        Question {
            compared_columns: vec![0],
            sampling: Sampling { seed, ..Sampling::default() },
            ..Question::new(vec![normal; self.random], self.intervals.iter().map(interval).collect(), requests)
        }
    }
}

impl Response for Problem {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        columns[0] = (self.response)(random, epistemic);
        Ok(())
    }
}
