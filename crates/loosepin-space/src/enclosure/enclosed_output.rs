//! What every kind of output says of itself over a box of positions.

use crate::enclosure::jet::Number;
use crate::enclosure::position_box::{PlacedJet, PositionBox};

/// An output that can be enclosed.
pub(crate) trait EnclosedOutput {
    /// The deviation from the position that the box is about, m or rad; every number where it may be on another branch.
    fn enclosed<T: Number>(&self, at: &PositionBox) -> PlacedJet<T>;
}
