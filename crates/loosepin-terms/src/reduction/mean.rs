//! The mean over time.

use super::kind::{Course, CourseEnds, ReductionDescription, ReductionKind, is_kind};
use super::maximum::Maximum;
use super::maximum_absolute::MaximumAbsolute;
use super::root_mean_square::RootMeanSquare;

pub(super) struct Mean;

impl Mean {
    pub const DESCRIPTION: ReductionDescription =
        ReductionDescription { words: "mean over the cycle", with_article: "the mean" };
}

impl ReductionKind for Mean {
    fn of(&self, course: &Course) -> f64 {
        course.mean
    }

    fn ends(&self, between: &CourseEnds) -> [f64; 2] {
        [between.lower.mean, between.upper.mean]
    }

    /// mean y <= √(mean y²) by the inequality of Cauchy and Schwarz.
    fn never_exceeds(&self, other: &dyn ReductionKind) -> bool {
        is_kind::<Maximum>(other) || is_kind::<RootMeanSquare>(other) || is_kind::<MaximumAbsolute>(other)
    }

    fn is_of_means(&self) -> bool {
        true
    }
}
