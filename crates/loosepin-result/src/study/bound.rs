//! Stored bounds: the request, both ends, their witnesses, errors and guarantee.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use loosepin_terms::{Deviation, Guarantee, Reading, Reduction, Statistic, Treatment};
use loosepin_text::units::{SiUnit, extended};

/// Lower and upper bound of one statistic over the epistemic inputs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BoundRecord {
    /// Name of the output.
    pub output: String,
    /// Which deviation, or the value itself.
    pub of: Deviation,
    /// Place in the cycle, or reduction of the cycle to one number.
    pub at: ResponsePoint,
    /// The statistic.
    pub statistic: Statistic,
    /// How the inputs were treated.
    pub treatment: Treatment,
    /// How an interval was read.
    pub reading: Reading,
    /// Unit of the values: that of the output, or `1` for a probability.
    pub unit: SiUnit,
    /// The smallest value of the statistic.
    pub lower: BoundEnd,
    /// The largest value of the statistic.
    pub upper: BoundEnd,
    /// The method behind the bound.
    pub guarantee: Guarantee,
}

/// One end of a bound.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct BoundEnd {
    /// The value found.
    #[serde(with = "extended")]
    pub value_si: f64,
    /// The value moved outwards by the unresolved part; this is the bound to rely on.
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

/// How the mechanism of a witness is run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WitnessCommand {
    /// The epistemic inputs.
    pub witness: Witness,
    /// The command, to be given in the folder in which the input files are; random inputs are as in the model.
    pub command: String,
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
