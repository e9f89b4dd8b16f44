//! The kinds of joint: one file each, and the list of them here. Nothing outside this folder names a kind.
//!
//! A kind says of itself what the rest of the program asks ([`KindOfJoint`]), and reads its own table.

mod circular_slot;
mod clearance;
mod kind;
mod prismatic;
mod reading;
mod revolute;
mod rigid;
mod row;
mod slot;

pub use circular_slot::CircularSlot;
pub use clearance::{CircularSlotClearance, Clearance, GuideClearance, SlotClearance};
pub use kind::{AtBeam, JointPlay, KindOfJoint, Line, NotDriven, PlayParts, TreeAttachment};
pub use prismatic::Prismatic;
pub(super) use reading::span_of;
pub use reading::{ContactFacts, JointReader, PlayKeys};
pub use revolute::Revolute;
pub use rigid::Rigid;
pub use row::{MarkerAxis, PlaneRow, Row, SpaceRow};
pub use slot::Slot;

use super::ids::{BodyId, PointId};
use crate::model::words::part_names::Names;
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::Dimension;

/// Makes the enum of all kinds, and hands every question on to the kind.
macro_rules! joint_kinds {
    ($($(#[$doc:meta])* $kind:ident),* $(,)?) => {
        /// A joint of any kind.
        #[derive(Debug, Clone)]
        pub enum JointKind {
            $($(#[$doc])* $kind($kind),)*
        }

        /// Words of all kinds in files, with their keys.
        pub(super) static JOINT_KINDS: &[(&str, &Keys)] = &[$(($kind::WORD, $kind::KEYS)),*];

        $(impl From<$kind> for JointKind {
            fn from(kind: $kind) -> Self {
                Self::$kind(kind)
            }
        })*

        impl JointKind {
            /// Reads a joint of the kind `word` from its table; `None` after a diagnostic, or if there is no such kind.
            pub(super) fn read(word: &str, table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self> {
                match word {
                    $(<$kind as KindOfJoint>::WORD => $kind::read(table, reader).map(Self::from),)*
                    _ => None,
                }
            }

            /// Friction and wear of the kind `word`: [`KindOfJoint::FRICTION_SIZE`], [`KindOfJoint::WEARS`].
            pub(super) fn friction_and_wear(word: &str) -> (Option<&'static str>, bool) {
                match word {
                    $(<$kind as KindOfJoint>::WORD => ($kind::FRICTION_SIZE, $kind::WEARS),)*
                    _ => (None, false),
                }
            }
        }

        /// `ask!(self, kind => expression)` for the current kind; `constant!(self, NAME)` for a constant of its kind.
        macro_rules! ask {
            ($own:expr, $name:ident => $answer:expr) => {
                match $own { $(JointKind::$kind($name) => $answer,)* }
            };
        }
        macro_rules! constant {
            ($own:expr, $name:ident) => {
                match $own { $(JointKind::$kind(_) => <$kind as KindOfJoint>::$name,)* }
            };
        }
    };
}

joint_kinds! {
    /// A pin turns in a hole.
    Revolute,
    /// A slider moves along a line.
    Prismatic,
    /// A pin slides and turns in a slot.
    Slot,
    /// A pin runs and turns in a slot along a circle.
    CircularSlot,
    /// Two bodies are one.
    Rigid,
}

impl JointKind {
    /// See [`KindOfJoint::WORD`].
    pub fn word(&self) -> &'static str {
        constant!(self, WORD)
    }

    /// See [`KindOfJoint::COORDINATE`].
    pub fn coordinate(&self) -> Option<Dimension> {
        constant!(self, COORDINATE)
    }

    /// Whether its coordinate is an angle.
    pub fn turns(&self) -> bool {
        self.coordinate() == Some(Dimension::ANGLE)
    }

    /// Whether its coordinate is a position along a line.
    pub fn slides(&self) -> bool {
        self.coordinate() == Some(Dimension::LENGTH)
    }

    /// See [`KindOfJoint::TREE_ATTACHMENT`].
    pub fn tree_attachment(&self) -> TreeAttachment {
        constant!(self, TREE_ATTACHMENT)
    }

    /// See [`KindOfJoint::ROWS`].
    pub fn rows(&self) -> &'static [PlaneRow] {
        constant!(self, ROWS)
    }

    /// Whether its bodies do not turn against each other.
    pub fn holds_angle(&self) -> bool {
        self.rows().contains(&PlaneRow::Angle)
    }

    /// See [`KindOfJoint::AT_BEAM`].
    pub fn at_beam(&self) -> AtBeam {
        constant!(self, AT_BEAM)
    }

    /// See [`KindOfJoint::CONTACT_PLACES`].
    pub fn contact_places(&self) -> &'static [&'static str] {
        constant!(self, CONTACT_PLACES)
    }

    /// See [`KindOfJoint::CLEARANCE_KEY`].
    pub fn clearance_key(&self) -> &'static str {
        constant!(self, CLEARANCE_KEY)
    }

    /// See [`KindOfJoint::points`].
    pub fn points(&self) -> [PointId; 2] {
        ask!(self, kind => kind.points())
    }

    /// The bodies of its points.
    pub fn bodies(&self) -> [BodyId; 2] {
        self.points().map(|point| point.body)
    }

    /// See [`KindOfJoint::angles_rad`].
    pub fn angles_rad(&self) -> [Option<QuantityId>; 2] {
        ask!(self, kind => kind.angles_rad())
    }

    /// See [`KindOfJoint::radius_m`].
    pub fn radius_m(&self) -> Option<QuantityId> {
        ask!(self, kind => kind.radius_m())
    }

    /// Angle of the second body from the first one, rad, if they do not turn against each other.
    pub fn held_turn_rad(&self, number: &dyn Fn(QuantityId) -> f64) -> Option<f64> {
        let angle_rad = |side: usize| self.angles_rad()[side].map_or(0.0, number);
        self.holds_angle().then(|| angle_rad(0) - angle_rad(1))
    }

    /// Bearing and journal of a revolute joint.
    pub fn revolute_points(&self) -> Option<[PointId; 2]> {
        if let Self::Revolute(pin) = self { Some([pin.bearing, pin.journal]) } else { None }
    }

    /// Guide and slider of a prismatic joint.
    pub fn prismatic(&self) -> Option<&Prismatic> {
        if let Self::Prismatic(line) = self { Some(line) } else { None }
    }

    /// The line fixed to the first body along which the second point moves.
    pub fn line(&self) -> Option<Line> {
        let angle_rad = self.angles_rad()[0].filter(|_| self.rows().contains(&PlaneRow::OnLine))?;
        Some(Line { point: self.points()[0], angle_rad })
    }

    /// Its play, where it may have any.
    pub fn play(&self) -> Option<JointPlay> {
        self.play_parts().map(PlayParts::play)
    }

    /// See [`KindOfJoint::play_parts`].
    pub fn play_parts(&self) -> Option<PlayParts<'_>> {
        ask!(self, kind => kind.play_parts())
    }

    /// The play of a pin in a round hole.
    pub fn pin_clearance(&self) -> Option<&Clearance> {
        match self.play_parts() {
            Some(PlayParts::Pin(clearance)) => Some(clearance),
            _ => None,
        }
    }

    /// See [`KindOfJoint::why_not_driven`].
    pub fn why_not_driven(&self, is_zero: &dyn Fn(QuantityId) -> bool) -> Option<NotDriven> {
        ask!(self, kind => kind.why_not_driven(is_zero))
    }

    /// See [`KindOfJoint::words`].
    pub fn words(&self, names: &dyn Names) -> String {
        ask!(self, kind => kind.words(names))
    }

    /// See [`KindOfJoint::play_words`].
    pub fn play_words(&self, names: &dyn Names) -> Option<String> {
        ask!(self, kind => kind.play_words(names))
    }
}
