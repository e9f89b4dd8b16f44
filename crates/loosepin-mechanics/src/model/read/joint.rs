//! Joints.

use super::reader::ModelReader;
use crate::model::ids::{BodyId, ContactId, JointId};
use crate::model::joint::{ContactFacts, JOINT_KINDS, JointKind, JointReader, PlayKeys};
use crate::model::parts::friction::Friction;
use crate::model::parts::topology::{Joint, JointFriction};
use crate::model::parts::wear::JointWear;
use loosepin_text::diagnostics::Span;
use loosepin_text::document::{Entry, Table};
use loosepin_text::numbers::{DIAMETRAL, EntryProblem, QuantityId, RADIAL};

impl ModelReader {
    /// Reads the table of joints.
    pub fn read_joints(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a joint") {
            self.numbers.remember(&entry);
            let kind = self.joint_kind(&entry);
            let id = kind.map(|(kind, friction, wear)| {
                self.joints.push(Joint { name: entry.name.to_owned(), kind, friction, wear });
                JointId(self.joints.len() - 1)
            });
            self.joint_names.push((entry.name.to_owned(), id));
        }
    }

    fn joint_kind(&mut self, entry: &Entry<'_>) -> Option<(JointKind, Option<JointFriction>, Option<JointWear>)> {
        let (word, table) = self.numbers.table_of_kind(entry, JOINT_KINDS)?;
        let (size_key, wears) = JointKind::friction_and_wear(word);
        let friction = size_key.map_or(Some(None), |key| self.joint_friction(&table, key));
        let kind = JointKind::read(word, &table, self);
        let clearance = kind.as_ref().and_then(JointKind::pin_clearance);
        let wear = if wears { self.joint_wear(&table, clearance) } else { Some(None) };
        let ((kind, friction), wear) = kind.zip(friction).zip(wear)?;
        if kind.play().is_some() && friction.is_some() {
            let beside = [RADIAL, DIAMETRAL].into_iter().find(|key| table.has(key)).unwrap_or("clearance");
            let problem = EntryProblem::KeyWithoutEffect { entry: entry.path.describe(), key: "friction", beside };
            return self.numbers.reader.refuse(&problem, entry.key_span);
        }
        let [first, second] = kind.bodies();
        if first != second {
            return Some((kind, friction, wear));
        }
        let body = self.bodies[first.0].name.clone();
        self.numbers.reader.refuse(&EntryProblem::SameBody { entry: entry.path.describe(), body }, entry.key_span)
    }

    /// Friction of an ideal joint with its size under `key`; the outer option is absent after a diagnostic.
    fn joint_friction(&mut self, table: &Table<'_>, key: &'static str) -> Option<Option<JointFriction>> {
        let size_m = self.numbers.quantity(table, key);
        let friction = table.get("friction").map(|entry| Friction::of_joint(&entry, self));
        for (key, needs) in [("friction", key), (key, "friction")] {
            if table.has(key) && !table.has(needs) {
                self.numbers.report_missing(table, key, vec![needs]);
                return None;
            }
        }
        match friction {
            None => Some(None),
            Some(friction) => Some(Some(JointFriction { friction: friction?, size_m: size_m? })),
        }
    }
}

impl JointReader for ModelReader {
    fn contact(&mut self, entry: &Entry<'_>) -> Option<ContactId> {
        let name = self.numbers.reader.text(entry)?.to_owned();
        self.used_contacts.push(name.clone());
        self.numbers.named(entry, "contact", &name, &self.contact_names)
    }

    fn leans(&self) -> bool {
        self.leans
    }

    fn no_contact(&mut self) -> ContactId {
        Self::no_contact(self)
    }

    fn contact_facts(&self, contact: ContactId) -> ContactFacts {
        let contact = &self.contacts[contact.0];
        ContactFacts {
            is_line: contact.law.line().is_some(),
            has_film: contact.film.is_some(),
            is_of_materials: contact.law.materials().is_some(),
        }
    }

    fn demand_flat_contact(&mut self, table: &Table<'_>, contact: ContactId, what_touches: &'static str) -> Option<()> {
        Self::demand_flat_contact(self, table, contact, what_touches)
    }

    fn play_clearance(&mut self, table: &Table<'_>, keys: &PlayKeys) -> Option<Option<QuantityId>> {
        Self::play_clearance(self, table, keys)
    }

    fn warm_clearance(
        &mut self,
        clearance: QuantityId,
        outer: &[QuantityId],
        bodies: [BodyId; 2],
        span: Span,
    ) -> Option<QuantityId> {
        Self::warm_clearance(self, clearance, outer, bodies, span)
    }

    fn expanded_with(&mut self, length: QuantityId, body: BodyId) -> QuantityId {
        let elongation = self.elongations.get(&body).copied();
        self.thermally_expanded(length, elongation)
    }
}
