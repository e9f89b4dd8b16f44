//! Loads: forces and torques from outside.

use super::file::ModelReader;
use super::function::{Changing, Function, TIME, Variable};
use super::load_keys::{FORCE_KEYS, HARMONIC_FORCE_KEYS, HARMONIC_TORQUE_KEYS, LOAD_KINDS, TORQUE_KEYS};
use super::problem::ModelProblem;
use super::quantity::QuantityId;
use super::topology::{BodyId, JointId, JointKind, PointId};
use loosepin_text::document::{Entry, Keys, Table};
use loosepin_text::units::{Dimension, Rule};

/// A force or a torque from outside; the ground gets nothing in return.
#[derive(Debug, Clone)]
pub struct Load {
    /// Name in the file.
    pub name: String,
    /// What it acts on.
    pub kind: LoadKind,
    /// Its size over time.
    pub course: Course,
    /// The joint whose coordinate and rate the function of its size reads.
    pub joint: Option<JointId>,
}

/// The kinds of load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadKind {
    /// A force on a point.
    Force {
        /// The point.
        point: PointId,
        /// Its direction, rad, from the x axis of the ground or of the body.
        direction_rad: QuantityId,
        /// Whether the direction turns with the body.
        follows_body: bool,
    },
    /// A torque on a body.
    Torque {
        /// The body.
        body: BodyId,
    },
}

impl LoadKind {
    /// The body that it acts on.
    pub fn body(&self) -> BodyId {
        match *self {
            Self::Force { point, .. } => point.body,
            Self::Torque { body } => body,
        }
    }
}

/// How something changes with time.
#[derive(Debug, Clone)]
pub enum Course {
    /// Not at all.
    Constant(QuantityId),
    /// mean + amplitude sin(2π frequency t + phase).
    Harmonic {
        /// Its middle.
        mean: QuantityId,
        /// Largest departure from the middle.
        amplitude: QuantityId,
        /// Oscillations in a second, 1/s, > 0.
        frequency: QuantityId,
        /// At time zero, rad.
        phase_rad: QuantityId,
    },
    /// By a function of the time, then of the coordinate and the rate of a joint where the load names one.
    Function(Function),
}

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
        let kinds: Vec<(&'static str, bool)> = LOAD_KINDS.iter().map(|(kind, _)| (*kind, *kind == "force")).collect();
        let is_force = self.reader.tag(entry, "kind", &kinds)?;
        let table = self.reader.table(entry, if is_force { &FORCE_KEYS } else { &TORQUE_KEYS })?;
        let kind = if is_force { self.force(&table) } else { self.torque(&table) };
        let joint = match table.get("joint") {
            None => Some(None),
            Some(joint) => self.read_joint(&joint).map(Some),
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
            self.reader.complain(&ModelProblem::LoadOnGround { entry: entry.path.describe() }, entry.key_span);
            return None;
        }
        let course = course?;
        if let (Some(_), Course::Constant(_) | Course::Harmonic { .. }) = (joint, &course)
            && let Some(found) = table.get("joint")
        {
            let problem = ModelProblem::JointNotRead { entry: table.path.describe(), key };
            self.reader.complain(&problem, found.key_span);
            return None;
        }
        Some(Load { name: entry.name.to_owned(), kind, course, joint })
    }

    fn force(&mut self, table: &Table<'_>) -> Option<LoadKind> {
        let point = table.get("point").and_then(|entry| self.point(&entry));
        let direction_rad = self.quantity(table, "direction");
        let follows_body = match table.get("frame") {
            Some(entry) => self.reader.choice(&entry, &[("ground", false), ("body", true)]),
            None => Some(false),
        };
        Some(LoadKind::Force { point: point?, direction_rad: direction_rad?, follows_body: follows_body? })
    }

    fn torque(&mut self, table: &Table<'_>) -> Option<LoadKind> {
        let entry = table.get("body")?;
        let name = self.reader.text(&entry)?.to_owned();
        self.body(&entry, &name).map(|body| LoadKind::Torque { body })
    }

    fn read_joint(&mut self, entry: &Entry<'_>) -> Option<JointId> {
        let name = self.reader.text(entry)?.to_owned();
        let joint = self.named(entry, "joint", &name, |file| &file.joint_names)?;
        if matches!(self.joints[joint.0].kind, JointKind::Rigid { .. }) {
            let problem = ModelProblem::DoesNotMove { entry: entry.path.describe(), joint: name };
            self.reader.complain(&problem, entry.span);
            return None;
        }
        Some(joint)
    }

    /// What expressions may read: the time, and coordinate and rate of a joint.
    pub(super) fn variables(&self, joint: Option<JointId>) -> Vec<Variable> {
        let mut variables = vec![TIME];
        match joint.map(|joint| &self.joints[joint.0].kind) {
            Some(JointKind::Prismatic { .. } | JointKind::Slot { .. }) => {
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
            return Some(match self.changing(entry, dimension, Rule::Finite, variables)? {
                Changing::Constant(id) => Course::Constant(id),
                Changing::Function(function) => Course::Function(function),
            });
        }
        let table = self.reader.table(entry, harmonic)?;
        let mean = self.quantity_or(&table, "mean", 0.0);
        let amplitude = self.quantity(&table, "amplitude");
        let frequency = self.quantity(&table, "frequency");
        let phase_rad = self.quantity_or(&table, "phase", 0.0);
        Some(Course::Harmonic { mean: mean?, amplitude: amplitude?, frequency: frequency?, phase_rad: phase_rad? })
    }
}
