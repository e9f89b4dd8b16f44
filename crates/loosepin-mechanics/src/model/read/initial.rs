//! Reading the initial state.

use super::reader::ModelReader;
use crate::model::ids::{Axis, BodyId, JointId};
use crate::model::part_reader::PartReader;
use crate::model::parts::initial::{InitialNumber, InitialOf, InitialOffset, InitialValue, OffsetPlace};
use crate::model::problem::ModelProblem;
use loosepin_text::document::{Entry, Kind, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Dimension as D, Rule};

record! {
    /// position and velocity of a body at time zero, relative to the ground
    struct InitialBody for PartReader;
    /// angle of the body's x axis
    optional angle: Entry<'t> = quantity(D::ANGLE, Rule::Finite), "\"90 deg\"";
    /// rate of that
    optional angular_velocity: Entry<'t> = quantity(D::ANGULAR_VELOCITY, Rule::Finite), "\"2 rad/s\"";
    /// position of the origin of the body's frame
    optional position: Entry<'t> = Kind::Vector, "[\"10 mm\", \"0 mm\"]";
    /// velocity of this origin
    optional velocity: Entry<'t> = Kind::Vector, "[\"1 m/s\", \"0 m/s\"]";
}

record! {
    /// coordinate and velocity of a joint at time zero
    struct InitialJoint for PartReader;
    /// angle from the bearing's body to the journal's
    optional angle: Entry<'t> = quantity(D::ANGLE, Rule::Finite), "\"30 deg\"";
    /// rate of that
    optional angular_velocity: Entry<'t> = quantity(D::ANGULAR_VELOCITY, Rule::Finite), "\"2 rad/s\"";
    /// position of the slider along the guide
    optional position: Entry<'t> = quantity(D::LENGTH, Rule::Finite), "\"5 mm\"";
    /// rate of that
    optional velocity: Entry<'t> = quantity(D::VELOCITY, Rule::Finite), "\"1 m/s\"";
    /// for a joint with play: offset of the journal's centre from the bearing's, along the axes of the ground; none if omitted
    optional offset: Entry<'t> = Kind::Vector, "[\"0 mm\", \"-0.5 mm\"]";
    /// rate of the offset; none if omitted
    optional offset_velocity: Entry<'t> = Kind::Vector, "[\"0 m/s\", \"0.1 m/s\"]";
    /// instead of an offset: the journal starts at rest on the side to which the forces at the start press it
    optional start: Entry<'t> = Kind::Choice(&["resting"]), "\"resting\"";
}

record! {
    /// the state at time zero: of a mechanism that its drives alone do not determine, and of journals in their bearings
    pub(super) struct InitialTable for PartReader;
    /// bodies, each under [initial.body.NAME]
    optional body: Entry<'t> = Kind::Tables { keys: &InitialBody::KEYS, except: &[] }, "";
    /// joints, each under [initial.joint.NAME]
    optional joint: Entry<'t> = Kind::Tables { keys: &InitialJoint::KEYS, except: &[] }, "";
}

impl ModelReader {
    /// Reads the initial state, and where journals are in their bearings.
    pub fn read_initial(&mut self, entry: &Entry<'_>) -> (Vec<InitialValue>, Vec<InitialOffset>) {
        let Some(table) = InitialTable::read(self, entry) else { return Default::default() };
        self.numbers.remember(entry);
        let (mut values, mut offsets) = (Vec::new(), Vec::new());
        if let Some(bodies) = table.body {
            for entry in self.numbers.reader.any_keys(&bodies) {
                self.initial_body(&entry, &mut values);
            }
        }
        if let Some(joints) = table.joint {
            for entry in self.numbers.reader.any_keys(&joints) {
                self.initial_joint(&entry, &mut values, &mut offsets);
            }
        }
        (values, offsets)
    }

