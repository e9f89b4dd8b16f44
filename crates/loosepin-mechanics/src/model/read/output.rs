//! Outputs.

use super::reader::ModelReader;
use crate::model::beam::Beam;
use crate::model::beam_problem::BeamProblem;
use crate::model::ids::{Actuator, Axis, BodyId, PointId};
use crate::model::keys::{MEASURES, OUTPUT_KEYS};
use crate::model::output::{Component, Derivative, Effort, Output, OutputKind, Position, Relative};
use crate::model::problem::ModelProblem;
use crate::model::topology::{Body, holds_section};
use crate::model::wear::WearMeasure;
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
        let moves = match measure {
            "position_of" | "angle_of" => Some(Derivative::Position),
            "velocity_of" | "angular_velocity_of" => Some(Derivative::Velocity),
            "acceleration_of" | "angular_acceleration_of" => Some(Derivative::Acceleration),
            _ => None,
        };
        let is_of_point = matches!(measure, "position_of" | "velocity_of" | "acceleration_of");
        if !is_of_point {
            self.refuse_beside(table, "along", measure);
        }
        if !matches!(measure, "force_in" | "wear_of") {
            self.refuse_beside(table, "component", measure);
        }
        if moves.is_none() && measure != "path_of" {
            self.refuse_beside(table, "relative_to", measure);
        }
        if let Some(derivative) = moves {
            let of = if is_of_point {
                let along = self.beside(table, "along", measure, "\"x\"", &[("x", Axis::X), ("y", Axis::Y)]);
                let point = self.relative_point(table, &entry);
                Position::Point(point?, along?)
            } else {
                Position::Angle(self.relative_body(table, &entry)?)
            };
            return Some(OutputKind::Motion { of, derivative });
        }
        match measure {
            "force_in" => {
                let components = [("x", Component::X), ("y", Component::Y), ("magnitude", Component::Magnitude)];
                let component = self.beside(table, "component", measure, "\"magnitude\"", &components);
                let text = self.reader.text(&entry)?;
                let name = text.strip_prefix("joint.").unwrap_or(text);
                let joint = self.named(&entry, "joint", name, |file| &file.joint_names)?;
                Some(OutputKind::Force { joint, component: component? })
            }
            "wear_of" => {
                let measures = WearMeasure::ALL.map(|measure| (measure.word(), measure));
                let component = self.beside(table, "component", measure, "\"bearing_volume\"", &measures);
                let text = self.reader.text(&entry)?;
                let name = text.strip_prefix("joint.").unwrap_or(text).to_owned();
                let joint = self.named(&entry, "joint", &name, |file| &file.joint_names)?;
                if self.joints[joint.0].wear.is_none() {
                    let problem = ModelProblem::DoesNotWear { entry: entry.path.describe(), joint: name };
                    return self.reader.refuse(&problem, entry.span);
                }
                Some(OutputKind::Wear { joint, measure: component? })
            }
            "stress_in" => self.stress(&entry),
            "torque_of" => self.effort(&entry, Effort::Torque),
            "force_of" => self.effort(&entry, Effort::Force),
            "power_of" => self.effort(&entry, Effort::Power),
            _ => self.relative_point(table, &entry).map(OutputKind::Path),
        }
    }

    /// The stress of the flexible body that an entry names.
    fn stress(&mut self, entry: &Entry<'_>) -> Option<OutputKind> {
        let body = self.body_of(entry)?;
        let Body { name, beam, .. } = &self.bodies[body.0];
        let (entry_words, name) = (entry.path.describe(), name.clone());
        let is_held = |point| holds_section(&self.joints, &self.drives, PointId { body, point });
        let problem = match beam {
            Some(beam) if beam.is_nodal() && beam.ends.into_iter().all(is_held) => {
                BeamProblem::StressHeldAtBothEnds { entry: entry_words, body: name }
            }
            Some(Beam { height_m: Some(_), .. }) => return Some(OutputKind::Stress(body)),
            Some(_) => BeamProblem::NoHeight { entry: entry_words, body: name },
            // The complaint about its beam is enough.
            None if !self.reader.complaints.is_empty() => return None,
            None => BeamProblem::IsRigid { entry: entry_words, body: name },
        };
        self.reader.refuse(&problem, entry.span)
    }

    /// The point that `entry` names, and the one under `relative_to`.
    fn relative_point(&mut self, table: &Table<'_>, entry: &Entry<'_>) -> Option<Relative<PointId>> {
        let of = self.point(entry);
        let Some(beside) = table.get("relative_to") else { return of.map(Relative::to_ground) };
        let to = self.point(&beside);
        let (of, to) = (of?, to?);
        self.refuse_same_body(&beside, of.body, to.body)?;
        Some(Relative { of, to: Some(to) })
    }

    /// The body that `entry` names, and the one under `relative_to`.
    fn relative_body(&mut self, table: &Table<'_>, entry: &Entry<'_>) -> Option<Relative<BodyId>> {
        let of = self.body_of(entry);
        let Some(beside) = table.get("relative_to") else { return of.map(Relative::to_ground) };
        let to = self.body_of(&beside);
        let (of, to) = (of?, to?);
        self.refuse_same_body(&beside, of, to)?;
        Some(Relative { of, to: Some(to) })
    }

    fn body_of(&mut self, entry: &Entry<'_>) -> Option<BodyId> {
        let name = self.reader.text(entry)?;
        self.body(entry, name)
    }

    /// Complains about what is seen from the body that it belongs to.
    fn refuse_same_body(&mut self, beside: &Entry<'_>, of: BodyId, to: BodyId) -> Option<()> {
        if of != to {
            return Some(());
        }
        let body = self.bodies[to.0].name.clone();
        self.reader.refuse(&ModelProblem::RelativeToItself { entry: beside.path.describe(), body }, beside.span)
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
                let doc = match measure {
                    "force_in" => "the component of the force",
                    "wear_of" => "the measure of wear",
                    _ => "the axis of the ground, or of the body of relative_to",
                };
                let problem = DocumentProblem::MissingKey { table: table.path.describe(), key, example, doc };
                self.reader.refuse(&problem, table.span)
            }
        }
    }

    fn output_unit(&mut self, table: &Table<'_>, kind: &OutputKind) -> Option<ReadableUnit> {
        let due = kind.dimension();
        let Some(entry) = table.get("unit") else {
            // Pressures are read in GPa otherwise, as moduli.
            let of_stress = ReadableUnit::of_dimension("MPa", due).filter(|_| matches!(kind, OutputKind::Stress(_)));
            return Some(of_stress.unwrap_or_else(|| ReadableUnit::default_for(due)));
        };
        let text = self.reader.text(&entry)?;
        let unit = ReadableUnit::of_dimension(text, due);
        if unit.is_none() {
            let problem = ModelProblem::WrongUnit { entry: entry.path.describe(), unit: text.to_owned(), due };
            self.reader.complain(&problem, entry.span);
        }
        unit
    }
}
