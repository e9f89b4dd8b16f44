//! Outputs.

use super::reader::ModelReader;
use crate::model::ids::{Actuator, BodyId, JointId, PointId};
use crate::model::output::{ActuatorFacts, BeamFacts, OUTPUT_KEYS, Output, OutputKind, OutputReader};
use crate::model::parts::beam::Beam;
use crate::model::parts::topology::holds_section;
use crate::model::problem::ModelProblem;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::{Dimension, ReadableUnit};

impl ModelReader {
    /// Reads the table of outputs.
    pub fn read_outputs(&mut self, entry: &Entry<'_>) -> Vec<Output> {
        let mut outputs = Vec::new();
        for entry in self.numbers.reader.named(entry, "an output") {
            self.numbers.remember(&entry);
            let output = self.numbers.reader.table(&entry, &OUTPUT_KEYS).and_then(|table| {
                let kind = self.output_kind(&table)?;
                let unit = self.output_unit(&table, &kind)?;
                Some(Output { name: entry.name.to_owned(), kind, unit })
            });
            outputs.extend(output);
        }
        outputs
    }

    fn output_kind(&mut self, table: &Table<'_>) -> Option<OutputKind> {
        let measure = OutputKind::measure_in(table)?;
        for key in OutputKind::keys_beside().filter(|key| !measure.beside.contains(key)) {
            self.numbers.refuse_beside(table, key, measure.key.name);
        }
        OutputKind::read(measure.key.name, table, self)
    }

    fn output_unit(&mut self, table: &Table<'_>, kind: &OutputKind) -> Option<ReadableUnit> {
        let due = kind.dimension();
        let Some(entry) = table.get("unit") else {
            let usual = kind.usual_unit().and_then(|unit| ReadableUnit::of_dimension(unit, due));
            return Some(usual.unwrap_or_else(|| ReadableUnit::default_for(due)));
        };
        let text = self.numbers.reader.text(&entry)?;
        let unit = ReadableUnit::of_dimension(text, due);
        if unit.is_none() {
            let problem = ModelProblem::WrongUnit { entry: entry.path.describe(), unit: text.to_owned(), due };
            self.numbers.reader.report(&problem, entry.span);
        }
        unit
    }
}

impl OutputReader for ModelReader {
    fn actuator(&mut self, entry: &Entry<'_>) -> Option<Actuator> {
        let text = self.numbers.reader.text(entry)?;
        match text.split_once('.') {
            Some(("drive", name)) => self.numbers.named(entry, "drive", name, &self.drive_names).map(Actuator::Drive),
            Some(("control", name)) => {
                self.numbers.named(entry, "control", name, &self.control_names).map(Actuator::Control)
            }
            _ => {
                let drives = self.drive_names.iter().map(|(name, _)| ("drive", name));
                let mut named = drives.chain(self.control_names.iter().map(|(name, _)| ("control", name)));
                let meant = named.find(|(_, name)| *name == text).map(|(what, name)| format!("{what}.{name}"));
                let problem =
                    ModelProblem::NotAnActuator { entry: entry.path.describe(), text: text.to_owned(), meant };
                self.numbers.reader.refuse(&problem, entry.span)
            }
        }
    }

    fn actuator_facts(&self, actuator: Actuator) -> ActuatorFacts {
        let (what, name, joint) = match actuator {
            Actuator::Drive(id) => ("drive", &self.drives[id.0].name, self.drives[id.0].joint),
            Actuator::Control(id) => ("control", &self.controls[id.0].name, self.controls[id.0].joint),
        };
        ActuatorFacts { what, name: name.clone(), joint, turns: self.coordinate_of(joint) == Dimension::ANGLE }
    }

    fn wears(&self, joint: JointId) -> bool {
        self.joints[joint.0].wear.is_some()
    }

    fn beam_facts(&self, body: BodyId) -> Option<BeamFacts> {
        let Beam { height_m, ends, .. } = self.bodies[body.0].beam.as_ref()?;
        let is_held = |point: &usize| holds_section(&self.joints, &self.drives, PointId { body, point: *point });
        let is_nodal = self.bodies[body.0].beam.as_ref().is_some_and(Beam::is_nodal);
        Some(BeamFacts {
            has_height: height_m.is_some(),
            is_nodal_between_sections: is_nodal && ends.iter().all(is_held),
        })
    }
}
