//! Kriging: a Gaussian process through the runs.
//! Its linear algebra, kernel and likelihood. The Gaussian process of the search over u stands in `loosepin-bounds`.

pub(crate) mod gaussian_process;
pub(crate) mod kernel;
pub(crate) mod kriging;
pub(crate) mod likelihood;
