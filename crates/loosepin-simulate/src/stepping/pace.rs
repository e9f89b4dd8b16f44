//! How fast a mechanism moves, before it has moved: the scale of steps and of the errors of velocities.

use crate::stepping::motion::Motion;
use loosepin_mechanics::mechanism::{CouplingGeometry, Mechanism, Sample};
use loosepin_mechanics::model::{Coupling, DriveId, JointId};

/// Rate of the fastest drive or reference between time zero and `end_s`, rad/s; driven lengths count as angles over the size of the
/// mechanism.
pub fn fastest_drive_rad_s(mechanism: &Mechanism, sample: &Sample<f64>, end_s: f64) -> f64 {
    let model = &mechanism.model;
    let scale = |joint: JointId| if model.joints[joint.0].kind.slides() { mechanism.size_m } else { 1.0 };
    let drives = model.drives.iter().enumerate();
    let drives = drives.map(|(index, drive)| sample.drives.pace_1_s(&drive.law, index, end_s, scale(drive.joint)));
    let controls =
        model.controls.iter().enumerate().map(|(index, control)| {
            sample.references.pace_1_s(&control.reference, index, end_s, scale(control.measured))
        });
    let fastest = drives.chain(controls).fold(0.0, f64::max);
    let is_constant = (0..model.drives.len()).all(|index| sample.drives.constant_speed(DriveId(index)).is_some());
    // What a coupling gears up is as fast as that.
    let gear = |numbers: &CouplingGeometry<f64>, coupling: &Coupling| {
        numbers.law.gain(scale(coupling.first) / scale(coupling.second))
    };
    let gears = sample.ideal.couplings.iter().zip(&model.couplings).map(|(numbers, coupling)| gear(numbers, coupling));
    let fastest = fastest * gears.fold(1.0, f64::max);
    // A motion that only stands still, or no drive: nothing is slower than the run is long.
    if is_constant && fastest > 0.0 { fastest } else { fastest.max(std::f64::consts::TAU / end_s) }
}

/// Estimate of the rates to come, rad/s, from the evaluated start of `motion`: angular velocities, and the roots of angular
/// accelerations; lengths over the size of the mechanism.
pub fn pace_of_start_rad_s(motion: &Motion<'_, f64>) -> f64 {
    let mechanism = motion.dynamics.mechanism();
    let paces = (1..=mechanism.real.links.len()).map(|slot| {
        let (twist, change) = (&motion.dynamics.kinematics.twists[slot], motion.dynamics.acceleration(slot));
        let rate = twist.angular.abs().max(twist.linear.length() / mechanism.size_m);
        rate.max(change.angular.abs().max(change.linear.length() / mechanism.size_m).sqrt())
    });
    paces.fold(0.0, f64::max)
}

/// Kinetic energy of all masses at the speed `rate_1_s` times the size of the mechanism, J.
pub fn energy_at_pace_j(mechanism: &Mechanism, sample: &Sample<f64>, rate_1_s: f64) -> f64 {
    let mass_kg: f64 = sample.real.links.iter().map(|link| link.mass_kg).sum();
    let speed_m_s = rate_1_s * mechanism.size_m;
    0.5 * mass_kg * speed_m_s * speed_m_s
}
