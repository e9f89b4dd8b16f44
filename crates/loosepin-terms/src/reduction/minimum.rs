//! The smallest value, min y.

use super::kind::{Course, CourseEnds, ReductionDescription, ReductionKind, is_kind};
use super::maximum::Maximum;
use super::maximum_absolute::MaximumAbsolute;
use super::mean::Mean;
use super::root_mean_square::RootMeanSquare;

pub(super) struct Minimum;

impl Minimum {
    pub const DESCRIPTION: ReductionDescription =
        ReductionDescription { words: "smallest value in the cycle", with_article: "the smallest" };
}

impl ReductionKind for Minimum {
    fn of(&self, course: &Course) -> f64 {
        course.smallest
    }

    fn ends(&self, between: &CourseEnds) -> [f64; 2] {
        [between.lower.smallest, between.upper.smallest]
    }

    /// min y <= mean y <= max y <= max |y|, and mean y <= √(mean y²).
    fn never_exceeds(&self, other: &dyn ReductionKind) -> bool {
        is_kind::<Mean>(other)
            || is_kind::<Maximum>(other)
            || is_kind::<RootMeanSquare>(other)
            || is_kind::<MaximumAbsolute>(other)
    }

    fn reach(&self, [lower, _]: [f64; 2]) -> Option<f64> {
        Some(-lower)
    }

    fn moved_by_more_turns(&self) -> Option<f64> {
        Some(-1.0)
    }
}
