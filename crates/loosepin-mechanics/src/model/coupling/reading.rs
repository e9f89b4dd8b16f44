//! Reader of a kind of coupling, beyond that of a joint.

use crate::model::entry_reader::EntryReader;
use crate::model::ids::{ContactId, JointId};
use crate::model::joint::JointKind;
use loosepin_text::document::{Entry, Table};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::Dimension;

/// The reader of a model, as far as couplings know it. What returns nothing has reported.
pub trait CouplingReader: EntryReader {
    /// Two different joints with coordinates, each of the dimension that is due, where one is.
    fn two_joints(
        &mut self,
        table: &Table<'_>,
        entries: [&Option<Entry<'_>>; 2],
        dues: [Option<Dimension>; 2],
    ) -> Option<[JointId; 2]>;

    /// Reports where the contact is one that flanks of teeth, or a cam and its follower, cannot have.
    fn demand_contact_of_flanks(
        &mut self,
        table: &Table<'_>,
        contact: ContactId,
        what_touches: &'static str,
    ) -> Option<()>;

    /// Value of a quantity in the file, SI.
    fn nominal_value(&self, id: QuantityId) -> f64;

    /// Kind of a joint.
    fn joint_kind(&self, joint: JointId) -> &JointKind;

    /// Whether an ideal joint has friction.
    fn has_friction(&self, joint: JointId) -> bool;

    /// Dimension of the coordinate of a joint.
    fn coordinate_of(&self, joint: JointId) -> Dimension {
        self.joint_kind(joint).coordinate().unwrap_or(Dimension::ANGLE)
    }
}
