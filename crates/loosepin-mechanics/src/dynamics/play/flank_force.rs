//! Couplings with play, and efforts along the coordinates of joints, in the equations of motion.

use crate::dynamics::equations::Dynamics;
use crate::dynamics::play::flanks::shares;
use crate::mechanism::{Flanks, JointGeometry, JointPlace};
use loosepin_math::{Real, Vec2};

impl<T: Real> Dynamics<'_, T> {
    /// ẍ of the coupling with play `play` at the last evaluation.
    #[inline(never)]
    pub(in crate::dynamics) fn flank_acceleration_m_s2(&self, flanks: &Flanks<T>) -> T {
        flanks.coupling.lever
            * flanks.coupling.acceleration(
                &flanks.places,
                &self.kinematics,
                #[inline(always)]
                |slot| self.acceleration(slot),
            )
    }

    /// Adds the force `force_n` along x of the coupling with play `play`.
    #[inline(never)]
    pub(in crate::dynamics) fn add_flank_force(&mut self, play: usize, force_n: T) {
        let Some(flanks) = self.sample.plays[play].shape.flanks() else { return };
        let (shares, joints, places) = (shares(&self.kinematics, flanks), flanks.coupling.joints, flanks.places);
        for side in [0, 1] {
            self.add_effort(&joints[side], &places[side], shares[side] * force_n);
        }
    }

    /// Adds a torque or force `effort` along the coordinate of a joint; gives the force on its second body, N.
    #[inline(always)]
    pub(in crate::dynamics) fn add_effort(
        &mut self,
        joint: &JointGeometry<T>,
        place: &JointPlace,
        effort: T,
    ) -> Vec2<T> {
        let [i, j] = place.slots;
        if place.is_prismatic {
            let (arms_m, line) = joint.line_of_action(place, &self.kinematics);
            let on_second_n = line * effort;
            self.add_force(i, arms_m[0], -on_second_n, T::zero());
            self.add_force(j, arms_m[1], on_second_n, T::zero());
            on_second_n
        } else {
            self.add_force(i, Vec2::zero(), Vec2::zero(), -effort);
            self.add_force(j, Vec2::zero(), Vec2::zero(), effort);
            Vec2::zero()
        }
    }
}
