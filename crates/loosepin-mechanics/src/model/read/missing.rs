//! Entries that runs need and a file lacks: collected, and reported where the model is run. The motion without dynamics needs none of it.

use super::reader::ModelReader;
use crate::model::contact::Contact;
use crate::model::ids::ContactId;
use loosepin_text::diagnostics::Diagnostic;
use loosepin_text::document::{DocumentProblem, Table};
use loosepin_text::numbers::{Origin, Quantity};
use loosepin_text::units::{Dimension, Rule};

/// Path of the contact of joints that name none: no name of a file has brackets.
const NO_CONTACT: &str = "(no contact)";

impl ModelReader {
    /// Notes that a key of a table is missing.
    pub(super) fn miss_for_runs(&mut self, table: &Table<'_>, key: &'static str) {
        // A key that is not known may have been meant for it, and was reported.
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
        let place = self.numbers.reader.place(table.span);
        self.missing_for_runs.push(Diagnostic::error(&problem, Some(place)));
    }

    /// The contact of joints that name none. Its numbers stand for nothing: a model with it is not run.
    pub(super) fn no_contact(&mut self) -> ContactId {
        if let Some(index) = self.contacts.iter().position(|contact| contact.is_missing) {
            return ContactId(index);
        }
        let number = |key: &str, dimension: Dimension| {
            let path = format!("contact.{NO_CONTACT}.{key}");
            let quantity = Quantity { path, dimension, rule: Rule::Finite, origin: Origin::Fixed, span: None };
            self.numbers.quantities.add_number(quantity, 1.0)
        };
        self.contacts.push(Contact::missing(NO_CONTACT, number));
        ContactId(self.contacts.len() - 1)
    }
}
