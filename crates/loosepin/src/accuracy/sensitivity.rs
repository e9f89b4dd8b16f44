//! First-order effect of eccentricities and dimensions on the outputs.

use super::dimension::DimensionDirection;
use super::error::AccuracyError;
use super::loops::DisplacedLoops;
use super::position::PositionReading;
use crate::math::{Dual, Vec2};
use crate::mechanism::{Geometry, Mechanism, numbered_point_m};
use crate::model::{DriveId, Values};

/// g_k = d(output)/d(e_k) for each output (outer) and each joint with play (inner), at the present position of `loops`:
/// m/m or rad/m. e_k is the journal's place minus the bearing's, in the ground's frame.
///
/// # Errors
/// The position is singular.
pub fn eccentricity_gradients(
    loops: &mut DisplacedLoops<'_>,
    readings: &[PositionReading],
) -> Result<Vec<Vec<Vec2<f64>>>, AccuracyError> {
    let plays = loops.eccentricities_m().len();
    let mut gradients = vec![vec![Vec2::zero(); plays]; readings.len()];
    for play in 0..plays {
        let along_x = loops.derivatives_along_journal(play, Vec2::new(1.0, 0.0), readings)?;
        let along_y = loops.derivatives_along_journal(play, Vec2::new(0.0, 1.0), readings)?;
        for (gradient, (x, y)) in gradients.iter_mut().zip(along_x.into_iter().zip(along_y)) {
            gradient[play] = Vec2::new(x, y);
        }
    }
    Ok(gradients)
}

/// d(output)/d(quantity) for each output, at the present position of `loops`, which is reached at `time_s`. The angle of
/// the drive `input` is held; other drives follow at the time at which it has that angle.
///
/// # Errors
/// The position is singular.
pub fn dimension_derivatives(
    loops: &mut DisplacedLoops<'_>,
    mechanism: &Mechanism,
    values: &Values,
    direction: &DimensionDirection,
    input: DriveId,
    time_s: f64,
    readings: &[PositionReading],
) -> Result<Vec<f64>, AccuracyError> {
    let (model, tree) = (&mechanism.model, &mechanism.ideal);
    let number = |id| Dual { value: values[id], derivative: direction.derivatives[id] };
    let geometry = Geometry::from_numbers(model, tree, &number);
    let change = |id| direction.derivatives[id];
    // The input's angle start + speed·t is held: dt = -(d start + t d speed)/speed.
    let held = &model.drives[input.0];
    let delay_s = -(change(held.start) + time_s * change(held.speed)) / values[held.speed];
    let driven: Vec<f64> = tree
        .drives
        .iter()
        .map(|&id| {
            if id == input {
                return 0.0;
            }
            let drive = &model.drives[id.0];
            change(drive.start) + time_s * change(drive.speed) + values[drive.speed] * delay_s
        })
        .collect();
    loops.derivatives(&geometry, &driven, readings, &|point| numbered_point_m(model, &number, point))
}
