//! Bounds as they are stored: what was asked, both ends, their witnesses, errors and guarantee.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::reduction::Reduction;
use loosepin_text::units::{SiUnit, extended};

/// Lower and upper bound of one statistic over the epistemic inputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BoundRecord {
    /// Name of the output.
    pub output: String,
    /// Which deviation, or the value itself.
    pub of: DeviationKind,
    /// Where in the cycle, or how the cycle was reduced to one number.
    pub at: ResponsePoint,
    /// The statistic.
    pub statistic: StatisticKind,
    /// How the inputs were treated.
    pub treatment: TreatmentKind,
    /// How an interval was read.
    pub reading: IntervalReading,
    /// Unit of the values: that of the output, or `1` for a probability.
    pub unit: SiUnit,
    /// The smallest value of the statistic.
    pub lower: BoundEnd,
    /// The largest value of the statistic.
    pub upper: BoundEnd,
    /// What stands behind the bound.
    pub guarantee: GuaranteeKind,
}

/// One end of a bound.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BoundEnd {
    /// The value found.
    #[serde(with = "extended")]
    pub value_si: f64,
    /// The value moved outwards by what was not resolved; this is the bound to rely on.
    #[serde(with = "extended")]
    pub widened_si: f64,
    /// The epistemic inputs that attain the value.
    pub witness: Witness,
    /// Numerical error of the value.
    pub error: NumericalError,
}

/// Epistemic inputs by path, numbers in SI.
pub type Witness = BTreeMap<String, WitnessValue>;

/// The value of one epistemic input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum WitnessValue {
    /// A number, SI.
    Number(f64),
    /// One of a list, for example the name of a contact law.
    Choice(String),
}

/// Numerical error of a bound in its three parts, in the unit of the bound, each >= 0.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct NumericalError {
    /// From the finite number of random samples.
    #[serde(with = "extended")]
    pub sampling_si: f64,
    /// From the search over the epistemic inputs.
    #[serde(with = "extended")]
    pub optimisation_si: f64,
    /// From a surrogate model; 0 where none was used.
    #[serde(with = "extended")]
    pub surrogate_si: f64,
}

impl NumericalError {
    /// The three parts added: they do not cancel in the worst case.
    pub fn total_si(&self) -> f64 {
        self.sampling_si + self.optimisation_si + self.surrogate_si
    }
}

/// Which difference from the ideal motion is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DeviationKind {
    /// The output itself.
    Value,
    /// Actual minus ideal with nominal dimensions.
    Total,
    /// Sampled dimensions without clearance, minus nominal.
    Dimensional,
    /// Sampled dimensions with clearance, minus the same without.
    Clearance,
}

impl DeviationKind {
    /// The word used in files and tables.
    pub fn word(self) -> &'static str {
        match self {
            DeviationKind::Value => "value",
            DeviationKind::Total => "total",
            DeviationKind::Dimensional => "dimensional",
            DeviationKind::Clearance => "clearance",
        }
    }
}

/// How a response over the cycle becomes one number.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum ResponsePoint {
    /// The response is one number already, or the whole cycle is meant.
    Whole,
    /// The value at one angle of the drive.
    Pose {
        /// Angle of the drive.
        pose_rad: f64,
    },
    /// One point of a curve over the cycle that is bounded as a whole.
    Curve {
        /// Angle of the drive.
        pose_rad: f64,
    },
    /// The cycle reduced to one number.
    Reduced {
        /// The reduction.
        reduction: Reduction,
    },
}

impl ResponsePoint {
    /// Angle of the drive, where there is one.
    pub fn pose_rad(&self) -> Option<f64> {
        match self {
            ResponsePoint::Pose { pose_rad } | ResponsePoint::Curve { pose_rad } => Some(*pose_rad),
            ResponsePoint::Whole | ResponsePoint::Reduced { .. } => None,
        }
    }

    /// The reduction, where there is one.
    pub fn reduction(&self) -> Option<Reduction> {
        match self {
            ResponsePoint::Reduced { reduction } => Some(*reduction),
            _ => None,
        }
    }
}

