//! Fits surrogates of the two trials of `loosepin::surrogate::trials`, and writes the points for other programs to fit.
//!
//! `surrogates CASE RUNS DESIGNS KINDS [FOLDER]`: CASE is `ishigami` or `oscillator`, KINDS a list such as `auto,chaos`. Prints
//! one line of JSON for each design and kind. With FOLDER, writes the inputs and outputs of the designs and of the test there.

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

use loosepin::surrogate::trials::{ishigami, ishigami_inputs, oscillator, oscillator_inputs, points};
use loosepin::surrogate::{Input, Options, Surrogate, SurrogateError, TrainingData, TrainingOutput};
use loosepin_bench::surrogate_choice;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

/// A response: from inputs to columns.
type Function = fn(&[f64]) -> Vec<f64>;

const TEST_POINTS: usize = 1_000;
const DESIGN_SEED: u64 = 7;
const TEST_SEED: u64 = 99;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [case, runs, designs, kinds, folder @ ..] = arguments.as_slice() else {
        return Err("usage: surrogates ishigami|oscillator RUNS DESIGNS KINDS [FOLDER]".into());
    };
    let (inputs, response): (Vec<Input>, Function) = match case.as_str() {
        "ishigami" => (ishigami_inputs(), |x| vec![ishigami(x)]),
        "oscillator" => (oscillator_inputs(), oscillator),
        other => return Err(format!("no case '{other}'; there are ishigami and oscillator").into()),
    };
    let runs: usize = runs.parse()?;
    let test = points(&inputs, TEST_SEED, 0, TEST_POINTS);
    let truth: Vec<Vec<f64>> = test.iter().map(|x| response(x)).collect();
    if let Some(folder) = folder.first() {
        write_table(&Path::new(folder).join(format!("{case}-test.csv")), &test, &truth)?;
    }
    for design in 0..designs.parse()? {
        let at = points(&inputs, DESIGN_SEED, design, runs);
        let answers: Vec<Vec<f64>> = at.iter().map(|x| response(x)).collect();
        if let Some(folder) = folder.first() {
            write_table(&Path::new(folder).join(format!("{case}-{runs}-{design}.csv")), &at, &answers)?;
        }
        for kind in kinds.split(',').filter(|kind| !kind.is_empty()) {
            let rows = answers.iter().cloned().map(Some).collect();
            let data = TrainingData::try_new(inputs.clone(), at.clone(), vec![TrainingOutput::curve("y", rows)])?;
            let choice = surrogate_choice(kind)
                .ok_or_else(|| format!("no kind '{kind}'; there are auto, chaos, kriging and network"))?;
            let begin = Instant::now();
            let surrogate = Surrogate::fit(&data, &Options { choice, ..Options::default() })?;
            let seconds = begin.elapsed().as_secs_f64();
            let output = &surrogate.outputs()[0];
            println!(
                "{{\"case\":\"{case}\",\"runs\":{runs},\"design\":{design},\"program\":\"ours-{kind}\",\"q2\":{:.6},\
                 \"held_out_q2\":{:.6},\"seconds\":{seconds:.3}}}",
                test_q2(&surrogate, &test, &truth)?,
                output.quality.q2.unwrap_or(f64::NAN),
            );
        }
    }
    Ok(())
}

/// 1 - Σ error²/Σ (y - mean)² over points and places.
fn test_q2(surrogate: &Surrogate, test: &[Vec<f64>], truth: &[Vec<f64>]) -> Result<f64, SurrogateError> {
    let count = test.len() as f64;
    let mean: Vec<f64> = (0..truth[0].len()).map(|t| truth.iter().map(|y| y[t]).sum::<f64>() / count).collect();
    let (mut square, mut total) = (0.0, 0.0);
    for (x, y) in test.iter().zip(truth) {
        let values = surrogate.predict(x)?.remove(0).values;
        square += values.iter().zip(y).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
        total += y.iter().zip(&mean).map(|(y, m)| (y - m) * (y - m)).sum::<f64>();
    }
    Ok(1.0 - square / total)
}

/// One row a run: inputs, then outputs.
fn write_table(path: &Path, inputs: &[Vec<f64>], outputs: &[Vec<f64>]) -> std::io::Result<()> {
    let mut text = String::new();
    for (x, y) in inputs.iter().zip(outputs) {
        let row: Vec<String> = x.iter().chain(y).map(f64::to_string).collect();
        let _ = writeln!(text, "{}", row.join(","));
    }
    std::fs::write(path, text)
}
