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
