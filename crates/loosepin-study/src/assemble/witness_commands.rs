//! How the mechanisms of the most important witnesses are run.

use crate::file::Study;
use crate::written::simulate_command::witness_command;
use loosepin_result::repeat::InputRole;
use loosepin_result::study::{ResponsePoint, StudyResult, Witness, WitnessCommand};

/// Witnesses that are listed at most.
const MAX_WITNESSES: usize = 6;

/// The commands, to be given in the folder of the input files.
pub fn witness_commands(study: &Study, result: &StudyResult) -> Vec<WitnessCommand> {
    let Some(model) = result.repeat.file_of(InputRole::Model) else { return Vec::new() };
    let commands = witnesses(result).into_iter().filter_map(|witness| {
        Some(WitnessCommand { witness: witness.clone(), command: witness_command(study, &model.name, witness)? })
    });
    commands.take(MAX_WITNESSES).collect()
}

/// Different witnesses of requirements and of bounds that are no points of curves, the most important first.
fn witnesses(result: &StudyResult) -> Vec<&Witness> {
    let of_requirements = result.requirements.iter().map(|requirement| &requirement.witness);
    let is_shown = |at: ResponsePoint| !matches!(at, ResponsePoint::Curve { .. });
    let bounds = result.bounds.iter().filter(|bound| bound.treatment.is_mixed() && is_shown(bound.at));
    let of_bounds = bounds.flat_map(|bound| [&bound.upper.witness, &bound.lower.witness]);
    let mut found: Vec<&Witness> = Vec::new();
    for witness in of_requirements.chain(of_bounds) {
        if !witness.is_empty() && !found.contains(&witness) {
            found.push(witness);
        }
    }
    found
}
