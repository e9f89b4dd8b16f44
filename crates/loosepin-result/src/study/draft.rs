//! Intermediate results of a study.

use super::{BoundRecord, CurveRange, Deviation, RequirementOutcome, Verdict};
use loosepin_text::units::{DisplayUnits, SiUnit};

/// Bounds from the runs so far. Each has the stated confidence by itself, and is mostly wider than that of the
/// finished study.
#[derive(Debug, Clone)]
pub struct Draft {
    /// Runs that these bounds come from.
    pub runs: usize,
    /// Bounds of single numbers that are asked for: of extremes and means of a cycle, not of curves.
    pub bounds: Vec<BoundRecord>,
    /// The requirements over a whole cycle.
    pub requirements: Vec<RequirementOutcome>,
    /// Deviation curves that were asked for, each at some of its poses.
    pub curves: Vec<DraftCurve>,
    /// The drive whose angles the poses are.
    pub drive: String,
    /// The units of the study.
    pub display_units: DisplayUnits,
}

/// A deviation over the cycle as the runs so far have it. Its band is no bound: it has no numerical error, and can still grow.
#[derive(Debug, Clone, PartialEq)]
pub struct DraftCurve {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Unit of the output.
    pub unit: SiUnit,
    /// Probabilities of the two ends of the band at one pose.
    pub probabilities: [f64; 2],
    /// Angles of the drive, rad.
    pub pose_rad: Vec<f64>,
    /// From the least lower to the greatest upper quantile, over the values of the unknown inputs that were run.
    pub band: CurveRange,
    /// How many such values were run; 1 where nothing is unknown.
    pub unknown_values: usize,
}

impl Draft {
    /// The worst of the verdicts so far; `None` without requirements.
    pub fn verdict(&self) -> Option<Verdict> {
        Verdict::of_all(self.requirements.iter().map(|requirement| requirement.verdict))
    }
}
