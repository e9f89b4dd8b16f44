//! The poses of a mechanism that actuators move: those of its own run without play.

use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::Values;
use loosepin_result::simulation::Drawing;

use crate::ideal::reference::IdealReference;
use crate::recording::drawing::{add_pose, skeleton};
use crate::settings::Settings;

/// The mechanism at `positions` + 1 instants of its cycle, moved by its actuators, without play.
///
/// # Errors
/// Why it cannot be followed, in words.
pub fn controlled_drawing(mechanism: &Mechanism, values: &Values, positions: usize) -> Result<Drawing, String> {
    let without_play = mechanism.without_play();
    let sample = Sample::new(mechanism, values).map_err(|error| error.to_string())?.without_play();
    let input = mechanism.model.input(mechanism.model.cycle.span, values);
    let mut reference = IdealReference::new(&without_play, &sample, input.turn_s(), &Settings::for_simulation())
        .map_err(|failure| failure.to_string())?;
    let mut drawing = skeleton(mechanism, values);
    for position in 0..=positions {
        let time_s = input.turn_s() * position as f64 / positions as f64;
        let dynamics = reference.at(time_s, false).map_err(|error| error.to_string())?;
        add_pose(&mut drawing.poses, &without_play.real, &dynamics.kinematics, input.angle_rad(time_s));
    }
    Ok(drawing)
}
