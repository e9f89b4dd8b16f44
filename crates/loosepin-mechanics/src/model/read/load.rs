//! Reading loads.

use super::function::Changing;
use super::reader::ModelReader;
use crate::model::function::{TIME, Variable};
use crate::model::ids::{BodyId, JointId};
use crate::model::load::{ARGUMENTS, Course, LOAD_KINDS, Load, LoadKind, SizeKeys};
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
        let (word, table) = self.table_of_kind(entry, LOAD_KINDS)?;
        let kind = LoadKind::read(word, &table, self);
        let size = LoadKind::size_of_kind(word);
        let joint = match size.and_then(|_| table.get("joint")) {
            None => Some(None),
            Some(joint) => self.moving_joint(&joint).map(Some),
        };
        // Without the joint it is not known what the expression may read.
        let joint = joint?;
        let course = match &size {
            Some(size) => self.size(entry, &table, size, joint).map(Some),
            None => Some(None),
        };
        let kind = kind?;
        if kind.acts_on().body() == BodyId(0) {
            return self.reader.refuse(&ModelProblem::LoadOnGround { entry: entry.path.describe() }, entry.key_span);
        }
        let course = course?;
        if let Some((course, size)) = course.as_ref().zip(size) {
            self.refuse_unread_joint(&table, course, &size)?;
        }
        Some(Load { name: entry.name.to_owned(), kind, course, joint })
    }

    /// The size of a load, constant, over time or the motion of a joint, or by points.
    fn size(
        &mut self,
        entry: &Entry<'_>,
        table: &Table<'_>,
        size: &SizeKeys,
        joint: Option<JointId>,
    ) -> Option<Course> {
        let variables = self.variables(joint);
        if let Some(given) = key_of_points(table) {
            return self.load_table((entry.name, table), given, size, &variables).map(Course::Table);
        }
        let of_pressures: &[&'static str] = if size.takes_pressures { &["area", "back_pressure"] } else { &[] };
        for only in ["of", "period", "curve"].iter().chain(of_pressures) {
            self.refuse_beside(table, only, size.key);
        }
        let entry = table.get(size.key)?;
        self.course(&entry, size.dimension, size.harmonic, &variables)
    }

    /// Complains of a joint that the size of a load does not read.
    fn refuse_unread_joint(&mut self, table: &Table<'_>, course: &Course, size: &SizeKeys) -> Option<()> {
        let is_of_time = matches!(course, Course::Table(LoadTable { variable: 0, .. }));
        if (is_of_time || matches!(course, Course::Constant(_) | Course::Harmonic { .. }))
            && let Some(found) = table.get("joint")
        {
            let entry = table.path.describe();
            let problem = match key_of_points(table) {
                Some(_) => ModelProblem::KeyWithoutEffect { entry, key: "joint", beside: "of = \"time\"" },
                None => ModelProblem::JointNotRead { entry, key: size.key },
            };
            return self.reader.refuse(&problem, found.key_span);
        }
        Some(())
    }

    /// The points of a load behind the key `given`: of its size, or of pressures.
    fn load_table(
        &mut self,
        (load, table): (&str, &Table<'_>),
        given: &'static str,
        size: &SizeKeys,
        variables: &[Variable],
    ) -> Option<LoadTable> {
        let curve = self.reader.choice_or(table, "curve", &TableCurve::WORDS, TableCurve::Monotone);
        let piston = if size.takes_pressures { self.piston(table) } else { Some(None) };
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
        let column = if piston.is_some() { ("pressure", Dimension::PRESSURE) } else { (size.key, size.dimension) };
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

/// The key under which a load has points in place of a size.
fn key_of_points(table: &Table<'_>) -> Option<&'static str> {
    ["points", "csv"].into_iter().find(|key| table.has(key))
}

impl From<Changing> for Course {
    fn from(value: Changing) -> Self {
        match value {
            Changing::Constant(id) => Self::Constant(id),
            Changing::Function(function) => Self::Function(function),
        }
    }
}
