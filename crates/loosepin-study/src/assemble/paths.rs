//! Ideal paths of outputs, with the zones in which play and scatter let their points be, to first order.

use crate::file::Study;
use crate::written::input_file::InputFile;
use loosepin_mechanics::model::Recorded;
use loosepin_result::point_path::CyclePaths;

/// Positions in a turn.
const POSITIONS: usize = 180;

/// The paths; `None` if no output is one, or the drives alone do not move the mechanism: no finished study is lost for it.
pub fn paths(study: &Study) -> Option<CyclePaths> {
    let is_path = |output: &loosepin_mechanics::model::Output| matches!(output.kind.recorded(), Recorded::Path(_));
    if !study.model.outputs.iter().any(is_path) {
        return None;
    }
    let record = InputFile::Study(Box::new(study.clone())).ideal_motion(POSITIONS, &[]).ok()?;
    Some(CyclePaths { drive: record.drive, drive_angle_rad: record.drive_angle_rad, paths: record.paths })
}
