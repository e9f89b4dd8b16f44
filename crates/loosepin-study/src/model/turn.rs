//! The turn that a study counts by.

use super::StudyModel;
use loosepin_mechanics::model::{Cycle, CycleInput, CycleSpan, DriveId};
use loosepin_space::ModelCycleSpan;
use loosepin_text::numbers::Values;
use std::f64::consts::TAU;

/// Name of the phase of a cycle that counts no drive.
const PHASE: &str = "cycle";
/// Positions in a turn where a model in space does not say how many.
const SPATIAL_SAMPLES: usize = 36;

impl StudyModel {
    /// The cycle of the model. One in space has no transient: its positions do not depend on what was before.
    pub fn cycle(&self) -> Cycle {
        let model = match self {
            Self::Planar(model) => return model.cycle.clone(),
            Self::Spatial(model) => model,
        };
        let (span, samples_per_turn) = match model.cycle {
            Some(cycle) => (
                match cycle.span {
                    ModelCycleSpan::Drive(drive) => CycleSpan::Turns(DriveId(drive)),
                    ModelCycleSpan::Duration(duration) => CycleSpan::Duration(duration),
                },
                cycle.samples_per_turn,
            ),
            None => (CycleSpan::Turns(DriveId(0)), SPATIAL_SAMPLES),
        };
        Cycle { span, transient_turns: 0.0, recorded_turns: 1.0, samples_per_turn }
    }

    /// The input of the cycle that counts by `span`.
    pub fn input(&self, span: CycleSpan, values: &Values) -> CycleInput {
        let model = match self {
            Self::Planar(model) => return model.input(span, values),
            Self::Spatial(model) => model,
        };
        let drive = match span {
            CycleSpan::Turns(drive) | CycleSpan::Periods(drive) => model.drives.get(drive.0),
            CycleSpan::Duration(_) => None,
        };
        match (drive, span) {
            (Some(drive), _) => CycleInput {
                name: drive.name.clone(),
                is_drive: true,
                start_rad: values[drive.start],
                speed_rad_s: values[drive.speed],
            },
            (None, CycleSpan::Duration(duration)) => {
                let speed_rad_s = TAU / values[duration];
                CycleInput { name: PHASE.to_owned(), is_drive: false, start_rad: 0.0, speed_rad_s }
            }
            (None, _) => CycleInput { name: PHASE.to_owned(), is_drive: false, start_rad: 0.0, speed_rad_s: 0.0 },
        }
    }

    /// The input of the model's own cycle.
    pub fn cycle_input(&self, values: &Values) -> CycleInput {
        self.input(self.cycle().span, values)
    }
}
