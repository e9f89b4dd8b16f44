//! One row: the second point stays on a circle about the first.
//!
//! With e from the first point to the second and u = e/|e|, Φ = |e| - R. How the first body turns does not matter.

use super::form::PointRows;
use crate::mechanism::tree::cut_geometry::CutGeometry;
use loosepin_math::{Real, Vec2};

/// u, |e| and Φ.
pub struct OnCircle<T> {
    outwards: Vec2<T>,
    distance_m: T,
    off_m: T,
}

impl<T: Real> PointRows<T> for OnCircle<T> {
    #[inline(always)]
    fn at(numbers: &CutGeometry<T>, _first_angle_rad: T, gap_m: Vec2<T>) -> Self {
        // Squares, not products: an interval knows that they are positive.
        let distance_m = (gap_m.x.squared() + gap_m.y.squared()).sqrt().max(T::from_f64(f64::MIN_POSITIVE));
        Self { outwards: gap_m * (T::one() / distance_m), distance_m, off_m: distance_m - numbers.radius_m }
    }

    #[inline(always)]
    fn residuals(&self) -> [T; 2] {
        [self.off_m, T::zero()]
    }

    #[inline(always)]
    fn rates(&self, velocity: Vec2<T>, _spin: Option<T>) -> [T; 2] {
        [self.outwards.dot(velocity), T::zero()]
    }

    /// d²|e|/dt²: what goes round adds its centripetal part.
    #[inline(always)]
    fn biases(&self, velocity_m_s: Vec2<T>, acceleration_m_s2: Vec2<T>, _spins: [T; 2]) -> [T; 2] {
        let around_m_s = self.outwards.cross(velocity_m_s);
        [self.outwards.dot(acceleration_m_s2) + around_m_s.squared() / self.distance_m, T::zero()]
    }

    #[inline(always)]
    fn force_n(&self, [outwards_n, _]: [T; 2]) -> Vec2<T> {
        self.outwards * outwards_n
    }

    /// By a length outwards, m.
    fn displace(numbers: &mut CutGeometry<T>, displacement: Vec2<T>, centred: &CutGeometry<T>) {
        numbers.radius_m = centred.radius_m + displacement.x;
    }
}
