//! The quasi-static answer and the deviation of a run from the ideal motion.

pub mod record;
