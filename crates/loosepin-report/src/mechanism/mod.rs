//! The drawing of a mechanism, still and moving: shapes, labels, signs, bent beams.
//! The studio and all pages draw by it; what is drawn comes from `loosepin_result`.

pub(crate) mod bends;
pub(crate) mod figure;
pub(crate) mod labels;
pub(crate) mod shapes;
pub(crate) mod signs;
