//! `loosepin motion`.

use std::sync::atomic::AtomicBool;

use loosepin::accuracy::record::{MotionRecord, MotionVerdict};
use loosepin::check::warnings;
use loosepin::report::{motion_page, motion_text, short_motion_text};
use loosepin::results::{MOTION_FILE, ResultKind};
use loosepin::simulate::motion_csv;
use loosepin::study::InputFile;

use super::inputs::warn;
use super::stored::{FirstScreen, StoredResult, claim, run_and_write, show_found, write_and_print};
use crate::arguments::MotionArguments;
use crate::ending::{Done, Ending};

/// Shows the ideal motion, and the quasi-static effect of play and of random inputs on it.
pub fn run(arguments: &MotionArguments) -> Ending {
    let file = InputFile::from_path(&arguments.file)?;
    warn(&warnings(&file));
    warn(&file.model().warnings_of_settings(&arguments.set));
    let record = file.motion_answer(&arguments.set, &arguments.path, &AtomicBool::new(false))?;
    let inputs = file.motion_inputs(&arguments.set, &arguments.path);
    let claim = claim(ResultKind::Motion, file.model().name(), inputs, &arguments.output);
    let folder = claim.take()?;
    if folder.is_finished() {
        return show_found::<MotionRecord>(folder, arguments.shown);
    }
    run_and_write(folder, |folder| {
        folder.write(MOTION_FILE, motion_csv(&record).as_bytes())?;
        write_and_print(&record, folder, arguments.shown)
    })
}

impl StoredResult for MotionRecord {
    const PAGE: fn(&Self) -> String = motion_page;
    const TEXT: fn(&Self) -> String = motion_text;
    const SHORT: Option<FirstScreen<Self>> = Some((short_motion_text, |record| match record.efforts.is_empty() {
        true => "all rows of the tables",
        false => "the efforts of the drives and all rows of the tables",
    }));

    fn done(&self) -> Done {
        let is_met = self.requirements.iter().all(|requirement| requirement.verdict == MotionVerdict::Met);
        if is_met { Done::Well } else { Done::RequirementNotMet }
    }
}
