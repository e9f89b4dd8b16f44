//! The state in which a mechanism begins that its drives do not move alone.

use crate::model::ids::{Axis, BodyId, JointId};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::Dimension;

/// One number of the initial state.
#[derive(Debug, Clone)]
pub struct InitialValue {
    /// Path in the file.
    pub path: String,
    /// The coordinate that has this value at time zero.
    pub of: InitialOf,
    /// Whether it is the rate of that.
    pub is_rate: bool,
    /// The value, rad or m, for a rate rad/s or m/s.
    pub number: InitialNumber,
}

/// Position of the journal of a joint with play in its bearing at time zero; centred if not given.
#[derive(Debug, Clone)]
pub struct InitialOffset {
    /// Path of its table.
    pub path: String,
    /// The joint.
    pub joint: JointId,
    /// Position.
    pub place: OffsetPlace,
}

/// The stated position of a journal in its bearing.
#[derive(Debug, Clone, Copy)]
pub enum OffsetPlace {
    /// Its centre from that of the bearing, along the axes of the ground, m, and the rate of that, m/s; zero where left out.
    Given {
        /// Components of the offset.
        offset_m: Option<[QuantityId; 2]>,
        /// Components of its rate.
        velocity_m_s: Option<[QuantityId; 2]>,
    },
    /// Against the side on which the forces at the start press it.
    Resting,
}

/// The source of a number of the initial state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InitialNumber {
    /// The file.
    Given(QuantityId),
    /// The reference of a control at time zero, or its rate.
    Reference {
        /// Index in [`crate::model::Model::controls`].
        control: usize,
    },
}

impl InitialOf {
    /// The coordinate of a joint, which is an angle or a length.
    pub fn joint(joint: JointId, coordinate: Dimension) -> Self {
        if coordinate == Dimension::LENGTH { Self::JointPosition(joint) } else { Self::JointAngle(joint) }
    }
}

impl InitialValue {
    /// Its dimension.
    pub fn dimension(&self) -> Dimension {
        let position = match self.of {
            InitialOf::BodyAngle(_) | InitialOf::JointAngle(_) => Dimension::ANGLE,
            InitialOf::BodyPosition(..) | InitialOf::JointPosition(_) => Dimension::LENGTH,
        };
        if self.is_rate { position.over(Dimension::TIME) } else { position }
    }
}

/// Coordinates that can have an initial value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InitialOf {
    /// The angle of a body's x axis from the ground's.
    BodyAngle(BodyId),
    /// A coordinate of the origin of a body's frame.
    BodyPosition(BodyId, Axis),
    /// The angle of the journal's body from the bearing's.
    JointAngle(JointId),
    /// The position of the slider along the guide.
    JointPosition(JointId),
}
