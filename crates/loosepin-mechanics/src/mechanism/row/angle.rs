//! The bodies do not turn against each other. In the plane.
//!
//! With the angle θ of the second body from where it should stand, Φ = sin θ: a turn more changes nothing.

use super::form::{CutMotion, CutState, RowAt};
use crate::mechanism::tree::cut_numbers::CutNumbers;
use crate::mechanism::tree::kinematics::Pose;
use loosepin_math::{Plane, Real, Vec2};

/// Sine and cosine of θ.
pub struct Angle<T> {
    sine: T,
    cosine: T,
}

/// θ, rad.
#[inline(always)]
pub(in crate::mechanism) fn turn_rad<T: Real>(numbers: &CutNumbers<T>, poses: [&Pose<T>; 2]) -> T {
    poses[1].angle_rad() + numbers.markers[1] - poses[0].angle_rad() - numbers.markers[0]
}

impl<T: Real> Angle<T> {
    #[inline(always)]
    pub(super) fn at(state: &CutState<'_, T, Plane>) -> Self {
        let (sine, cosine) = turn_rad(state.numbers, state.poses).sin_cos();
        Self { sine, cosine }
    }
}

impl<T: Real> RowAt<T, Plane> for Angle<T> {
    #[inline(always)]
    fn residuals(&self, out: &mut [T]) {
        out[0] = self.sine;
    }

    #[inline(always)]
    fn rates(&self, _: impl FnOnce() -> Vec2<T>, side: usize, spin: T, out: &mut [T]) {
        let sign = if side == 0 { -T::one() } else { T::one() };
        out[0] = spin * sign * self.cosine;
    }

    #[inline(always)]
    fn biases(&self, motion: &CutMotion<T, Plane>, out: &mut [T]) {
        let spin = motion.spins[1] - motion.spins[0];
        out[0] = self.cosine * (motion.spin_rates[1] - motion.spin_rates[0]) - self.sine * spin.squared();
    }

    /// A couple alone.
    #[inline(always)]
    fn force_n(&self, _: &[T]) -> Vec2<T> {
        Vec2::zero()
    }
}
