//! Points at which a response is evaluated: scrambled Sobol' sequences and counted random bits.
//! Random numbers belong to a position, not to a moment. Variables are not known here.

pub(crate) mod counter;
pub(crate) mod direction_numbers;
pub(crate) mod sobol;
