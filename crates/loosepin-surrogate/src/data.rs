//! Runs to learn from.

use super::error::SurrogateError;
use super::input::Input;

/// Least number of different points that a surrogate is fitted to: three to fit, one to hold out.
pub const FEWEST_RUNS: usize = 4;

/// One output of the runs: a number, or a curve with a value at each place of the cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct TrainingOutput {
    /// Name, as in messages and results.
    pub name: String,
    /// One row a run; empty if the run gave no such output.
    pub rows: Vec<Option<Vec<f64>>>,
    /// Variance of the noise in the values of each run, where it is known, as for a mean over cycles or samples.
    pub noise: Option<Vec<f64>>,
}

impl TrainingOutput {
    /// An output that is one number.
    pub fn number(name: &str, values: impl IntoIterator<Item = Option<f64>>) -> Self {
        Self {
            name: name.to_owned(),
            rows: values.into_iter().map(|value| value.map(|y| vec![y])).collect(),
            noise: None,
        }
    }

    /// An output that is a curve.
    pub fn curve(name: &str, rows: Vec<Option<Vec<f64>>>) -> Self {
        Self { name: name.to_owned(), rows, noise: None }
    }

    /// The same with the known variance of the noise in the values of each run.
    pub fn with_noise(mut self, variances: Vec<f64>) -> Self {
        self.noise = Some(variances);
        self
    }
}

/// Checked runs: where they were made, and what came out.
#[derive(Debug, Clone, PartialEq)]
pub struct TrainingData {
    inputs: Vec<Input>,
    points: Vec<Vec<f64>>,
    outputs: Vec<TrainingOutput>,
}

impl TrainingData {
    /// Runs at `points`, one row a run and one number an input.
    ///
    /// # Errors
    ///
    /// [`SurrogateError`] where there is no input, run or output; a row has another length than it must; a number is not
    /// finite or outside what its input can be; or fewer than [`FEWEST_RUNS`] different points gave an output.
    pub fn try_new(
        inputs: Vec<Input>,
        points: Vec<Vec<f64>>,
        outputs: Vec<TrainingOutput>,
    ) -> Result<Self, SurrogateError> {
        if inputs.is_empty() {
            return Err(SurrogateError::NoInput);
        }
        if outputs.is_empty() {
            return Err(SurrogateError::NoOutput);
        }
        for (run, point) in points.iter().enumerate() {
            if point.len() != inputs.len() {
                return Err(SurrogateError::PointLength { run, length: point.len(), inputs: inputs.len() });
            }
            for (input, (range, &value)) in inputs.iter().map(Input::support).zip(point).enumerate() {
                // A rounding error beyond an end is that of whoever computed the point.
                let slack = 1e-9 * (range.1 - range.0);
                if !value.is_finite() || value < range.0 - slack || value > range.1 + slack {
                    return Err(SurrogateError::InputOutside { run, input, value, lower: range.0, upper: range.1 });
                }
            }
        }
        for output in &outputs {
            check_output(output, &points)?;
        }
        Ok(Self { inputs, points, outputs })
    }

    /// The inputs.
    pub fn inputs(&self) -> &[Input] {
        &self.inputs
    }

    /// Inputs of the runs.
    pub fn points(&self) -> &[Vec<f64>] {
        &self.points
    }

    /// Outputs of the runs.
    pub fn outputs(&self) -> &[TrainingOutput] {
        &self.outputs
    }
}

fn check_output(output: &TrainingOutput, points: &[Vec<f64>]) -> Result<(), SurrogateError> {
    let name = || output.name.clone();
    if output.rows.len() != points.len() {
        return Err(SurrogateError::OutputRows { output: name(), rows: output.rows.len(), runs: points.len() });
    }
    if let Some(noise) = &output.noise {
        if noise.len() != points.len() {
            return Err(SurrogateError::OutputRows { output: name(), rows: noise.len(), runs: points.len() });
        }
        if let Some((run, value)) = noise.iter().enumerate().find(|(_, v)| !(**v >= 0.0) || !v.is_finite()) {
            return Err(SurrogateError::Noise { output: name(), run, value: *value });
        }
    }
    let mut length = None;
    let mut different: Vec<&[f64]> = Vec::new();
    for (run, (row, point)) in output.rows.iter().zip(points).enumerate() {
        let Some(row) = row else { continue };
        let expected = *length.get_or_insert(row.len());
        if row.len() != expected || row.is_empty() {
            return Err(SurrogateError::CurveLength { output: name(), run, length: row.len(), expected });
        }
        if let Some(value) = row.iter().find(|value| !value.is_finite()) {
            return Err(SurrogateError::OutputNotFinite { output: name(), run, value: *value });
        }
        if different.len() < FEWEST_RUNS && !different.contains(&point.as_slice()) {
            different.push(point);
        }
    }
    let missing = output.rows.iter().filter(|row| row.is_none()).count();
    if different.len() < FEWEST_RUNS {
        let runs = points.len();
        return Err(SurrogateError::TooFewRuns { output: name(), different: different.len(), runs, missing });
    }
    Ok(())
}
