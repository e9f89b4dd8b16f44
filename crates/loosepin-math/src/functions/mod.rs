//! Functions that are the same bits everywhere, and curves through points.
//! Elementary functions and splines. Linear systems stand in `solve`, steps through time in `integrate`.

pub(crate) mod angle;
pub(crate) mod arctangent;
pub(crate) mod exponential;
pub(crate) mod exponentials;
pub(crate) mod hermite;
pub(crate) mod interval;
pub(crate) mod pieces;
pub(crate) mod quadratic;
pub(crate) mod spline;
pub(crate) mod whole_range;
