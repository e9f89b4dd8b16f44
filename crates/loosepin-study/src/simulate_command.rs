//! Commands of `loosepin simulate` that run one mechanism of a study: every number in SI with as many digits as read back to the same bits.

use super::file::{EpistemicInput, EpistemicSubject, Study};
use loosepin_bounds::RunInputs;
use loosepin_result::repeat::shell_word;
use loosepin_result::study::{Witness, WitnessValue};
use loosepin_text::units::SiUnit;

/// The command that makes a run again.
pub(super) fn run_command(study: &Study, inputs: &RunInputs) -> String {
    let mut command = begun(&study.model_path.display().to_string());
    for (input, &value) in study.random.iter().zip(&inputs.random) {
        set_number(&mut command, &input.path, &input.unit(&study.model), value);
    }
    for (input, &value) in study.epistemic.iter().zip(&inputs.epistemic) {
        // A parameter of a distribution has done its work: the value drawn from it is set above.
        if matches!(input.subject, EpistemicSubject::Parameter { .. }) {
            continue;
        }
        match input.law(value) {
            Some(law) => set_word(&mut command, &input.path, law.name()),
            None => set_number(&mut command, &input.path, &input.unit(&study.model), value),
        }
    }
    ended(command, study)
}

/// The command that runs the mechanism of a witness, with random inputs as in the model at `model_path`. Nothing where the witness
/// has a parameter of a distribution, which no mechanism has.
pub(super) fn witness_command(study: &Study, model_path: &str, witness: &Witness) -> Option<String> {
    let mut command = begun(model_path);
    for (path, value) in witness {
        let is_of_model = |input: &&EpistemicInput| !matches!(input.subject, EpistemicSubject::Parameter { .. });
        let input = study.epistemic.iter().find(|input| input.path == *path).filter(is_of_model)?;
        match value {
            WitnessValue::Number(value_si) => set_number(&mut command, path, &input.unit(&study.model), *value_si),
            WitnessValue::Choice(word) => set_word(&mut command, path, word),
        }
    }
    Some(ended(command, study))
}

fn begun(model_path: &str) -> String {
    format!("loosepin simulate {}", shell_word(model_path))
}

fn set_word(command: &mut String, path: &str, word: &str) {
    command.push_str(&format!(" --set \"{path}={word}\""));
}

fn set_number(command: &mut String, path: &str, unit: &SiUnit, value: f64) {
    // A unit alone below the line is written as a power: a number followed by `1/m` is no value.
    let symbol = match unit.symbol() {
        "1" => String::new(),
        symbol => symbol.strip_prefix("1/").map_or(format!(" {symbol}"), |below| format!(" {below}^-1")),
    };
    set_word(command, path, &format!("{value:?}{symbol}"));
}

/// With the cycle and the tolerance of the study.
fn ended(command: String, study: &Study) -> String {
    format!(
        "{command} --transient {} --turns {} --tolerance \"{:?} m\"",
        study.cycle.transient_turns, study.cycle.recorded_turns, study.sampling.tolerance_m
    )
}
