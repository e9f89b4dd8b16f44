//! A surrogate of all outputs: fitted, asked, saved, loaded.

use super::data::TrainingData;
use super::design::Design;
use super::error::SurrogateError;
use super::input::Input;
use super::onnx::{Layers, OnnxMetadata, model};
use super::options::Options;
use super::output::OutputSurrogate;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

/// Version of the saved form.
const FORMAT: u32 = 1;
/// Share of the width of the runs, in each input, by which a point may lie beyond them: an unbounded input has tails that a
/// few runs do not reach.
const REACH: f64 = 0.25;

/// Surrogates of all outputs over the same inputs.
#[derive(Clone, Serialize, Deserialize)]
pub struct Surrogate {
    format: u32,
    inputs: Vec<Input>,
    /// Valid range of the surrogate: one interval an input.
    ranges: Vec<(f64, f64)>,
    outputs: Vec<OutputSurrogate>,
}

/// Prediction of a surrogate at a point for one output.
#[derive(Debug, Clone, PartialEq)]
pub struct Prediction {
    /// One value a place; a number is a curve of one place.
    pub values: Vec<f64>,
    /// Standard deviation of the error of each value, such that its square is right on average over held-out runs.
    pub deviations: Vec<f64>,
}

impl Surrogate {
    /// Fits all outputs of `data`.
    ///
    /// # Errors
    ///
    /// [`SurrogateError::NotFitted`] where the kind that `options` ask for cannot be fitted.
    pub fn fit(data: &TrainingData, options: &Options) -> Result<Self, SurrogateError> {
        let design = Design::new(data.inputs(), data.points());
        let outputs = data
            .outputs()
            .iter()
            .map(|output| OutputSurrogate::fit(&design, output, options))
            .collect::<Result<_, _>>()?;
        let ranges = data.inputs().iter().enumerate().map(|(k, input)| range(input, data.points(), k)).collect();
        Ok(Self { format: FORMAT, inputs: data.inputs().to_vec(), ranges, outputs })
    }

    /// Valid range of the surrogate: the range of the runs in each input and a quarter of it on either side, no further than the input
    /// itself can be.
    pub fn ranges(&self) -> &[(f64, f64)] {
        &self.ranges
    }

    /// The outputs, each with its quality.
    pub fn outputs(&self) -> &[OutputSurrogate] {
        &self.outputs
    }

    /// All outputs at `point`.
    ///
    /// # Errors
    ///
    /// [`SurrogateError::QueryLength`], and [`SurrogateError::Extrapolation`] outside [`Self::ranges`].
    pub fn predict(&self, point: &[f64]) -> Result<Vec<Prediction>, SurrogateError> {
        let (scaled, germ) = self.standard(point)?;
        let answers = self.outputs.iter().map(|output| output.predict(&scaled, &germ));
        Ok(answers.map(|(values, deviations)| Prediction { values, deviations }).collect())
    }

    /// Residual that is added to the values of output number `output` at `point`, for `share` in \[0, 1) of its distribution; zero if the
    /// residual is not part of the surrogate, since it falls with more runs.
    ///
    /// # Errors
    ///
    /// As for [`Self::predict`].
    pub fn residual(&self, output: usize, point: &[f64], share: f64) -> Result<Option<Vec<f64>>, SurrogateError> {
        let (scaled, _) = self.standard(point)?;
        Ok(self.outputs[output].residual.draw(&scaled, share))
    }

    fn standard(&self, point: &[f64]) -> Result<(Vec<f64>, Vec<f64>), SurrogateError> {
        if point.len() != self.inputs.len() {
            return Err(SurrogateError::QueryLength { length: point.len(), inputs: self.inputs.len() });
        }
        for (input, (&value, &(lower, upper))) in point.iter().zip(&self.ranges).enumerate() {
            if !(value >= lower && value <= upper) {
                return Err(SurrogateError::Extrapolation { input, value, lower, upper });
            }
        }
        let pairs = || self.inputs.iter().zip(point);
        Ok((pairs().map(|(input, x)| input.scaled(*x)).collect(), pairs().map(|(input, x)| input.germ(*x)).collect()))
    }

    /// The surrogate as JSON, with its quality and its ranges.
    ///
    /// # Errors
    ///
    /// What the writer says.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string(self)
    }

    /// Output number `output` as an ONNX file in double precision: from "inputs", a row a point in the order of the inputs, to "values", a
    /// column a place; not-a-number outside of [`Self::ranges`]. Of the error it holds what `metadata` says.
    ///
    /// # Errors
    ///
    /// [`SurrogateError::NotNetworks`] where it is not made of networks and constants alone.
    pub fn to_onnx(&self, output: usize, metadata: OnnxMetadata) -> Result<Vec<u8>, SurrogateError> {
        let OutputSurrogate { name, modes, fits, .. } = &self.outputs[output];
        let layers = Layers::new(fits, self.inputs.len())
            .map_err(|other| SurrogateError::NotNetworks { output: name.clone(), kind: other.kind().name() })?;
        Ok(model(name, (&self.inputs, &self.ranges), layers, modes, metadata))
    }

    /// A surrogate from what [`Self::to_json`] wrote: the same values to the last bit.
    ///
    /// # Errors
    ///
    /// [`SurrogateError::NotLoaded`] and [`SurrogateError::OtherFormat`].
    pub fn from_json(text: &str) -> Result<Self, SurrogateError> {
        from_versioned_json(text, FORMAT)
    }
}

/// Content of a file of version `format`; the version is checked before the rest.
///
/// # Errors
///
/// [`SurrogateError::NotLoaded`] and [`SurrogateError::OtherFormat`].
pub fn from_versioned_json<T: DeserializeOwned>(text: &str, format: u32) -> Result<T, SurrogateError> {
    #[derive(Deserialize)]
    struct Header {
        format: u32,
    }
    let reason = |error: serde_json::Error| SurrogateError::NotLoaded { reason: error.to_string() };
    let header: Header = serde_json::from_str(text).map_err(reason)?;
    if header.format != format {
        return Err(SurrogateError::OtherFormat { found: header.format, expected: format });
    }
    serde_json::from_str(text).map_err(reason)
}

/// The range of the runs in input `k`, with its reach, within the support.
fn range(input: &Input, points: &[Vec<f64>], k: usize) -> (f64, f64) {
    let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
    for point in points {
        (lowest, highest) = (lowest.min(point[k]), highest.max(point[k]));
    }
    let (lower, upper) = input.support();
    let reach = REACH * (highest - lowest);
    ((lowest - reach).max(lower.min(lowest)), (highest + reach).min(upper.max(highest)))
}
