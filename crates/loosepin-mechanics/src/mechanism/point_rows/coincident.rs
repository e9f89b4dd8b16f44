//! Two rows: the points coincide, x and y.

use super::form::PointRows;
use crate::mechanism::tree::cut_geometry::CutGeometry;
use loosepin_math::{Real, Vec2};

/// The way from the first point to the second less the eccentricity, m.
pub struct Coincident<T>(Vec2<T>);

impl<T: Real> PointRows<T> for Coincident<T> {
    #[inline(always)]
    fn at(numbers: &CutGeometry<T>, _first_angle_rad: T, gap_m: Vec2<T>) -> Self {
        Self(gap_m - numbers.eccentricity_m)
    }

    #[inline(always)]
    fn residuals(&self) -> [T; 2] {
        [self.0.x, self.0.y]
    }

    #[inline(always)]
    fn rates(&self, velocity: Vec2<T>, _spin: Option<T>) -> [T; 2] {
        [velocity.x, velocity.y]
    }

    #[inline(always)]
    fn biases(&self, _velocity_m_s: Vec2<T>, acceleration_m_s2: Vec2<T>, _spins: [T; 2]) -> [T; 2] {
        [acceleration_m_s2.x, acceleration_m_s2.y]
    }

    #[inline(always)]
    fn force_n(&self, [x_n, y_n]: [T; 2]) -> Vec2<T> {
        Vec2::new(x_n, y_n)
    }

    /// By an eccentricity in the ground's frame.
    fn displace(numbers: &mut CutGeometry<T>, displacement: Vec2<T>, _centred: &CutGeometry<T>) {
        numbers.eccentricity_m = displacement;
    }
}
