//! Before anything runs: the plans of all questions, goals and budget, what a study will cost.
//! No run is made here but those that are timed.

pub(crate) mod budget;
pub(crate) mod cost_estimate;
pub(crate) mod estimate_cost;
pub(crate) mod goals;
pub(crate) mod plans;
pub(crate) mod problem;
