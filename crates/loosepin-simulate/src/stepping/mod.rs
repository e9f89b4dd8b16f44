//! One step of one run: the state and its derivative, implicit steps, projection onto the loops, and the events located inside of a
//! step. It knows no lanes and records nothing.

pub(crate) mod gap;
pub(crate) mod implicit;
pub(crate) mod motion;
pub(crate) mod pace;
pub(crate) mod projection;
pub(crate) mod resolution;
pub(crate) mod search;
pub(crate) mod slot_end;
