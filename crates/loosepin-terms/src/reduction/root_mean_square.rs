//! The root of the mean square, √(mean y²).

use super::kind::{Course, CourseEnds, ReductionDescription, ReductionKind, is_kind};
use super::maximum_absolute::MaximumAbsolute;

pub(super) struct RootMeanSquare;

impl RootMeanSquare {
    pub const DESCRIPTION: ReductionDescription =
        ReductionDescription { words: "root mean square over the cycle", with_article: "the mean" };
}

impl ReductionKind for RootMeanSquare {
    fn of(&self, course: &Course) -> f64 {
        // Below zero by round-off alone; what is no number stays none.
        if course.mean_square < 0.0 { 0.0 } else { course.mean_square.sqrt() }
    }

    fn ends(&self, between: &CourseEnds) -> [f64; 2] {
        [between.near.mean_square.sqrt(), between.far.mean_square.sqrt()]
    }

    fn never_exceeds(&self, other: &dyn ReductionKind) -> bool {
        is_kind::<MaximumAbsolute>(other)
    }

    fn is_never_negative(&self) -> bool {
        true
    }

    fn is_of_means(&self) -> bool {
        true
    }
}
