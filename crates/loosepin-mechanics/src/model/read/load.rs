//! Reading loads.

use super::function::Changing;
use super::reader::ModelReader;
use crate::model::function::{TIME, Variable};
use crate::model::ids::{BodyId, JointId};
use crate::model::keys::load::{ARGUMENTS, HARMONIC_FORCE_KEYS, HARMONIC_TORQUE_KEYS, LOAD_KINDS};
use crate::model::load::{Course, Load, LoadKind};
use crate::model::load_table::{LoadTable, Piston};
use crate::model::problem::ModelProblem;
use crate::model::table_curve::TableCurve;
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
        let given = ["points", "csv"].into_iter().find(|key| table.has(key));
        let course = match given {
            Some(given) => {
                self.load_table((entry.name, &table), given, (key, dimension), &variables).map(Course::Table)
            }
            None => {
                let of_tables: &[&'static str] = if is_force {
                    &["of", "period", "curve", "area", "back_pressure"]
                } else {
                    &["of", "period", "curve"]
                };
                for only in of_tables {
                    self.refuse_beside(&table, only, key);
                }
                table.get(key).and_then(|entry| self.course(&entry, dimension, harmonic, &variables))
            }
        };
        let kind = kind?;
        if kind.body() == BodyId(0) {
            return self.reader.refuse(&ModelProblem::LoadOnGround { entry: entry.path.describe() }, entry.key_span);
        }
        let course = course?;
        let is_of_time = matches!(&course, Course::Table(LoadTable { variable: 0, .. }));
        if (is_of_time || matches!(course, Course::Constant(_) | Course::Harmonic { .. }))
            && let Some(found) = table.get("joint")
        {
            let entry = table.path.describe();
            let problem = match given {
                Some(_) => ModelProblem::KeyWithoutEffect { entry, key: "joint", beside: "of = \"time\"" },
                None => ModelProblem::JointNotRead { entry, key },
            };
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

    /// The points of a load behind the key `given`: of a force or a torque, `of`.
    fn load_table(
        &mut self,
        (load, table): (&str, &Table<'_>),
        given: &'static str,
        of: (&'static str, Dimension),
        variables: &[Variable],
    ) -> Option<LoadTable> {
        let curve = self.choice_or(table, "curve", &TableCurve::WORDS, TableCurve::Monotone);
        let piston = if of.0 == "force" { self.piston(table) } else { Some(None) };
        let Some(argument) = table.get("of") else {
            self.complain_of_missing(table, given, vec!["of"]);
            return None;
        };
        let word = self.reader.choice(&argument, &ARGUMENTS.map(|word| (word, word)))?;
        let Some(variable) = variables.iter().position(|(name, _)| *name == word) else {
            let names: Vec<&'static str> = variables.iter().map(|(name, _)| *name).collect();
            let problem = ModelProblem::NotOfJoint { entry: argument.path.describe(), word, names };
            return self.reader.refuse(&problem, argument.span);
        };
        let piston = piston?;
        let column = if piston.is_some() { ("pressure", Dimension::PRESSURE) } else { of };
        let columns = [variables[variable], column];
        let points = self.table_points(table, columns);
        let period = match table.get("period") {
            Some(_) if word == "speed" => {
                self.refuse_beside(table, "period", "of = \"speed\"");
                return None;
            }
            Some(entry) => Some(self.quantity_of(&entry, columns[0].1, Rule::Positive)?),
            None => None,
        };
        let dimensions = columns.map(|(_, dimension)| dimension);
        let load = load.to_owned();
        let read = LoadTable { load, variable, points: points?, curve: curve?, period, piston, dimensions };
        if let Err(problem) = read.course(&self.quantities.nominal()) {
            let span = table.get("period").map_or(table.span, |entry| entry.span);
            return self.reader.refuse(&problem, span);
        }
        Some(read)
    }

    /// The piston of a force whose table is of pressures; none where it is of forces.
    fn piston(&mut self, table: &Table<'_>) -> Option<Option<Piston>> {
        if !table.has("area") {
            if table.has("back_pressure") {
                self.complain_of_missing(table, "back_pressure", vec!["area"]);
                return None;
            }
            return Some(None);
        }
        let area_m2 = self.quantity(table, "area");
        let back_pressure_pa = self.quantity_or(table, "back_pressure", 0.0);
        Some(Some(Piston { area_m2: area_m2?, back_pressure_pa: back_pressure_pa? }))
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
