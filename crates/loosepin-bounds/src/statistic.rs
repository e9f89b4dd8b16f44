//! Statistics of a scalar response.

pub use loosepin_terms::Statistic;
