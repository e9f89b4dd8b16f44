//! Bounds of statistics over the epistemic inputs.

mod statistic;

pub use statistic::Statistic;
