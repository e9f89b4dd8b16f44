//! Kriging: a Gaussian process through the runs.

pub(crate) mod gaussian_process;
pub(crate) mod kernel;
pub(crate) mod kriging;
pub(crate) mod likelihood;
