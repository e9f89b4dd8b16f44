//! How long the positions of a run can be trusted, measured by a second run of another order at a tenth of the tolerance.
//!
//! Contacts amplify errors, so that the local error of a step, which is what a tolerance limits, says little about the error of a position some
//! impacts later. Two runs that err differently part as fast as each parts from the exact motion.

mod horizon;
mod measure;
mod positions;
mod second_run;

pub use measure::measure_trust;
pub use positions::PositionHistory;
pub use second_run::{SecondRun, compare_positions};
