//! The way from point to point has no part along an axis of the first marker. In space.
//!
//! Φ = a·d, with ȧ = ω × a of the first body.

use super::form::{CutMotion, CutState, RowAt};
use super::perpendicular::{axis, axis_change};
use crate::model::MarkerAxis;
use loosepin_math::{Geometry, Real, Space, Vec3, Vector};

/// a and d, in the ground's frame.
pub struct Across<T> {
    axis: Vec3<T>,
    gap_m: Vec3<T>,
}

impl<T: Real> Across<T> {
    #[inline(always)]
    pub(super) fn at(state: &CutState<'_, T, Space>, own: MarkerAxis) -> Self {
        Self { axis: axis(state, 0, own), gap_m: state.gap_m }
    }
}

impl<T: Real> RowAt<T, Space> for Across<T> {
    #[inline(always)]
    fn residuals(&self, out: &mut [T]) {
        out[0] = self.axis.inner(self.gap_m);
    }

    #[inline(always)]
    fn rates(&self, velocity: impl FnOnce() -> Vec3<T>, side: usize, spin: Vec3<T>, out: &mut [T]) {
        let along = self.axis.inner(velocity());
        out[0] = if side == 0 { along + Space::triple(spin, self.axis, self.gap_m) } else { along };
    }

    /// ä·d + 2 ȧ·ḋ + a·d̈.
    #[inline(always)]
    fn biases(&self, motion: &CutMotion<T, Space>, out: &mut [T]) {
        let change = axis_change(self.axis, motion.spins[0], motion.spin_rates[0]);
        let twice = T::from_f64(2.0) * Space::swung(motion.spins[0], self.axis).inner(motion.velocity_m_s);
        out[0] = change.inner_plus(self.gap_m, self.axis.inner_plus(motion.acceleration_m_s2, twice));
    }

    #[inline(always)]
    fn force_n(&self, multipliers_n: &[T]) -> Vec3<T> {
        self.axis * multipliers_n[0]
    }
}
