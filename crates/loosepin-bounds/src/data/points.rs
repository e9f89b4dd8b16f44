//! Points of the unit cube at which random inputs are drawn.

use super::problem::Sampling;
use loosepin_uncertainty::ScrambledSobol;

/// Replicate, index within it, and the point.
pub(crate) type DrawnPoint = (u32, u32, Vec<f64>);

/// The points of every inner run, replicate by replicate.
pub(crate) fn inner_points(sampling: &Sampling, sobol: &ScrambledSobol) -> impl Iterator<Item = DrawnPoint> {
    points(sampling.inner, sampling.replicates, sobol)
}

/// The points of every run of the probability-only treatment, replicate by replicate.
pub(crate) fn mixture_points(sampling: &Sampling, sobol: &ScrambledSobol) -> impl Iterator<Item = DrawnPoint> {
    points(sampling.mixture, sampling.replicates, sobol)
}

fn points(runs: usize, replicates: usize, sobol: &ScrambledSobol) -> impl Iterator<Item = DrawnPoint> {
    let per_replicate = (runs / replicates) as u32;
    let places = (0..replicates as u32).flat_map(move |replicate| (0..per_replicate).map(move |at| (replicate, at)));
    places.map(|(replicate, index)| {
        let mut point = vec![0.0; sobol.dimensions()];
        sobol.write_point(replicate, index, &mut point);
        (replicate, index, point)
    })
}
