//! How random inputs go together.

pub(crate) mod copula;
pub(crate) mod correlation;
pub(crate) mod linear_correlation;
pub(crate) mod sample_correlation;
