//! Actuators of controls in the equations of motion.

use super::element_force::ActuatorForce;
use super::equations::Dynamics;
use crate::model::FeedForward;
use loosepin_math::{Real, Vec2};

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
    pub(super) fn add_controls(&mut self) {
        self.controls_w = T::zero();
        let mechanism = self.mechanism;
        let model = &mechanism.model;
        if let Some(inverse) = &mut self.inverse {
            inverse.evaluate(model, &self.sample, self.time_s, &mut self.drive_room);
        }
        for (index, control) in model.controls.iter().enumerate() {
            let [actuated, measured] = self.control_places[index];
            let numbers = &self.sample.controls[index];
            let motion =
                self.sample.references.law_motion(&control.reference, index, self.time_s, &mut self.drive_room);
            let [coordinate, speed] = numbers.measured.motion(&measured, &self.kinematics);
            let error = motion[0] - coordinate;
            let mut effort = match (&control.feed_forward, &numbers.feed_forward, &self.inverse) {
                (FeedForward::Course(course), Some(course_numbers), _) => {
                    course_numbers.value(course, &[self.time_s, coordinate, speed], &mut self.function_room)
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
            let mut on_second_n = Vec2::zero();
            let [i, j] = actuated.slots;
            if actuated.is_prismatic {
                let (arms_m, line) = numbers.actuated.line_of_action(&actuated, &self.kinematics);
                on_second_n = line * effort;
                self.add_force(i, arms_m[0], -on_second_n, T::zero());
                self.add_force(j, arms_m[1], on_second_n, T::zero());
            } else {
                self.add_force(i, Vec2::zero(), Vec2::zero(), -effort);
                self.add_force(j, Vec2::zero(), Vec2::zero(), effort);
            }
            self.actuators[index] = ActuatorForce { reference: motion[0], error, effort, rate, on_second_n };
        }
    }
}
