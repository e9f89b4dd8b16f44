//! Outputs.

use super::reader::ModelReader;
use crate::model::ids::{Actuator, Axis};
use crate::model::keys::{MEASURES, OUTPUT_KEYS};
use crate::model::problem::ModelProblem;
use crate::model::topology::{Component, Effort, Output, OutputKind};
use loosepin_text::document::{DocumentProblem, Entry, Table};
use loosepin_text::units::{Dimension, ReadableUnit};

impl ModelReader {
    /// Reads the table of outputs.
    pub fn read_outputs(&mut self, entry: &Entry<'_>) -> Vec<Output> {
        let mut outputs = Vec::new();
        for entry in self.reader.named(entry, "an output") {
            self.remember(&entry);
            let output = self.reader.table(&entry, &OUTPUT_KEYS).and_then(|table| {
                let kind = self.output_kind(&table)?;
                let unit = self.output_unit(&table, &kind)?;
                Some(Output { name: entry.name.to_owned(), kind, unit })
            });
            outputs.extend(output);
        }
        outputs
    }

    fn output_kind(&mut self, table: &Table<'_>) -> Option<OutputKind> {
        let measure = MEASURES.into_iter().find(|key| table.has(key))?;
        let entry = table.get(measure)?;
        let is_of_point = matches!(measure, "position_of" | "velocity_of" | "acceleration_of");
        if !is_of_point {
            self.refuse_beside(table, "along", measure);
        }
        if measure != "force_in" {
            self.refuse_beside(table, "component", measure);
        }
        match measure {
            "position_of" | "velocity_of" | "acceleration_of" => {
                let along = self.beside(table, "along", measure, "\"x\"", &[("x", Axis::X), ("y", Axis::Y)]);
                let point = self.point(&entry)?;
                let along = along?;
                Some(match measure {
                    "position_of" => OutputKind::Position { point, along },
                    "velocity_of" => OutputKind::Velocity { point, along },
                    _ => OutputKind::Acceleration { point, along },
                })
            }
            "force_in" => {
                let components = [("x", Component::X), ("y", Component::Y), ("magnitude", Component::Magnitude)];
                let component = self.beside(table, "component", measure, "\"magnitude\"", &components);
                let text = self.reader.text(&entry)?;
                let name = text.strip_prefix("joint.").unwrap_or(text);
                let joint = self.named(&entry, "joint", name, |file| &file.joint_names)?;
                Some(OutputKind::Force { joint, component: component? })
            }
            "torque_of" => self.effort(&entry, Effort::Torque),
            "force_of" => self.effort(&entry, Effort::Force),
            "power_of" => self.effort(&entry, Effort::Power),
            "path_of" => self.point(&entry).map(OutputKind::Path),
            _ => {
                let name = self.reader.text(&entry)?;
                let body = self.body(&entry, name)?;
                Some(match measure {
                    "angle_of" => OutputKind::Angle(body),
                    "angular_velocity_of" => OutputKind::AngularVelocity(body),
                    _ => OutputKind::AngularAcceleration(body),
                })
            }
        }
    }

    /// The effort of the drive or control that an entry names.
    fn effort(&mut self, entry: &Entry<'_>, effort: Effort) -> Option<OutputKind> {
        let actuator = self.actuator(entry)?;
        let (what, name, joint) = match actuator {
            Actuator::Drive(id) => ("drive", &self.drives[id.0].name, self.drives[id.0].joint),
            Actuator::Control(id) => ("control", &self.controls[id.0].name, self.controls[id.0].joint),
        };
        let turns = self.coordinate_of(joint) == Dimension::ANGLE;
        if (effort == Effort::Torque && !turns) || (effort == Effort::Force && turns) {
            let problem = ModelProblem::WrongEffort {
                entry: entry.path.describe(),
                actuator: format!("{what} '{name}'"),
                joint: self.joints[joint.0].name.clone(),
                turns,
                text: format!("{what}.{name}"),
            };
            return self.reader.refuse(&problem, entry.span);
        }
        Some(OutputKind::Effort { actuator, effort })
    }

    /// The drive or control that an entry names as `drive.NAME` or `control.NAME`.
    fn actuator(&mut self, entry: &Entry<'_>) -> Option<Actuator> {
        let text = self.reader.text(entry)?;
        match text.split_once('.') {
            Some(("drive", name)) => self.named(entry, "drive", name, |file| &file.drive_names).map(Actuator::Drive),
            Some(("control", name)) => {
                self.named(entry, "control", name, |file| &file.control_names).map(Actuator::Control)
            }
            _ => {
                let drives = self.drive_names.iter().map(|(name, _)| ("drive", name));
                let mut named = drives.chain(self.control_names.iter().map(|(name, _)| ("control", name)));
                let meant = named.find(|(_, name)| *name == text).map(|(what, name)| format!("{what}.{name}"));
                let problem =
                    ModelProblem::NotAnActuator { entry: entry.path.describe(), text: text.to_owned(), meant };
                self.reader.refuse(&problem, entry.span)
            }
        }
    }

    /// The choice behind a key that this measure needs.
    fn beside<T: Copy>(
        &mut self,
        table: &Table<'_>,
        key: &'static str,
        measure: &'static str,
        example: &'static str,
        choices: &[(&'static str, T)],
    ) -> Option<T> {
        match table.get(key) {
            Some(entry) => self.reader.choice(&entry, choices),
            None => {
                let doc = if measure == "force_in" { "the component of the force" } else { "the axis of the ground" };
                let problem = DocumentProblem::MissingKey { table: table.path.describe(), key, example, doc };
                self.reader.refuse(&problem, table.span)
            }
        }
    }

    fn output_unit(&mut self, table: &Table<'_>, kind: &OutputKind) -> Option<ReadableUnit> {
        let due = kind.dimension();
        let Some(entry) = table.get("unit") else { return Some(ReadableUnit::default_for(due)) };
        let text = self.reader.text(&entry)?;
        let unit = ReadableUnit::of_dimension(text, due);
        if unit.is_none() {
            let problem = ModelProblem::WrongUnit { entry: entry.path.describe(), unit: text.to_owned(), due };
            self.reader.complain(&problem, entry.span);
        }
        unit
    }
}
