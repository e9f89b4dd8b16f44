//! Actuators of controls in the equations of motion.

use crate::dynamics::elements::element_force::ActuatorForce;
use crate::dynamics::equations::Dynamics;
use crate::model::FeedForward;
use loosepin_math::Real;

impl<T: Real> Dynamics<'_, T> {
    /// Actuators at the last evaluation, in the order of the controls of the model.
    pub fn actuators(&self) -> &[ActuatorForce<T>] {
        &self.actuators
    }

    /// Integrals of the errors of all controls at the last evaluation.
    pub fn error_integrals(&self) -> &[T] {
        &self.error_integrals
    }

    /// Integrals of the errors of all controls for the evaluations to come, rad s or m s. Those of controls without an integral
    /// do not matter.
    pub fn error_integrals_mut(&mut self) -> &mut [T] {
        &mut self.error_integrals
    }

    /// Adds the actuators of the controls at the time of the state, and notes their power F q̇.
    #[inline(always)]
    pub(in crate::dynamics) fn add_controls(&mut self) {
        self.controls_w = T::zero();
        let mechanism = self.mechanism;
        let model = &mechanism.model;
        if let Some(inverse) = &mut self.inverse {
            inverse.evaluate(model, &self.sample, self.time_s, &mut self.drive_workspace);
        }
        for (index, control) in model.controls.iter().enumerate() {
            let [actuated, measured] = self.control_places[index];
            let numbers = &self.sample.controls[index];
            let motion = self.sample.references.law_motion(index, self.time_s, &mut self.drive_workspace);
            let [coordinate, speed] = numbers.measured.motion(&measured, &self.kinematics);
            let error = motion[0] - coordinate;
            let mut effort = match (&control.feed_forward, &numbers.feed_forward, &self.inverse) {
                (FeedForward::TimeCourse(course), Some(course_numbers), _) => {
                    course_numbers.value(course, &[self.time_s, coordinate, speed], &mut self.function_workspace)
                }
                (FeedForward::InverseDynamics, _, Some(inverse)) => inverse.effort(model, index),
                _ => T::zero(),
            };
            effort = numbers.proportional.mul_add(error, effort);
            if let Some(integral) = numbers.integral {
                effort = integral.mul_add(self.error_integrals[index], effort);
            }
            if let Some(derivative) = numbers.derivative {
                effort = derivative.mul_add(motion[1] - speed, effort);
            }
            if let Some(limit) = numbers.limit {
                // In this order an effort that is no number stays none.
                effort = (-limit).max(limit.min(effort));
            }
            let rate = numbers.actuated.motion(&actuated, &self.kinematics)[1];
            self.controls_w = effort.mul_add(rate, self.controls_w);
            let joint = numbers.actuated;
            let on_second_n = self.add_effort(&joint, &actuated, effort);
            self.actuators[index] = ActuatorForce { reference: motion[0], error, effort, rate, on_second_n };
        }
    }
}
