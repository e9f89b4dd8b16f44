//! `loosepin sweep`.

use loosepin::mechanism::Mechanism;
use loosepin::model::{Model, Rule, SetValues, SettingError, measured_argument};
use loosepin::report::{sweep_page, sweep_text};
use loosepin::result::repeat::Repeat;
use loosepin::results::{InputsHash, InputsHasher, ResultKind};
use loosepin::simulate::record::Override;
use loosepin::simulate::{Settings, input_files};
use loosepin::study::Progress;
use loosepin::sweep::record::SweepRecord;
use loosepin::sweep::{SECTIONS_FILE, SWEEP_FILE, SweepError, SweepPlan, sections_csv, sweep, sweep_csv};
use loosepin::units::Dimension;

use super::inputs::{add_model, check_tolerance, read_model};
use super::signals::stop_on_signals;
use super::stored::{StoredResult, claim, run_and_write, show_found, write_and_print};
use super::threads::threads;
use crate::arguments::SweepArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};
use crate::progress::Bar;

/// Runs the sweep, or shows the stored one.
pub fn run(arguments: &SweepArguments) -> Ending {
    let model = read_model(&arguments.model)?;
    let set = model.set_values(&arguments.set)?;
    let plan = plan(arguments, &model, &set)?;
    check_tolerance(plan.settings.tolerance_m, plan.smallest_clearance(&set))?;
    let claim = claim(ResultKind::Sweep, &model.name, inputs(arguments, &model, &plan), &arguments.output);
    // Compiled at the middle of the range: a clearance that begins at zero then has play, as for most values.
    let middle = middle_values(&model, &set, &plan)?;
    let mechanism = Mechanism::new(&set.model, &middle.values).map_err(|error| error.diagnostic(&model))?;
    let folder = claim.take()?;
    if folder.is_finished() {
        return show_found::<SweepRecord>(folder);
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
        record.repeat = repeat(&model, arguments);
        folder.write(SWEEP_FILE, sweep_csv(&record).as_bytes())?;
        folder.write(SECTIONS_FILE, sections_csv(&record).as_bytes())?;
        write_and_print(&record, folder)
    })
}

impl StoredResult for SweepRecord {
    const PAGE: fn(&Self) -> String = sweep_page;
    const TEXT: fn(&Self) -> String = sweep_text;
}

fn plan(arguments: &SweepArguments, model: &Model, set: &SetValues) -> Result<SweepPlan, Failure> {
    let range = model.parse_setting_range(&arguments.over)?;
    if set.settings.iter().any(|setting| setting.id == range.id) {
        let path = model.quantities[range.id].path.clone();
        return Err(Failure::of(&SettingError::Twice { path }));
    }
    let tolerance_m = measured_argument("--tolerance", &arguments.tolerance, Dimension::LENGTH, Rule::Positive)?;
    Ok(SweepPlan {
        range,
        points: arguments.points as usize,
        transient_turns: arguments.transient,
        recorded_turns: arguments.turns,
        settings: Settings { tolerance_m, ..Settings::for_study() },
        overrides: Override::from_settings(&arguments.set),
    })
}

/// The values of the model with the swept quantity in the middle of its range.
fn middle_values(model: &Model, set: &SetValues, plan: &SweepPlan) -> Result<SetValues, Failure> {
    let mut settings: Vec<_> = set.settings.iter().map(|setting| (setting.id, setting.value_si)).collect();
    settings.push((plan.range.id, 0.5 * (plan.range.from_si + plan.range.to_si)));
    let values = model.quantities.evaluate(&settings).map_err(|error| Failure::of(&error))?;
    Ok(SetValues { model: set.model.clone(), settings: set.settings.clone(), values })
}

/// The command that makes the sweep again.
fn repeat(model: &Model, arguments: &SweepArguments) -> Repeat {
    let mut stated: Vec<String> = Vec::new();
    for [name, value] in arguments.set.iter().map(|set| ["--set", set]).chain([["--over", &arguments.over]]) {
        stated.extend([name.to_owned(), value.to_owned()]);
    }
    stated.extend(["--points".to_owned(), arguments.points.to_string()]);
    stated.extend(["--transient".to_owned(), arguments.transient.to_string()]);
    stated.extend(["--turns".to_owned(), arguments.turns.to_string()]);
    stated.extend(["--tolerance".to_owned(), arguments.tolerance.clone()]);
    Repeat::new("sweep", &stated, input_files(model))
}

fn inputs(arguments: &SweepArguments, model: &Model, plan: &SweepPlan) -> InputsHash {
    let mut hasher = InputsHasher::new(ResultKind::Sweep);
    add_model(&mut hasher, model);
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
