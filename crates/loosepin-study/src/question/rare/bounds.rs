//! Bounds of a probability that was not counted but estimated.

use loosepin_bounds::{Bound, Statistic};
use loosepin_result::study::RareMethodUsed;
use loosepin_uncertainty::reliability::RareEstimate;

/// The bounds of a rare probability.
pub struct Rare {
    /// Column of the response.
    pub column: usize,
    /// The statistic.
    pub statistic: Statistic,
    /// Its bounds, to stand in place of the counted ones.
    pub bounds: [Bound; 2],
    /// Whether the values of the epistemic inputs at both ends are the only ones. Otherwise the search for them is not confirmed
    /// by points everywhere: the true range is at least as wide.
    pub is_confirmed: bool,
    /// How both ends were estimated.
    pub ends: [RareEnd; 2],
}

/// One end.
pub struct RareEnd {
    pub method: RareMethodUsed,
    pub estimate: RareEstimate,
    /// Reliability index, where there is one.
    pub index: Option<f64>,
    pub runs: usize,
    /// Failed runs: no event at the lower end, the event at the upper one.
    pub failed: usize,
}
