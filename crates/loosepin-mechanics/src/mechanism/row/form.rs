//! What every condition says of itself at a state.

use crate::mechanism::attachment::TreeGeometry;
use crate::mechanism::tree::cut_numbers::CutNumbers;
use crate::mechanism::tree::kinematics::{Kinematics, Pose};
use crate::mechanism::tree::spanning_tree::Tree;
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

/// The velocities of the bodies of a cut joint for unit speeds, and where its constraint begins in the Jacobian.
pub struct CutColumns<'a, T: Real, G: TreeGeometry> {
    /// The tree.
    pub tree: &'a Tree<G>,
    /// Where it is.
    pub kinematics: &'a Kinematics<T, G>,
    /// Slots of the first and the second body.
    pub slots: [usize; 2],
    /// Arms of the points from the origins of these, in the ground's frame, m.
    pub arms_m: [G::Vector<T>; 2],
    /// Number of speeds: of columns of the Jacobian.
    pub speeds: usize,
}

/// A condition at a state; `out` has a number for each of its scalar constraints.
pub trait RowAt<T: Real, G: TreeGeometry>: Sized {
    /// Φ, m or without a unit.
    fn residuals(&self, out: &mut [T]);

    /// dΦ where the second point moves from the first by `velocity`, and the first body or the second, `side`, turns by `spin`.
    fn rates(&self, velocity: impl FnOnce() -> G::Vector<T>, side: usize, spin: G::Spin<T>, out: &mut [T]);

    /// Adds dΦ for unit speeds to its `count` rows of the Jacobian, `out`.
    #[inline(always)]
    fn add_columns(&self, columns: &CutColumns<'_, T, G>, count: usize, out: &mut [T]) {
        let CutColumns { tree, kinematics, slots, arms_m, speeds } = *columns;
        let mut rates = [T::zero(); MOST_SCALARS];
        let rates = &mut rates[..count];
        for (side, sign) in [(0, -T::one()), (1, T::one())] {
            for column in kinematics.columns(tree, slots[side]) {
                self.rates(|| column.at(arms_m[side]) * sign, side, G::spin(column.turning), rates);
                for (scalar, rate) in rates.iter().enumerate() {
                    out[scalar * speeds + column.coordinate] += *rate;
                }
            }
        }
    }

    /// d²Φ/dt².
    fn biases(&self, motion: &CutMotion<T, G>, out: &mut [T]);

    /// Force on the second body at its point, N: the multipliers times the gradient with respect to that point.
    fn force_n(&self, multipliers: &[T]) -> G::Vector<T>;
}

/// A geometry whose conditions can be computed: each function is that of [`RowAt`] for the kind of `row`.
pub trait RowGeometry: TreeGeometry {
    /// See [`RowAt::residuals`].
    fn residuals<T: Real>(row: Self::Row, state: &CutState<'_, T, Self>, out: &mut [T]);

    /// See [`RowAt::add_columns`].
    fn add_columns<T: Real>(
        row: Self::Row,
        state: &CutState<'_, T, Self>,
        columns: &CutColumns<'_, T, Self>,
        out: &mut [T],
    );

    /// See [`RowAt::rates`].
    fn rates<T: Real>(
        row: Self::Row,
        state: &CutState<'_, T, Self>,
        velocity: impl FnOnce() -> Self::Vector<T>,
        side_and_spin: (usize, Self::Spin<T>),
        out: &mut [T],
    );

    /// See [`RowAt::biases`].
    fn biases<T: Real>(row: Self::Row, state: &CutState<'_, T, Self>, motion: &CutMotion<T, Self>, out: &mut [T]);

    /// See [`RowAt::force_n`].
    fn force_n<T: Real>(row: Self::Row, state: &CutState<'_, T, Self>, multipliers: &[T]) -> Self::Vector<T>;
}
