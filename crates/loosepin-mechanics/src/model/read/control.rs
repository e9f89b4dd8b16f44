//! Reading controlled joints.

use super::drive::Driven;
use super::reader::ModelReader;
use crate::model::control::{Control, FeedForward};
use crate::model::ids::{ControlId, JointId};
use crate::model::initial::{InitialNumber, InitialOf, InitialValue};
use crate::model::keys::control::{CONTROL_KEYS, INVERSE_DYNAMICS};
use crate::model::problem::ModelProblem;
use crate::model::quantity::QuantityId;
use crate::model::topology::Joint;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::{Dimension, Rule};

impl ModelReader {
    /// Reads the table of controls.
    pub fn read_controls(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.named(entry, "a control") {
            self.remember(&entry);
            let control = self.reader.table(&entry, &CONTROL_KEYS).and_then(|table| self.control(&entry, &table));
            let id = control.map(|control| {
                self.controls.push(control);
                ControlId(self.controls.len() - 1)
            });
            self.control_names.push((entry.name.to_owned(), id));
        }
    }

    fn control(&mut self, entry: &Entry<'_>, table: &Table<'_>) -> Option<Control> {
        let joint_entry = table.get("joint")?;
        let joint = self.moving_joint(&joint_entry)?;
        let drive = self.drives.iter().find(|drive| drive.joint == joint);
        let other = drive.map(|drive| format!("drive '{}'", drive.name)).or_else(|| {
            let control = self.controls.iter().find(|control| control.joint == joint)?;
            Some(format!("control '{}'", control.name))
        });
        if let Some(other) = other {
            let name = self.joints[joint.0].name.clone();
            let problem = ModelProblem::ControlledTwice { entry: entry.path.describe(), joint: name, other };
            return self.reader.refuse(&problem, joint_entry.span);
        }
        let measured = match table.get("measured") {
            Some(entry) => self.moving_joint(&entry)?,
            None => joint,
        };
        let [along, coordinate] = [joint, measured].map(|joint| self.coordinate_of(joint));
        let effort = if along == Dimension::LENGTH { Dimension::FORCE } else { Dimension::TORQUE };
        let mut gain = |key: &str, dimension: Dimension| {
            table.get(key).map(|entry| self.quantity_of(&entry, dimension, Rule::NonNegative))
        };
        let by_error = effort.over(coordinate);
        let proportional = gain("proportional", by_error).flatten();
        let integral = gain("integral", by_error.over(Dimension::TIME));
        let derivative = gain("derivative", by_error.times(Dimension::TIME));
        let limit = table.get("limit").map(|entry| self.quantity_of(&entry, effort, Rule::Positive));
        let feed_forward = self.feed_forward(table, effort, joint, measured);
        let driven = Driven::new(measured, coordinate);
        let reference = match table.get("motion") {
            Some(motion) => self.motion(&motion, &driven),
            None => self.constant_speed(entry, table, &driven),
        };
        Some(Control {
            name: entry.name.to_owned(),
            joint,
            measured,
            proportional: proportional?,
            integral: present(integral)?,
            derivative: present(derivative)?,
            feed_forward: feed_forward?,
            limit: present(limit)?,
            reference: reference?,
        })
    }

    /// A joint that has a coordinate.
    pub(super) fn moving_joint(&mut self, entry: &Entry<'_>) -> Option<JointId> {
        let joint = self.joint(entry)?;
        if self.joints[joint.0].kind.coordinate().is_none() {
            return self.reader.refuse(&self.does_not_move(entry.path.describe(), joint), entry.span);
        }
        Some(joint)
    }

    /// What is wrong where something needs the coordinate of a joint that has none.
    pub(super) fn does_not_move(&self, entry: String, joint: JointId) -> ModelProblem {
        let Joint { name, kind, .. } = &self.joints[joint.0];
        let why = kind.why_not_driven(&|_| false).map_or("has no coordinate", |refused| refused.why);
        ModelProblem::DoesNotMove { entry, joint: name.clone(), why }
    }

    fn feed_forward(
        &mut self,
        table: &Table<'_>,
        effort: Dimension,
        joint: JointId,
        measured: JointId,
    ) -> Option<FeedForward> {
        let Some(entry) = table.get("feed_forward") else { return Some(FeedForward::None) };
        if entry.is_text() && self.reader.text(&entry) == Some(INVERSE_DYNAMICS) {
            if joint != measured {
                self.refuse_beside(table, "measured", "feed_forward = \"inverse dynamics\"");
                return None;
            }
            return Some(FeedForward::InverseDynamics);
        }
        let variables = self.variables(Some(measured));
        Some(FeedForward::Course(self.changing(&entry, effort, Rule::Finite, &variables)?.into()))
    }

    /// Where nothing is given of the initial state, controlled joints start on their references, and as fast.
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

/// An absent entry is right (`Some(None)`); an entry that could not be read is not (`None`).
fn present(found: Option<Option<QuantityId>>) -> Option<Option<QuantityId>> {
    match found {
        None => Some(None),
        Some(id) => id.map(Some),
    }
}
