//! The normal force law of long pins where the file names none.

use super::reader::ModelReader;
use crate::contact::{LONG_PIN_LAW, NormalDescription, point_law};
use crate::model::ids::ContactId;
use crate::model::topology::{JointKind, Stiffness};
use crate::model::wear::{WearGeometry, WearLife};

impl ModelReader {
    /// Gives contacts whose law the file leaves out the law of a long pin, where all that they are of are pins in bearings with a length
    /// and the stiffness comes from materials. `wear` is read by then: between worn surfaces a foundation acts, which has no line law.
    pub(super) fn take_laws_of_long_pins(&mut self, wear: Option<&WearLife>) {
        let is_worn = wear.is_some_and(|wear| !matches!(wear.geometry, WearGeometry::Fixed));
        for index in 0..self.contacts.len() {
            let contact = &self.contacts[index];
            let has_materials = matches!(contact.stiffness, Stiffness::Material { .. });
            if contact.is_law_named || !has_materials || !self.are_long_pins(ContactId(index), is_worn) {
                continue;
            }
            let contact = &mut self.contacts[index];
            contact.law = NormalDescription::Line(LONG_PIN_LAW);
            contact.damping = point_law(LONG_PIN_LAW.default_damping);
        }
    }

    /// Whether the contact is of pins in bearings with a length alone, and of at least one.
    fn are_long_pins(&self, id: ContactId, is_worn: bool) -> bool {
        let mut of_joints = self.joints.iter().filter(|joint| joint.kind.play().is_some_and(|(_, of)| of == id));
        let has_any = of_joints.clone().next().is_some();
        let is_long = of_joints.all(|joint| match &joint.kind {
            JointKind::Revolute { clearance: Some(clearance), .. } => {
                clearance.bearing_length_m.is_some() && !(is_worn && joint.wear.is_some())
            }
            _ => false,
        });
        let is_of_coupling = self.couplings.iter().any(|coupling| coupling.play.is_some_and(|play| play.contact == id));
        has_any && is_long && !is_of_coupling
    }
}
