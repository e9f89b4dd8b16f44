//! The search for extremes over the box of the epistemic inputs: models of statistics, what they leave open, and the next points.

mod assessment;
mod broken_reach;
pub(crate) mod design;
mod extremes;
mod gaussian_process;
mod grid;
mod index_model;
mod kinks;
mod local;
pub(crate) mod measure;
pub(crate) mod models;
mod next;
pub(crate) mod noise;
pub(crate) mod parts;
pub(crate) mod prediction;
mod promises;
pub(crate) mod reach;
mod roughness;
pub(crate) mod scouts;
pub(crate) mod search_box;
pub(crate) mod shared_grids;
pub(crate) mod smoother;
mod summits;
mod surroundings;
pub(crate) mod target;
pub(crate) mod target_model;
mod trend;
