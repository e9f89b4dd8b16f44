//! Commands of `loosepin simulate` that run one mechanism of a study: every number in SI with as many digits as read back to the same bits.

use crate::file::{EpistemicInput, EpistemicSubject, Study};
use loosepin_bounds::RunInputs;
use loosepin_result::repeat::shell_word;
use loosepin_result::study::{Witness, WitnessValue};
use loosepin_text::units::SiUnit;

/// The command that makes a run again.
pub(crate) fn run_command(study: &Study, inputs: &RunInputs) -> String {
    // Places of journals are not set: a motion shows what all of them do.
    let random = study.random.iter().zip(&inputs.random).filter(|(input, _)| input.quantity().is_some());
    let mut settings: Vec<String> =
        random.map(|(input, &value)| number_setting(&input.path, &input.unit(&study.model), value)).collect();
    for (input, &value) in study.epistemic.iter().zip(&inputs.epistemic) {
        // A parameter of a distribution has done its work: the value drawn from it is set above.
        if matches!(input.subject, EpistemicSubject::Parameter { .. } | EpistemicSubject::Play) {
            continue;
        }
        settings.push(match input.law(value) {
            Some(law) => format!("{}={}", input.path, law.name()),
            None => number_setting(&input.path, &input.unit(&study.model), value),
        });
    }
    command(study, &study.model_path.display().to_string(), &settings)
}

/// The command that runs the mechanism of a witness, with random inputs as in the model at `model_path`. `None` if the witness
/// has a parameter of a distribution, which no mechanism has.
pub(crate) fn witness_command(study: &Study, model_path: &str, witness: &Witness) -> Option<String> {
    Some(command(study, model_path, &witness_settings(study, witness)?))
}

/// The settings `path=value` of that command.
pub(crate) fn witness_settings(study: &Study, witness: &Witness) -> Option<Vec<String>> {
    let setting = |(path, value): (&String, &WitnessValue)| {
        let is_of_model = |input: &&EpistemicInput| !matches!(input.subject, EpistemicSubject::Parameter { .. });
        let input = study.epistemic.iter().find(|input| input.path == *path).filter(is_of_model)?;
        Some(match value {
            WitnessValue::Number(value_si) => number_setting(path, &input.unit(&study.model), *value_si),
            WitnessValue::Choice(word) => format!("{path}={word}"),
        })
    };
    let is_play = |path: &String| {
        study.epistemic.iter().any(|input| input.path == *path && matches!(input.subject, EpistemicSubject::Play))
    };
    // Every motion has the journals on both sides.
    witness.iter().filter(|(path, _)| !is_play(path)).map(setting).collect()
}

fn number_setting(path: &str, unit: &SiUnit, value: f64) -> String {
    format!("{path}={}", exact_value(value, unit))
}

/// A value with its SI unit, with as many digits as read back to the same bits.
pub fn exact_value(value_si: f64, unit: &SiUnit) -> String {
    // A unit alone below the line is written as a power: a number followed by `1/m` is no value.
    let symbol = match unit.symbol() {
        "1" => String::new(),
        symbol => symbol.strip_prefix("1/").map_or(format!(" {symbol}"), |below| format!(" {below}^-1")),
    };
    format!("{value_si:?}{symbol}")
}

/// With the cycle and the tolerance of the study, and the settings that it was run with.
fn command(study: &Study, model_path: &str, settings: &[String]) -> String {
    let path = |text: &str| text.split_once('=').map_or(text, |(path, _)| path).trim().to_owned();
    let of_study = study.settings().iter().filter(|own| settings.iter().all(|set| path(set) != path(own)));
    let set: String = of_study.chain(settings).map(|setting| format!(" --set \"{setting}\"")).collect();
    if !study.model.has_dynamics() {
        return format!("loosepin motion {}{set}", shell_word(model_path));
    }
    format!(
        "loosepin simulate {}{set} --transient {} --turns {} --tolerance \"{:?} m\"",
        shell_word(model_path),
        study.cycle.transient_turns,
        study.cycle.recorded_turns,
        study.sampling.tolerance_m
    )
}
