//! The motion of a mechanism without dynamics, for the page of its study.

use crate::file::Study;
use loosepin_result::motion::MotionRecord;

/// The motion with the clearances that are uncertain where there is most play; `None` where runs are drawn instead, or where it has none: no
/// finished study is lost for it.
pub fn motion(study: &Study) -> Option<MotionRecord> {
    let settings: Vec<String> = study.widest_play().into_iter().map(|(_, setting)| setting).collect();
    study.model.motion_of_page(&settings, study.paths())
}
