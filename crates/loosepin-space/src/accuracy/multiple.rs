//! The largest multiple of some errors that plays make good.

use crate::accuracy::linear::planes::Planes;
use crate::accuracy::linear::slice::largest;
use crate::accuracy::play_set::PlaySet;
use crate::play::block::Block;

/// Largest multiple of the errors that is looked at: beyond it they do not matter.
pub(crate) const MAX_MULTIPLE: f64 = 1e6;
/// Part of the errors that plays do not reach, relative to the largest derivative by play, that is round-off.
const UNREACHED: f64 = 1e-9;
/// By how much more than the bound of a single row is looked at, so that this is no bound of its own.
const BEYOND: f64 = 1.01;

/// The largest θ <= [`MAX_MULTIPLE`] with h·p = θ h0 for a p within the play.
#[derive(Debug, Clone)]
pub(crate) struct Multiple {
    pub factor: f64,
    /// The smallest Σ c |λ·h| with λ·h0 = 1 that was found: an upper bound of θ, equal to it but for round-off.
    pub bound: f64,
    /// p in units of the radii.
    pub place: Vec<f64>,
    /// c |λ·h| of each block; they add up to the bound.
    pub parts: Vec<f64>,
}

/// `rows` are h in units of the radii, `right` is h0. `None` if h0 has a part above `negligible` that no play reaches, so that only θ = 0 is left.
///
/// θ is one more variable of the set, in units of its largest value: of one row alone, θ <= Σ c |h_k|/|h0_k|.
pub(crate) fn largest_multiple(set: &PlaySet, rows: &[Vec<f64>], right: &[f64], negligible: f64) -> Option<Multiple> {
    let size = right.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    if size <= f64::MIN_POSITIVE {
        let (place, parts) = (vec![0.0; set.variables()], vec![0.0; set.blocks().len()]);
        return Some(Multiple { factor: MAX_MULTIPLE, bound: MAX_MULTIPLE, place, parts });
    }
    let reach = rows.iter().flatten().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let own = Planes::new(rows, set.variables(), UNREACHED * reach);
    if own.unreached(right) > negligible.max(UNREACHED * size.max(reach)) {
        return None;
    }
    let of_row = |(row, h0): (&Vec<f64>, &f64)| set.support(row).iter().sum::<f64>() / h0.abs();
    // A row that no play reaches is open by no more than what is negligible.
    let is_reached = |(row, h0): &(&Vec<f64>, &f64)| {
        h0.abs() > UNREACHED * size && set.support(row).iter().sum::<f64>() > UNREACHED * reach
    };
    let single = rows.iter().zip(right).filter(is_reached).map(of_row);
    let most = (BEYOND * single.fold(f64::INFINITY, f64::min)).min(MAX_MULTIPLE);
    let wider = set.with_block(Block::single(most));
    let last = set.variables();
    let rows: Vec<Vec<f64>> =
        rows.iter().zip(right).map(|(row, h0)| row.iter().copied().chain([-h0 * most]).collect()).collect();
    let planes = Planes::new(&rows, wider.variables(), UNREACHED * reach);
    let mut gains = vec![0.0; wider.variables()];
    gains[last] = most;
    let found = largest(&wider, &gains, None, &planes, &vec![0.0; rows.len()])?;
    let mut parts = wider.support(&found.rest);
    // What the multipliers leave of the gain of θ: nothing, unless its largest value is too small.
    let bound = parts.iter().sum();
    parts.truncate(set.blocks().len());
    Some(Multiple { factor: found.place[last] * most, bound, place: found.place[..last].to_vec(), parts })
}
