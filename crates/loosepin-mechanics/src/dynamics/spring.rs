//! Springs with their dampers in the equations of motion.

use super::equations::Dynamics;
use super::linear_spring::linear_spring;
use super::torsional_spring::torsional_spring;
use crate::model::SpringKind;
use loosepin_math::{Real, Vec2};

/// What a spring does to its two bodies.
#[derive(Debug, Clone, Copy)]
pub struct SpringForce<T> {
    /// Its ends from the origins of the bodies, m, in the ground's frame.
    pub arms_m: [Vec2<T>; 2],
    /// Force on the second body, N, in the ground's frame; the first gets the opposite.
    pub on_second_n: Vec2<T>,
    /// Torque on the second body, N m; the first gets the opposite.
    pub moment_on_second_n_m: T,
    /// Stored energy, J.
    pub stored_j: T,
    /// Power that the damper turns into heat, W.
    pub damping_loss_w: T,
}

impl<T: Real> Dynamics<'_, T> {
    /// The force of spring `index` of the model at the last state that was set.
    #[inline(always)]
    pub fn spring_force(&self, index: usize) -> SpringForce<T> {
        let (slots, numbers) = (self.spring_slots[index], &self.sample.springs[index]);
        match self.mechanism.model.springs[index].kind {
            SpringKind::Linear { .. } => linear_spring(&self.kinematics, slots, numbers),
            SpringKind::Torsional { .. } => torsional_spring(&self.kinematics, slots, numbers),
        }
    }

    /// Slots of the first and second bodies of the springs.
    pub fn spring_slots(&self) -> &[[usize; 2]] {
        &self.spring_slots
    }

    /// Adds the forces of the springs, and notes what their dampers lose.
    #[inline(always)]
    pub(super) fn add_springs(&mut self) {
        self.damping_loss_w = T::zero();
        for index in 0..self.spring_slots.len() {
            let force = self.spring_force(index);
            let [i, j] = self.spring_slots[index];
            self.add_force(i, force.arms_m[0], -force.on_second_n, -force.moment_on_second_n_m);
            self.add_force(j, force.arms_m[1], force.on_second_n, force.moment_on_second_n_m);
            self.damping_loss_w += force.damping_loss_w;
        }
    }
}