    fn initial_body(&mut self, entry: &Entry<'_>, values: &mut Vec<InitialValue>) {
        self.numbers.remember(entry);
        let own = InitialBody::read(self, entry);
        let (Some(own), Some(body)) = (own, self.body(&entry.at_key(), entry.name)) else { return };
        if body == BodyId(0) {
            self.numbers.reader.report(&ModelProblem::InitialOfGround, entry.key_span);
            return;
        }
        let of = InitialOf::BodyAngle(body);
        for (entry, is_rate, dimension) in
            [(own.angle, false, D::ANGLE), (own.angular_velocity, true, D::ANGULAR_VELOCITY)]
        {
            entry.into_iter().for_each(|entry| self.initial_value(&entry, of, is_rate, dimension, values));
        }
        for (entry, is_rate, dimension) in [(own.position, false, D::LENGTH), (own.velocity, true, D::VELOCITY)] {
            let Some(entry) = entry else { continue };
            let Some(pair) = self.numbers.reader.pair(&entry) else { continue };
            for (mut element, (axis, name)) in pair.into_iter().zip([(Axis::X, "x"), (Axis::Y, "y")]) {
                element.path = entry.path.join(name);
                self.initial_value(&element, InitialOf::BodyPosition(body, axis), is_rate, dimension, values);
            }
        }
    }

    fn initial_joint(&mut self, entry: &Entry<'_>, values: &mut Vec<InitialValue>, offsets: &mut Vec<InitialOffset>) {
        self.numbers.remember(entry);
        let own = InitialJoint::read(self, entry);
        let joint = self.numbers.named(&entry.at_key(), "joint", entry.name, &self.joint_names);
        let (Some(own), Some(joint)) = (own, joint) else { return };
        offsets.extend(self.initial_offset(&own, joint));
        let Some(coordinate) = self.joints[joint.0].kind.coordinate() else {
            self.numbers.reader.report(&self.does_not_move("initial".to_owned(), joint), entry.key_span);
            return;
        };
        let of = InitialOf::joint(joint, coordinate);
        let turns = matches!(of, InitialOf::JointAngle(_));
        for (entry, fits, is_rate, dimension) in [
            (own.angle, turns, false, D::ANGLE),
            (own.angular_velocity, turns, true, D::ANGULAR_VELOCITY),
            (own.position, !turns, false, D::LENGTH),
            (own.velocity, !turns, true, D::VELOCITY),
        ] {
            let Some(entry) = entry else { continue };
            if fits {
                self.initial_value(&entry, of, is_rate, dimension, values);
            } else {
                let key = entry.name.to_owned();
                let problem = ModelProblem::WrongCoordinate { entry: own.table.path.describe(), key };
                self.numbers.reader.report(&problem, entry.key_span);
            }
        }
    }

    /// Position of the journal of `joint` in its bearing; `None` if it is not stated.
    fn initial_offset(&mut self, own: &InitialJoint<'_>, joint: JointId) -> Option<InitialOffset> {
        let written = [&own.offset, &own.offset_velocity, &own.start].into_iter().flatten().next()?;
        if self.joints[joint.0].kind.pin_clearance().is_none() {
            let (entry, key) = (own.table.path.describe(), written.name.to_owned());
            let problem = ModelProblem::OffsetWithoutPlay { entry, key, joint: self.joints[joint.0].name.clone() };
            return self.numbers.reader.refuse(&problem, written.key_span);
        }
        let mut vector = |written: &Option<Entry<'_>>, dimension: Dimension| {
            let written = written.as_ref()?;
            let pair = self.numbers.reader.pair(written)?;
            let parts = pair.into_iter().zip(["x", "y"]).map(|(mut element, axis)| {
                element.path = written.path.join(axis);
                self.numbers.quantity_of(&element, dimension, Rule::Finite)
            });
            let parts = parts.collect::<Option<Vec<QuantityId>>>()?;
            <[QuantityId; 2]>::try_from(parts).ok()
        };
        let offset_m = vector(&own.offset, D::LENGTH);
        let velocity_m_s = vector(&own.offset_velocity, D::VELOCITY);
        let place = match &own.start {
            Some(start) => {
                for key in ["offset", "offset_velocity"] {
                    self.numbers.refuse_beside(&own.table, key, "start");
                }
                self.numbers.reader.choice(start, &[("resting", OffsetPlace::Resting)])?
            }
            None => OffsetPlace::Given { offset_m, velocity_m_s },
        };
        Some(InitialOffset { path: own.table.path.dotted(), joint, place })
    }

    fn initial_value(
        &mut self,
        entry: &Entry<'_>,
        of: InitialOf,
        is_rate: bool,
        dimension: Dimension,
        values: &mut Vec<InitialValue>,
    ) {
        let value = self.numbers.quantity_of(entry, dimension, Rule::Finite);
        let number = value.map(InitialNumber::Given);
        values.extend(number.map(|number| InitialValue { path: entry.path.dotted(), of, is_rate, number }));
    }
}
