//! Errors of surrogates: no fit, or no prediction.

use thiserror::Error;

/// Why runs cannot be learned from, or a surrogate gives no value.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum SurrogateError {
    #[error("no input; a surrogate is a function of at least one input")]
    NoInput,
    #[error("no output; a surrogate has at least one output")]
    NoOutput,
    #[error("run {run} has {length} numbers; there are {inputs} inputs")]
    PointLength { run: usize, length: usize, inputs: usize },
    #[error("run {run}: input {input} is {value}; it must lie between {lower} and {upper}")]
    InputOutside { run: usize, input: usize, value: f64, lower: f64, upper: f64 },
    #[error(
        "output '{output}' has {rows} rows; there are {runs} runs\nhint: a run without this output has an empty row"
    )]
    OutputRows { output: String, rows: usize, runs: usize },
    #[error(
        "output '{output}', run {run}: a curve of {length} values; the first one has {expected}, all must be as long"
    )]
    CurveLength {
        output: String,
        run: usize,
        /// Values of this curve.
        length: usize,
        /// Values of the first curve.
        expected: usize,
    },
    #[error("output '{output}', run {run}: {value}; must be finite\nhint: leave out the output of a run that failed")]
    OutputNotFinite { output: String, run: usize, value: f64 },
    #[error("output '{output}', run {run}: variance of the noise {value}; must be finite and >= 0")]
    Noise { output: String, run: usize, value: f64 },
    #[error(
        "output '{output}': {different} different points among {runs} runs, {missing} of which failed; a surrogate needs at \
         least 4\nhint: make more runs, or give the bounds directly"
    )]
    TooFewRuns {
        output: String,
        /// Different points at which it is known, counted up to four.
        different: usize,
        runs: usize,
        missing: usize,
    },
    #[error(
        "output '{output}': {kind} cannot be fitted to its {runs} runs\nhint: leave the choice of the kind to the program"
    )]
    NotFitted { output: String, kind: &'static str, runs: usize },
    #[error("a point of {length} numbers; the surrogate has {inputs} inputs")]
    QueryLength { length: usize, inputs: usize },
    #[error(
        "input {input} is {value}; the surrogate has learned from {lower} to {upper} and does not extrapolate\n\
         hint: run the model itself there, or add runs that reach so far"
    )]
    Extrapolation { input: usize, value: f64, lower: f64, upper: f64 },
    #[error(
        "output '{output}' is learned by {kind}; neural networks alone can be written as ONNX\n\
         hint: its coefficients stand in surrogates.json; or learn networks, kind = \"network\" under [surrogate]"
    )]
    NotNetworks { output: String, kind: &'static str },
    #[error("no saved surrogate: {reason}")]
    NotLoaded { reason: String },
    #[error("a saved surrogate of format {found}; this program reads format {expected}")]
    OtherFormat { found: u32, expected: u32 },
}
