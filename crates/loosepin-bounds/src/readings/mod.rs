//! Results of the runs, for each structure of the epistemic inputs and each way of reading it. A file for each reading: intervals,
//! mixtures, random sets, distributions. Estimators and searches are asked, not changed.

mod added_quantile;
pub(crate) mod bounds;
mod contradiction;
pub(crate) mod coverage;
mod deviation;
mod evidence;
pub(crate) mod experiment;
mod interval;
mod inverted;
mod limits;
pub(crate) mod pinching;
pub(crate) mod probability_box;
pub(crate) mod promise;
pub(crate) mod random_set;
pub(crate) mod second_order;
pub(crate) mod setup;
pub(crate) mod simultaneous;
mod statistics;
pub(crate) mod treatment;
