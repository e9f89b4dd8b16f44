//! Interface of a reduction. What reduces curves asks for these properties, never for a reduction by its name.

use std::any::Any;

/// Names of a reduction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ReductionDescription {
    /// In a table: "largest value in the cycle".
    pub words: &'static str,
    /// In front of what is reduced: "the largest".
    pub with_article: &'static str,
}

/// What reductions need of a curve over the recorded part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Course {
    /// Its largest value.
    pub largest: f64,
    /// Its smallest value.
    pub smallest: f64,
    /// Its mean.
    pub mean: f64,
    /// The mean of its square.
    pub mean_square: f64,
}

/// Curves that lie between two others: their ends at each point, and the magnitudes nearest to and farthest from zero between these.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CourseEnds {
    /// Of the lower ends.
    pub lower: Course,
    /// Of the upper ends.
    pub upper: Course,
    /// Of the smallest magnitudes.
    pub near: Course,
    /// Of the largest magnitudes.
    pub far: Course,
}

/// Properties of a reduction R of a curve y. Where nothing is stated the answer is the careful one.
pub(super) trait ReductionKind: Any {
    /// R(y).
    fn of(&self, course: &Course) -> f64;

    /// The least and the largest R of the curves that lie between two others.
    fn ends(&self, between: &CourseEnds) -> [f64; 2];

    /// Whether no curve gives a larger number than by `other`.
    fn never_exceeds(&self, other: &dyn ReductionKind) -> bool {
        let _ = other;
        false
    }

    /// How far a point of a curve between these ends may take the number, in its direction: the point that can take it furthest decides it.
    /// `None` of numbers that all points make.
    fn reach(&self, ends: [f64; 2]) -> Option<f64> {
        let _ = ends;
        None
    }

    /// Whether no curve gives a negative number.
    fn is_never_negative(&self) -> bool {
        false
    }

    /// Whether the curve is integrated for it.
    fn is_of_means(&self) -> bool {
        false
    }

    /// The direction, 1 or -1, in which a longer curve alone can take it; `None` where it can go either way.
    fn moved_by_more_turns(&self) -> Option<f64> {
        None
    }
}

/// Whether `other` is the reduction `K`: how the order of two is stated.
pub(super) fn is_kind<K: ReductionKind>(other: &dyn ReductionKind) -> bool {
    let other: &dyn Any = other;
    other.is::<K>()
}
