//! From the smallest value to the largest, max y - min y.

use super::kind::{Course, CourseEnds, ReductionDescription, ReductionKind};

pub(super) struct Range;

impl Range {
    pub const DESCRIPTION: ReductionDescription =
        ReductionDescription { words: "peak-to-peak value in the cycle", with_article: "the peak-to-peak" };
}

impl ReductionKind for Range {
    fn of(&self, course: &Course) -> f64 {
        course.largest - course.smallest
    }

    fn ends(&self, CourseEnds { lower, upper, .. }: &CourseEnds) -> [f64; 2] {
        [(lower.largest - upper.smallest).max(0.0), upper.largest - lower.smallest]
    }

    fn is_never_negative(&self) -> bool {
        true
    }

    fn moved_by_more_turns(&self) -> Option<f64> {
        Some(1.0)
    }
}
