//! Random and epistemic inputs, and the points at which a response is evaluated.

mod distribution;

pub use distribution::Distribution;
