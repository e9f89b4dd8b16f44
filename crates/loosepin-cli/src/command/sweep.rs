//! `loosepin sweep`.

use loosepin::check::never_moving;
use loosepin::model::{Model, Rule, measured_argument};
use loosepin::report::{sweep_page, sweep_text};
use loosepin::results::{InputsHash, InputsHasher, ResultKind};
use loosepin::study::Progress;
use loosepin::sweep::record::SweepRecord;
use loosepin::sweep::{
    SECTIONS_FILE, SWEEP_FILE, SweepError, SweepPlan, SweepRequest, SweptValues, sections_csv, sweep, sweep_csv,
};
use loosepin::units::Dimension;

use super::inputs::{add_planar_model, check_tolerance, read_model, warn};
use super::signals::stop_on_signals;
use super::stored::{StoredResult, claim, run_and_write, show_found, write_and_print};
use super::threads::threads;
use crate::arguments::{ShownArguments, SweepArguments};
use crate::console;
use crate::ending::{Done, Ending, Failure};
use crate::progress::Bar;

/// Runs the sweep, or shows the stored one.
pub fn run(arguments: &SweepArguments) -> Ending {
    let model = read_model(&arguments.model)?;
    let set = model.set_values(&arguments.set)?;
    warn(&set.warnings());
    let tolerance_m = measured_argument("--tolerance", &arguments.tolerance, Dimension::LENGTH, Rule::Positive)?;
    let request = request(arguments);
    let plan = request.plan(&model, &set, tolerance_m)?;
    check_tolerance(plan.settings.tolerance_m, plan.smallest_clearance(&set))?;
    let claim = claim(ResultKind::Sweep, &model.name, inputs(arguments, &model, &plan), &arguments.output);
    let mechanism = plan.compile(&set)?;
    warn(&never_moving(&mechanism, &set.values));
    let folder = claim.take()?;
    if folder.is_finished() {
        return show_found::<SweepRecord>(folder, ShownArguments::default());
    }
    let stop = stop_on_signals("Ctrl-C ends the sweep at once");
    let bar = Bar::new();
    let heard = |finished: usize| bar.runs(finished, plan.points);
    heard(0);
    let outcome = sweep(&mechanism, &set, &plan, threads(arguments.threads), &heard, &stop);
    bar.finish();
    if let Err(SweepError::Interrupted { finished, runs }) = outcome {
        folder.abandon()?;
        console::message(&format!("interrupted after {finished} of {runs} runs"));
        return Ok(Done::Interrupted);
    }
    run_and_write(folder, |folder| {
        let mut record = outcome.map_err(|error| Failure::of(&error))?;
        record.repeat = request.repeat(&model);
        folder.write(SWEEP_FILE, sweep_csv(&record).as_bytes())?;
        folder.write(SECTIONS_FILE, sections_csv(&record).as_bytes())?;
        write_and_print(&record, folder, ShownArguments::default())
    })
}

impl StoredResult for SweepRecord {
    const PAGE: fn(&Self) -> String = sweep_page;
    const TEXT: fn(&Self) -> String = sweep_text;
}

fn request(arguments: &SweepArguments) -> SweepRequest<'_> {
    SweepRequest {
        values: SweptValues::Between { over: &arguments.over, points: arguments.points as usize },
        set: &arguments.set,
        transient_turns: arguments.transient,
        recorded_turns: arguments.turns,
        tolerance: &arguments.tolerance,
    }
}

fn inputs(arguments: &SweepArguments, model: &Model, plan: &SweepPlan) -> InputsHash {
    let mut hasher = InputsHasher::new(ResultKind::Sweep);
    add_planar_model(&mut hasher, model);
    for set in &arguments.set {
        hasher.add("set", set);
    }
    hasher
        .add("over", &model.quantities[plan.range.id].path)
        .add_number("from", plan.range.from_si)
        .add_number("to", plan.range.to_si)
        .add("points", plan.points.to_string())
        .add("transient_turns", plan.transient_turns.to_string())
        .add("recorded_turns", plan.recorded_turns.to_string())
        .add_number("tolerance_m", plan.settings.tolerance_m)
        .finish()
}
