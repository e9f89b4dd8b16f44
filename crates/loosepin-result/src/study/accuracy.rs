//! How near the bounds were to be, and how near they are.

use serde::{Deserialize, Serialize};

use super::bound::ResponsePoint;
use loosepin_terms::{Deviation, Statistic};
use loosepin_text::units::{SiUnit, extended};

/// How near the bounds were to be, what that was to cost, and what came of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AccuracyRecord {
    /// Why the samples grew no further.
    pub stop: AccuracyStop,
    /// Stated limit of the cost.
    pub budget: Budget,
    /// Whether the budget was stated.
    pub is_budget_stated: bool,
    /// Rounds that were made: with as many as a budget the same runs are made again.
    pub rounds: u32,
    /// Runs of these rounds.
    pub runs: u64,
    /// Runs of the round that was left, where the budget ended the study.
    pub next_round_runs: Option<u64>,
    /// Requested and reached accuracy, bound by bound; for a curve at the pose that is furthest from it.
    pub targets: Vec<AccuracyOutcome>,
    /// How the targets were approached.
    pub steps: Vec<AccuracyStep>,
}

impl AccuracyRecord {
    /// Whether the bounds are those of surrogates, so that training and confirming runs were added.
    pub fn is_learned(&self) -> bool {
        self.steps.iter().any(|step| step.training > 0)
    }
}

/// Why the samples grew no further.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum AccuracyStop {
    /// All targets are reached, or there are none and the samples are as stated.
    Reached,
    /// The next round would have gone beyond the budget.
    Budget,
    /// More runs are not possible or do not help.
    Exhausted,
}

/// When a study ends although its bounds are not yet as near as asked.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Budget {
    /// Limit of the number of runs.
    Runs {
        /// How many.
        runs: u64,
    },
    /// Before a round that would end later than this after the beginning.
    Time {
        /// Seconds.
        seconds: f64,
    },
    /// After this many rounds: what a study that ended by its time has made.
    Rounds {
        /// How many.
        rounds: u32,
    },
}

/// One target and the bounds that it is of.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AccuracyOutcome {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Place; of a curve the pose that is furthest from the target.
    pub at: ResponsePoint,
    /// The statistic.
    pub statistic: Statistic,
    /// Unit of the numbers.
    pub unit: SiUnit,
    /// Requested largest widening of the bounds.
    #[serde(with = "extended")]
    pub asked_si: f64,
    /// Reached widening.
    #[serde(with = "extended")]
    pub reached_si: f64,
    /// Of that, what the finite samples make.
    #[serde(with = "extended")]
    pub sampling_si: f64,
    /// And what the search over the epistemic inputs makes.
    #[serde(with = "extended")]
    pub optimisation_si: f64,
    /// And what a surrogate does not know, where the bounds are those of one.
    #[serde(default, with = "extended", skip_serializing_if = "is_zero")]
    pub surrogate_si: f64,
    /// Runs that it would take at the pace so far; absent where it is reached or nothing can be foreseen.
    pub runs_needed: Option<u64>,
}

impl AccuracyOutcome {
    /// Whether the bounds are as near as asked.
    pub fn is_reached(&self) -> bool {
        self.reached_si <= self.asked_si
    }
}

/// A size of the samples, and how near it brought the bounds.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct AccuracyStep {
    /// Rounds up to it.
    pub rounds: u32,
    /// Runs up to it.
    pub runs: u64,
    /// Values of the epistemic inputs.
    pub outer: u64,
    /// Samples at each.
    pub inner: u64,
    /// Runs to learn from up to it, where the bounds are those of surrogates.
    #[serde(default, skip_serializing_if = "is_zero_count")]
    pub training: u64,
    /// Direct runs at the values that attain them up to it.
    #[serde(default, skip_serializing_if = "is_zero_count")]
    pub confirming: u64,
    /// The largest widening over the requested one.
    #[serde(with = "extended")]
    pub share: f64,
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

/// Whether there are none: then a file says nothing of them.
pub(crate) fn is_zero_count(count: &u64) -> bool {
    *count == 0
}
