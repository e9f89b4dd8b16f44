//! Torque, force or power of a drive or control.

use super::kind::{KindOfOutput, KindOfReading, Measure};
use super::reader::OutputReader;
use super::state::OutputState;
use crate::model::ids::Actuator;
use crate::model::problem::ModelProblem;
use crate::model::words::part_names::PartNames;
use loosepin_math::Real;
use loosepin_text::document::{Kind, Table, optional};
use loosepin_text::units::Dimension;

/// Torque, force or power of a drive or control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// The drive or control.
    pub actuator: Actuator,
    /// Which of them.
    pub measure: EffortMeasure,
}

/// A measure of what a drive or control does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EffortMeasure {
    /// Torque on the journal's body of a revolute joint, N m; the bearing's body gets the opposite.
    Torque,
    /// Force on the slider along the guide, or on the pin along its slot, N; the other body gets the opposite.
    Force,
    /// Power that it supplies, W: torque times angular velocity, or force times velocity, of its joint.
    Power,
}

const fn of_actuator(name: &'static str, example: &'static str, doc: &'static str) -> Measure {
    Measure { key: optional(name, Kind::Reference("drive or control"), example, doc), beside: &[] }
}

impl KindOfOutput for Effort {
    const MEASURES: &'static [Measure] = &[
        of_actuator("torque_of", "\"drive.crank\"", "the torque of a drive or control in a revolute joint"),
        of_actuator("force_of", "\"drive.carriage\"", "the force of a drive or control in a prismatic joint or a slot"),
        of_actuator("power_of", "\"control.elbow\"", "the power that a drive or control supplies"),
    ];
    type Reading = Self;

    fn read(measure: &'static str, table: &Table<'_>, reader: &mut dyn OutputReader) -> Option<Self> {
        let entry = table.get(measure)?;
        let actuator = reader.actuator(&entry)?;
        let facts = reader.actuator_facts(actuator);
        let (measure, is_possible) = match measure {
            "torque_of" => (EffortMeasure::Torque, facts.turns),
            "force_of" => (EffortMeasure::Force, !facts.turns),
            "power_of" => (EffortMeasure::Power, true),
            _ => return None,
        };
        if !is_possible {
            let problem = ModelProblem::WrongEffort {
                entry: entry.path.describe(),
                actuator: format!("{} '{}'", facts.what, facts.name),
                joint: reader.joint_name(facts.joint),
                turns: facts.turns,
                text: format!("{}.{}", facts.what, facts.name),
            };
            return reader.document().refuse(&problem, entry.span);
        }
        Some(Self { actuator, measure })
    }

    fn dimension(&self) -> Dimension {
        match self.measure {
            EffortMeasure::Torque => Dimension::TORQUE,
            EffortMeasure::Force => Dimension::FORCE,
            EffortMeasure::Power => Dimension::POWER,
        }
    }

    fn reading(&self) -> Option<Self> {
        Some(*self)
    }
}

impl KindOfReading for Effort {
    const IS_EFFORT: bool = true;

    fn words(&self, names: &dyn PartNames) -> String {
        let part = match self.measure {
            EffortMeasure::Torque => "torque",
            EffortMeasure::Force => "force",
            EffortMeasure::Power => "power",
        };
        format!("{part} of {}", names.actuator(self.actuator))
    }

    fn needs_forces(&self) -> bool {
        true
    }

    #[inline(always)]
    fn value<T: Real>(&self, state: &impl OutputState<T>) -> T {
        let [along, rate] = state.effort_and_rate(self.actuator);
        match self.measure {
            EffortMeasure::Torque | EffortMeasure::Force => along,
            EffortMeasure::Power => along * rate,
        }
    }
}
