//! How far a point strays across its path, as numbers, for a page that draws the path itself while a mechanism is edited.

use serde::Serialize;

use crate::mechanism::figure::pose_step;
use crate::mechanism::shapes::MM_PER_M;
use crate::medium::script_data::rounded;
use loosepin_result::motion::MotionRecord;

/// The tolerance zone about the path of an output point.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LivePath {
    /// Name of the output.
    pub output: String,
    /// The point: `coupler.tip`.
    pub point: String,
    /// Reach across the motion to either side, by play and by the 95 % ellipse of the scatter, mm; one for each pose of the drawing,
    /// 0 where the point stands still.
    pub across_mm: Vec<Option<f64>>,
}

/// The zones of all outputs that are paths, where anything takes their points off them. The words of a path relative to another point name no
/// point of the drawing, which therefore shows no zone of it.
pub fn live_paths(record: &MotionRecord) -> Vec<LivePath> {
    let step = pose_step(record.drive_angle_rad.len());
    let zones = record.paths.iter().filter(|path| path.has_zone() && path.is_complete());
    zones
        .filter_map(|path| {
            let across_m = |position: usize| match path.stands_still(position) {
                true => 0.0,
                false => path.along_and_across_m(position)[1],
            };
            let across: Vec<f64> = (0..path.positions()).map(|position| MM_PER_M * across_m(position)).collect();
            Some(LivePath {
                output: path.output.clone()?,
                point: path.point.clone(),
                across_mm: rounded(&across).into_iter().step_by(step).collect(),
            })
        })
        .collect()
}
