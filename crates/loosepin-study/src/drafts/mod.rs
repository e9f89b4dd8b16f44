//! What is told of a study while it runs.

pub(crate) mod curves;
pub(crate) mod draft;
pub(crate) mod progress;
