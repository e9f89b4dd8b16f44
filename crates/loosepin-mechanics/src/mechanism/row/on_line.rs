//! The second point stays on a line fixed to the first body. In the plane.
//!
//! With the line's direction d, its normal n = d⊥ and e from the first point to the second, Φ = n·e. Both turn with the first body:
//! dn/dt = -ω d, dd/dt = ω n.

use super::form::{CutMotion, CutState, RowAt};
use loosepin_math::{Plane, Real, Vec2};

/// Directions along and across the line in the ground's frame, and e.
pub struct OnLine<T> {
    line: Vec2<T>,
    normal: Vec2<T>,
    gap_m: Vec2<T>,
}

impl<T: Real> OnLine<T> {
    #[inline(always)]
    pub(super) fn at(state: &CutState<'_, T, Plane>) -> Self {
        let (sine, cosine) = (state.poses[0].angle_rad() + state.numbers.markers[0]).sin_cos();
        let (line, normal) = (Vec2::new(cosine, sine), Vec2::new(-sine, cosine));
        Self { line, normal, gap_m: state.gap_m }
    }
}

impl<T: Real> RowAt<T, Plane> for OnLine<T> {
    #[inline(always)]
    fn residuals(&self, out: &mut [T]) {
        out[0] = self.normal.dot(self.gap_m);
    }

    #[inline(always)]
    fn rates(&self, velocity: impl FnOnce() -> Vec2<T>, side: usize, spin: T, out: &mut [T]) {
        let across = self.normal.dot(velocity());
        out[0] = if side == 0 { across - spin * self.line.dot(self.gap_m) } else { across };
    }

    /// Second derivative of n·e.
    #[inline(always)]
    fn biases(&self, motion: &CutMotion<T, Plane>, out: &mut [T]) {
        let (spin_rad_s, spin_rate_rad_s2) = (motion.spins[0], motion.spin_rates[0]);
        out[0] = self.normal.dot(motion.acceleration_m_s2)
            - T::from_f64(2.0) * spin_rad_s * self.line.dot(motion.velocity_m_s)
            - spin_rate_rad_s2 * self.line.dot(self.gap_m)
            - spin_rad_s.squared() * self.normal.dot(self.gap_m);
    }

    #[inline(always)]
    fn force_n(&self, multipliers_n: &[T]) -> Vec2<T> {
        self.normal * multipliers_n[0]
    }
}
