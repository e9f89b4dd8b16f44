//! The turn that a study of a model in space counts by.

use loosepin_mechanics::model::{Cycle, CycleInput, CycleSpan, DriveId};
use loosepin_space::{ModelCycleSpan, SpatialModel};
use loosepin_text::numbers::Values;
use std::f64::consts::TAU;

/// Name of the phase of a cycle that counts no drive.
const PHASE: &str = "cycle";
/// Positions in a turn where a model does not say how many.
const SAMPLES: usize = 36;

/// The cycle of the model. It has no transient: its positions do not depend on what was before.
pub(super) fn cycle(model: &SpatialModel) -> Cycle {
    let (span, samples_per_turn) = match model.cycle {
        Some(cycle) => (
            match cycle.span {
                ModelCycleSpan::Drive(drive) => CycleSpan::Turns(DriveId(drive)),
                ModelCycleSpan::Duration(duration) => CycleSpan::Duration(duration),
            },
            cycle.samples_per_turn,
        ),
        None => (CycleSpan::Turns(DriveId(0)), SAMPLES),
    };
    Cycle { span, transient_turns: 0.0, recorded_turns: 1.0, samples_per_turn }
}

/// The input of the cycle that counts by `span`.
pub(super) fn input(model: &SpatialModel, span: CycleSpan, values: &Values) -> CycleInput {
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
