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
//! Where an input has evidence or is a fuzzy number the box has parts (`structure.rs`): every statistic has its extremes in each of
//! them from the same runs, and masses add (`combine.rs`, `spread.rs`). Where an interval may hold another value for each sample the
//! extremes are taken sample by sample (`random_set.rs`).
//!
//! Planning and running are separate: [`DoubleLoop::next_round`] says which runs come next, given the [`SampleTable`] of
//! all rounds before; whoever calls it runs them in any order and on any machine, and adds them in the order given.
//! [`DoubleLoop::results`] turns the finished table into [`Bounds`]. [`evaluate()`] does all of it in one call. [`Refinement`] makes
//! the samples larger until the bounds are as near as they are asked to be.

mod assemble;
mod bound;
mod by_surrogate;
mod combine;
mod coverage;
mod evaluate;
mod gaussian_process;
mod index;
mod inner_basis;
mod measure;
mod moments;
mod orthogonal;
mod pinching;
mod plan;
mod points;
mod pool;
mod preintegration;
mod probability;
mod probability_box;
mod problem;
mod quantile;
mod random_inputs;
mod random_set;
mod refinement;
mod sample;
mod search;
mod search_box;
mod second_order;
mod simultaneous;
mod smooth;
mod smoother;
mod spread;
mod statistic;
mod structure;
mod table;
mod target;
mod treatment;
mod trend;

pub use bound::{Bound, BoundError, BoundPair, Bounds, Guarantee, LevelBounds, Reading, Treatment, Witness};
pub use by_surrogate::{
    ColumnGroup, Confirmation, GroupBounds, Learned, LearnedComparison, LearnedGroup, LearnedTreatments,
    MOST_WITNESSES, SurrogateBounds, SurrogateInput, SurrogatePair, SurrogatePlan, SurrogatePlanError, SurrogateRounds,
    SurrogateSection, SurrogateSettings,
};
pub use coverage::{Coverage, CoveragePoint};
pub use evaluate::{EvaluateError, Response, evaluate, execute};
pub use pinching::{PinchedInput, Pinching};
pub use plan::{DoubleLoop, PlanError};
pub use probability_box::ProbabilityBox;
pub use problem::MOST_OUTER;
pub use problem::{Problem, ProblemError, Request, Sampling};
pub use refinement::{Assessment, Goal, Refinement, Standing};
pub use second_order::{Percentile, StatisticPercentiles};
pub use simultaneous::SimultaneousBand;
pub use statistic::Statistic;
pub use table::{Failure, Purpose, RunInputs, SampleTable, TableError};
pub use treatment::{Band, TreatmentComparison};

#[cfg(test)]
mod correlated_cases;
#[cfg(test)]
mod discrete_cases;
#[cfg(test)]
mod evidence_cases;
#[cfg(test)]
mod exact_cases;
#[cfg(test)]
mod kink_cases;
#[cfg(test)]
mod noisy_cases;
#[cfg(test)]
mod parameter_cases;
#[cfg(test)]
mod periodic_cases;
#[cfg(test)]
mod second_order_cases;
#[cfg(test)]
mod simultaneous_cases;
#[cfg(test)]
mod tail_cases;
