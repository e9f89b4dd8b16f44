//! Reading loads.

use super::function::Changing;
use super::reader::ModelReader;
use crate::model::function::{TIME, Variable};
use crate::model::ids::{BodyId, JointId};
use crate::model::keys::load::{HARMONIC_FORCE_KEYS, HARMONIC_TORQUE_KEYS, LOAD_KINDS};
use crate::model::load::{Course, Load, LoadKind};
use crate::model::problem::ModelProblem;
use loosepin_text::document::{Entry, Keys, Table};
use loosepin_text::units::{Dimension, Rule};

impl ModelReader {
    /// Reads the table of loads.
    pub fn read_loads(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.named(entry, "a load") {
            self.remember(&entry);
            let load = self.load(&entry);
            self.loads.extend(load);
        }
    }

    fn load(&mut self, entry: &Entry<'_>) -> Option<Load> {
        let (kind, table) = self.table_of_kind(entry, LOAD_KINDS)?;
        let is_force = kind == "force";
        let kind = if is_force { self.force(&table) } else { self.torque(&table) };
        let joint = match table.get("joint") {
            None => Some(None),
            Some(joint) => self.moving_joint(&joint).map(Some),
        };
        let (key, dimension, harmonic) = if is_force {
            ("force", Dimension::FORCE, &HARMONIC_FORCE_KEYS)
        } else {
            ("torque", Dimension::TORQUE, &HARMONIC_TORQUE_KEYS)
        };
        // Without the joint it is not known what the expression may read.
        let joint = joint?;
        let variables = self.variables(joint);
        let course = table.get(key).and_then(|entry| self.course(&entry, dimension, harmonic, &variables));
        let kind = kind?;
        if kind.body() == BodyId(0) {
            return self.reader.refuse(&ModelProblem::LoadOnGround { entry: entry.path.describe() }, entry.key_span);
        }
        let course = course?;
        if let (Some(_), Course::Constant(_) | Course::Harmonic { .. }) = (joint, &course)
            && let Some(found) = table.get("joint")
        {
            let problem = ModelProblem::JointNotRead { entry: table.path.describe(), key };
            return self.reader.refuse(&problem, found.key_span);
        }
        Some(Load { name: entry.name.to_owned(), kind, course, joint })
    }

    fn force(&mut self, table: &Table<'_>) -> Option<LoadKind> {
        let point = table.get("point").and_then(|entry| self.point(&entry));
        let direction_rad = self.quantity(table, "direction");
        let follows_body = self.choice_or(table, "frame", &[("ground", false), ("body", true)], false);
        Some(LoadKind::Force { point: point?, direction_rad: direction_rad?, follows_body: follows_body? })
    }

    fn torque(&mut self, table: &Table<'_>) -> Option<LoadKind> {
        let entry = table.get("body")?;
        let name = self.reader.text(&entry)?.to_owned();
        self.body(&entry, &name).map(|body| LoadKind::Torque { body })
    }

    /// Variables of an expression: the time, and coordinate and rate of a joint.
    pub(super) fn variables(&self, joint: Option<JointId>) -> Vec<Variable> {
        let mut variables = vec![TIME];
        match joint.map(|joint| self.coordinate_of(joint)) {
            Some(along) if along == Dimension::LENGTH => {
                variables.extend([("position", Dimension::LENGTH), ("speed", Dimension::VELOCITY)]);
            }
            Some(_) => variables.extend([("angle", Dimension::ANGLE), ("speed", Dimension::ANGULAR_VELOCITY)]),
            None => {}
        }
        variables
    }

    fn course(
        &mut self,
        entry: &Entry<'_>,
        dimension: Dimension,
        harmonic: &'static Keys,
        variables: &[Variable],
    ) -> Option<Course> {
        if !entry.is_table() {
            return self.changing(entry, dimension, Rule::Finite, variables).map(Course::from);
        }
        let table = self.reader.table(entry, harmonic)?;
        let mean = self.quantity_or(&table, "mean", 0.0);
        let amplitude = self.quantity(&table, "amplitude");
        let frequency = self.quantity(&table, "frequency");
        let phase_rad = self.quantity_or(&table, "phase", 0.0);
        Some(Course::Harmonic { mean: mean?, amplitude: amplitude?, frequency: frequency?, phase_rad: phase_rad? })
    }
}

impl From<Changing> for Course {
    fn from(value: Changing) -> Self {
        match value {
            Changing::Constant(id) => Self::Constant(id),
            Changing::Function(function) => Self::Function(function),
        }
    }
}
