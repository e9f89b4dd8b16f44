//! Numbers as people read them: units, digits, rounding that never makes a bound narrower, and what each number is (`tag`).
//! Every number of a page or a terminal is written here. No sentences.

pub(crate) mod largest;
pub(crate) mod number;
pub(crate) mod rounding;
pub(crate) mod tag;
