//! `loosepin merge`.

use std::cell::Cell;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::SystemTime;

use loosepin::files::{Folder, FolderLock};
use loosepin::report::study_page;
use loosepin::results::{Claim, Destination, ResultKind, ResultsError, ShardFolders, ShardsError};
use loosepin::store::{ExistingRuns, RunStore, Shard};
use loosepin::study::result::StudyResult;
use loosepin::study::{
    ClaimOutcome, OpenRound, RunOptions, RunSubset, StudyError, begin_in_folder, conclude, plan_shards, run_study,
    store_identity,
};
use loosepin::units;

use super::signals::stop_on_signals;
use super::stored::show_found;
use super::study::{read_study_with_options, show_outcome};
use super::threads::threads;
use crate::arguments::MergeArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};
use crate::progress::Bar;

/// Joins the shards, then writes the results or starts the next round.
pub fn run(arguments: &MergeArguments) -> Ending {
    let shards = ShardFolders::read(&arguments.folders).map_err(|error| Failure::of(&error))?;
    let record = &shards.record;
    let path = arguments.study.as_ref().unwrap_or(&record.study);
    let (mut study, inputs) = read_study_with_options(path, [&[], &record.accuracy, &[]], record.budget.as_deref())?;
    if let Some(share) = arguments.most_failed {
        study.set_most_failed(share);
    }
    if inputs.to_string() != record.inputs_blake3 {
        let expected = record.inputs_blake3.chars().take(8).collect();
        return Err(Failure::of(&ShardsError::Changed { study: path.clone(), found: inputs.short(), expected }));
    }
    let claim = Claim {
        kind: ResultKind::Study,
        name: study.name.clone(),
        inputs,
        destination: Destination::Folder(results(arguments, &shards)?),
        with_force: arguments.output.force,
    };
    if !claim.is_finished()? {
        plan_shards(&study, threads(arguments.threads)).map_err(|error| error.diagnostic(&study))?;
    }
    let stop = stop_on_signals("Ctrl-C ends the merge at once; the shards keep their runs");
    let of = record.of;
    let mut stores: Vec<(Shard, Folder)> = Vec::new();
    for (shard, path) in (1..=of).filter_map(|index| Shard::new(index, of)).zip(&shards.folders) {
        let not_opened = |source| Failure::of(&ResultsError::Read { path: path.clone(), source });
        stores.push((shard, Folder::open(path).map_err(not_opened)?));
    }
    let beginning = if claim.with_force { ExistingRuns::Anew } else { ExistingRuns::GoOn };
    let added = Cell::new(0);
    let open = |lock: &Arc<FolderLock>| {
        let (store, new) = RunStore::begin_joined(lock, &store_identity(&claim.inputs), beginning, &stores)?;
        added.set(new);
        Ok(store)
    };
    let (folder, store) = match begin_in_folder(&claim, open)? {
        ClaimOutcome::Open(folder, store) => (folder, store),
        ClaimOutcome::Finished(folder) => return show_found::<StudyResult>(folder, arguments.shown),
    };
    console::message(&format!("{} new runs of {}", added.get(), units::counted_or_no(of as usize, "shard", "shards")));
    let threads = threads(arguments.threads);
    let started = SystemTime::now();
    let bar = Bar::resumed(store.runs_at_start() as usize);
    let run_subset = RunSubset::Joined { of, largest_round: arguments.small_round as usize };
    let options = RunOptions { store: Some(&store), run_subset, ..RunOptions::new(threads, &bar, &stop) };
    let outcome = run_study(&study, &claim.inputs.to_string(), &options);
    bar.finish();
    if let Err(StudyError::RoundOpen(open)) = &outcome {
        store.publish().map_err(|error| Failure::of(&error))?;
        tell_open(open, of);
        return Ok(Done::RoundOpen);
    }
    let concluded = conclude(&study, folder, store, outcome, &study_page, (started, threads))?;
    show_outcome(concluded, "continue with the same command", arguments.shown)
}

/// The folder of the results, the same as for a study on one machine.
fn results(arguments: &MergeArguments, shards: &ShardFolders) -> Result<PathBuf, Failure> {
    if let Some(folder) = &arguments.output.folder {
        return Ok(folder.clone());
    }
    let folder = &shards.folders[0];
    let of = shards.record.of;
    let results = Shard::new(1, of).and_then(|shard| shard.results(folder));
    results.ok_or_else(|| Failure::of(&ShardsError::Renamed { folder: folder.clone(), shard: 1, of }))
}

/// Shows the runs that the shards still have to make.
fn tell_open(open: &OpenRound, of: u32) {
    let missing = open.missing_runs();
    if missing < open.runs {
        let shards: Vec<String> = open
            .missing
            .iter()
            .map(|(shard, runs)| format!("{shard}/{of} ({})", units::counted(*runs, "run")))
            .collect();
        console::message(&format!(
            "the current round of {} is not complete: runs of these shards are missing: {}\n\
             hint: run these shards again with --resume, then merge again",
            units::counted(open.runs, "run"),
            units::listed(&shards, "and")
        ));
    } else {
        console::message(&format!(
            "the next round has {}\nhint: run the shards again with --resume, then merge again",
            units::counted(missing, "run")
        ));
    }
}
