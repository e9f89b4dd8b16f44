//! Polynomials of the random inputs, fitted to the runs at one u: where a response is smooth in them they know its statistics.
//! Bases, fits with their checks, single runs that contradict them. What counts runs is in the folder above.

pub(crate) mod basis;
pub(crate) mod inner_basis;
pub(crate) mod known_fits;
pub(crate) mod orthogonal;
pub(crate) mod preintegration;
pub(crate) mod single_runs;
pub(crate) mod smooth;
pub(crate) mod smoothness;
