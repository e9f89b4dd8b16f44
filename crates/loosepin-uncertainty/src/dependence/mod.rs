//! How random inputs go together.
//! Copulas and what turns one measure of correlation into another. A single variable stands in `variables`.

pub(crate) mod copula;
pub(crate) mod correlation;
pub(crate) mod linear_correlation;
pub(crate) mod sample_correlation;
