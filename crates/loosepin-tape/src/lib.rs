//! Straight-line arithmetic for many runs at once: written down once ([`trace`]), compiled to machine code or evaluated
//! lane by lane with the same bits ([`native`]).

pub mod native;
pub mod trace;
