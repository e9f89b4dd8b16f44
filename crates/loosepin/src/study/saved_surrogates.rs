//! The surrogates of a study as a file: saved with their quality and their ranges, loaded, asked by the paths of their inputs.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::result::{DeviationKind, ResponsePoint, Witness};
use crate::surrogate::{Prediction, Surrogate, SurrogateError, from_versioned_json};
use crate::units::SiUnit;

/// Version of the file.
const FORMAT: u32 = 1;

/// All surrogates of a study; `surrogates.json` is this type.
#[derive(Clone, Serialize, Deserialize)]
pub struct SavedSurrogates {
    /// Version of the layout.
    pub format: u32,
    /// Name of the study.
    pub study: String,
    /// Hash of all inputs of the study, hexadecimal.
    pub input_hash: String,
    /// The inputs of every surrogate, in their order.
    pub inputs: Vec<SavedInput>,
    /// The surrogates, one for each number or curve and each combination of the members of lists.
    pub outputs: Vec<SavedOutput>,
}

/// One input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SavedInput {
    /// Its path in the model.
    pub path: String,
    /// Unit of its values.
    pub unit: SiUnit,
}

/// One number or one curve.
#[derive(Clone, Serialize, Deserialize)]
pub struct SavedOutput {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: DeviationKind,
    /// Where in the cycle; one place for a number.
    pub at: Vec<ResponsePoint>,
    /// Unit of its values.
    pub unit: SiUnit,
    /// The members of lists that it holds for, by path.
    pub members: Witness,
    /// The surrogate, with its held-out quality and the ranges of its inputs.
    pub surrogate: Surrogate,
}

/// Why saved surrogates cannot be loaded, or give no value.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SavedSurrogateError {
    /// The text, or the question.
    #[error(transparent)]
    Surrogate(#[from] SurrogateError),
    /// An input without a value.
    #[error("no value of '{path}'; the surrogates depend on it")]
    NoValue {
        /// Its path.
        path: String,
    },
    /// A value of something else.
    #[error("'{path}' is no input of these surrogates")]
    NoInput {
        /// The path.
        path: String,
    },
    /// Outside what was learned.
    #[error(
        "'{path}' is {value} {unit}; learned was from {lower} to {upper} {unit}, and nothing is extrapolated\n\
         hint: run the model itself there, or add runs that reach so far"
    )]
    Extrapolation {
        /// Path of the input.
        path: String,
        /// Its value.
        value: f64,
        /// Least value that is answered.
        lower: f64,
        /// Largest value that is answered.
        upper: f64,
        /// Unit of all three.
        unit: SiUnit,
    },
}

impl SavedSurrogates {
    /// Surrogates over `inputs`, of the study of this name and hash.
    pub(super) fn new(study: &str, input_hash: &str, inputs: Vec<SavedInput>, outputs: Vec<SavedOutput>) -> Self {
        Self { format: FORMAT, study: study.to_owned(), input_hash: input_hash.to_owned(), inputs, outputs }
    }

    /// The text of the file.
    ///
    /// # Errors
    /// What the writer says.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string(self)
    }

    /// Surrogates from what [`Self::to_json`] wrote: the same values to the last bit.
    ///
    /// # Errors
    /// [`SurrogateError::NotLoaded`] and [`SurrogateError::OtherFormat`].
    pub fn from_json(text: &str) -> Result<Self, SavedSurrogateError> {
        Ok(from_versioned_json(text, FORMAT)?)
    }

    /// What output number `output` is at these values, SI, by the paths of the inputs.
    ///
    /// # Errors
    /// An input without a value, a value of something else, and a value outside the range that was learned.
    pub fn predict(&self, output: usize, values: &BTreeMap<String, f64>) -> Result<Prediction, SavedSurrogateError> {
        if let Some(path) = values.keys().find(|path| self.inputs.iter().all(|input| input.path != **path)) {
            return Err(SavedSurrogateError::NoInput { path: path.clone() });
        }
        let value = |input: &SavedInput| {
            let value = values.get(&input.path).copied();
            value.ok_or_else(|| SavedSurrogateError::NoValue { path: input.path.clone() })
        };
        let point = self.inputs.iter().map(value).collect::<Result<Vec<f64>, _>>()?;
        let answers = self.outputs[output].surrogate.predict(&point).map_err(|error| match error {
            SurrogateError::Extrapolation { input, value, lower, upper } => {
                let SavedInput { path, unit } = self.inputs[input].clone();
                SavedSurrogateError::Extrapolation { path, value, lower, upper, unit }
            }
            other => other.into(),
        })?;
        // Every surrogate of the file has one output.
        answers.into_iter().next().ok_or_else(|| SurrogateError::NoOutput.into())
    }
}
