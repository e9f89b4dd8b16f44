//! Reading loads.

use super::function::Changing;
use super::reader::ModelReader;
use crate::model::entry_reader::EntryReader;
use crate::model::ids::{BodyId, JointId};
use crate::model::load::{ARGUMENTS, LOAD_KINDS, Load, LoadKind, PointsOfLoad, SizeKeys, SizeTable, TimeCourse};
use crate::model::part_reader::DeferredQuantity;
use crate::model::parts::load_table::{LoadTable, Piston};
use crate::model::problem::ModelProblem;
use crate::model::values::function::{TIME, Variable};
use loosepin_text::document::{Entry, Table};
use loosepin_text::numbers::EntryProblem;
use loosepin_text::units::{Dimension, Rule};

impl ModelReader {
    /// Reads the table of loads.
    pub fn read_loads(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a load") {
            self.numbers.remember(&entry);
            let load = self.load(&entry);
            self.loads.extend(load);
        }
    }

    fn load(&mut self, entry: &Entry<'_>) -> Option<Load> {
        let (word, table) = self.numbers.table_of_kind(entry, LOAD_KINDS)?;
        let (kind, written) = LoadKind::read(word, table, self);
        let size = written.zip(LoadKind::size_of_kind(word));
        // Without the joint it is not known what the expression may read.
        let joint = match size.as_ref().and_then(|(own, _)| own.joint.as_ref()) {
            None => None,
            Some(joint) => Some(self.moving_joint(joint)?),
        };
        let course = match &size {
            Some((own, keys)) => self.size(entry.name, own, keys, joint).map(Some),
            None => Some(None),
        };
        let kind = kind?;
        if kind.acts_on().body() == BodyId(0) {
            return self
                .numbers
                .reader
                .refuse(&ModelProblem::LoadOnGround { entry: entry.path.describe() }, entry.key_span);
        }
        let course = course?;
        if let Some((course, (own, keys))) = course.as_ref().zip(size) {
            self.refuse_unread_joint(&own, course, &keys)?;
        }
        Some(Load { name: entry.name.to_owned(), kind, course, joint })
    }

    /// The size of a load, constant, over time or the motion of a joint, or by points.
    fn size(&mut self, load: &str, own: &SizeTable<'_>, keys: &SizeKeys, joint: Option<JointId>) -> Option<TimeCourse> {
        let variables = self.variables(joint);
        if let Some(given) = key_of_points(own) {
            return self.load_table((load, own), given, keys, &variables).map(TimeCourse::Table);
        }
        let of_pressures: &[&'static str] = if own.pressures.is_some() { &["area", "back_pressure"] } else { &[] };
        for only in ["of", "period", "curve"].iter().chain(of_pressures) {
            self.numbers.refuse_beside(&own.table, only, keys.key);
        }
        let entry = own.size.as_ref()?;
        if entry.is_table() {
            return (keys.harmonic)(self, entry);
        }
        self.changing(entry, keys.dimension, Rule::Finite, &variables).map(TimeCourse::from)
    }

    /// Reports a joint that the size of a load does not read.
    fn refuse_unread_joint(&mut self, own: &SizeTable<'_>, course: &TimeCourse, keys: &SizeKeys) -> Option<()> {
        let is_of_time = matches!(course, TimeCourse::Table(LoadTable { variable: 0, .. }));
        if (is_of_time || matches!(course, TimeCourse::Constant(_) | TimeCourse::Harmonic { .. }))
            && let Some(found) = &own.joint
        {
            let entry = own.table.path.describe();
            let problem = match key_of_points(own) {
                Some(_) => EntryProblem::KeyWithoutEffect { entry, key: "joint", beside: "of = \"time\"" }.into(),
                None => ModelProblem::JointNotRead { entry, key: keys.key },
            };
            return self.numbers.reader.refuse(&problem, found.key_span);
        }
        Some(())
    }

    /// The points of a load behind the key `given`: of its size, or of pressures.
    fn load_table(
        &mut self,
        (load, own): (&str, &SizeTable<'_>),
        given: &'static str,
        keys: &SizeKeys,
        variables: &[Variable],
    ) -> Option<LoadTable> {
        let PointsOfLoad { csv, of, period, curve, .. } = &own.rest;
        let piston = own.pressures.as_ref().map_or(Some(None), |pressures| self.piston(&own.table, pressures));
        let Some(argument) = of else {
            self.numbers.report_missing(&own.table, given, vec!["of"]);
            return None;
        };
        let word = self.numbers.reader.choice(argument, &ARGUMENTS.map(|word| (word, word)))?;
        let Some(variable) = variables.iter().position(|(name, _)| *name == word) else {
            let names: Vec<&'static str> = variables.iter().map(|(name, _)| *name).collect();
            let problem = ModelProblem::NotOfJoint { entry: argument.path.describe(), word, names };
            return self.numbers.reader.refuse(&problem, argument.span);
        };
        let piston = piston?;
        let column = if piston.is_some() { ("pressure", Dimension::PRESSURE) } else { (keys.key, keys.dimension) };
        let columns = [variables[variable], column];
        let points = self.table_points([&own.points, csv], columns);
        let period_span = period.as_ref().map_or(own.table.span, |entry| entry.span);
        let period = match period {
            Some(_) if word == "speed" => {
                self.numbers.refuse_beside(&own.table, "period", "of = \"speed\"");
                return None;
            }
            Some(entry) => Some(self.numbers.quantity_of(entry, columns[0].1, Rule::Positive)?),
            None => None,
        };
        let dimensions = columns.map(|(_, dimension)| dimension);
        let load = load.to_owned();
        let read = LoadTable { load, variable, points: points?, curve: (*curve)?, period, piston, dimensions };
        if let Err(problem) = read.course(&self.numbers.quantities.nominal()) {
            return self.numbers.reader.refuse(&problem, period_span);
        }
        Some(read)
    }

    /// The piston of a force whose table is of pressures, by its area and back pressure; `None` if it is of forces.
    fn piston(
        &mut self,
        table: &Table<'_>,
        (area, back): &(Option<Entry<'_>>, DeferredQuantity<'_>),
    ) -> Option<Option<Piston>> {
        let Some(area) = area else {
            if matches!(back, DeferredQuantity::Written(_)) {
                self.numbers.report_missing(table, "back_pressure", vec!["area"]);
                return None;
            }
            return Some(None);
        };
        let area_m2 = self.numbers.quantity_at(area);
        let back_pressure_pa = back.quantity(self);
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
}

/// The key under which a load has points in place of a size.
fn key_of_points(own: &SizeTable<'_>) -> Option<&'static str> {
    let csv = own.rest.csv.as_ref().map(|_| "csv");
    own.points.as_ref().map(|_| "points").or(csv)
}

impl From<Changing> for TimeCourse {
    fn from(value: Changing) -> Self {
        match value {
            Changing::Constant(id) => Self::Constant(id),
            Changing::Function(function) => Self::Function(function),
        }
    }
}
