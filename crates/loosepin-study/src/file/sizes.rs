//! The largest sizes of a study.

/// Poses of a question, at most: every one has bounds of its own, and a chart of 2000 points has one for each pixel.
pub const MAX_POSES: usize = 2000;
/// Runs of a study, at most: at 10,000 a second they take a day and a half.
pub const MAX_RUNS: u64 = 1 << 30;
