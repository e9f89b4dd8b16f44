//! The conditions of space.

use super::across::Across;
use super::coincident::Coincident;
use super::list::rows;
use super::perpendicular::Perpendicular;
use crate::model::{Row, SpaceRow};
use loosepin_math::Space;

rows! {
    Space, SpaceRow, |state| {
        SpaceRow::Coincident => Coincident::at(state),
        SpaceRow::Perpendicular(a, b) => Perpendicular::at(state, [a, b]),
        SpaceRow::Across(axis) => Across::at(state, axis),
    }
}
