//! Reading controlled joints.

use super::drive::{Driven, MOTION, Prescribed, SPEED};
use super::reader::ModelReader;
use crate::model::ids::{ControlId, JointId};
use crate::model::part_reader::PartReader;
use crate::model::parts::control::{Control, FeedForward};
use crate::model::parts::initial::{InitialNumber, InitialOf, InitialValue};
use crate::model::parts::topology::Joint;
use crate::model::problem::ModelProblem;
use loosepin_text::document::{Entry, Kind, quantity};
use loosepin_text::record;
use loosepin_text::units::{Dimension, Dimension as D, Rule};

/// Value of `feed_forward` that asks for the torques that the references need.
const INVERSE_DYNAMICS: &str = "inverse dynamics";

record! {
    /// a controlled joint: the torque or force of its actuator depends on the error of a joint against a reference, on its integral and
    /// on its rate
    pub(super) struct ControlTable for PartReader,
        exactly one of [speed, motion], exactly one of [start_angle, start_position, motion];
    /// the joint with the actuator: revolute (with or without play) or prismatic
    required joint: Entry<'t> = Kind::Reference("joint"), "\"elbow\"";
    /// the joint whose angle or position follows the reference; the joint of the actuator if omitted
    optional measured: Entry<'t> = Kind::Reference("joint"), "\"wrist\"";
    /// proportional gain: torque or force per error, >= 0
    required proportional: Option<Entry<'t>> = Kind::AnyQuantity, "\"40 N m/rad\"";
    /// integral gain: torque or force per time integral of the error, >= 0; none if omitted
    optional integral: Entry<'t> = Kind::AnyQuantity, "\"100 N m/(rad s)\"";
    /// derivative gain: torque or force per rate of the error, >= 0; none if omitted
    optional derivative: Entry<'t> = Kind::AnyQuantity, "\"2 N m s/rad\"";
    /// additional torque or force: constant, an expression over time, angle (or position) and speed, or the value that the bodies need to
    /// follow the references without play; none if omitted
    optional feed_forward: Entry<'t> = Kind::AnyOf(&[
        Kind::Choice(&[INVERSE_DYNAMICS]),
        quantity(D::TORQUE, Rule::Finite),
        quantity(D::FORCE, Rule::Finite),
    ]), "\"inverse dynamics\"";
    /// largest torque or force of the actuator, in either direction; no limit if omitted
    optional limit: Entry<'t> =
        Kind::AnyOf(&[quantity(D::TORQUE, Rule::Positive), quantity(D::FORCE, Rule::Positive)]), "\"8 N m\"";
    /// constant speed of the reference
    optional speed: Entry<'t> = SPEED, "\"90 deg/s\"";
    /// angle of the reference at time zero, with speed
    optional start_angle: Entry<'t> = quantity(D::ANGLE, Rule::Finite), "\"0 deg\"";
    /// position of the reference at time zero, with speed
    optional start_position: Entry<'t> = quantity(D::LENGTH, Rule::Finite), "\"0 mm\"";
    /// the reference over time, instead of a constant speed
    optional motion: Entry<'t> =
        MOTION, "{ kind = \"cycloidal\", from = \"0 deg\", to = \"90 deg\", duration = \"0.5 s\" }";
}

