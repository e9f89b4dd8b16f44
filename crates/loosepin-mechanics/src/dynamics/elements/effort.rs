//! Efforts of drives and controls: torque, force and power.

use crate::dynamics::equations::Dynamics;
use crate::model::Actuator;
use loosepin_math::Real;

impl<T: Real> Dynamics<'_, T> {
    /// Effort of a drive or control along the coordinate of its joint, N m or N, and the rate of that coordinate, rad/s or m/s, at
    /// the last evaluation. Their product is the power that it supplies, W.
    ///
    /// It acts on the journal's body or the slider; the bearing's body or the guide gets the opposite. For a drive it is what its
    /// motion needs: inertia minus all applied and constraint forces, taken along the driven coordinate.
    #[inline(always)]
    pub fn effort_and_rate(&self, actuator: Actuator) -> [T; 2] {
        match actuator {
            Actuator::Drive(drive) => {
                let tree = &self.mechanism.real;
                // A driven joint is always in the tree, whose drives are in the order of its links.
                let place = tree.drives.iter().position(|own| *own == drive);
                place.map_or([T::zero(); 2], |k| [self.drive_force(k), self.rates[tree.free + k]])
            }
            Actuator::Control(control) => {
                let force = &self.actuators[control.0];
                [force.effort, force.rate]
            }
        }
    }
}
