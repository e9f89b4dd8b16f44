//! Intermediate results of a running study. Bounds of pilots and quantiles of the runs so far, without the errors of the final ones.

pub(crate) mod curves;
pub(crate) mod draft;
pub(crate) mod progress;
