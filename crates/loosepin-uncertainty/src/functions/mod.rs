//! Special functions of probability: distribution functions, their inverses, exact limits.
//! Pure numbers; no variables.

pub(crate) mod binomial;
pub(crate) mod incomplete_beta;
pub(crate) mod incomplete_gamma;
pub(crate) mod normal;
pub(crate) mod student;
