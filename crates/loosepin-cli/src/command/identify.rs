//! `loosepin identify`.

use loosepin::identify::record::{Identification, Outcome};
use loosepin::identify::{
    IdentifyProblem, MotionValues, Options, identify, known_bounds, narrowed, plan_motion, write_narrowed,
};
use loosepin::report::{identification_text, motion_plan_text};
use loosepin::result::json::to_json;
use loosepin::study::Study;
use loosepin::units::DisplayUnits;

use super::inputs::read_study;
use super::threads::threads;
use crate::arguments::IdentifyArguments;
use crate::console;
use crate::ending::{Done, Ending, Failure};

/// Shows what the readings of a study say of its plays, and writes the narrowed study where that is asked for.
pub fn run(arguments: &IdentifyArguments) -> Ending {
    let study = read_study(&arguments.study)?;
    let threads = threads(arguments.threads);
    if arguments.plan {
        let asked = MotionValues { confidence: arguments.confidence, points: arguments.points, threads };
        let plan = plan_motion(&study, arguments.specimen.as_deref(), &asked)?;
        let text = if arguments.json {
            json(&plan)?
        } else {
            motion_plan_text(&plan, &study.model.shown_in(DisplayUnits::default()))
        };
        console::print(&text)?;
        return Ok(Done::Well);
    }
    let options = Options {
        confidence: arguments.confidence,
        specimen: arguments.specimen.clone(),
        points: arguments.points,
        threads,
        ..Options::default()
    };
    let answer = identify(&study, &options)?;
    let text = if arguments.json { json(&answer)? } else { identification_text(&answer) };
    console::print(&text)?;
    let is_misfit = answer.specimens.iter().any(|specimen| matches!(specimen.outcome, Outcome::Misfit(_)))
        || answer.motion.iter().any(|specimen| specimen.misfit.is_some());
    if let Some(path) = &arguments.write {
        // What is not explained is no ground for narrowing.
        if is_misfit {
            console::message(&format!("{} is not written: no values explain what was measured", path.display()));
        } else {
            write(&study, &answer, path)?;
        }
    }
    Ok(if is_misfit { Done::Misfit } else { Done::Well })
}

fn json(answer: &impl serde::Serialize) -> Result<String, Failure> {
    to_json(answer).map_err(|error| Failure::of(&IdentifyProblem::NoJson { reason: error.to_string() }))
}

fn write(study: &Study, answer: &Identification, path: &std::path::Path) -> Result<(), Failure> {
    let known = known_bounds(answer)?;
    let (text, changes) = narrowed(study, &known);
    write_narrowed(study, path, &text)?;
    console::message(&format!(
        "wrote {}: {}",
        path.display(),
        match changes.len() {
            0 => "no interval is narrower than before".to_owned(),
            count => console::counted(count, "interval narrowed", "intervals narrowed"),
        }
    ));
    for change in changes {
        let [before, after] = [&change.before, &change.after].map(|ends| format!("{} to {}", ends[0], ends[1]));
        console::message(&console::indented(&format!("{}: {after}, before {before}", change.path)));
    }
    Ok(())
}
