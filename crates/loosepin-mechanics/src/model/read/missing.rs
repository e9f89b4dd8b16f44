//! What runs need and a file leaves out: noted, and asked for where somebody runs the model. The motion without dynamics needs none of it.

use super::reader::ModelReader;
use crate::contact::{NormalDescription, point_law};
use crate::model::ids::ContactId;
use crate::model::quantity::{Origin, Quantity, QuantityId};
use crate::model::topology::{Contact, Stiffness};
use loosepin_text::diagnostics::Complaint;
use loosepin_text::document::{DocumentProblem, Table};
use loosepin_text::units::{Dimension, Rule};

/// Path of the contact of joints that name none: no name of a file has brackets.
const NO_CONTACT: &str = "(no contact)";

impl ModelReader {
    /// Notes that a key of a table is missing.
    pub(super) fn miss_for_runs(&mut self, table: &Table<'_>, key: &'static str) {
        // A key that is not known may have been meant for it, and was complained about.
        if table.has_unknown() {
            return;
        }
        let Some(key) = table.key(key) else { return };
        let problem = DocumentProblem::MissingKey {
            table: table.path.describe(),
            key: key.name,
            example: key.example,
            doc: key.doc,
        };
        let place = self.reader.place(table.span);
        self.missing_for_runs.push(Complaint::error(&problem, Some(place)));
    }

    /// The contact of joints that name none. Its numbers stand for nothing: a model with it is not run.
    pub(super) fn no_contact(&mut self) -> Option<ContactId> {
        if let Some(index) = self.contacts.iter().position(|contact| contact.is_missing) {
            return Some(ContactId(index));
        }
        let law = point_law(super::contact::DEFAULT_LAW)?;
        let mut number = |key: &str, dimension: Dimension| -> QuantityId {
            let path = format!("contact.{NO_CONTACT}.{key}");
            let quantity = Quantity { path, dimension, rule: Rule::Finite, origin: Origin::Fixed, span: None };
            self.quantities.add_number(quantity, 1.0)
        };
        let exponent = number("exponent", Dimension::NUMBER);
        let stiffness_n_m_n = number("stiffness", Dimension::contact_stiffness(1.0));
        let restitution = number("restitution", Dimension::NUMBER);
        let minimum_impact_speed_m_s = number("minimum_impact_speed", Dimension::VELOCITY);
        self.contacts.push(Contact {
            name: NO_CONTACT.to_owned(),
            law: NormalDescription::Point(law),
            damping: Some(law),
            line_damping: None,
            restitution: Some(restitution),
            stiffness: Stiffness::Given { stiffness_n_m_n, exponent },
            damping_coefficient_n_s_m: None,
            minimum_impact_speed_m_s,
            density_kg_m3: None,
            friction: None,
            film: None,
            is_missing: true,
            is_law_named: true,
        });
        Some(ContactId(self.contacts.len() - 1))
    }
}
