//! Sparse polynomial chaos.

pub(crate) mod expansion;
pub(crate) mod index_set;
pub(crate) mod least_angle;
pub(crate) mod polynomial;
pub(crate) mod regression;
