//! Errors of plans and of results.

use thiserror::Error;

use super::check::ProblemError;
use loosepin_uncertainty::{IntervalError, SobolError};

/// Errors when making a plan or its next round.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum PlanError {
    /// The problem breaks a rule.
    #[error(transparent)]
    Problem(#[from] ProblemError),
    /// Sobol' points do not exist in that many dimensions.
    #[error(transparent)]
    Sobol(#[from] SobolError),
    /// A random input has no finite interval between the quantiles at which it is cut.
    #[error("random input {input}, cut at {standard_deviations} standard deviations: {source}")]
    Cut {
        input: usize,
        /// Cut, in standard deviations.
        standard_deviations: f64,
        /// Reason why the quantiles are no interval.
        source: IntervalError,
    },
    #[error("the table has {found} columns; the problem has {expected}")]
    OtherColumns { found: usize, expected: usize },
    #[error(
        "point {point} has {found} runs; its plan has {expected}\nhint: add all runs of a round before asking for the next"
    )]
    UnfinishedPoint {
        /// Outer index.
        point: u32,
        found: usize,
        expected: usize,
    },
    #[error(
        "point {point} has {value} for epistemic input {input}, which is none of its list\nhint: add the runs as the plan gave them"
    )]
    UnknownMember {
        /// Outer index.
        point: u32,
        input: usize,
        value: f64,
    },
    #[error("the table is empty\nhint: run the rounds first")]
    NoRuns,
}
