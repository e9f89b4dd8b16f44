//! Reading couplings and cams.

use super::reader::ModelReader;
use crate::model::coupling::{CAM, COUPLING_KINDS, Coupling, CouplingReader};
use crate::model::ids::{ContactId, JointId};
use crate::model::joint::{JointKind, span_of};
use crate::model::problem::ModelProblem;
use loosepin_text::document::{Entry, Table};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::Dimension;

impl ModelReader {
    /// Reads the table of couplings.
    pub fn read_couplings(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a coupling") {
            self.numbers.remember(&entry);
            let found = self.numbers.table_of_kind(&entry, COUPLING_KINDS);
            let coupling = found.and_then(|(word, table)| Coupling::read(word, &entry, &table, self));
            self.couplings.extend(coupling);
        }
    }

    /// Reads the table of cams.
    pub fn read_cams(&mut self, entry: &Entry<'_>) {
        let (word, keys) = CAM;
        for entry in self.numbers.reader.named(entry, "a cam") {
            self.numbers.remember(&entry);
            let table = self.numbers.reader.table(&entry, keys);
            let cam = table.and_then(|table| Coupling::read(word, &entry, &table, self));
            self.couplings.extend(cam);
        }
    }

    /// Dimension of the coordinate of a joint.
    pub(super) fn coordinate_of(&self, joint: JointId) -> Dimension {
        CouplingReader::coordinate_of(self, joint)
    }

    /// A joint with a coordinate, of the dimension that is due, where one is.
    fn coupled_joint(&mut self, entry: &Entry<'_>, due: Option<Dimension>) -> Option<JointId> {
        let joint = self.moving_joint(entry)?;
        let found = self.coordinate_of(joint);
        if let Some(due) = due.filter(|due| *due != found) {
            let name = self.joints[joint.0].name.clone();
            let due = if due == Dimension::LENGTH { "prismatic" } else { "revolute" };
            self.numbers
                .reader
                .report(&ModelProblem::WrongJoint { entry: entry.path.describe(), joint: name, due }, entry.span);
            return None;
        }
        Some(joint)
    }
}

impl CouplingReader for ModelReader {
    fn two_joints(
        &mut self,
        table: &Table<'_>,
        entries: [&Option<Entry<'_>>; 2],
        dues: [Option<Dimension>; 2],
    ) -> Option<[JointId; 2]> {
        let [first, second] = [0, 1].map(|side| self.coupled_joint(entries[side].as_ref()?, dues[side]));
        let (first, second) = (first?, second?);
        if first == second {
            let name = self.joints[first.0].name.clone();
            let problem = ModelProblem::SameJoint { entry: table.path.describe(), joint: name };
            return self.numbers.reader.refuse(&problem, span_of(entries[1], table));
        }
        Some([first, second])
    }

    /// Reports a contact of flanks that needs their radii or their sliding, which are not defined.
    fn demand_contact_of_flanks(&mut self, table: &Table<'_>, id: ContactId, what_touches: &'static str) -> Option<()> {
        let contact = &self.contacts[id.0];
        let what = match contact.law.line() {
            Some(law) => format!("the line-contact law '{}'", law.name),
            _ if contact.law.materials().is_some() => "a stiffness from the materials".to_owned(),
            _ if contact.film.is_some() => "a film of oil".to_owned(),
            _ if contact.friction.is_some() => "friction".to_owned(),
            _ => return Some(()),
        };
        let problem = ModelProblem::NotForFlanks {
            entry: table.path.describe(),
            contact: contact.name.clone(),
            what,
            what_touches,
        };
        self.numbers.reader.refuse(&problem, table.get("contact").map_or(table.span, |entry| entry.span))
    }

    fn nominal_value(&self, id: QuantityId) -> f64 {
        self.numbers.quantities.nominal_value(id)
    }

    fn joint_kind(&self, joint: JointId) -> &JointKind {
        &self.joints[joint.0].kind
    }

    fn has_friction(&self, joint: JointId) -> bool {
        self.joints[joint.0].friction.is_some()
    }
}
