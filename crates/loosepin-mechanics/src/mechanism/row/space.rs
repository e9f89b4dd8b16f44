//! The conditions of space.

use super::across::Across;
use super::coincident::Coincident;
use super::form::{CutState, RowGeometry};
use super::list::rows_at;
use super::perpendicular::Perpendicular;
use crate::model::SpaceRow;
use loosepin_math::{Real, Space};

rows_at! {
    /// A condition in space at a state.
    SpaceRowAt over Space { Coincident, Perpendicular, Across }
}

impl RowGeometry for Space {
    type RowAt<T: Real> = SpaceRowAt<T>;

    #[inline(always)]
    fn row_at<T: Real>(row: SpaceRow, state: &CutState<'_, T, Self>) -> SpaceRowAt<T> {
        match row {
            SpaceRow::Coincident => SpaceRowAt::Coincident(Coincident::at(state)),
            SpaceRow::Perpendicular(a, b) => SpaceRowAt::Perpendicular(Perpendicular::at(state, [a, b])),
            SpaceRow::Across(axis) => SpaceRowAt::Across(Across::at(state, axis)),
        }
    }
}
