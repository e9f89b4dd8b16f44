//! `loosepin motion`.

use loosepin::accuracy::record::{MotionRecord, MotionVerdict};
use loosepin::model::Model;
use loosepin::report::{motion_page, motion_text};
use loosepin::result::repeat::Repeat;
use loosepin::results::{InputsHash, InputsHasher, ResultKind};
use loosepin::simulate::input_files;
use loosepin::study::InputFile;

use super::inputs::{add_model, add_study, warn};
use super::stored::{StoredResult, claim, run_and_write, show_found, write_and_print};
use crate::arguments::MotionArguments;
use crate::ending::{Done, Ending};

/// Positions in a turn: every degree.
const POSITIONS: usize = 360;

/// Shows the ideal motion, and the quasi-static effect of play and of random inputs on it.
pub fn run(arguments: &MotionArguments) -> Ending {
    let file = InputFile::from_path(&arguments.file)?;
    let model = file.model();
    warn(match &file {
        InputFile::Model(model) => &model.warnings,
        InputFile::Study(study) => &study.warnings,
    });
    let mut record = file.ideal_motion_with_worst_cases(POSITIONS, &arguments.set)?;
    record.repeat = repeat(&file, &arguments.set);
    let claim = claim(ResultKind::Motion, &model.name, inputs(model, &file, arguments), &arguments.output);
    let folder = claim.take()?;
    if folder.is_finished() {
        return show_found::<MotionRecord>(folder);
    }
    run_and_write(folder, |folder| write_and_print(&record, folder))
}

impl StoredResult for MotionRecord {
    const PAGE: fn(&Self) -> String = motion_page;
    const TEXT: fn(&Self) -> String = motion_text;

    fn done(&self) -> Done {
        let is_met = self.requirements.iter().all(|requirement| requirement.verdict == MotionVerdict::Met);
        if is_met { Done::Well } else { Done::RequirementNotMet }
    }
}

/// The command that makes the result again.
fn repeat(file: &InputFile, set: &[String]) -> Repeat {
    let arguments: Vec<String> = set.iter().flat_map(|set| ["--set".to_owned(), set.clone()]).collect();
    match file {
        InputFile::Model(model) => Repeat::new("motion", &arguments, input_files(model)),
        InputFile::Study(study) => Repeat::new("motion", &arguments, study.input_files()),
    }
}

fn inputs(model: &Model, file: &InputFile, arguments: &MotionArguments) -> InputsHash {
    let mut hasher = InputsHasher::new(ResultKind::Motion);
    add_model(&mut hasher, model);
    if let InputFile::Study(study) = file {
        add_study(&mut hasher, study);
    }
    for set in &arguments.set {
        hasher.add("set", set);
    }
    hasher.finish()
}
