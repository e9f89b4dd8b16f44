//! Another normal force law in a contact of a model: a law is no number, so it is chosen before a mechanism is compiled.

use crate::model::contact::{LawError, NormalDescription};
use crate::model::ids::ContactId;
use crate::model::parts::topology::Model;
use crate::model::parts::wear::FoundationChoice;
use crate::model::values::path_error::PathError;
use loosepin_text::diagnostics::nearest_name;
use loosepin_text::units::quoted;

impl Model {
    /// The contact whose law has this path, `contact.NAME.law`; `None` if the path is none of a law.
    ///
    /// # Errors
    /// The model has no such contact.
    pub fn contact_of_law(&self, path: &str) -> Option<Result<ContactId, PathError>> {
        let name = path.strip_prefix("contact.")?.strip_suffix(".law").filter(|name| !name.contains('.'))?;
        let index = self.contacts.iter().position(|contact| contact.name == name);
        Some(index.map(ContactId).ok_or_else(|| {
            let known = || self.contacts.iter().map(|contact| contact.name.as_str());
            let hint = match nearest_name(name, known()) {
                Some(nearest) => format!("did you mean 'contact.{nearest}.law'?"),
                None => format!("available: {}", quoted(&known().collect::<Vec<_>>())),
            };
            PathError::Unknown { path: path.to_owned(), why: Some(format!("it has no contact '{name}'")), hint }
        }))
    }

    /// A copy with another normal force law in one contact; the numbers, their table and their order stay.
    ///
    /// # Errors
    /// The law needs what the model does not give.
    pub fn with_law(&self, contact: ContactId, law: NormalDescription) -> Result<Model, LawError> {
        let given = &self.contacts[contact.0];
        let table = format!("contact '{}'", given.name);
        let changed = given.law.with(law, given.line_loss, &table)?;
        let needs = |key: &'static str, table: String| Err(LawError::NeedsKey { law: law.name(), key, table });
        for joint in self.joints.iter().filter(|_| changed.line().is_some()) {
            let Some(clearance) = joint.kind.pin_clearance().filter(|clearance| clearance.contact == contact) else {
                continue;
            };
            if clearance.bearing_length_m.is_none() {
                return needs("bearing_length", format!("joint '{}'", joint.name));
            }
            // A line law has no stiffness for the foundation between worn surfaces.
            if self.has_worn_geometry()
                && joint.wear.as_ref().is_some_and(|wear| wear.foundation == FoundationChoice::Law)
            {
                return needs("foundation_stiffness", format!("joint '{}' wear", joint.name));
            }
        }
        let mut model = self.clone();
        let contact = &mut model.contacts[contact.0];
        (contact.law, contact.is_law_named) = (changed, true);
        Ok(model)
    }
}

#[cfg(test)]
mod tests {
    use crate::model::{ContactId, Model, NormalDescription};

    /// The slider-crank template.
    const SLIDER_CRANK: &str = include_str!("../../../../loosepin-import/templates/slider-crank/model.toml");

    fn law(name: &str) -> NormalDescription {
        NormalDescription::all().find(|law| law.name() == name).unwrap()
    }

    /// The slider-crank template with these lines in its contact, in place of materials and law.
    fn model(lines: &str) -> Model {
        let (before, rest) = SLIDER_CRANK.split_once("[contact.steel_pin]").unwrap();
        let (_, after) = rest.split_once("\n[").unwrap();
        let text = format!("{before}[contact.steel_pin]\n{lines}\n[{after}");
        Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}\n{text}"))
    }

    const STEEL: &str = "restitution = 0.9\nyoungs_modulus = \"207 GPa\"\npoisson_ratio = 0.3";

    #[test]
    fn identity_a_law_that_is_set_is_the_law_that_is_written() {
        let set = model(STEEL).with_law(ContactId(0), law("flores")).unwrap();
        let written = model(&format!("{STEEL}\nlaw = \"flores\""));
        let words = |model: &Model| format!("{:?}", model.contacts);
        assert_eq!(words(&set), words(&written));
        assert_eq!(set.quantities.nominal(), model(STEEL).quantities.nominal());
    }

    #[test]
    fn what_a_law_lacks_is_named() {
        let refused = |lines: &str, name: &str| model(lines).with_law(ContactId(0), law(name)).unwrap_err().to_string();
        assert_eq!(
            refused(STEEL, "johnson"),
            "johnson needs bearing_length of joint 'gudgeon', which the model does not give"
        );
        let given = "restitution = 0.9\nstiffness = \"6.6e10 N/m^1.5\"\nexponent = 1.5";
        assert_eq!(
            refused(given, "johnson"),
            "johnson needs youngs_modulus of contact 'steel_pin', which the model does not give"
        );
        assert_eq!(
            refused(STEEL, "kelvin-voigt"),
            "kelvin-voigt needs another kind of stiffness than lankarani-nikravesh, the law of contact 'steel_pin' in the model"
        );
        let linear = "law = \"kelvin-voigt\"\nstiffness = \"1e7 N/m\"\ndamping_coefficient = \"900 N s/m\"";
        assert_eq!(
            refused(linear, "anagnostopoulos"),
            "anagnostopoulos needs restitution of contact 'steel_pin', which the model does not give"
        );
    }

    #[test]
    fn no_line_law_comes_to_a_foundation_of_the_point_law() {
        let worn = |wear: &str, geometry: &str| {
            let text = SLIDER_CRANK.replace(
                "contact = \"steel_pin\"\n",
                &format!("contact = \"steel_pin\"\nbearing_length = \"20 mm\"\nwear = {{ bearing = {{ coefficient = \"2e-15 m^2/N\" }}{wear} }}\n"),
            ) + &format!("\n[wear]\ncycles = 1000\ngeometry = \"{geometry}\"\n");
            let model =
                Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}\n{text}"));
            model.with_law(ContactId(0), law("johnson")).map(|model| model.contacts[0].law.name())
        };
        assert_eq!(
            worn(", foundation = \"law\"", "worn").unwrap_err().to_string(),
            "johnson needs foundation_stiffness of joint 'gudgeon' wear, which the model does not give"
        );
        assert_eq!(worn("", "worn"), Ok("johnson"));
        assert_eq!(worn("", "fixed"), Ok("johnson"));
    }
}
