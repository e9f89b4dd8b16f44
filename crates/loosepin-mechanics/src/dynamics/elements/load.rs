//! Loads in the equations of motion.

use crate::dynamics::elements::element_force::LoadForce;
use crate::dynamics::equations::Dynamics;
use crate::mechanism::{JointPlace, Pose, Twist};
use crate::model::{LoadPlace, Push, TimeCourse};
use loosepin_math::{Real, Vec2};

impl<T: Real> Dynamics<'_, T> {
    /// Loads at the last evaluation, in the order of the model.
    pub fn loads(&self) -> &[LoadForce<T>] {
        &self.loads
    }

    /// Adds the loads at the time of the state, and notes their power F·v + M ω.
    #[inline(always)]
    pub(in crate::dynamics) fn add_loads(&mut self) {
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
            (Some(TimeCourse::Function(_) | TimeCourse::Table(_)), Some(joint)) => {
                let place = JointPlace::new(&self.mechanism.model, &self.mechanism.real, joint);
                self.sample.loads[index].joint.motion(&place, &self.kinematics)
            }
            _ => [T::zero(); 2],
        };
        let numbers = &self.sample.loads[index];
        let size = match (&numbers.course, &load.course) {
            (Some(numbers), Some(course)) => {
                numbers.value(course, &[self.time_s, coordinate, rate], &mut self.function_workspace)
            }
            // It has no size.
            (None, _) | (_, None) => T::zero(),
        };
        let (pose, twist) = (&self.kinematics.poses[slot], &self.kinematics.twists[slot]);
        let Push { arm_m, force_n, torque_n_m } =
            load.kind.push(&numbers.own, size, &LoadAtState { pose, twist, arm_m: numbers.arm_m });
        LoadForce { slot, arm_m, force_n, torque_n_m }
    }
}

/// The place of a load at the current state.
struct LoadAtState<'s, T: Real> {
    pose: &'s Pose<T>,
    twist: &'s Twist<T>,
    /// The point that it acts on, in the frame of the body, m.
    arm_m: Vec2<T>,
}

impl<T: Real> LoadPlace<T> for LoadAtState<'_, T> {
    #[inline(always)]
    fn turned(&self, vector: Vec2<T>) -> Vec2<T> {
        self.pose.turn(vector)
    }

    #[inline(always)]
    fn arm_m(&self) -> Vec2<T> {
        self.pose.turn(self.arm_m)
    }

    #[inline(always)]
    fn velocity_m_s(&self, arm_m: Vec2<T>) -> Vec2<T> {
        self.twist.at(arm_m)
    }
}