impl ModelReader {
    /// Reads the table of controls.
    pub fn read_controls(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a control") {
            self.numbers.remember(&entry);
            let control = ControlTable::read(self, &entry).and_then(|own| self.control(&entry, &own));
            let id = control.map(|control| {
                self.controls.push(control);
                ControlId(self.controls.len() - 1)
            });
            self.control_names.push((entry.name.to_owned(), id));
        }
    }

    fn control(&mut self, entry: &Entry<'_>, own: &ControlTable<'_>) -> Option<Control> {
        let joint = self.moving_joint(&own.joint)?;
        let drive = self.drives.iter().find(|drive| drive.joint == joint);
        let other = drive.map(|drive| format!("drive '{}'", drive.name)).or_else(|| {
            let control = self.controls.iter().find(|control| control.joint == joint)?;
            Some(format!("control '{}'", control.name))
        });
        if let Some(other) = other {
            let name = self.joints[joint.0].name.clone();
            let problem = ModelProblem::ControlledTwice { entry: entry.path.describe(), joint: name, other };
            return self.numbers.reader.refuse(&problem, own.joint.span);
        }
        let measured = match &own.measured {
            Some(entry) => self.moving_joint(entry)?,
            None => joint,
        };
        let [along, coordinate] = [joint, measured].map(|joint| self.coordinate_of(joint));
        let effort = if along == Dimension::LENGTH { Dimension::FORCE } else { Dimension::TORQUE };
        let mut number = |entry: &Option<Entry<'_>>, dimension: Dimension, rule: Rule| match entry {
            Some(entry) => self.numbers.quantity_of(entry, dimension, rule).map(Some),
            None => Some(None),
        };
        let by_error = effort.over(coordinate);
        let proportional = number(&own.proportional, by_error, Rule::NonNegative);
        let integral = number(&own.integral, by_error.over(Dimension::TIME), Rule::NonNegative);
        let derivative = number(&own.derivative, by_error.times(Dimension::TIME), Rule::NonNegative);
        let limit = number(&own.limit, effort, Rule::Positive);
        let feed_forward = self.feed_forward(own, effort, joint, measured);
        let ControlTable { table, speed, start_angle, start_position, motion, .. } = own;
        let driven = Driven { joint: measured, dimension: coordinate };
        let reference = self.prescribed(&Prescribed { table, speed, start_angle, start_position, motion }, &driven);
        Some(Control {
            name: entry.name.to_owned(),
            joint,
            measured,
            proportional: proportional??,
            integral: integral?,
            derivative: derivative?,
            feed_forward: feed_forward?,
            limit: limit?,
            reference: reference?,
        })
    }

    /// A joint that has a coordinate.
    pub(super) fn moving_joint(&mut self, entry: &Entry<'_>) -> Option<JointId> {
        let joint = self.joint(entry)?;
        if self.joints[joint.0].kind.coordinate().is_none() {
            return self.numbers.reader.refuse(&self.does_not_move(entry.path.describe(), joint), entry.span);
        }
        Some(joint)
    }

    /// The problem of an entry that needs the coordinate of a joint without one.
    pub(super) fn does_not_move(&self, entry: String, joint: JointId) -> ModelProblem {
        let Joint { name, kind, .. } = &self.joints[joint.0];
        let why = kind.why_not_driven(&|_| false).map_or("has no coordinate", |refused| refused.why);
        ModelProblem::DoesNotMove { entry, joint: name.clone(), why }
    }

    fn feed_forward(
        &mut self,
        own: &ControlTable<'_>,
        effort: Dimension,
        joint: JointId,
        measured: JointId,
    ) -> Option<FeedForward> {
        let Some(entry) = &own.feed_forward else { return Some(FeedForward::None) };
        if entry.is_text() && self.numbers.reader.text(entry) == Some(INVERSE_DYNAMICS) {
            if joint != measured {
                self.numbers.refuse_beside(&own.table, "measured", "feed_forward = \"inverse dynamics\"");
                return None;
            }
            return Some(FeedForward::InverseDynamics);
        }
        let variables = self.variables(Some(measured));
        Some(FeedForward::TimeCourse(self.changing(entry, effort, Rule::Finite, &variables)?.into()))
    }

    /// Initial state of controlled joints if none is given: on their references, and as fast.
    pub fn initial_of_controls(&self) -> Vec<InitialValue> {
        let both = self.controls.iter().enumerate().flat_map(|(index, control)| {
            let of = InitialOf::joint(control.measured, self.coordinate_of(control.measured));
            let path = format!("control.{}", control.name);
            [false, true].map(|is_rate| InitialValue {
                path: path.clone(),
                of,
                is_rate,
                number: InitialNumber::Reference { control: index },
            })
        });
        both.collect()
    }
}
