//! Reading contacts.

use super::reader::ModelReader;
use crate::model::contact::{Contact, ContactTable};
use crate::model::ids::ContactId;
use loosepin_text::document::Entry;

impl ModelReader {
    /// Reads the table of contacts.
    pub fn read_contacts(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a contact") {
            self.numbers.remember(&entry);
            let own = ContactTable::read(self, &entry);
            let contact = own.and_then(|own| Contact::read(entry.name, &own, self));
            let id = contact.map(|contact| {
                self.contacts.push(contact);
                ContactId(self.contacts.len() - 1)
            });
            self.contact_names.push((entry.name.to_owned(), id));
        }
    }
}
