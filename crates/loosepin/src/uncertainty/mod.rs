//! Random and epistemic inputs, and the points at which a response is evaluated.
//!
//! Elementary functions come from the `libm` crate, never from the platform, so that a sample has the same bits on any
//! processor.

mod counter;
mod direction_numbers;
mod distribution;
mod epistemic;
mod incomplete_beta;
mod interval;
mod normal;
mod parameter;
mod random_variable;
mod sobol;
mod student;

pub use counter::hash;
pub use distribution::{Distribution, DistributionError};
pub use epistemic::{EpistemicVariable, Members, MembersError};
pub use interval::{Interval, IntervalError};
pub use normal::{normal_cdf, normal_quantile};
pub use parameter::{EpistemicParameter, Parameter};
pub use random_variable::RandomVariable;
pub use sobol::{MAXIMUM_DIMENSIONS, ScrambledSobol, SobolError};
pub use student::student_factor;
