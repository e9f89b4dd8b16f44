//! Reader of a kind of joint: the part of the model's reader that joints know.

use crate::model::ids::{BodyId, ContactId};
use crate::model::part_reader::PartReader;
use loosepin_text::diagnostics::Span;
use loosepin_text::document::{Entry, Table, Value};
use loosepin_text::numbers::QuantityId;

/// Keys of a kind that go with its clearance.
pub struct PlayKeys {
    /// The key of the clearance.
    pub clearance: &'static str,
    /// Keys that a clearance above zero needs; the contact only where the model is run.
    pub needed: &'static [&'static str],
    /// Keys that it needs where a contact is named or parts are warm, and that the motion without dynamics does not use else.
    pub with_contact: &'static [&'static str],
    /// All keys that have a meaning beside a clearance only.
    pub beside: &'static [&'static str],
}

/// Requirements of a joint on its contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ContactFacts {
    /// Whether its law is of a line contact, which needs a length.
    pub is_line: bool,
    /// Whether it has a film of oil.
    pub has_film: bool,
    /// Whether its stiffness comes from the materials.
    pub is_of_materials: bool,
}

/// The reader of a model, as far as joints know it. What returns nothing has reported.
pub trait JointReader: PartReader {
    /// A contact.
    fn contact(&mut self, entry: &Entry<'_>) -> Option<ContactId>;

    /// Whether pins with play lean out of the plane.
    fn leans(&self) -> bool;

    /// The contact that stands for none, of what has play and names none.
    fn no_contact(&mut self) -> ContactId;

    /// What a joint asks of a contact.
    fn contact_facts(&self, contact: ContactId) -> ContactFacts;

    /// Reports where the contact is one that `what_touches`, on a plane, cannot have.
    fn demand_flat_contact(&mut self, table: &Table<'_>, contact: ContactId, what_touches: &'static str) -> Option<()>;

    /// The clearance of a joint that may have play; the outer option is absent after a diagnostic, the inner for an ideal joint.
    fn play_clearance(&mut self, table: &Table<'_>, keys: &PlayKeys) -> Option<Option<QuantityId>>;

    /// A clearance with both parts as warm as their bodies: the outer part has the sizes `outer` at the drawing's temperature.
    fn warm_clearance(
        &mut self,
        clearance: QuantityId,
        outer: &[QuantityId],
        bodies: [BodyId; 2],
        span: Span,
    ) -> Option<QuantityId>;

    /// A length of a body that is as warm as it is.
    fn expanded_with(&mut self, length: QuantityId, body: BodyId) -> QuantityId;
}

impl<'t, R: JointReader + ?Sized> Value<'t, R> for ContactId {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        reader.contact(entry)
    }
}

/// Span of the value of a key; of the table if the key is not written.
pub fn span_of(entry: &Option<Entry<'_>>, table: &Table<'_>) -> Span {
    entry.as_ref().map_or(table.span, |entry| entry.span)
}
