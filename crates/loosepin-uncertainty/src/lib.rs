//! Random and epistemic inputs, and the points at which a response is evaluated.
//!
//! Elementary functions come from the `libm` crate, never from the platform, so that a sample has the same bits on any
//! processor.
//!
//! A random value is made in two steps: `sobol.rs` gives a point of the unit cube, `random_variable.rs` the quantile of the
//! distribution at each coordinate. Which points, and what is computed there, is the plan of `loosepin-bounds`.

pub mod contributors;
pub mod reliability;

mod dependence;
mod epistemic;
mod evidence;
mod family;
mod functions;
mod fuzzy;
mod interval;
mod points;
mod variables;

pub use dependence::copula::{Copula, EmpiricalCopula};
pub use dependence::correlation::{CopulaError, GaussianCopula, Pair, normal_of_rank, rank_of_normal};
pub use dependence::linear_correlation::{CorrelationSeries, UnattainableCorrelation};
pub use dependence::sample_correlation::sample_correlation;
pub use epistemic::{EpistemicVariable, Members, MembersError};
pub use evidence::{Evidence, EvidenceError, FocalElement, MASS_TOLERANCE};
pub use functions::binomial::{binomial_tail, clopper_pearson};
pub use functions::normal::{normal_cdf, normal_quantile};
pub use functions::student::student_factor;
pub use fuzzy::{FuzzyError, FuzzyNumber, USUAL_CUTS};
pub use interval::{Interval, IntervalError};
pub use points::counter::{hash, normal, uniform};
pub use points::sobol::{MAXIMUM_DIMENSIONS, ScrambledSobol, SobolError};
pub use variables::distribution::{Distribution, DistributionError};
pub use variables::parameter::{EpistemicParameter, Parameter};
pub use variables::random_variable::{QuantileLevel, RandomVariable};
pub use variables::sample_fit::{FEWEST_FITTED, FittedFamily, GoodnessOfFit, SampleFit, SampleFitError};
pub use variables::second_order::SecondOrder;
