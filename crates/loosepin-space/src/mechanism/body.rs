//! A rigid body.

use loosepin_math::Pose;

/// A rigid body with the pose in which it is assembled, which may be rough for bodies that move.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Where it is at the start.
    pub start: Pose,
}

impl Body {
    /// A body.
    pub fn new(name: impl Into<String>, start: Pose) -> Self {
        Self { name: name.into(), start }
    }

    /// The ground, which is the first body of each mechanism.
    pub fn ground() -> Self {
        Self::new("ground", Pose::GROUND)
    }
}
