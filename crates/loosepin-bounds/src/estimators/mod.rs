//! Statistics at one u, with their errors, from the runs made there.
//! Counts, moments, order statistics, polynomials, with the error that runs show. What varies with u is not seen here.

pub(crate) mod basis;
pub(crate) mod estimate;
pub(crate) mod gathered;
pub(crate) mod in_order;
pub(crate) mod index;
pub(crate) mod inner_basis;
pub(crate) mod known;
mod known_fits;
pub(crate) mod mean_error;
pub(crate) mod moments;
pub(crate) mod order_statistics;
pub(crate) mod ordered;
pub(crate) mod orthogonal;
pub(crate) mod pool;
pub(crate) mod preintegration;
pub(crate) mod probability;
pub(crate) mod quantile;
pub(crate) mod replicates;
pub(crate) mod sample;
pub(crate) mod sampled;
pub(crate) mod single_runs;
pub(crate) mod smooth;
pub(crate) mod smoothness;
pub(crate) mod unseen;
