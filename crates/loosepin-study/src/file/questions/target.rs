//! Accuracies as a study states them.

use loosepin_text::units::Dimension;

/// Largest allowed widening of bounds.
///
/// It concerns the bounds that measure what it measures, of one output or statistic where these are named. Of several that concern
/// a bound, that of the command line counts before that of the file, the one that names more before the one that names less, and
/// the later one before the earlier.
#[derive(Debug, Clone, PartialEq)]
pub struct AccuracyTarget {
    /// Whether it comes from the command line.
    pub is_argument: bool,
    /// The question it stands in, by its place in [`Study::asks`](crate::file::Study::asks).
    pub ask: Option<usize>,
    /// The output, by its place in the model.
    pub output: Option<usize>,
    /// The statistic, by the name that it has in study files.
    pub statistic: Option<&'static str>,
    /// Dimension of the bounds.
    pub dimension: Dimension,
    /// The most that is allowed, SI, > 0.
    pub most_si: f64,
}
