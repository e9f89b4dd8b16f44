//! The motion of a mechanism in space, for the page of its study.

use crate::file::Study;
use loosepin_result::motion::MotionRecord;

/// The motion with the clearances that are uncertain where there is most play; `None` of a planar model, or where it has none: no finished study
/// is lost for it.
pub fn spatial(study: &Study) -> Option<MotionRecord> {
    let model = study.model.spatial()?;
    let settings: Vec<String> = study.widest_play().into_iter().map(|(_, setting)| setting).collect();
    let values = study.model.spatial_values(&settings).ok()?;
    model.motion_record(&values).ok()
}
