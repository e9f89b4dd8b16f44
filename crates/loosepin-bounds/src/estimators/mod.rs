//! Statistics at one u, with their errors, from the runs made there.
//! Counts, moments, order statistics, polynomials, with the error that runs show. What varies with u is not seen here.

pub(crate) mod estimate;
pub(crate) mod gathered;
pub(crate) mod index;
pub(crate) mod known;
pub(crate) mod mean_error;
pub(crate) mod moments;
pub(crate) mod order_statistics;
pub(crate) mod ordered;
pub(crate) mod polynomials;
pub(crate) mod pool;
pub(crate) mod probability;
pub(crate) mod quantile;
pub(crate) mod replicates;
pub(crate) mod sample;
pub(crate) mod sampled;
mod stratification;
pub(crate) mod tail;
pub(crate) mod unsampled_events;
