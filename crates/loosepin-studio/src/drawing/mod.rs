//! Drawing of an edited mechanism: its still picture, dimensions, loads. Pictures of results come from the report.

pub(crate) mod centres;
pub(crate) mod dimensions;
pub(crate) mod forces;
pub(crate) mod still;
