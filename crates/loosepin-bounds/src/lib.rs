//! Bounds of statistics over the epistemic inputs: the direct double loop.
//!
//! A response turns a row of numbers into a row of numbers. Its random inputs X have distributions, its epistemic inputs
//! u are known to lie in a set U: intervals, and lists of which each holds the one that is true. Every combination of the
//! members of lists has a box of the intervals of its own, searched by itself with the same random numbers; the extremes are
//! those of all boxes. For every requested statistic S of every requested column Y = g(X, u),
//!
//! ```text
//! S_low = min over u in U of S(u),   S_up = max over u in U of S(u),   S(u) = statistic of g(X, u) over X.
//! ```
//!
//! Where an input has evidence or is a fuzzy number the box has parts (`search/parts.rs`): every statistic has its extremes in each of
//! them from the same runs, and masses add (`readings/evidence.rs`). Where an interval may hold another value for each sample the
//! extremes are taken sample by sample (`readings/random_set.rs`).
//!
//! Planning and running are separate: [`DoubleLoop::next_round`] says which runs come next, given the [`SampleTable`] of
//! all rounds before; whoever calls it runs them in any order and on any machine, and adds them in the order given.
//! [`DoubleLoop::results`] turns the finished table into [`Bounds`]. [`evaluate()`] does all of it in one call. [`Refinement`] makes
//! the samples larger until the bounds are as near as they are asked to be.
//!
//! Six floors, each of which knows those below it only:
//!
//! ```text
//! data         questions, runs, bounds
//! estimators   statistics at one u, with their errors
//! search       models of quantities over u, what they leave open, and the next points
//! measures     statistics at all u, and what is searched for their extremes: a file for each estimator
//! readings     answers: interval, evidence, fuzzy numbers, random sets, second-order probability
//! plan         which runs are made;   by_surrogate: the same with runs replaced by what was learned from a few
//! ```

#![cfg_attr(test, allow(clippy::disallowed_methods, reason = "tests make files of their own"))]

mod by_surrogate;
mod data;
mod estimators;
mod measures;
mod parallel;
mod plan;
mod readings;
mod search;

pub use by_surrogate::{
    ColumnGroup, Confirmation, GroupBounds, Learned, LearnedComparison, LearnedGroup, LearnedTreatments, MAX_WITNESSES,
    SurrogateBounds, SurrogateInput, SurrogatePair, SurrogatePlan, SurrogatePlanError, SurrogateRounds,
    SurrogateSection, SurrogateSettings,
};
pub use data::bound::{Bound, BoundError, BoundPair, CutBounds, Guarantee, Treatment, Witness};
pub use data::defaults::{BAND_PROBABILITY, CUT_STANDARD_DEVIATIONS, PERCENTILES, USUAL_GROWTH};
pub use data::gaps::Gaps;
pub use data::problem::{Problem, Reading, Request, Sampling};
pub use data::scratch::Scratch;
pub use data::table::{Failure, Purpose, RunInputs, SampleTable, TableError};
pub use estimators::probability::least_counted_runs;
pub use loosepin_terms::{Event, NumberKind, Side, Statistic, between_order_statistics};
pub use plan::check::{MAX_OUTER, ProblemError};
pub use plan::double_loop::DoubleLoop;
pub use plan::error::PlanError;
pub use plan::evaluate::{EvaluateError, Function, Response, evaluate, execute};
pub use plan::promise::{
    PROMISE_MISS, PromiseError, PromisePlan, PromiseRequest, PromiseSettings, PromisedBound, least_promise_runs,
};
pub use plan::refinement::{Assessment, Goal, Refinement, RefinementStatus};
pub use readings::bounds::Bounds;
pub use readings::coverage::{Coverage, CoveragePoint};
pub use readings::pinching::{PinchedEnd, PinchedInput, Pinching};
pub use readings::probability_box::ProbabilityBox;
pub use readings::promise::InnerRuns;
pub use readings::second_order::{Percentile, StatisticPercentiles};
pub use readings::simultaneous::SimultaneousBand;
pub use readings::treatment::{Band, TreatmentComparison};

#[cfg(test)]
mod cases;

/// The program of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
