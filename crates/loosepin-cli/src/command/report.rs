//! `loosepin report`.

use loosepin::accuracy::record::MotionRecord;
use loosepin::results::{ResultKind, ResultsError, ResultsFolder};
use loosepin::simulate::record::SimulationRecord;
use loosepin::study::result::StudyResult;
use loosepin::sweep::record::SweepRecord;

use super::stored::show_again;
use crate::arguments::ReportArguments;
use crate::ending::Ending;

/// Writes the page of stored results again.
pub fn run(arguments: &ReportArguments) -> Ending {
    let mut folder = ResultsFolder::reopen(&arguments.folder)?;
    match folder.kind() {
        ResultKind::Simulation => show_again::<SimulationRecord>(&mut folder),
        ResultKind::Study => show_again::<StudyResult>(&mut folder),
        ResultKind::Sweep => show_again::<SweepRecord>(&mut folder),
        ResultKind::Motion => show_again::<MotionRecord>(&mut folder),
        ResultKind::Networks => Err(ResultsError::NoPage { folder: folder.path().to_owned() }.into()),
    }
}
