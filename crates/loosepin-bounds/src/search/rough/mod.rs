//! Places where a statistic is not smooth.
//! Kinks, jumps and their reach. Smooth models stand in `models`.

pub(crate) mod broken_reach;
pub(crate) mod kinks;
pub(crate) mod roughness;
pub(crate) mod suspected_kinks;
