//! Springs with their dampers in the equations of motion.

use crate::dynamics::elements::element_force::SpringForce;
use crate::dynamics::elements::linear_spring::linear_spring;
use crate::dynamics::elements::torsional_spring::torsional_spring;
use crate::dynamics::equations::Dynamics;
use crate::model::SpringKind;
use loosepin_math::Real;

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
    pub(in crate::dynamics) fn add_springs(&mut self) {
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
