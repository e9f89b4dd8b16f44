//! Mechanical advantage by virtual power.

use loosepin_mechanics::mechanism::{IdealMotion, Mechanism};
use loosepin_mechanics::model::{BodyId, Model, Position, Relative};
use loosepin_result::kinematics::MechanicalAdvantage;
use loosepin_text::units::SiUnit;

use super::turning::{Walked, crossings};

/// Speeds below this share of the largest one are round-off of a stand-still; of an output, also those below this share of the speed of the
/// drive, times the size of the mechanism where they are lengths.
const STILL: f64 = 1e-9;

/// An output, or the point of a path, on which the drive acts.
pub struct MovedOutput {
    /// Name of the output or of the path.
    pub name: String,
    /// Unit of its position.
    pub unit: SiUnit,
    /// Its position: one number, or both coordinates of a point.
    pub readings: Vec<Position>,
}

/// Mechanical advantages ω/|v| of all that moves with the only drive. The coordinate of the drive itself has none.
///
/// The smallest one belongs to the largest speed: where d(|v|²/2)/dt = v·a changes its sign, located by the exact motion.
pub fn mechanical_advantages(
    mechanism: &Mechanism,
    moved: &[MovedOutput],
    walked: &Walked<'_, '_>,
    jet: &dyn Fn(&IdealMotion<'_>, Position) -> [f64; 3],
) -> Vec<MechanicalAdvantage> {
    let speed_rad_s = walked.input.speed_rad_s.abs();
    let of = |output: &MovedOutput| {
        let jets =
            |state: &IdealMotion<'_>| output.readings.iter().map(|reading| jet(state, *reading)).collect::<Vec<_>>();
        let speed =
            |state: &IdealMotion<'_>| jets(state).iter().fold(0.0_f64, |speed, [_, rate, _]| speed.hypot(*rate));
        let gain = |state: &IdealMotion<'_>| jets(state).iter().map(|[_, rate, second]| rate * second).sum::<f64>();
        let speeds_si: Vec<f64> = walked.states.iter().map(speed).collect();
        let largest_of_states_si = speeds_si.iter().copied().fold(0.0, f64::max);
        let least_si = STILL * largest_of_states_si;
        let size = if output.unit == SiUnit::ANGLE { 1.0 } else { mechanism.size_m };
        if largest_of_states_si <= STILL * speed_rad_s * size {
            return None;
        }
        let largest_si = crossings(walked, &gain).iter().map(speed).fold(largest_of_states_si, f64::max);
        let advantage = |speed_si: &f64| if *speed_si > least_si { speed_rad_s / speed_si } else { f64::INFINITY };
        Some(MechanicalAdvantage {
            name: output.name.clone(),
            unit: if output.unit == SiUnit::ANGLE { SiUnit::NONE } else { SiUnit::from_symbol("1/m") },
            value_si: speeds_si.iter().map(advantage).collect(),
            least_si: Some(speed_rad_s / largest_si),
        })
    };
    moved.iter().filter(|output| !is_of_drive(&mechanism.model, output)).filter_map(of).collect()
}

/// Whether an output is the angle that the only drive of the model turns.
fn is_of_drive(model: &Model, output: &MovedOutput) -> bool {
    let ([drive], [Position::Angle(Relative { of, to })]) = (&model.drives[..], &output.readings[..]) else {
        return false;
    };
    let driven = model.joints[drive.joint.0].kind.points().map(|point| point.body);
    let seen = [*of, to.unwrap_or(BodyId(0))];
    driven == seen || driven == [seen[1], seen[0]]
}
