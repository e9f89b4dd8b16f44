//! The surrogates of a study as a file: saved with their quality and their ranges, loaded, asked by the paths of their inputs.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use loosepin_result::study::{Deviation, ResponsePoint, Witness};
use loosepin_surrogate::{OnnxMetadata, Prediction, Surrogate, SurrogateError, from_versioned_json};
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::units::{SiUnit, format_number};

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

/// One input of an exported surrogate, with the range in which it answers.
#[derive(Serialize)]
struct ExportedInput<'a> {
    path: &'a str,
    unit: &'a SiUnit,
    lower: f64,
    upper: f64,
}

/// One number or one curve.
#[derive(Clone, Serialize, Deserialize)]
pub struct SavedOutput {
    /// Name of the output.
    pub output: String,
    /// Which deviation.
    pub of: Deviation,
    /// Places in the cycle; one for a number.
    pub at: Vec<ResponsePoint>,
    /// Unit of its values.
    pub unit: SiUnit,
    /// The members of lists that it holds for, by path.
    pub members: Witness,
    /// The surrogate, with its held-out quality and the ranges of its inputs.
    pub surrogate: Surrogate,
}

problems! {
    /// Why saved surrogates cannot be loaded, or give no value.
    #[derive(Debug, Clone, PartialEq)]
    pub enum SavedSurrogateError {
        /// The text, or the question.
        Surrogate { error: SurrogateError } => match error {
                SurrogateError::NotNetworks { .. } => Code::SurrogateNotExported,
                _ => Code::NoSurrogateAnswer,
            },
            says("{error}");
        /// An input without a value.
        NoValue { path: String } => Code::NoSurrogateAnswer,
            says("no value of '{path}'; the surrogates depend on it");
        /// A value of something else.
        NoInput { path: String } => Code::NoSurrogateAnswer,
            says("'{path}' is not an input of these surrogates");
        /// Outside of the training range.
        Extrapolation { path: String, value: f64, lower: f64, upper: f64, unit: SiUnit } => Code::NoSurrogateAnswer,
            says(
                "'{path}' is {}; learned was from {} to {}, and nothing is extrapolated\n\
                 hint: run the model itself there, or add runs that reach so far",
                with_unit(*value, unit),
                with_unit(*lower, unit),
                with_unit(*upper, unit)
            );
    }
}

/// An SI value with its unit, in significant digits.
fn with_unit(value_si: f64, unit: &SiUnit) -> String {
    format!("{} {unit}", format_number(value_si)).trim_end_matches(" 1").to_owned()
}

impl From<SurrogateError> for SavedSurrogateError {
    fn from(error: SurrogateError) -> Self {
        Self::Surrogate { error }
    }
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

    /// Value of output number `output` at these values, SI, by the paths of the inputs.
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

    /// Output number `output` as an ONNX file in double precision, where it is made of networks: from "inputs", a row a point, SI, to
    /// "values", a column a place, SI. What the numbers are stands in its metadata: `study`, `input_hash`, `output`, `of`, `at`, `unit`,
    /// `members`, `inputs` (with the ranges, outside of which a row of values is not-a-number) and `held_out_rms`, all that is left of
    /// what the surrogate knows of its error.
    ///
    /// # Errors
    /// [`SurrogateError::NotNetworks`].
    pub fn to_onnx(&self, output: usize) -> Result<Vec<u8>, SavedSurrogateError> {
        let saved = &self.outputs[output];
        let ranges = self.inputs.iter().zip(saved.surrogate.ranges());
        let of_input = |(input, &(lower, upper)): (&'_ SavedInput, &(f64, f64))| {
            let SavedInput { path, unit } = input;
            serde_json::json!(ExportedInput { path, unit, lower, upper })
        };
        let inputs: Vec<serde_json::Value> = ranges.map(of_input).collect();
        let rms = saved.surrogate.outputs().first().map_or(f64::NAN, |learned| learned.quality.rms);
        let metadata: OnnxMetadata = [
            ("study", self.study.clone()),
            ("input_hash", self.input_hash.clone()),
            ("output", saved.output.clone()),
            ("of", saved.of.word().to_owned()),
            ("at", serde_json::json!(saved.at).to_string()),
            ("unit", saved.unit.symbol().to_owned()),
            ("members", serde_json::json!(saved.members).to_string()),
            ("inputs", serde_json::json!(inputs).to_string()),
            ("held_out_rms", rms.to_string()),
        ]
        .map(|(key, text)| (key.to_owned(), text))
        .into();
        Ok(saved.surrogate.to_onnx(0, metadata)?)
    }

    /// A name for the file of output number `output`: its number, which output, which deviation.
    pub fn onnx_file_name(&self, output: usize) -> String {
        let saved = &self.outputs[output];
        let plain: String = saved.output.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
        format!("{output}-{plain}-{}.onnx", saved.of.word())
    }
}
