//! A study that nobody watches.

use std::sync::atomic::AtomicBool;

use loosepin::study::{Progress, RunOptions, Study, StudyError, StudyRun, run_study};

pub(crate) struct Silent;

impl Progress for Silent {
    fn runs(&self, _: usize, _: usize) {}
}

/// `study` on two threads.
pub(crate) fn run(study: &Study) -> StudyRun {
    run_on(2, study).unwrap_or_else(|error| panic!("{error}"))
}

/// `study` on so many threads.
pub(crate) fn run_on(threads: usize, study: &Study) -> Result<StudyRun, StudyError> {
    run_study(study, "", &RunOptions::new(threads, &Silent, &AtomicBool::new(false)))
}
