//! Reader of a kind of output: the part of the model's reader that outputs know.

use crate::model::ids::{Actuator, BodyId, JointId};
use crate::model::part_reader::PartReader;
use loosepin_text::document::{DocumentProblem, Entry, Table};

/// The reader of a model, as far as outputs know it. What returns nothing has reported.
pub trait OutputReader: PartReader {
    /// A drive or control, written `drive.NAME` or `control.NAME`.
    fn actuator(&mut self, entry: &Entry<'_>) -> Option<Actuator>;

    /// What acts there, and where.
    fn actuator_facts(&self, actuator: Actuator) -> ActuatorFacts;

    /// Whether a joint wears.
    fn wears(&self, joint: JointId) -> bool;

    /// What a flexible body is like; `None` for a rigid one.
    fn beam_facts(&self, body: BodyId) -> Option<BeamFacts>;
}

/// A drive or control, and the joint in which it acts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ActuatorFacts {
    /// `drive` or `control`.
    pub what: &'static str,
    /// Its name.
    pub name: String,
    /// Its joint.
    pub joint: JointId,
    /// Whether the coordinate of its joint is an angle.
    pub turns: bool,
}

/// Requirements of an output on a flexible body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BeamFacts {
    /// Whether the height of its section is known.
    pub has_height: bool,
    /// Whether it is in absolute nodal coordinates, with its sections held at both ends.
    pub is_nodal_between_sections: bool,
}

/// A key that a measure needs beside it.
pub(super) struct NeededKey {
    /// The key.
    pub key: &'static str,
    /// How it may be written.
    pub example: &'static str,
    /// Description.
    pub doc: &'static str,
}

/// The choice behind a key that a measure needs.
pub(super) fn needed_choice<T: Copy>(
    reader: &mut dyn OutputReader,
    table: &Table<'_>,
    needed: &NeededKey,
    choices: &[(&'static str, T)],
) -> Option<T> {
    let entry = needed_entry(reader, table, needed)?;
    reader.document().choice(&entry, choices)
}

/// The entry of a key that a measure needs.
pub(super) fn needed_entry<'t>(
    reader: &mut dyn OutputReader,
    table: &Table<'t>,
    needed: &NeededKey,
) -> Option<Entry<'t>> {
    let NeededKey { key, example, doc } = *needed;
    let entry = table.get(key);
    if entry.is_none() {
        let problem = DocumentProblem::MissingKey { table: table.path.describe(), key, example, doc };
        reader.document().report(&problem, table.span);
    }
    entry
}
