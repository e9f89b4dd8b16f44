//! Points at which a response is evaluated: scrambled Sobol' sequences and counted random bits.

pub(crate) mod counter;
pub(crate) mod direction_numbers;
pub(crate) mod sobol;
