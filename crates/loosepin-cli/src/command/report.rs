//! `loosepin report`.

use loosepin::results::{ResultKind, ResultsFolder};

use super::{motion, simulate, study, sweep};
use crate::arguments::ReportArguments;
use crate::ending::Ending;

/// Writes the page of stored results again.
pub fn run(arguments: &ReportArguments) -> Ending {
    let mut folder = ResultsFolder::open(&arguments.folder)?;
    match folder.kind() {
        ResultKind::Simulation => simulate::show_again(&mut folder),
        ResultKind::Study => study::show_again(&mut folder),
        ResultKind::Sweep => sweep::show_again(&mut folder),
        ResultKind::Motion => motion::show_again(&mut folder),
    }
}
