//! References of a model: bodies, joints, contacts, drives, controls and points by number; axes.

/// Index of a body in [`crate::model::Model::bodies`]; 0 is the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(pub usize);

/// Index of a joint in [`crate::model::Model::joints`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JointId(pub usize);

/// Index of a contact in [`crate::model::Model::contacts`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ContactId(pub usize);

/// Index of a drive in [`crate::model::Model::drives`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DriveId(pub usize);

/// Index of a control in [`crate::model::Model::controls`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ControlId(pub usize);

/// An actuator along the coordinate of a joint: a drive, or the actuator of a control.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Actuator {
    /// A drive, which needs whatever its motion takes.
    Drive(DriveId),
    /// The actuator of a control.
    Control(ControlId),
}

/// An element that may have play: a joint, or a coupling by its index in [`crate::model::Model::couplings`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum PlayId {
    /// A joint.
    Joint(JointId),
    /// A coupling.
    Coupling(usize),
}

/// A point of a body: `body`, and the index in [`crate::model::Body::points`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct PointId {
    /// The body that carries the point.
    pub body: BodyId,
    /// Index in [`crate::model::Body::points`].
    pub point: usize,
}

/// An axis of the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// Horizontal.
    X,
    /// Vertical, gravity along -y.
    Y,
}
