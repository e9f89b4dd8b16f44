//! Random inputs: distributions as a family, a tolerance, a fit or a sample, their uncertain parameters, correlations. The distributions
//! themselves are those of `loosepin-uncertainty`.

pub(crate) mod correlation;
pub(crate) mod distribution;
pub(crate) mod family;
pub(crate) mod fit;
pub(crate) mod parameter;
pub(crate) mod random;
pub(crate) mod random_problem;
pub(crate) mod tails;
