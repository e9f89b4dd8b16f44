//! Drives at constant speed, and the cycle.

use super::parts::{ModelCycle, ModelCycleSpan, ModelDrive};
use super::problem::SpatialModelProblem;
use super::reader::SpaceReader;
use crate::mechanism::drive::JointCoordinate;
use loosepin_text::document::{Entry, Kind, count, quantity};
use loosepin_text::numbers::EntryProblem;
use loosepin_text::numbers::{QuantityId, ReadsNumbers};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

record! {
    /// a joint that is driven at constant speed
    pub(super) struct SpatialDriveTable for ReadsNumbers, exactly one of [start_angle, start_position],
        planned &[("motion", "drives in space move at constant speed; give speed and start_angle or start_position")];
    /// a revolute, prismatic, cylindrical or screw joint
    required joint: Entry<'t> = Kind::Reference("joint"), "\"main\"";
    /// constant speed of the journal's body relative to the bearing's
    required speed: Entry<'t> = SPEED, "\"60 rpm\"";
    /// angle about the axis from bearing_across to journal_across at time zero
    optional start_angle: QuantityId = quantity(D::ANGLE, Rule::Finite), "\"0 deg\"";
    /// position of the journal along the axis from the bearing at time zero
    optional start_position: QuantityId = quantity(D::LENGTH, Rule::Finite), "\"0 mm\"";
}

/// Kind of the value of `speed`.
const SPEED: Kind = Kind::AnyOf(&[quantity(D::ANGULAR_VELOCITY, Rule::Finite), quantity(D::VELOCITY, Rule::Finite)]);

record! {
    /// the turn over which the mechanism is moved
    pub(super) struct SpatialCycleTable for ReadsNumbers, exactly one of [drive, duration],
        planned &[
            ("transient_turns", "there are no runs in space yet; a motion takes one turn"),
            ("recorded_turns", "there are no runs in space yet; a motion takes one turn"),
        ];
    /// the drive whose turns are counted
    optional drive: Entry<'t> = Kind::Reference("drive"), "\"crank\"";
    /// the time that counts as one turn, instead of a drive
    optional duration: QuantityId = quantity(D::TIME, Rule::Positive), "\"0.2 s\"";
    /// positions in a turn
    optional samples_per_turn: usize = count(1, MAX_SAMPLES_PER_TURN), "72", or 72;
}

/// Positions in a turn, at most: each takes milliseconds.
const MAX_SAMPLES_PER_TURN: u64 = 10_000;

impl SpaceReader {
    /// Reads the table of drives.
    pub fn read_drives(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a drive") {
            self.numbers.remember(&entry);
            let drive = SpatialDriveTable::read(self, &entry).and_then(|own| self.drive(&entry, &own));
            let number = drive.map(|drive| {
                self.drives.push(drive);
                self.drives.len() - 1
            });
            self.drive_names.push((entry.name.to_owned(), number));
        }
    }

    fn drive(&mut self, entry: &Entry<'_>, own: &SpatialDriveTable<'_>) -> Option<ModelDrive> {
        let joint = self.joint(&own.joint)?;
        let name = self.joints[joint].name.clone();
        let kind = self.joints[joint].kind;
        let words = entry.path.describe();
        if !kind.turns() && !kind.slides() {
            let problem = SpatialModelProblem::NotDrivable { entry: words, joint: name, kind: kind.word() };
            return self.numbers.reader.refuse(&problem, own.joint.span);
        }
        let (coordinate, dimension, start, found, due) = match (own.start_angle, own.start_position) {
            (Some(start), _) => (JointCoordinate::Angle, D::ANGULAR_VELOCITY, start, "start_angle", "start_position"),
            (None, start) => (JointCoordinate::Slide, D::VELOCITY, start?, "start_position", "start_angle"),
        };
        let fits = if coordinate == JointCoordinate::Angle { kind.turns() } else { kind.slides() };
        if !fits {
            let problem = EntryProblem::WrongStart { entry: words, found, due, kind: kind.word(), joint: name };
            let at = own.table.get(found).map_or(own.table.span, |entry| entry.key_span);
            return self.numbers.reader.refuse(&problem, at);
        }
        // A screw has one freedom, whichever coordinate is driven.
        let is_other =
            |drive: &ModelDrive| drive.joint == joint && (drive.coordinate == coordinate || kind.freedoms() == 1);
        if let Some(other) = self.drives.iter().find(|drive| is_other(drive)) {
            let other = other.name.clone();
            let problem = EntryProblem::DrivenTwice { entry: words, joint: name, other };
            return self.numbers.reader.refuse(&problem, own.joint.span);
        }
        let speed = self.numbers.quantity_of(&own.speed, dimension, Rule::Finite)?;
        Some(ModelDrive { name: entry.name.to_owned(), joint, coordinate, speed, start })
    }

    /// Reads what a turn is.
    pub fn read_cycle(&mut self, entry: &Entry<'_>) -> Option<ModelCycle> {
        let own = SpatialCycleTable::read(self, entry)?;
        self.numbers.remember(entry);
        let span = match own.duration {
            Some(duration) => ModelCycleSpan::Duration(duration),
            None => {
                let entry = own.drive?;
                let name = self.numbers.reader.text(&entry)?;
                let drive = self.numbers.named(&entry, "drive", name, &self.drive_names)?;
                if self.drives[drive].coordinate == JointCoordinate::Slide {
                    let problem = SpatialModelProblem::CycleNeedsTurns { drive: name.to_owned() };
                    return self.numbers.reader.refuse(&problem, entry.span);
                }
                ModelCycleSpan::Drive(drive)
            }
        };
        Some(ModelCycle { span, samples_per_turn: own.samples_per_turn })
    }
}
