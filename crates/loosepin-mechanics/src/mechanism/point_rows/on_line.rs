//! One row: the second point stays on a line fixed to the first body.
//!
//! With the line's direction d, its normal n = d⊥ and e from the first point to the second, Φ = n·e. Both turn with the first body:
//! dn/dt = -ω d, dd/dt = ω n.

use super::form::PointRows;
use crate::mechanism::tree::cut_geometry::CutGeometry;
use crate::mechanism::tree::points::direction;
use loosepin_math::{Real, Vec2};

/// Directions along and across the line in the ground's frame, and e.
pub struct OnLine<T> {
    line: Vec2<T>,
    normal: Vec2<T>,
    gap_m: Vec2<T>,
}

impl<T: Real> PointRows<T> for OnLine<T> {
    #[inline(always)]
    fn at(numbers: &CutGeometry<T>, first_angle_rad: T, gap_m: Vec2<T>) -> Self {
        let (sine, cosine) = (first_angle_rad + numbers.angles_rad[0]).sin_cos();
        Self { line: Vec2::new(cosine, sine), normal: Vec2::new(-sine, cosine), gap_m }
    }

    #[inline(always)]
    fn residuals(&self) -> [T; 2] {
        [self.normal.dot(self.gap_m), T::zero()]
    }

    #[inline(always)]
    fn rates(&self, velocity: Vec2<T>, spin: Option<T>) -> [T; 2] {
        let across = self.normal.dot(velocity);
        [spin.map_or(across, |spin| across - spin * self.line.dot(self.gap_m)), T::zero()]
    }

    /// Second derivative of n·e.
    #[inline(always)]
    fn biases(
        &self,
        velocity_m_s: Vec2<T>,
        acceleration_m_s2: Vec2<T>,
        [spin_rad_s, spin_rate_rad_s2]: [T; 2],
    ) -> [T; 2] {
        let bias = self.normal.dot(acceleration_m_s2)
            - T::from_f64(2.0) * spin_rad_s * self.line.dot(velocity_m_s)
            - spin_rate_rad_s2 * self.line.dot(self.gap_m)
            - spin_rad_s.squared() * self.normal.dot(self.gap_m);
        [bias, T::zero()]
    }

    #[inline(always)]
    fn force_n(&self, [across_n, _]: [T; 2]) -> Vec2<T> {
        self.normal * across_n
    }

    /// By an ordinate across the line, m, and an angle, rad.
    fn displace(numbers: &mut CutGeometry<T>, displacement: Vec2<T>, centred: &CutGeometry<T>) {
        let Vec2 { x: ordinate_m, y: tilt_rad } = displacement;
        numbers.arms_m[0] = centred.arms_m[0].plus(direction(numbers.angles_rad[0]).turned(), ordinate_m);
        numbers.angles_rad[1] = centred.angles_rad[1] - tilt_rad;
    }
}
