//! Reading drives and the motions that they prescribe.

use super::reader::ModelReader;
use crate::model::drive::{Drive, DriveLaw, DriveReader, MOTION_KINDS, Steady};
use crate::model::ids::{DriveId, JointId};
use crate::model::joint::NotDriven;
use crate::model::part_reader::PartReader;
use crate::model::problem::ModelProblem;
use crate::model::values::function::{Changing, TIME};
use loosepin_text::document::{Entry, Kind, Table, quantity};
use loosepin_text::numbers::EntryProblem;
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};

record! {
    /// a driven joint: at constant speed, or with a given motion
    pub(super) struct DriveTable for PartReader,
        exactly one of [speed, motion], exactly one of [start_angle, start_position, motion];
    /// an ideal revolute or a prismatic joint
    required joint: Entry<'t> = Kind::Reference("joint"), "\"main\"";
    /// constant speed of the journal's body relative to the bearing's, or of the slider along the guide
    optional speed: Entry<'t> = SPEED, "\"5000 rpm\"";
    /// angle from the bearing's body to the journal's at time zero, with speed
    optional start_angle: Entry<'t> = quantity(Dimension::ANGLE, Rule::Finite), "\"0 deg\"";
    /// position of the slider along the guide at time zero, with speed
    optional start_position: Entry<'t> = quantity(Dimension::LENGTH, Rule::Finite), "\"0 mm\"";
    /// angle or position over time, instead of a constant speed
    optional motion: Entry<'t> =
        MOTION, "{ kind = \"harmonic\", mean = \"90 deg\", amplitude = \"30 deg\", frequency = \"2 Hz\" }";
}

/// Kind of the value of `speed`.
pub(super) const SPEED: Kind =
    Kind::AnyOf(&[quantity(Dimension::ANGULAR_VELOCITY, Rule::Finite), quantity(Dimension::VELOCITY, Rule::Finite)]);

/// Kind of the value of `motion`.
pub(super) const MOTION: Kind = Kind::Tagged { tag: "kind", variants: MOTION_KINDS };

/// A driven or controlled joint, as what moves it sees it: revolute by an angle, or prismatic by a length.
pub(super) struct Driven {
    pub(super) joint: JointId,
    /// Dimension of the coordinate.
    pub(super) dimension: Dimension,
}

/// The motion of a joint as its table states it.
pub(super) struct Prescribed<'e, 't> {
    pub(super) table: &'e Table<'t>,
    pub(super) speed: &'e Option<Entry<'t>>,
    pub(super) start_angle: &'e Option<Entry<'t>>,
    pub(super) start_position: &'e Option<Entry<'t>>,
    pub(super) motion: &'e Option<Entry<'t>>,
}

impl ModelReader {
    /// Reads the table of drives.
    pub fn read_drives(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a drive") {
            self.numbers.remember(&entry);
            let drive = DriveTable::read(self, &entry).and_then(|own| self.drive(&entry, &own));
            let id = drive.map(|drive| {
                self.drives.push(drive);
                DriveId(self.drives.len() - 1)
            });
            self.drive_names.push((entry.name.to_owned(), id));
        }
    }

    fn drive(&mut self, entry: &Entry<'_>, own: &DriveTable<'_>) -> Option<Drive> {
        let driven = self.driven_joint(entry, &own.joint)?;
        let DriveTable { table, speed, start_angle, start_position, motion, .. } = own;
        let law = self.prescribed(&Prescribed { table, speed, start_angle, start_position, motion }, &driven)?;
        Some(Drive { name: entry.name.to_owned(), joint: driven.joint, law })
    }

    fn driven_joint(&mut self, entry: &Entry<'_>, joint_entry: &Entry<'_>) -> Option<Driven> {
        let joint = self.joint(joint_entry)?;
        let joint_name = self.joints[joint.0].name.clone();
        let words = entry.path.describe();
        if let Some(other) = self.drives.iter().find(|drive| drive.joint == joint) {
            let other = other.name.clone();
            let problem = EntryProblem::DrivenTwice { entry: words, joint: joint_name, other };
            return self.numbers.reader.refuse(&problem, joint_entry.span);
        }
        let kind = &self.joints[joint.0].kind;
        let refused = kind.why_not_driven(&|clearance_m| self.is_nominally_zero(clearance_m));
        let NotDriven { why, hint } = match (refused, kind.coordinate()) {
            (None, Some(dimension)) => return Some(Driven { joint, dimension }),
            (refused, _) => refused.unwrap_or(NotDriven::because("has no coordinate")),
        };
        let problem = ModelProblem::NotDrivable { entry: words, joint: joint_name, why, hint };
        self.numbers.reader.refuse(&problem, joint_entry.span)
    }

    /// Whether a clearance is zero, by a value of its own.
    fn is_nominally_zero(&self, clearance_m: QuantityId) -> bool {
        self.numbers.quantities[clearance_m].is_settable() && self.numbers.quantities.nominal_value(clearance_m) == 0.0
    }

    /// The motion of a joint: behind `motion`, or at constant speed from a start.
    pub(super) fn prescribed(&mut self, own: &Prescribed<'_, '_>, driven: &Driven) -> Option<DriveLaw> {
        if let Some(motion) = own.motion {
            let (word, table) = self.numbers.table_of_kind(motion, MOTION_KINDS)?;
            return DriveLaw::read(word, &table, driven.dimension, self);
        }
        let rate = driven.dimension.over(Dimension::TIME);
        let speed = own.speed.as_ref().and_then(|entry| self.numbers.quantity_of(entry, rate, Rule::Finite));
        let (angle, position) = ((own.start_angle, "start_angle"), (own.start_position, "start_position"));
        let ((start, due), (other, found), kind) = match driven.dimension == Dimension::LENGTH {
            true => (position, angle, "prismatic"),
            false => (angle, position, "revolute"),
        };
        if let Some(other) = other {
            let joint = self.joints[driven.joint.0].name.clone();
            let problem = EntryProblem::WrongStart { entry: own.table.path.describe(), found, due, kind, joint };
            self.numbers.reader.report(&problem, other.key_span);
        }
        let start = start.as_ref().and_then(|entry| self.numbers.quantity_at(entry));
        Some(DriveLaw::steady_motion(Steady { speed: speed?, start: start? }))
    }
}

impl DriveReader for ModelReader {
    fn over_time(&mut self, entry: &Entry<'_>, dimension: Dimension) -> Option<Changing> {
        self.changing(entry, dimension, Rule::Finite, &[TIME])
    }
}
