//! An axis of the first marker is at a right angle to one of the second. In space.
//!
//! Φ = a·b, with ȧ = ω_i × a and ḃ = ω_j × b: dΦ = (ω_i - ω_j)·(a × b).

use super::form::{CutMotion, CutState, RowAt};
use crate::model::MarkerAxis;
use loosepin_math::{Geometry, Real, Space, Vec3, Vector};

/// a, b and a × b, in the ground's frame.
pub struct Perpendicular<T> {
    axes: [Vec3<T>; 2],
    across: Vec3<T>,
}

/// An axis of the marker of the first body or the second, in the ground's frame.
#[inline(always)]
pub(super) fn axis<T: Real>(state: &CutState<'_, T, Space>, side: usize, axis: MarkerAxis) -> Vec3<T> {
    let marker = &state.numbers.markers[side];
    let own = match axis {
        MarkerAxis::X => marker.x,
        MarkerAxis::Y => marker.y,
        MarkerAxis::Z => marker.z,
    };
    state.poses[side].turn(own)
}

/// Second derivative of an axis that is carried round: α × a + ω × (ω × a).
#[inline(always)]
pub(super) fn axis_change<T: Real>(axis: Vec3<T>, spin: Vec3<T>, spin_rate: Vec3<T>) -> Vec3<T> {
    Space::centripetal(Space::swung(spin_rate, axis), spin, axis)
}

impl<T: Real> Perpendicular<T> {
    #[inline(always)]
    pub(super) fn at(state: &CutState<'_, T, Space>, axes: [MarkerAxis; 2]) -> Self {
        let axes = [axis(state, 0, axes[0]), axis(state, 1, axes[1])];
        Self { axes, across: Space::swung(axes[0], axes[1]) }
    }
}

impl<T: Real> RowAt<T, Space> for Perpendicular<T> {
    #[inline(always)]
    fn residuals(&self, out: &mut [T]) {
        out[0] = self.axes[0].inner(self.axes[1]);
    }

    #[inline(always)]
    fn rates(&self, _: impl FnOnce() -> Vec3<T>, side: usize, spin: Vec3<T>, out: &mut [T]) {
        let turned = spin.inner(self.across);
        out[0] = if side == 0 { turned } else { -turned };
    }

    /// ä·b + 2 ȧ·ḃ + a·b̈.
    #[inline(always)]
    fn biases(&self, motion: &CutMotion<T, Space>, out: &mut [T]) {
        let [a, b] = self.axes;
        let rates = [0, 1].map(|side| Space::swung(motion.spins[side], self.axes[side]));
        let changes = [0, 1].map(|side| axis_change(self.axes[side], motion.spins[side], motion.spin_rates[side]));
        let twice = T::from_f64(2.0) * rates[0].inner(rates[1]);
        out[0] = changes[0].inner_plus(b, changes[1].inner_plus(a, twice));
    }

    /// A couple alone.
    #[inline(always)]
    fn force_n(&self, _: &[T]) -> Vec3<T> {
        Vec3::zero()
    }
}
