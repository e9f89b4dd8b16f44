//! The largest value, max y.

use super::kind::{Course, CourseEnds, ReductionDescription, ReductionKind, is_kind};
use super::maximum_absolute::MaximumAbsolute;

pub(super) struct Maximum;

impl Maximum {
    pub const DESCRIPTION: ReductionDescription =
        ReductionDescription { words: "largest value in the cycle", with_article: "the largest" };
}

impl ReductionKind for Maximum {
    fn of(&self, course: &Course) -> f64 {
        course.largest
    }

    fn ends(&self, between: &CourseEnds) -> [f64; 2] {
        [between.lower.largest, between.upper.largest]
    }

    fn never_exceeds(&self, other: &dyn ReductionKind) -> bool {
        is_kind::<MaximumAbsolute>(other)
    }

    fn reach(&self, [_, upper]: [f64; 2]) -> Option<f64> {
        Some(upper)
    }

    fn moved_by_more_turns(&self) -> Option<f64> {
        Some(1.0)
    }
}
