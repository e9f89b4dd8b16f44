//! Gaps between the points of a study.

/// How finely the box of the epistemic inputs was seen: a peak of a statistic within a gap may have been missed, whatever its height. Shares of
/// the volume of the box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gaps {
    /// The largest cube without a point at which statistics were estimated.
    pub between_points: f64,
    /// The largest cube without a single run: a peak that stands out of the scatter of one run is seen by that.
    pub between_runs: f64,
}
