//! Default numbers in one place: for this crate, for study files and for Python.

use super::problem::Sampling;

/// Share of the central band that the three treatments are compared by.
pub const BAND_PROBABILITY: f64 = 0.95;
/// Number of standard deviations at which a random input is truncated if it is treated as an interval.
pub const CUT_STANDARD_DEVIATIONS: f64 = 3.0;
/// Percentiles of statistics that are themselves random.
pub const PERCENTILES: [f64; 3] = [0.05, 0.5, 0.95];

impl Default for Sampling {
    fn default() -> Self {
        Self { outer: 64, inner: 256, replicates: 8, mixture: 1024, extreme: 128, seed: 1, confidence: 0.99 }
    }
}

/// Growth limit of samples, in multiples of the runs of the plan without an accuracy, where an accuracy is requested and no budget is
/// stated.
pub const USUAL_GROWTH: usize = 100;