/// A statistic of a response for fixed epistemic inputs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum StatisticKind {
    /// Expected value.
    Mean,
    /// Standard deviation.
    StandardDeviation,
    /// The value that the response stays below with this probability.
    Quantile {
        /// Probability, in (0, 1).
        probability: f64,
    },
    /// The band in which a share of mechanisms stays for the whole cycle, at one of its points.
    SimultaneousBand {
        /// The share, in (0, 1).
        share: f64,
    },
    /// Probability that the response is above a limit.
    ProbabilityAbove {
        /// The limit.
        limit_si: f64,
    },
    /// Probability that the response is below a limit.
    ProbabilityBelow {
        /// The limit.
        limit_si: f64,
    },
    /// Probability that the absolute value of the response is above a limit.
    ProbabilityBeyond {
        /// The limit, >= 0.
        limit_si: f64,
    },
}

impl StatisticKind {
    /// The word used in files and tables, and the parameter (a probability, or a limit in SI) where there is one.
    pub fn word_and_parameter(self) -> (&'static str, Option<f64>) {
        match self {
            StatisticKind::Mean => ("mean", None),
            StatisticKind::StandardDeviation => ("standard_deviation", None),
            StatisticKind::Quantile { probability } => ("quantile", Some(probability)),
            StatisticKind::SimultaneousBand { share } => ("simultaneous_band", Some(share)),
            StatisticKind::ProbabilityAbove { limit_si } => ("probability_above", Some(limit_si)),
            StatisticKind::ProbabilityBelow { limit_si } => ("probability_below", Some(limit_si)),
            StatisticKind::ProbabilityBeyond { limit_si } => ("probability_beyond", Some(limit_si)),
        }
    }

    /// Whether the statistic is a probability, a pure number between 0 and 1.
    pub fn is_probability(self) -> bool {
        matches!(
            self,
            StatisticKind::ProbabilityAbove { .. }
                | StatisticKind::ProbabilityBelow { .. }
                | StatisticKind::ProbabilityBeyond { .. }
        )
    }
}

/// How random and epistemic inputs are told apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TreatmentKind {
    /// Every interval is taken as uniformly distributed.
    ProbabilityOnly,
    /// Every random input is cut to an interval.
    IntervalOnly,
    /// Each is taken for what it is.
    Mixed,
}

impl TreatmentKind {
    /// The word used in files.
    pub fn word(self) -> &'static str {
        match self {
            TreatmentKind::ProbabilityOnly => "probability_only",
            TreatmentKind::IntervalOnly => "interval_only",
            TreatmentKind::Mixed => "mixed",
        }
    }
}

/// How an interval is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum IntervalReading {
    /// One fixed but unknown value, the same for every mechanism made (A).
    Fixed,
    /// Of unknown distribution, independent of the random inputs (A2).
    UnknownDistribution,
    /// Free to differ from mechanism to mechanism in any way (B).
    RandomSet,
}

impl IntervalReading {
    /// The word used in files.
    pub fn word(self) -> &'static str {
        match self {
            IntervalReading::Fixed => "fixed",
            IntervalReading::UnknownDistribution => "unknown_distribution",
            IntervalReading::RandomSet => "random_set",
        }
    }
}

/// What stands behind a bound.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum GuaranteeKind {
    /// Proven to hold, rounding included.
    Enclosure,
    /// The best that a search over the epistemic inputs found.
    Optimised,
    /// Holds with a stated confidence over the random sampling.
    Sampled {
        /// Confidence, in (0, 1).
        confidence: f64,
    },
    /// The true range is at least this wide: the search has not been confirmed.
    Inner,
}

impl GuaranteeKind {
    /// The word used in files, and the confidence where there is one.
    pub fn word_and_confidence(self) -> (&'static str, Option<f64>) {
        match self {
            GuaranteeKind::Enclosure => ("enclosure", None),
            GuaranteeKind::Optimised => ("optimised", None),
            GuaranteeKind::Sampled { confidence } => ("sampled", Some(confidence)),
            GuaranteeKind::Inner => ("inner", None),
        }
    }
}
