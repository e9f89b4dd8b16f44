//! Loads in the equations of motion.

use super::element_force::LoadForce;
use super::equations::Dynamics;
use crate::mechanism::JointPlace;
use crate::model::{Course, LoadKind};
use loosepin_math::{Real, Vec2};

impl<T: Real> Dynamics<'_, T> {
    /// Loads at the last evaluation, in the order of the model.
    pub fn loads(&self) -> &[LoadForce<T>] {
        &self.loads
    }

    /// Adds the loads at the time of the state, and notes their power F·v + M ω.
    #[inline(always)]
    pub(super) fn add_loads(&mut self) {
        self.loads_w = T::zero();
        for index in 0..self.loads.len() {
            let force = self.load_force(index);
            self.loads[index] = force;
            self.add_force(force.slot, force.arm_m, force.force_n, force.torque_n_m);
            let twist = &self.kinematics.twists[force.slot];
            self.loads_w += force.force_n.dot(twist.at(force.arm_m)) + force.torque_n_m * twist.angular;
        }
    }

    #[inline(always)]
    fn load_force(&mut self, index: usize) -> LoadForce<T> {
        let load = &self.mechanism.model.loads[index];
        let slot = self.loads[index].slot;
        let [coordinate, rate] = match (&load.course, load.joint) {
            (Course::Function(_) | Course::Table(_), Some(joint)) => {
                let place = JointPlace::new(&self.mechanism.model, &self.mechanism.real, joint);
                self.sample.loads[index].joint.motion(&place, &self.kinematics)
            }
            _ => [T::zero(); 2],
        };
        let numbers = &self.sample.loads[index];
        let size = numbers.course.value(&load.course, &[self.time_s, coordinate, rate], &mut self.function_room);
        let pose = &self.kinematics.poses[slot];
        match load.kind {
            LoadKind::Force { follows_body, .. } => {
                let direction = if follows_body { pose.turn(numbers.direction) } else { numbers.direction };
                let arm_m = pose.turn(numbers.arm_m);
                LoadForce { slot, arm_m, force_n: direction * size, torque_n_m: T::zero() }
            }
            LoadKind::Torque { .. } => LoadForce { slot, arm_m: Vec2::zero(), force_n: Vec2::zero(), torque_n_m: size },
        }
    }
}
