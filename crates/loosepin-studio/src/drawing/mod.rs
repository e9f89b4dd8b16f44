//! Drawing of an edited mechanism: its still picture, dimensions, loads; and a drawing that becomes a model. Pictures of results come from
//! the report.

pub(crate) mod centres;
pub(crate) mod dimensions;
pub(crate) mod drawn;
pub(crate) mod forces;
pub(crate) mod still;
