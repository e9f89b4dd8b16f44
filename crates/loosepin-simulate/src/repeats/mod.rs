//! Whether a motion repeats itself and how long its positions can be trusted: sections once a turn, periods, exponents, second runs.
//! Wear over many cycles stands in `wear`.

pub(crate) mod error_oscillation;
pub(crate) mod lyapunov;
pub(crate) mod period;
pub(crate) mod sections;
pub(crate) mod trust;
pub(crate) mod turns;
