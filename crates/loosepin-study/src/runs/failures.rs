//! Failed runs: their reasons, and how to repeat one.

use crate::file::Study;
use crate::response::study_response::StudyResponse;
use crate::written::simulate_command::run_command;
use loosepin_bounds::SampleTable;
use loosepin_result::study::{ExampleRun, FailureGroup};
use loosepin_simulate::RunFailure;
use std::collections::BTreeMap;

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
                example: ExampleRun { index: run as u64, command: run_command(study, inputs) },
            }
        })
        .collect();
    failures.sort_by_key(|group| std::cmp::Reverse(group.count));
    failures
}
