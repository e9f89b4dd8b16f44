//! The search for extremes over the box of the epistemic inputs: models of statistics, what they leave open, and the next points.
//! It sees values with errors at points of a unit box, and knows neither runs nor statistics.

mod climb;
pub(crate) mod design;
mod extremes;
mod furthest;
pub(crate) mod gaps;
pub(crate) mod models;
mod next;
pub(crate) mod parts;
mod promises;
pub(crate) mod reach;
pub(crate) mod rough;
pub(crate) mod scouts;
pub(crate) mod search_box;
mod summits;
mod surroundings;
pub(crate) mod target;
