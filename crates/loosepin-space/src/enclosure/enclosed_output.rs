//! What every kind of output says of itself over a box of positions.

use crate::enclosure::jet::Jet;
use crate::enclosure::position_box::PositionBox;

/// A number with derivatives by the numbers of two bodies; the second may be the ground.
pub(crate) struct PlacedJet<const C: usize> {
    pub bodies: [usize; 2],
    pub jet: Jet<C>,
}

/// An output that can be enclosed.
pub(crate) trait EnclosedOutput {
    /// The deviation from the position that the box is about, m or rad; every number where it may be on another branch.
    fn enclosed<const C: usize>(&self, at: &PositionBox) -> PlacedJet<C>;
}
