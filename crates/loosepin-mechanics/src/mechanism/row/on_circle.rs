//! The second point stays on a circle about the first. In the plane.
//!
//! With e from the first point to the second and u = e/|e|, Φ = |e| - R. How the first body turns does not matter.

use super::form::{CutMotion, CutState, RowAt};
use loosepin_math::{Plane, Real, Vec2};

/// u, |e| and Φ.
pub struct OnCircle<T> {
    outwards: Vec2<T>,
    distance_m: T,
    off_m: T,
}

impl<T: Real> OnCircle<T> {
    #[inline(always)]
    pub(super) fn at(state: &CutState<'_, T, Plane>) -> Self {
        let gap_m = state.gap_m;
        // Squares, not products: an interval knows that they are positive.
        let distance_m = (gap_m.x.squared() + gap_m.y.squared()).sqrt().max(T::from_f64(f64::MIN_POSITIVE));
        let outwards = gap_m * (T::one() / distance_m);
        Self { outwards, distance_m, off_m: distance_m - state.numbers.radius_m }
    }
}

impl<T: Real> RowAt<T, Plane> for OnCircle<T> {
    #[inline(always)]
    fn residuals(&self, out: &mut [T]) {
        out[0] = self.off_m;
    }

    #[inline(always)]
    fn rates(&self, velocity: impl FnOnce() -> Vec2<T>, _: usize, _: T, out: &mut [T]) {
        out[0] = self.outwards.dot(velocity());
    }

    /// d²|e|/dt²: what goes round adds its centripetal part.
    #[inline(always)]
    fn biases(&self, motion: &CutMotion<T, Plane>, out: &mut [T]) {
        let around_m_s = self.outwards.cross(motion.velocity_m_s);
        out[0] = self.outwards.dot(motion.acceleration_m_s2) + around_m_s.squared() / self.distance_m;
    }

    #[inline(always)]
    fn force_n(&self, multipliers_n: &[T]) -> Vec2<T> {
        self.outwards * multipliers_n[0]
    }
}
