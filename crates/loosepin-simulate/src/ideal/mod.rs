//! The ideal mechanism beside a run: what deviations are measured against, and the outputs as columns of numbers. It knows no contact.
//! Worst cases and scatter of the ideal mechanism stand in `accuracy`.

pub(crate) mod column;
pub(crate) mod column_table;
pub(crate) mod curve;
pub(crate) mod free_motion;
pub(crate) mod path_error;
pub(crate) mod reference;
