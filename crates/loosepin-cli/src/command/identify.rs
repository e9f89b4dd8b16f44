//! `loosepin identify`.

use loosepin::identify::record::{Gain, Identification, Outcome};
use loosepin::identify::{
    IdentifyProblem, MotionValues, Options, ProgressCallback, SpecimenStudy, identify, plan_motion, write_narrowed,
};
use loosepin::report::{identification_gain, identification_page, identification_text, motion_plan_text};
use loosepin::result::json::to_json;
use loosepin::result::repeat::Repeat;
use loosepin::result::study::StudyResult;
use loosepin::results::{Claim, Destination, InputsHash, InputsHasher, ResultKind};
use loosepin::study::{Progress, RunOptions, Study, run_study, study_inputs};
use loosepin::units::{DisplayUnits, counted_or_no};

use super::inputs::{add_model, add_study, read_study};
use super::signals::stop_on_signals;
use super::stored::{StoredResult, run_and_write, show_found, write_and_print};
use super::threads::threads;
use crate::arguments::{IdentifyArguments, ShownArguments};
use crate::console;
use crate::ending::{Done, Ending, Failure};
use crate::progress::Bar;
use std::path::PathBuf;

/// Shows the bounds of the plays from the readings of a study; writes the narrowed study and a page if requested.
pub fn run(arguments: &IdentifyArguments) -> Ending {
    let study = read_study(&arguments.study, &[])?;
    if arguments.plan {
        let asked = motion_values(arguments);
        let plan = with_bar(|heard| plan_motion(&study, arguments.specimen.as_deref(), &asked, heard))?;
        let text = if arguments.json {
            json(&plan)?
        } else {
            motion_plan_text(&plan, &study.model.shown_in(DisplayUnits::default()))
        };
        console::print(&text)?;
        return Ok(Done::Well);
    }
    let Some(folder) = &arguments.out else {
        let answer = answer(&study, arguments)?;
        let text = if arguments.json { json(&answer)? } else { identification_text(&answer) };
        console::print(&text)?;
        return write_asked(&study, &answer, arguments);
    };
    let claim = Claim {
        kind: ResultKind::Identification,
        name: study.name.clone(),
        inputs: inputs(&study, arguments),
        destination: Destination::Folder(folder.clone()),
        with_force: arguments.force,
    };
    let folder = claim.take()?;
    if folder.is_finished() {
        let answer = Identification::read(&folder)?;
        show_found::<Identification>(folder, ShownArguments::default())?;
        return write_asked(&study, &answer, arguments);
    }
    run_and_write(folder, |folder| {
        let mut answer = answer(&study, arguments)?;
        if !study.motion.is_empty() {
            let asked = motion_values(arguments);
            let plan = with_bar(|heard| plan_motion(&study, arguments.specimen.as_deref(), &asked, heard))?;
            answer.plan = Some(plan);
        }
        answer.repeat = Repeat::new("identify", &stated(arguments), study.input_files());
        write_and_print(&answer, folder, ShownArguments::default())?;
        write_asked(&study, &answer, arguments)
    })
}

impl StoredResult for Identification {
    const PAGE: fn(&Self) -> String = identification_page;
    const TEXT: fn(&Self) -> String = identification_text;

    fn done(&self) -> Done {
        if is_misfit(self) { Done::Misfit } else { Done::Well }
    }
}

fn motion_values(arguments: &IdentifyArguments) -> MotionValues {
    let threads = threads(arguments.threads);
    let (confidence, points) = (arguments.confidence, arguments.points);
    let (with_posterior, with_lengths) = (arguments.posterior, arguments.lengths);
    MotionValues { confidence, points, threads, with_posterior, with_lengths }
}

/// The results of the readings and the motion, and the comparison of the study's bounds if requested.
fn answer(study: &Study, arguments: &IdentifyArguments) -> Result<Identification, Failure> {
    let options = Options {
        confidence: arguments.confidence,
        specimen: arguments.specimen.clone(),
        points: arguments.points,
        threads: threads(arguments.threads),
        with_posterior: arguments.posterior,
        with_lengths: arguments.lengths,
        ..Options::default()
    };
    let mut answer = with_bar(|heard| identify(study, &options, heard))?;
    if arguments.compare {
        if is_misfit(&answer) {
            console::message("the study is not compared: no values explain the measurements");
        } else {
            match SpecimenStudy::new(study, &answer, &study_path(arguments)) {
                Ok(after) => answer.gain = Some(gain(study, &after.study, options.threads)?),
                // The identification is shown even so.
                Err(diagnostics) => console::report(&diagnostics),
            }
        }
    }
    Ok(answer)
}

