//! From the texts in the page to what the page shows of them: bands, diagnostics, numbers with their places.
//! Nothing is written.

pub(crate) mod check;
pub(crate) mod diagnostics;
pub(crate) mod fixes;
pub(crate) mod limits;
pub(crate) mod look;
pub(crate) mod places;
mod plane_view;
pub(crate) mod quantities;
pub(crate) mod seen_model;
mod space_view;
pub(crate) mod texts;
mod title;
