//! The normal force law of long pins where the file names none.

use super::reader::ModelReader;
use crate::model::ids::ContactId;
use crate::model::parts::wear::{WearGeometry, WearLife};

impl ModelReader {
    /// Gives contacts whose law the file leaves out the law of a long pin, where all that they are of are pins in bearings with a length
    /// and the stiffness comes from materials. `wear` is read by then: between worn surfaces a foundation acts, which has no line law.
    pub(super) fn take_laws_of_long_pins(&mut self, wear: Option<&WearLife>) {
        let is_worn = wear.is_some_and(|wear| !matches!(wear.geometry, WearGeometry::Fixed));
        for index in 0..self.contacts.len() {
            let contact = &self.contacts[index];
            if !contact.is_law_named
                && let Some(law) = contact.law.of_long_pins()
                && self.are_long_pins(ContactId(index), is_worn)
            {
                self.contacts[index].law = law;
            }
        }
    }

    /// Whether the contact is of pins in bearings with a length alone, and of at least one.
    fn are_long_pins(&self, id: ContactId, is_worn: bool) -> bool {
        let mut of_joints = self.joints.iter().filter(|joint| joint.kind.play().is_some_and(|play| play.contact == id));
        let has_any = of_joints.clone().next().is_some();
        let is_long = of_joints.all(|joint| {
            let has_length = joint.kind.pin_clearance().is_some_and(|clearance| clearance.bearing_length_m.is_some());
            has_length && !(is_worn && joint.wear.is_some())
        });
        let is_of_coupling = self.couplings.iter().any(|coupling| coupling.play.is_some_and(|play| play.contact == id));
        has_any && is_long && !is_of_coupling
    }
}

#[cfg(test)]
mod tests {
    use crate::model::Model;

    /// The slider-crank template.
    const SLIDER_CRANK: &str = include_str!("../../../../loosepin-import/templates/slider-crank/model.toml");
    const LENGTH: &str = "contact = \"steel_pin\"\nbearing_length = \"20 mm\"\n";

    /// Its law, whether the file names it, and the law of its energy loss.
    fn law(change: impl Fn(&str) -> String) -> (&'static str, bool, &'static str) {
        let text = change(SLIDER_CRANK);
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let contact = &model.contacts[0];
        (contact.law.name(), contact.is_law_named, contact.law.loss().map_or("", |law| law.name))
    }

    #[test]
    fn a_pin_with_a_length_has_a_line_contact_where_no_law_is_named() {
        let long = |text: &str| text.replace("contact = \"steel_pin\"\n", LENGTH);
        let unnamed = |text: &str| text.replace("law = \"lankarani-nikravesh\"\n", "");
        assert_eq!(law(|text| unnamed(&long(text))), ("johnson", false, "lankarani-nikravesh"));
        assert_eq!(law(unnamed), ("lankarani-nikravesh", false, "lankarani-nikravesh"));
        assert_eq!(law(long), ("lankarani-nikravesh", true, "lankarani-nikravesh"));
        // A stiffness that is given has no line contact, and neither has a contact that another joint without a length shares.
        let given = |text: &str| {
            let materials = "youngs_modulus = \"207 GPa\"\npoisson_ratio = 0.3\ndensity = \"7800 kg/m^3\"";
            let (before, after) = text.split_once(materials).unwrap();
            format!("{before}stiffness = \"6.6e10 N/m^1.5\"\nexponent = 1.5\n#{after}")
        };
        assert_eq!(law(|text| given(&unnamed(&long(text)))).0, "lankarani-nikravesh");
        let shared = |text: &str| {
            text.replace(
                "journal = \"rod.big_end\"\n",
                "journal = \"rod.big_end\"\nbearing_radius = \"11 mm\"\n\
                radial_clearance = \"0.1 mm\"\ncontact = \"steel_pin\"\n",
            )
        };
        assert_eq!(law(|text| shared(&unnamed(&long(text)))).0, "lankarani-nikravesh");
    }
}
