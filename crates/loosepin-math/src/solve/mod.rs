//! Linear systems and least squares of small size.
//! Numbers in, numbers out; no mechanics.

pub(crate) mod complex_lu;
pub mod dense;
pub mod descent;
pub(crate) mod four_rows;
pub(crate) mod gauss;
pub(crate) mod gram;
pub(crate) mod ldl;
pub(crate) mod svd;
