//! Failed runs: their reasons, and how to repeat one.

use super::file::{EpistemicSubject, Study};
use super::response::StudyResponse;
use loosepin_bounds::{RunInputs, SampleTable};
use loosepin_result::study::{ExampleRun, FailureGroup};
use loosepin_simulate::RunFailure;
use loosepin_text::units::SiUnit;
use std::collections::BTreeMap;
use std::path::Path;

/// The failed runs of `table` by reason, the most frequent first.
pub fn failures(study: &Study, response: &StudyResponse, table: &SampleTable) -> Vec<FailureGroup> {
    let mut groups: BTreeMap<u16, (u64, usize)> = BTreeMap::new();
    for run in 0..table.len() {
        if let Some(failure) = table.failure(run) {
            groups.entry(failure.0).or_insert((0, run)).0 += 1;
        }
    }
    let mut failures: Vec<FailureGroup> = groups
        .into_iter()
        .map(|(number, (count, run))| {
            let inputs = &table.inputs()[run];
            let mut row = vec![f64::NAN; response.row_length()];
            // The same inputs fail in the same way: this tells the reason in words.
            let words = match response.run(&inputs.random, &inputs.epistemic, &mut row) {
                Err(reason) => reason.to_string(),
                Ok(()) => RunFailure::code_of(number).to_owned(),
            };
            FailureGroup {
                code: RunFailure::code_of(number).to_owned(),
                words,
                count,
                example: ExampleRun { index: run as u64, command: command(study, inputs) },
            }
        })
        .collect();
    failures.sort_by_key(|group| std::cmp::Reverse(group.count));
    failures
}

/// The command that makes a run again: every number in SI with as many digits as read back to the same bits.
fn command(study: &Study, inputs: &RunInputs) -> String {
    let number = |path: &str, unit: &SiUnit, value: f64| {
        // A unit alone below the line is written as a power: a number followed by `1/m` is no value.
        let symbol = match unit.symbol() {
            "1" => String::new(),
            symbol => symbol.strip_prefix("1/").map_or(format!(" {symbol}"), |below| format!(" {below}^-1")),
        };
        format!(" --set \"{path}={value:?}{symbol}\"")
    };
    let mut words = format!("loosepin simulate {}", shell_word(&study.model_path));
    for (input, &value) in study.random.iter().zip(&inputs.random) {
        words.push_str(&number(&input.path, &input.unit(&study.model), value));
    }
    for (input, &value) in study.epistemic.iter().zip(&inputs.epistemic) {
        // A parameter of a distribution has done its work: the value drawn from it is set above.
        if matches!(input.subject, EpistemicSubject::Parameter { .. }) {
            continue;
        }
        words.push_str(&match input.law(value) {
            Some(law) => format!(" --set \"{}={}\"", input.path, law.name()),
            None => number(&input.path, &input.unit(&study.model), value),
        });
    }
    words.push_str(&format!(
        " --transient {} --turns {} --tolerance \"{:?} m\"",
        study.cycle.transient_turns, study.cycle.recorded_turns, study.sampling.tolerance_m
    ));
    words
}

/// A path as a shell takes it: as it is, or in single quotes.
fn shell_word(path: &Path) -> String {
    let path = path.display().to_string();
    let is_plain = |character: char| character.is_alphanumeric() || "/._-+,:@%".contains(character);
    if path.chars().all(is_plain) { path } else { format!("'{}'", path.replace('\'', "'\\''")) }
}

#[cfg(test)]
mod tests {
    use super::shell_word;
    use std::path::Path;

    #[test]
    fn paths_are_quoted_where_a_shell_would_take_them_apart() {
        let quoted = |path: &str| shell_word(Path::new(path));
        assert_eq!(quoted("../cases/worn-pin/model.toml"), "../cases/worn-pin/model.toml");
        assert_eq!(quoted("my mechanism/model.toml"), "'my mechanism/model.toml'");
        assert_eq!(quoted("it's $HOME.toml"), "'it'\\''s $HOME.toml'");
    }
}
