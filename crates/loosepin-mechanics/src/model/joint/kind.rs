//! The interface of a kind of joint, and its terms.

use super::clearance::{CircularSlotClearance, Clearance, GuideClearance, SlotClearance};
use super::reading::JointReader;
use super::row::PlaneRow;
use crate::model::ids::{ContactId, PointId};
use crate::model::words::part_names::Names;
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::Dimension;

/// A kind of joint between two bodies of the plane.
///
/// The rest of the program asks these questions, and knows no kind by its name. Constants are what all joints of a kind have in common,
/// methods what one of them states.
pub trait KindOfJoint: Sized {
    /// Word in files.
    const WORD: &'static str;
    /// Keys of its table.
    const KEYS: &'static Keys;
    /// Dimension of its coordinate: an angle, or a position along a line; `None` if it has none.
    const COORDINATE: Option<Dimension>;
    /// How a body hangs on another by it.
    const TREE_ATTACHMENT: TreeAttachment;
    /// The constraints that it is where it closes a loop.
    const ROWS: &'static [PlaneRow];
    /// What it is to a flexible body.
    const AT_BEAM: AtBeam;
    /// Names of the places where its parts may touch; empty where there is one alone.
    const CONTACT_PLACES: &'static [&'static str] = &[];
    /// Key of its clearance, in errors and hints.
    const CLEARANCE_KEY: &'static str = "clearance";
    /// Key of the size on which its friction acts where it is ideal; `None` if it has no friction.
    const FRICTION_SIZE: Option<&'static str> = None;
    /// Whether it may wear.
    const WEARS: bool = false;

    /// Reads it from its table; `None` after a diagnostic.
    fn read(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self>;

    /// The two points that it connects; the first body is the one that holds: bearing, guide, slot.
    fn points(&self) -> [PointId; 2];

    /// Angles, in the frames of both bodies, of a direction that both bodies share, rad: of its line where it has one, else of the second body's x
    /// axis. None is zero.
    fn angles_rad(&self) -> [Option<QuantityId>; 2] {
        [None; 2]
    }

    /// Radius of the circle about the first point on which the second one stays, m, where it has one.
    fn radius_m(&self) -> Option<QuantityId> {
        None
    }

    /// The parts between which it has play, where it states any.
    fn play_parts(&self) -> Option<PlayParts<'_>> {
        None
    }

    /// Why it cannot be driven; `None` if it can. `is_zero` tells whether a clearance is zero for good.
    fn why_not_driven(&self, is_zero: &dyn Fn(QuantityId) -> bool) -> Option<NotDriven>;

    /// What it connects, in words.
    fn words(&self, names: &dyn Names) -> String;

    /// What its play is, in words; `None` if it states none.
    fn play_words(&self, names: &dyn Names) -> Option<String> {
        let _ = names;
        None
    }
}

/// How a body hangs on another by a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TreeAttachment {
    /// The body turns about the point.
    Turning,
    /// The body slides along the line.
    Sliding,
    /// The body is fixed.
    Fixed,
    /// The joint is never in the tree: it is always cut, since it costs fewer constraints than it would have coordinates.
    Never,
}

/// Role of a joint for a flexible body at one of its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AtBeam {
    /// The joint holds the point, and the section turns freely unless the joint is driven.
    Point,
    /// The joint holds the section there: a couple acts.
    Section,
    /// The joint cannot hold one: its name in words.
    Refused(&'static str),
}

/// The line of a guide or a slot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Line {
    /// A point of the first body on it; positions count from here.
    pub point: PointId,
    /// Its direction from the first body's x axis, rad.
    pub angle_rad: QuantityId,
}

/// The play of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct JointPlay {
    /// The clearance, m, >= 0; zero makes the joint ideal.
    pub clearance_m: QuantityId,
    /// The contact.
    pub contact: ContactId,
    /// The radius that it is part of, m: the clearance is smaller, and in practice far smaller. `None` if it is part of none.
    pub radius_m: Option<QuantityId>,
}

/// The parts between which a joint has play.
#[derive(Debug, Clone, Copy)]
pub enum PlayParts<'k> {
    /// A pin in a round hole.
    Pin(&'k Clearance),
    /// A block in a straight guide.
    Block {
        /// Sizes of block and guide.
        clearance: &'k GuideClearance,
        /// Direction of the guide from the first body's x axis, rad.
        guide_angle_rad: QuantityId,
        /// The same from the second body's x axis, rad.
        slider_angle_rad: QuantityId,
    },
    /// A pin in a straight slot.
    Slot {
        /// Sizes of pin and slot.
        clearance: &'k SlotClearance,
        /// Direction of the slot from the first body's x axis, rad.
        slot_angle_rad: QuantityId,
    },
    /// A pin in a slot along a circle.
    CircularSlot {
        /// Sizes of pin and slot.
        clearance: &'k CircularSlotClearance,
        /// Radius of the middle of the slot, m.
        radius_m: QuantityId,
    },
}

impl PlayParts<'_> {
    /// Clearance, contact, and the radius that the clearance is part of.
    pub fn play(self) -> JointPlay {
        match self {
            Self::Pin(own) => JointPlay {
                clearance_m: own.radial_clearance_m,
                contact: own.contact,
                radius_m: own.has_radius.then_some(own.bearing_radius_m),
            },
            Self::Block { clearance: own, .. } => {
                JointPlay { clearance_m: own.clearance_m, contact: own.contact, radius_m: None }
            }
            Self::Slot { clearance: own, .. } => {
                JointPlay { clearance_m: own.clearance_m, contact: own.contact, radius_m: Some(own.end_radius_m) }
            }
            Self::CircularSlot { clearance: own, .. } => {
                JointPlay { clearance_m: own.clearance_m, contact: own.contact, radius_m: Some(own.half_width_m) }
            }
        }
    }

    /// Whether the faces of a guide end.
    pub fn has_face_ends(self) -> bool {
        matches!(self, Self::Block { clearance, .. } if clearance.ends_m.is_some())
    }

    /// Whether a pin has a place along a slot with ends.
    pub fn is_in_slot(self) -> bool {
        matches!(self, Self::Slot { .. })
    }

    /// Whether the force differs from that of the contact's law from place to place.
    pub fn has_shares(self) -> bool {
        self.has_face_ends() || self.is_in_slot() || matches!(self, Self::CircularSlot { .. })
    }
}

/// Why a joint cannot be driven.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotDriven {
    /// "has play".
    pub why: &'static str,
    /// Alternative for the user.
    pub hint: &'static str,
}

impl NotDriven {
    /// Reason for a kind that no drive moves.
    pub const fn because(why: &'static str) -> Self {
        Self { why, hint: "drive a revolute or prismatic joint" }
    }
}
