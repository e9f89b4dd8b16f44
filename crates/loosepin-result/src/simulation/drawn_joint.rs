//! How kinds of joint are drawn. Pages, terminal and studio ask here, and know no kind by its name.

use serde::{Deserialize, Serialize};

/// Kinds of joint that are drawn differently.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum DrawnJointKind {
    /// Ideal revolute joint.
    Revolute,
    /// Revolute joint with clearance.
    RevoluteWithClearance,
    /// Prismatic joint.
    Prismatic,
    /// A pin in a slot.
    Slot,
    /// A pin in a slot along a circle.
    CircularSlot,
    /// Rigid connection.
    Rigid,
    /// Any other: its two points.
    Other,
}

/// Drawing of a pin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DrawnPin {
    /// A pin without play.
    Solid,
    /// A journal that moves in its bearing.
    InBearing,
}

impl DrawnJointKind {
    /// The drawing of a joint whose kind has this word in files; `has_play` where a pin has play in a round hole.
    pub fn of(word: &str, has_play: bool) -> Self {
        match (word, has_play) {
            ("revolute", false) => Self::Revolute,
            ("revolute", true) => Self::RevoluteWithClearance,
            ("prismatic", _) => Self::Prismatic,
            ("slot", _) => Self::Slot,
            ("circular-slot", _) => Self::CircularSlot,
            ("rigid", _) => Self::Rigid,
            _ => Self::Other,
        }
    }

    /// Whether it has a line along which it slides.
    pub fn has_line(self) -> bool {
        matches!(self, Self::Prismatic | Self::Slot)
    }

    /// Whether it runs along a circle about its first point.
    pub fn has_circle(self) -> bool {
        self == Self::CircularSlot
    }

    /// Whether it runs between two faces.
    pub fn has_faces(self) -> bool {
        self.has_line() || self.has_circle()
    }

    /// Whether a block slides along that line, and does not turn.
    pub fn has_block(self) -> bool {
        self == Self::Prismatic
    }

    /// Its pin, where one is drawn.
    pub fn pin(self) -> Option<DrawnPin> {
        match self {
            Self::Revolute | Self::Slot | Self::CircularSlot => Some(DrawnPin::Solid),
            Self::RevoluteWithClearance => Some(DrawnPin::InBearing),
            Self::Prismatic | Self::Rigid | Self::Other => None,
        }
    }

    /// Whether one body turns about the other, as a drive may turn it.
    pub fn turns(self) -> bool {
        matches!(self, Self::Revolute | Self::RevoluteWithClearance)
    }

    /// Name beside a drawing.
    pub fn words(self) -> &'static str {
        match self {
            Self::Revolute => "revolute joint",
            Self::RevoluteWithClearance => "revolute joint with play",
            Self::Prismatic => "sliding joint",
            Self::Slot => "pin in a slot",
            Self::CircularSlot => "pin in a circular slot",
            Self::Rigid => "rigid connection",
            Self::Other => "joint",
        }
    }
}
