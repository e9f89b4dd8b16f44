//! What every condition says of itself at a state.

use crate::mechanism::attachment::TreeGeometry;
use crate::mechanism::tree::cut_numbers::CutNumbers;
use crate::mechanism::tree::kinematics::Pose;
use loosepin_math::{Geometry, Real};

/// Most scalar constraints of a condition.
pub const MOST_SCALARS: usize = 3;

/// A cut joint at a state.
pub struct CutState<'a, T: Real, G: Geometry> {
    /// Its numbers.
    pub numbers: &'a CutNumbers<T, G>,
    /// Poses of its first and second body.
    pub poses: [&'a Pose<T, G>; 2],
    /// The way from the first point to the second, in the ground's frame, m.
    pub gap_m: G::Vector<T>,
}

/// How the bodies of a cut joint move: velocity and acceleration of the second point from the first, ω and α of both bodies.
pub struct CutMotion<T: Real, G: Geometry> {
    /// m/s.
    pub velocity_m_s: G::Vector<T>,
    /// m/s².
    pub acceleration_m_s2: G::Vector<T>,
    /// rad/s.
    pub spins: [G::Spin<T>; 2],
    /// rad/s².
    pub spin_rates: [G::Spin<T>; 2],
}

/// A condition at a state; `out` has a number for each of its scalar constraints.
pub trait RowAt<T: Real, G: Geometry>: Sized {
    /// Φ, m or without a unit.
    fn residuals(&self, out: &mut [T]);

    /// dΦ where the second point moves from the first by `velocity`, and the first body or the second, `side`, turns by `spin`.
    fn rates(&self, velocity: impl FnOnce() -> G::Vector<T>, side: usize, spin: G::Spin<T>, out: &mut [T]);

    /// d²Φ/dt².
    fn biases(&self, motion: &CutMotion<T, G>, out: &mut [T]);

    /// Force on the second body at its point, N: the multipliers times the gradient with respect to that point.
    fn force_n(&self, multipliers: &[T]) -> G::Vector<T>;
}

/// A geometry whose conditions can be computed.
pub trait RowGeometry: TreeGeometry {
    /// A condition at a state.
    type RowAt<T: Real>: RowAt<T, Self>;

    /// `row` at a state.
    fn row_at<T: Real>(row: Self::Row, state: &CutState<'_, T, Self>) -> Self::RowAt<T>;
}
