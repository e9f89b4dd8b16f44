//! The interface of a form of rows.

use crate::mechanism::tree::cut_geometry::CutGeometry;
use loosepin_math::{Real, Vec2};

/// A form of constraint rows at a state. Of a form with one row the second entries are zero.
pub trait PointRows<T: Real>: Sized {
    /// At a state: the angle of the first point's body, rad, and the way from the first point to the second, m, in the ground's frame.
    fn at(numbers: &CutGeometry<T>, first_angle_rad: T, gap_m: Vec2<T>) -> Self;

    /// Φ, m.
    fn residuals(&self) -> [T; 2];

    /// dΦ for a `velocity` of the second point from the first, where the first body turns by `spin`.
    fn rates(&self, velocity: Vec2<T>, spin: Option<T>) -> [T; 2];

    /// d²Φ/dt² for velocity and acceleration of the second point from the first, and ω and α of the first body.
    fn biases(&self, velocity_m_s: Vec2<T>, acceleration_m_s2: Vec2<T>, spins: [T; 2]) -> [T; 2];

    /// Force on the second body, N: λ times the gradient with respect to the second point.
    fn force_n(&self, multipliers_n: [T; 2]) -> Vec2<T>;

    /// Displaces the second body from where it is in `centred`.
    fn displace(numbers: &mut CutGeometry<T>, displacement: Vec2<T>, centred: &CutGeometry<T>);
}
