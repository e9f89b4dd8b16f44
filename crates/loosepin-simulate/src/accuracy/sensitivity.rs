//! First-order effect of eccentricities and dimensions on the outputs.

use super::dimension::DimensionDirection;
use super::error::AccuracyError;
use super::loops::DisplacedLoops;
use loosepin_math::{Dual, Vec2};
use loosepin_mechanics::mechanism::{Mechanism, TreeNumbers, numbered_point_m, workspace_length};
use loosepin_mechanics::model::{CycleSpan, DriveId, Position, Values};

/// g_k = d(output)/d(e_k) for each output (outer) and each joint with play (inner), at the present position of `loops`, SI.
/// e_k is the journal's place minus the bearing's, in the ground's frame; of a slider its ordinate and angle in the guide
/// ([`super::PlayReach`]).
///
/// # Errors
/// The position is singular.
pub fn play_gradients(
    loops: &mut DisplacedLoops<'_>,
    readings: &[Position],
) -> Result<Vec<Vec<Vec2<f64>>>, AccuracyError> {
    let plays = loops.displacements().len();
    let mut gradients = vec![vec![Vec2::zero(); plays]; readings.len()];
    for play in 0..plays {
        let along_first = loops.derivatives_along_play(play, Vec2::new(1.0, 0.0), readings)?;
        let along_second = loops.derivatives_along_play(play, Vec2::new(0.0, 1.0), readings)?;
        for (gradient, (x, y)) in gradients.iter_mut().zip(along_first.into_iter().zip(along_second)) {
            gradient[play] = Vec2::new(x, y);
        }
    }
    Ok(gradients)
}

/// d(output)/d(quantity) for each output, at the present position of `loops`, which is reached at `time_s`. The input of a
/// cycle that counts by `span` is held; drives follow at the time at which it is the same.
///
/// # Errors
/// The position is singular.
pub fn dimension_derivatives(
    loops: &mut DisplacedLoops<'_>,
    mechanism: &Mechanism,
    values: &Values,
    direction: &DimensionDirection,
    span: CycleSpan,
    time_s: f64,
    readings: &[Position],
) -> Result<Vec<f64>, AccuracyError> {
    let (model, tree) = (&mechanism.model, &mechanism.ideal);
    let number = |id| Dual { value: values[id], derivative: direction.derivatives[id] };
    let geometry = TreeNumbers::from_numbers(model, tree, &number);
    let mut workspace = vec![Dual::constant(Dual::constant(Dual::constant(0.0))); workspace_length(model)];
    let mut motion = |drive: DriveId| {
        let law = &model.drives[drive.0].law;
        let [position, velocity, _] = law.motion(&number, time_s).at(Dual::constant(time_s), &mut workspace);
        [position.derivative, velocity.value]
    };
    // What the time must change by to hold the input: an angle of a drive, or a share of the period.
    let delay_s = match (span, model.period_s(span, &number)) {
        (CycleSpan::Turns(held), _) => {
            let [change, velocity] = motion(held);
            -change / velocity
        }
        (_, Some(period_s)) => time_s * period_s.derivative / period_s.value,
        (_, None) => 0.0,
    };
    let driven: Vec<f64> = tree
        .drives
        .iter()
        .map(|&drive| {
            let [change, velocity] = motion(drive);
            if span == CycleSpan::Turns(drive) { 0.0 } else { change + velocity * delay_s }
        })
        .collect();
    loops.derivatives(&geometry, &driven, readings, &|point| numbered_point_m(model, &number, point))
}
