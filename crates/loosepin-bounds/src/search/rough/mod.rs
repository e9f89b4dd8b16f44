//! Places where a statistic is not smooth.

pub(crate) mod broken_reach;
pub(crate) mod kinks;
pub(crate) mod roughness;
pub(crate) mod suspected_kinks;
