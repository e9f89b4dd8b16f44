//! What kinds of joints know of the reader of a model.

use crate::model::direction::Direction;
use crate::model::marker::PointId;
use loosepin_text::diagnostics::{Problem, Span};
use loosepin_text::document::Entry;
use loosepin_text::numbers::ReadsNumbers;

/// The reader of a model, as far as joints know it. What returns nothing has reported.
pub(crate) trait JointReader: ReadsNumbers {
    /// The point that an entry names as `body.point`.
    fn point(&mut self, entry: &Entry<'_>) -> Option<PointId>;

    /// The direction at an entry, in the frame of a body.
    fn direction(&mut self, entry: &Entry<'_>, body: usize) -> Option<Direction>;

    /// Reports a problem.
    fn refuse(&mut self, problem: &dyn Problem, span: Span) {
        self.numbers().reader.report(problem, span);
    }
}
