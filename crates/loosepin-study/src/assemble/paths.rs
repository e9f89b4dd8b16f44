//! Ideal paths of outputs and of further points, with the zones in which play and scatter let their points be, to first order.

use crate::file::Study;
use crate::written::input_file::InputFile;
use loosepin_result::motion::MotionRecord;
use loosepin_result::point_path::CyclePaths;
use loosepin_text::diagnostics::Diagnostics;

/// Positions in a turn.
const POSITIONS: usize = 180;

/// The paths, of `motion` where the page shows one; `None` if there are none, or the drives alone do not move the mechanism: no finished study
/// is lost for it.
pub fn paths(study: &Study, motion: Option<&MotionRecord>) -> Option<CyclePaths> {
    if study.paths().is_empty() && !study.model.has_paths_with_zones() {
        return None;
    }
    let of = |record: &MotionRecord| CyclePaths {
        drive: record.drive.clone(),
        drive_angle_rad: record.drive_angle_rad.clone(),
        paths: record.paths.clone(),
    };
    let file = || InputFile::Study(Box::new(study.clone()));
    motion.map(of).or_else(|| file().ideal_motion_with_paths(POSITIONS, study.paths()).ok().as_ref().map(of))
}

impl Study {
    /// Adds the paths of points `BODY.POINT` to those of outputs: the result has them with the zones in which play and scatter let the points
    /// be, to first order.
    ///
    /// # Errors
    /// A point that the model does not have; a mechanism that its drives do not move alone.
    pub fn add_paths(&mut self, points: &[String]) -> Result<(), Diagnostics> {
        if points.is_empty() {
            return Ok(());
        }
        // At all positions: after the runs nothing can fail that did not before.
        InputFile::Study(Box::new(self.clone())).ideal_motion_with_paths(POSITIONS, points)?;
        self.state_paths(points);
        Ok(())
    }
}
