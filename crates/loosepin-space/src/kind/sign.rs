//! What is drawn of a joint.

/// The sign by which a kind of joint is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointSign {
    /// A pin in a bearing, with their axis.
    Pin,
    /// A block between two rails.
    Guide,
    /// A shaft that slides through a bearing, with their axis.
    Sleeve,
    /// A ball in a socket.
    Ball,
    /// The two pins of a cross.
    Cross,
    /// A plate on a plate.
    Plate,
    /// Two bodies that are one.
    Weld,
}

impl JointSign {
    /// Whether the body of the bearing is drawn as rails along the axis.
    pub fn has_rails(self) -> bool {
        matches!(self, Self::Guide)
    }

    /// Whether a bearing is drawn along the axis, with its length.
    pub fn has_bearing(self) -> bool {
        matches!(self, Self::Pin | Self::Sleeve)
    }
}