fn is_misfit(answer: &Identification) -> bool {
    answer.specimens.iter().any(|specimen| matches!(specimen.outcome, Outcome::Misfit(_)))
        || answer.motion.iter().any(|specimen| specimen.misfit.is_some())
}

/// The file of the narrowed study, whether or not it is written.
fn study_path(arguments: &IdentifyArguments) -> PathBuf {
    arguments.write.clone().unwrap_or_else(|| arguments.study.with_file_name("narrowed.toml"))
}

/// The bounds of the study as it is and with the narrowed intervals.
fn gain(study: &Study, after: &Study, threads: usize) -> Result<Gain, Failure> {
    let stop = stop_on_signals("Ctrl-C ends the study at once");
    let run = |study: &Study| -> Result<StudyResult, Failure> {
        let bar = Bar::new();
        let options = RunOptions::new(threads, &bar, &stop);
        let outcome = run_study(study, &study_inputs(study, &[], None).to_string(), &options);
        bar.finish();
        Ok(outcome.map_err(|error| error.diagnostic(study))?.result)
    };
    Ok(identification_gain(&run(study)?, &run(after)?))
}

/// The result of `work`, a long computation, with a progress bar on a terminal.
fn with_bar<T>(work: impl FnOnce(ProgressCallback<'_>) -> T) -> T {
    let bar = Bar::of_values();
    let heard = |finished: usize, most: usize| {
        bar.runs(finished, most);
        true
    };
    let done = work(&heard);
    bar.finish();
    done
}

/// The options that affect the result.
fn stated(arguments: &IdentifyArguments) -> Vec<String> {
    let mut stated = vec!["--confidence".to_owned(), arguments.confidence.to_string()];
    stated.extend(["--points".to_owned(), arguments.points.to_string()]);
    stated.extend(arguments.specimen.iter().flat_map(|name| ["--specimen".to_owned(), name.clone()]));
    stated.extend(arguments.compare.then(|| "--compare".to_owned()));
    stated.extend(arguments.posterior.then(|| "--posterior".to_owned()));
    stated.extend(arguments.lengths.then(|| "--lengths".to_owned()));
    stated.extend(["--out".to_owned(), "identified".to_owned()]);
    stated
}

fn inputs(study: &Study, arguments: &IdentifyArguments) -> InputsHash {
    let mut hasher = InputsHasher::new(ResultKind::Identification);
    add_study(&mut hasher, study);
    add_model(&mut hasher, &study.model);
    for stated in stated(arguments) {
        hasher.add("stated", &stated);
    }
    hasher.finish()
}

fn json(answer: &impl serde::Serialize) -> Result<String, Failure> {
    to_json(answer).map_err(|error| Failure::of(&IdentifyProblem::NoJson { reason: error.to_string() }))
}

/// Writes the narrowed study if requested.
fn write_asked(study: &Study, answer: &Identification, arguments: &IdentifyArguments) -> Ending {
    let done = answer.done();
    let Some(path) = &arguments.write else { return Ok(done) };
    if done == Done::Misfit {
        // Measurements that no values explain cannot narrow an interval.
        console::message(&format!("{} is not written: no values explain the measurements", path.display()));
        return Ok(done);
    }
    let SpecimenStudy { text, narrowed: changes, mechanisms, .. } = SpecimenStudy::new(study, answer, path)?;
    // The files that the study names are written with it, so that the written study can be read.
    let rows = mechanisms.as_ref().map(|[name, rows]| (path.with_file_name(name), rows));
    let named = rows.iter().map(|(file, rows)| (file.as_path(), rows.as_str()));
    write_narrowed(study, &named.chain([(path.as_path(), text.as_str())]).collect::<Vec<_>>())?;
    if let Some((file, _)) = &rows {
        console::message(&format!("wrote {}: mechanisms that agree with what was measured", file.display()));
    }
    console::message(&format!(
        "wrote {}: {}",
        path.display(),
        match changes.len() {
            0 => "no interval is narrower than before".to_owned(),
            count => counted_or_no(count, "interval narrowed", "intervals narrowed"),
        }
    ));
    for change in changes {
        let [before, after] = [&change.before, &change.after].map(|ends| format!("{} to {}", ends[0], ends[1]));
        console::message(&console::indented(&format!("{}: {after}, before {before}", change.path)));
    }
    Ok(done)
}
