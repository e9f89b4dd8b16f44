//! Bounds with few runs: the double loop uses a surrogate, and direct runs check its error.
//!
//! [`SurrogatePlan`] takes the same [`Problem`](crate::Problem) as the direct double loop and goes through four steps, of which only the
//! first and the third make runs:
//!
//! ```text
//! training_round    runs over X and u together (Purpose::Training)             -> SampleTable
//! learn             a surrogate of each group of columns, held-out error       -> Learned
//! confirming_round  the double loop on the surrogate; direct runs with the
//!                   same X at the witnesses of its bounds (Purpose::Confirming) -> SampleTable
//! results           bounds corrected by the direct runs, widened by the rest   -> SurrogateBounds
//! ```
//!
//! **What is conceded.** A surrogate says ŝ(X, u) with a standard deviation σ(X, u) whose square is right on average over
//! held-out runs. The double loop goes over ŝ and over both ends of the band ŝ ± kσ at once, as columns of one response: an extreme
//! of the mean, of a quantile or of a probability on the far end of the band is what the statistic can be when the surrogate
//! errs everywhere by kσ to the same side, at whichever u that goes furthest. k is 3 at first; where direct runs differ from ŝ by
//! more than twice σ in the root mean square, it is 1.5 times as much. A mean moves by the mean of the error over X and a deviation
//! by no more than that of the error, so that both have a smaller k, told by the same direct runs (`reach.rs`).
//! The distance from the bound on ŝ to that on the band is the part `surrogate` of [`BoundError`](crate::BoundError).
//!
//! **What is corrected.** At the witness u*, with direct runs g at some of the inner points,
//!
//! ```text
//! E g = E ŝ + E(g - ŝ),    P(g > L) = P(ŝ > L) + E(1(g > L) - 1(ŝ > L))
//! ```
//!
//! are estimated without bias, whatever the surrogate (control variates). Deviations and quantiles are not, nor is a u repaired that
//! the surrogate did not show: such bounds are not called confirmed.
//!
//! **Noise.** Where the held-out error does not fall with more runs ([`SurrogateVerdict`](loosepin_surrogate::SurrogateVerdict)), its distribution is
//! part of ŝ: every inner run draws from it, the same share of it at every u.
//!
//! Outside the range of its runs a surrogate gives no answer: such inner runs count as failed, which widens what they belong to.

mod confirm;
mod learned;
mod plan;
mod reach;
mod response;
mod results;
mod rounds;
mod search;
mod section;
mod settings;
mod space;
mod treatments;

pub use confirm::Confirmation;
pub use learned::{Learned, LearnedGroup};
pub use plan::{SurrogatePlan, SurrogatePlanError};
pub use results::{GroupBounds, SurrogateBounds, SurrogatePair};
pub use rounds::SurrogateRounds;
pub use section::SurrogateSection;
pub use settings::{ColumnGroup, MAX_WITNESSES, SurrogateSettings};
pub use space::SurrogateInput;
pub use treatments::{LearnedComparison, LearnedTreatments};

#[cfg(test)]
mod cases;
