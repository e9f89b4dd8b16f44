//! A joint between two bodies.

use crate::kind::{SpatialKind, SpatialPlay};
use crate::mechanism::marker::Marker;

/// A joint: marker i (bearing) and marker j (journal), the kind that holds them together, and its play if it has some.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Its name.
    pub name: String,
    /// Which rows it is made of.
    pub kind: SpatialKind,
    /// Marker i, of the bearing, socket, guide or nut: play is described in its axes.
    pub bearing: Marker,
    /// Marker j, of the journal, ball, slider or screw.
    pub journal: Marker,
    /// Play of the journal in the bearing; `None` for an ideal joint.
    pub play: Option<SpatialPlay>,
}

impl Joint {
    /// An ideal joint.
    pub fn new(name: impl Into<String>, kind: impl Into<SpatialKind>, bearing: Marker, journal: Marker) -> Self {
        Self { name: name.into(), kind: kind.into(), bearing, journal, play: None }
    }

    /// The same joint with play.
    pub fn with_play(self, play: impl Into<SpatialPlay>) -> Self {
        Self { play: Some(play.into()), ..self }
    }
}
