//! Neural networks.

pub(crate) mod ensemble;
pub(crate) mod layer;
pub(crate) mod training;
