//! Sampling noise of a statistic over the box.

/// Sampling noise of the values at the points.
#[derive(Debug, Clone, Default)]
pub(crate) struct Noise {
    /// Its mean variance.
    pub variance: f64,
    /// Difference of each replicate of the sample from the value at every point, replicate by replicate; empty if unknown. Where the same
    /// random numbers give nearly the same error at neighbouring points these differences are smooth in u, and no part of them is between
    /// the points.
    pub replicates: Vec<Vec<f64>>,
}

impl Noise {
    /// No sampling noise, or a negligible one.
    pub const NONE: Self = Self { variance: 0.0, replicates: Vec::new() };

    /// That at some of the points.
    pub fn at_points(&self, points: &[usize]) -> Self {
        let of = |replicate: &Vec<f64>| points.iter().map(|&point| replicate[point]).collect();
        Self { variance: self.variance, replicates: self.replicates.iter().map(of).collect() }
    }
}
