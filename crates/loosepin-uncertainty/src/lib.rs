//! Random and epistemic inputs, and the points at which a response is evaluated.
//!
//! Elementary functions come from the `libm` crate, never from the platform, so that a sample has the same bits on any
//! processor.
//!
//! A random value is made in two steps: `sobol.rs` gives a point of the unit cube, `random_variable.rs` the quantile of the
//! distribution at each coordinate. Which points, and what is computed there, is the plan of `loosepin-bounds`.

pub mod contributors;
pub mod reliability;

mod binomial;
mod copula;
mod correlation;
mod counter;
mod direction_numbers;
mod distribution;
mod epistemic;
mod evidence;
mod family;
mod fuzzy;
mod incomplete_beta;
mod incomplete_gamma;
mod interval;
mod linear_correlation;
mod normal;
mod open_end;
mod parameter;
mod random_variable;
mod sample_correlation;
mod sample_fit;
mod second_order;
mod sobol;
mod student;

pub use binomial::{binomial_tail, clopper_pearson};
pub use copula::{Copula, EmpiricalCopula};
pub use correlation::{CopulaError, GaussianCopula, Pair, normal_of_rank, rank_of_normal};
pub use counter::{hash, normal, uniform};
pub use distribution::{Distribution, DistributionError};
pub use epistemic::{EpistemicVariable, Members, MembersError};
pub use evidence::{Evidence, EvidenceError, FocalElement, MASS_TOLERANCE};
pub use fuzzy::{FuzzyError, FuzzyNumber, USUAL_CUTS};
pub use interval::{Interval, IntervalError};
pub use linear_correlation::{CorrelationSeries, UnattainableCorrelation};
pub use normal::{normal_cdf, normal_quantile};
pub use parameter::{EpistemicParameter, Parameter};
pub use random_variable::{QuantileLevel, RandomVariable};
pub use sample_correlation::sample_correlation;
pub use sample_fit::{FEWEST_FITTED, FittedFamily, Goodness, SampleFit, SampleFitError};
pub use second_order::SecondOrder;
pub use sobol::{MAXIMUM_DIMENSIONS, ScrambledSobol, SobolError};
pub use student::student_factor;
