//! Statistics at all outer points, and what their extremes are searched by: a file for each estimator, which alone knows how the target of a
//! search relates to its statistic.

mod margin;
pub(crate) mod mean;
pub(crate) mod measure;
pub(crate) mod of_statistic;
pub(crate) mod probability;
pub(crate) mod quantile;
mod sampled;
mod smooth_probability;
pub(crate) mod standard_deviation;
pub(crate) mod targets;
