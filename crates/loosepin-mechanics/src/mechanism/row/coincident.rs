//! The points coincide: a row for each coordinate of the ground.

use super::form::{CutMotion, CutState, RowAt};
use crate::mechanism::attachment::TreeGeometry;
use loosepin_math::{Geometry, Real, Vector};

/// The way from the first point to the second less the eccentricity, m.
pub struct Coincident<T: Real, G: Geometry>(G::Vector<T>);

impl<T: Real, G: Geometry> Coincident<T, G> {
    #[inline(always)]
    pub(super) fn at(state: &CutState<'_, T, G>) -> Self {
        Self(state.gap_m - state.numbers.eccentricity_m)
    }
}

impl<T: Real, G: TreeGeometry> RowAt<T, G> for Coincident<T, G> {
    #[inline(always)]
    fn residuals(&self, out: &mut [T]) {
        self.0.write(out);
    }

    #[inline(always)]
    fn rates(&self, velocity: impl FnOnce() -> G::Vector<T>, _: usize, _: G::Spin<T>, out: &mut [T]) {
        velocity().write(out);
    }

    #[inline(always)]
    fn biases(&self, motion: &CutMotion<T, G>, out: &mut [T]) {
        motion.acceleration_m_s2.write(out);
    }

    #[inline(always)]
    fn force_n(&self, multipliers_n: &[T]) -> G::Vector<T> {
        G::position(multipliers_n)
    }
}
