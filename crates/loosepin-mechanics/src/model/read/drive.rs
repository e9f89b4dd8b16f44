//! Reading drives and the motions that they prescribe.

use super::function::Changing;
use super::reader::ModelReader;
use crate::model::drive::{Drive, DriveLaw};
use crate::model::function::TIME;
use crate::model::ids::{DriveId, JointId};
use crate::model::joint::NotDriven;
use crate::model::keys::drive::{DRIVE_KEYS, MOTION_KINDS};
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
        Some(DriveLaw::Constant { speed: speed?, start: start? })
    }

    pub(super) fn motion(&mut self, entry: &Entry<'_>, driven: &Driven) -> Option<DriveLaw> {
        let (kind, table) = self.table_of_kind(entry, MOTION_KINDS)?;
        match kind {
            "polynomial" => self.polynomial(&table, driven.dimension),
            "harmonic" => self.harmonic(&table, driven.dimension),
            "cycloidal" => self.cycloidal(&table, driven.dimension),
            "table" => self.table_motion(&table, driven.dimension),
            _ => {
                let entry = table.get("position")?;
                match self.changing(&entry, driven.dimension, Rule::Finite, &[TIME])? {
                    Changing::Function(function) => Some(DriveLaw::Function(function)),
                    // It stands still.
                    Changing::Constant(id) => Some(DriveLaw::Polynomial { coefficients: vec![id] }),
                }
            }
        }
    }

    fn polynomial(&mut self, table: &Table<'_>, dimension: Dimension) -> Option<DriveLaw> {
        let list = table.get("coefficients")?;
        let elements = self.reader.list(&list)?;
        if elements.is_empty() {
            return self
                .reader
                .refuse(&ModelProblem::TooFewPoints { entry: list.path.describe(), least: 1 }, list.span);
        }
        let mut due = dimension;
        let mut coefficients = Vec::new();
        for element in &elements {
            coefficients.push(self.quantity_of(element, due, Rule::Finite));
            due = due.over(Dimension::TIME);
        }
        let coefficients: Option<Vec<QuantityId>> = coefficients.into_iter().collect();
        Some(DriveLaw::Polynomial { coefficients: coefficients? })
    }

    fn harmonic(&mut self, table: &Table<'_>, dimension: Dimension) -> Option<DriveLaw> {
        let [mean, amplitude] = ["mean", "amplitude"]
            .map(|key| table.get(key).and_then(|entry| self.quantity_of(&entry, dimension, Rule::Finite)));
        let frequency = self.quantity(table, "frequency");
        let phase_rad = self.quantity_or(table, "phase", 0.0);
        Some(DriveLaw::Harmonic { mean: mean?, amplitude: amplitude?, frequency: frequency?, phase_rad: phase_rad? })
    }

    fn cycloidal(&mut self, table: &Table<'_>, dimension: Dimension) -> Option<DriveLaw> {
        let [from, to] = ["from", "to"]
            .map(|key| table.get(key).and_then(|entry| self.quantity_of(&entry, dimension, Rule::Finite)));
        let duration_s = self.quantity(table, "duration");
        let dwell_s = self.quantity_or(table, "dwell", 0.0);
        Some(DriveLaw::Cycloidal { from: from?, to: to?, duration_s: duration_s?, dwell_s: dwell_s? })
    }

    fn table_motion(&mut self, table: &Table<'_>, dimension: Dimension) -> Option<DriveLaw> {
        let ends = table.get("ends");
        let is_periodic = ends.and_then(|entry| self.reader.choice(&entry, &[("clamped", false), ("periodic", true)]));
        let points = self.table_points(table, [("time", Dimension::TIME), ("position", dimension)])?;
        let is_periodic = is_periodic?;
        Some(DriveLaw::Table { points, is_periodic })
    }
}
