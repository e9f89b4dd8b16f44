//! Loads in the equations of motion.

use super::equations::Dynamics;
use crate::math::{Real, Vec2};
use crate::mechanism::points_of;
use crate::model::{Course, JointId, JointKind, LoadKind};

/// What a load does to its body.
#[derive(Debug, Clone, Copy)]
pub struct LoadForce<T> {
    /// Slot of the body.
    pub slot: usize,
    /// Point of attack from the origin of the body, m, in the ground's frame.
    pub arm_m: Vec2<T>,
    /// Force, N, in the ground's frame.
    pub force_n: Vec2<T>,
    /// Torque, N m.
    pub torque_n_m: T,
}

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
            (Course::Function(_), Some(joint)) => self.joint_motion(index, joint),
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

    /// Coordinate and rate of the joint that a load reads: angle of the journal's body from the bearing's, or position s of
    /// the slider along the guide: s = d·e with e from guide point to slider point, ṡ = d·ė + ω d⊥·e.
    #[inline(always)]
    fn joint_motion(&self, load: usize, joint: JointId) -> [T; 2] {
        let kind = &self.mechanism.model.joints[joint.0].kind;
        let [i, j] = points_of(kind).map(|point| self.mechanism.real.slot_of_body[point.body.0]);
        let (poses, twists) = (&self.kinematics.poses, &self.kinematics.twists);
        match kind {
            JointKind::Prismatic { .. } | JointKind::Slot { .. } => {
                let numbers = &self.sample.loads[load];
                let line = poses[i].turn(numbers.joint_line);
                let arms = [poses[i].turn(numbers.joint_arms_m[0]), poses[j].turn(numbers.joint_arms_m[1])];
                let gap = poses[j].position_m + arms[1] - poses[i].position_m - arms[0];
                let gap_rate = twists[j].at(arms[1]) - twists[i].at(arms[0]);
                [line.dot(gap), line.dot(gap_rate) + twists[i].angular * line.turned().dot(gap)]
            }
            _ => [poses[j].angle_rad - poses[i].angle_rad, twists[j].angular - twists[i].angular],
        }
    }
}
