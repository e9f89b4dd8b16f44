//! Models of a statistic over the box, from its estimates at a few points, and what they predict.
//! Where to look next is decided outside.

pub(crate) mod assessment;
pub(crate) mod gaussian_process;
pub(crate) mod grid;
pub(crate) mod index_model;
pub(crate) mod local;
pub(crate) mod noise;
pub(crate) mod of_points;
pub(crate) mod prediction;
pub(crate) mod shared_grids;
pub(crate) mod smoother;
pub(crate) mod target_model;
pub(crate) mod trend;
