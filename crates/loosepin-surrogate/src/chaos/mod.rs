//! Sparse polynomial chaos.
//! Its polynomials, the order in which they enter, and the regression. Fitting as such is asked by `fitted`.

pub(crate) mod expansion;
pub(crate) mod index_set;
pub(crate) mod least_angle;
pub(crate) mod polynomial;
pub(crate) mod regression;
