//! Reading drives and the motions that they prescribe.

use super::reader::ModelReader;
use crate::model::drive::{Drive, DriveLaw, DriveReader, MOTION_KINDS, Steady};
use crate::model::function::{Changing, TIME};
use crate::model::ids::{DriveId, JointId};
use crate::model::joint::NotDriven;
use crate::model::keys::drive::DRIVE_KEYS;
use crate::model::problem::ModelProblem;
use crate::model::quantity::QuantityId;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::{Dimension, Rule};

/// A driven or controlled joint, as what moves it sees it.
pub(super) struct Driven {
    joint: JointId,
    /// Of the coordinate.
    dimension: Dimension,
    kind: &'static str,
    start_key: &'static str,
    other_key: &'static str,
}

impl Driven {
    /// A revolute joint by an angle, a prismatic one by a length.
    pub fn new(joint: JointId, dimension: Dimension) -> Self {
        if dimension == Dimension::LENGTH {
            let (start_key, other_key) = ("start_position", "start_angle");
            return Self { joint, dimension, kind: "prismatic", start_key, other_key };
        }
        Self { joint, dimension, kind: "revolute", start_key: "start_angle", other_key: "start_position" }
    }
}

impl ModelReader {
    /// Reads the table of drives.
    pub fn read_drives(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.named(entry, "a drive") {
            self.remember(&entry);
            let drive = self.reader.table(&entry, &DRIVE_KEYS).and_then(|table| self.drive(&entry, &table));
            let id = drive.map(|drive| {
                self.drives.push(drive);
                DriveId(self.drives.len() - 1)
            });
            self.drive_names.push((entry.name.to_owned(), id));
        }
    }

    fn drive(&mut self, entry: &Entry<'_>, table: &Table<'_>) -> Option<Drive> {
        let driven = self.driven_joint(entry, table)?;
        let law = match table.get("motion") {
            Some(motion) => self.motion(&motion, &driven),
            None => self.constant_speed(entry, table, &driven),
        };
        Some(Drive { name: entry.name.to_owned(), joint: driven.joint, law: law? })
    }

    fn driven_joint(&mut self, entry: &Entry<'_>, table: &Table<'_>) -> Option<Driven> {
        let joint_entry = table.get("joint")?;
        let joint = self.joint(&joint_entry)?;
        let joint_name = self.joints[joint.0].name.clone();
        let words = entry.path.describe();
        if let Some(other) = self.drives.iter().find(|drive| drive.joint == joint) {
            let other = other.name.clone();
            let problem = ModelProblem::DrivenTwice { entry: words, joint: joint_name, other };
            return self.reader.refuse(&problem, joint_entry.span);
        }
        let kind = &self.joints[joint.0].kind;
        let refused = kind.why_not_driven(&|clearance_m| self.is_nominally_zero(clearance_m));
        let NotDriven { why, hint } = match (refused, kind.coordinate()) {
            (None, Some(coordinate)) => return Some(Driven::new(joint, coordinate)),
            (refused, _) => refused.unwrap_or(NotDriven::never("has no coordinate")),
        };
        let problem = ModelProblem::NotDrivable { entry: words, joint: joint_name, why, hint };
        self.reader.refuse(&problem, joint_entry.span)
    }

    /// Whether a clearance is zero, by a value of its own.
    fn is_nominally_zero(&self, clearance_m: QuantityId) -> bool {
        self.quantities[clearance_m].is_settable() && self.quantities.nominal_value(clearance_m) == 0.0
    }

    pub(super) fn constant_speed(&mut self, entry: &Entry<'_>, table: &Table<'_>, driven: &Driven) -> Option<DriveLaw> {
        let rate = driven.dimension.over(Dimension::TIME);
        let speed = table.get("speed").and_then(|entry| self.quantity_of(&entry, rate, Rule::Finite));
        if let Some(found) = table.get(driven.other_key) {
            let problem = ModelProblem::WrongStart {
                entry: entry.path.describe(),
                found: driven.other_key,
                due: driven.start_key,
                kind: driven.kind,
                joint: self.joints[driven.joint.0].name.clone(),
            };
            self.reader.complain(&problem, found.key_span);
        }
        let start = self.quantity(table, driven.start_key);
        Some(DriveLaw::steady_motion(Steady { speed: speed?, start: start? }))
    }

    pub(super) fn motion(&mut self, entry: &Entry<'_>, driven: &Driven) -> Option<DriveLaw> {
        let (word, table) = self.table_of_kind(entry, MOTION_KINDS)?;
        DriveLaw::read(word, &table, driven.dimension, self)
    }
}

impl DriveReader for ModelReader {
    fn over_time(&mut self, entry: &Entry<'_>, dimension: Dimension) -> Option<Changing> {
        self.changing(entry, dimension, Rule::Finite, &[TIME])
    }
}
