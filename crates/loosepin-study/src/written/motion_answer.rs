//! The motion of a file without dynamics, as by `loosepin motion`.

use crate::written::input_file::InputFile;
use crate::written::inputs::{add_model, add_study};
use loosepin_result::motion::MotionRecord;
use loosepin_result::repeat::Repeat;
use loosepin_store::results::{InputsHash, InputsHasher, ResultKind};
use loosepin_text::diagnostics::Diagnostics;
use std::sync::atomic::AtomicBool;

/// Positions in a turn: every degree.
const POSITIONS: usize = 360;

impl InputFile {
    /// The ideal motion at every degree, with worst cases of the play, the requirements of a study judged by them, and the command that
    /// makes it again, until `stop` is set; `set` are settings `path=value`, `paths` points `BODY.POINT` whose paths are recorded besides those
    /// of outputs.
    ///
    /// # Errors
    /// As for [`Self::ideal_motion_with_worst_cases`].
    pub fn motion_answer(
        &self,
        set: &[String],
        paths: &[String],
        stop: &AtomicBool,
    ) -> Result<MotionRecord, Diagnostics> {
        let mut record = self.ideal_motion_with_worst_cases(POSITIONS, set, paths, stop)?;
        let written = set.iter().map(|set| ("--set", set)).chain(paths.iter().map(|path| ("--path", path)));
        let arguments: Vec<String> = written.flat_map(|(name, text)| [name.to_owned(), text.clone()]).collect();
        record.repeat = match self {
            InputFile::Model(model) => Repeat::new("motion", &arguments, model.input_files()),
            InputFile::Study(study) => Repeat::new("motion", &arguments, study.input_files()),
        };
        Ok(record)
    }

    /// The hash of everything that [`Self::motion_answer`] is computed from.
    pub fn motion_inputs(&self, set: &[String], paths: &[String]) -> InputsHash {
        let mut hasher = InputsHasher::new(ResultKind::Motion);
        add_model(&mut hasher, self.model());
        if let InputFile::Study(study) = self {
            add_study(&mut hasher, study);
        }
        for set in set {
            hasher.add("set", set);
        }
        for path in paths {
            hasher.add("path", path);
        }
        hasher.finish()
    }
}
