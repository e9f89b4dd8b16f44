//! The largest magnitude, max |y|.

use super::kind::{Course, CourseEnds, ReductionDescription, ReductionKind};

pub(super) struct MaximumAbsolute;

impl MaximumAbsolute {
    pub const DESCRIPTION: ReductionDescription =
        ReductionDescription { words: "largest absolute value in the cycle", with_article: "the largest" };
}

impl ReductionKind for MaximumAbsolute {
    fn of(&self, course: &Course) -> f64 {
        course.largest.max(-course.smallest)
    }

    fn ends(&self, between: &CourseEnds) -> [f64; 2] {
        [between.near.largest, between.far.largest]
    }

    fn reach(&self, [lower, upper]: [f64; 2]) -> Option<f64> {
        Some(upper.max(-lower))
    }

    fn is_never_negative(&self) -> bool {
        true
    }

    fn moved_by_more_turns(&self) -> Option<f64> {
        Some(1.0)
    }
}
