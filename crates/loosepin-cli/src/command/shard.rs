//! `loosepin study --shard i/n`: a part of the runs of a study.

use std::path::Path;

use loosepin::files::Folder;
use loosepin::result::json::to_json;
use loosepin::results::{Claim, Destination, SHARD_FILE, ShardRecord};
use loosepin::store::{ExistingRuns, PUBLISHED_FILE, RunStore, Shard};
use loosepin::study::{
    ClaimOutcome, RunOptions, RunSubset, Study, StudyError, begin_in_folder, plan_shards, run_study, store_identity,
};

use loosepin::units::counted;

use super::signals::stop_on_signals;
use super::stored::show_reused_runs;
use super::threads::threads;
use crate::arguments::StudyArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};
use crate::progress::Bar;

/// Makes the runs of `shard` in the current round of the study whose folder `whole` claims.
pub fn run(arguments: &StudyArguments, shard: Shard, study: &Study, whole: Claim) -> Ending {
    let results = whole.path();
    if whole.is_finished()? {
        console::message(&format!(
            "{} already holds this study: shard {shard} has nothing to run (--force runs it again)",
            results.display()
        ));
        return Ok(Done::Well);
    }
    plan_shards(study, threads(arguments.threads)).map_err(|error| error.diagnostic(study))?;
    let claim = Claim { destination: Destination::Folder(shard.folder(&results)), ..whole };
    let record = ShardRecord {
        shard: shard.index(),
        of: shard.of(),
        name: study.name.clone(),
        study: arguments.study.clone(),
        accuracy: arguments.accuracy.clone(),
        budget: arguments.budget.clone(),
        inputs_blake3: claim.inputs.to_string(),
        version: loosepin::VERSION.to_owned(),
    };
    let has_published = |folder: &Folder| folder.find(Path::new(PUBLISHED_FILE)).is_ok_and(|found| found.is_some());
    let published = Folder::open(&results).ok().filter(has_published);
    let beginning = ExistingRuns::from_options(claim.with_force, arguments.resume);
    let identity = store_identity(&claim.inputs);
    let begun = begin_in_folder(&claim, |lock| RunStore::begin_beside(lock, published.as_ref(), &identity, beginning))?;
    let ClaimOutcome::Open(folder, store) = begun else {
        console::message(&format!("{} already holds this study", claim.path().display()));
        return Ok(Done::Well);
    };
    let text = to_json(&record).map_err(|error| folder.foreign_file(SHARD_FILE, error))?;
    // Not one of the files of the result, which are deleted when it starts again.
    folder.write_beside(SHARD_FILE, text.as_bytes())?;
    show_reused_runs(&store);
    let stop = stop_on_signals("Ctrl-C ends the shard at once; saved runs are kept");
    let bar = Bar::new();
    let (threads, run_subset) = (threads(arguments.threads), RunSubset::Shard(shard));
    let options = RunOptions { store: Some(&store), run_subset, ..RunOptions::new(threads, &bar, &stop) };
    let outcome = run_study(study, &claim.inputs.to_string(), &options);
    bar.finish();
    let merge = format!("loosepin merge {}.shard-*-of-{}", results.display(), shard.of());
    match outcome {
        Ok(_) => {
            console::message(&format!(
                "shard {shard}: all runs of the study are finished\nhint: {merge} writes the results"
            ));
            Ok(Done::Well)
        }
        Err(StudyError::RoundOpen(open)) => {
            let made = match open.made {
                0 => "has nothing to run".to_owned(),
                1 => "has finished its run".to_owned(),
                made => format!("has finished its {made} runs"),
            };
            console::message(&format!(
                "shard {shard} {made} in the current round of {}\nhint: when all shards have finished, continue with {merge}",
                counted(open.runs, "run")
            ));
            Ok(Done::Well)
        }
        Err(StudyError::Interrupted { .. }) => {
            let kept = store.flush().map_err(|error| Failure::of(&error))?;
            console::message(&format!(
                "interrupted; {kept} runs of shard {shard} are kept in {}\nhint: continue with the same command and --resume",
                folder.path().display()
            ));
            Ok(Done::Interrupted)
        }
        // Finished runs are kept after any error.
        Err(error) => Err(error.diagnostic(study).into()),
    }
}
