//! Couplings as constraints: Φ = q_2 - f(q_1).

use crate::mechanism::loops::coupling_geometry::CouplingGeometry;
use crate::mechanism::tree::kinematics::{Kinematics, Twist};
use crate::mechanism::tree::spanning_tree::{CouplingPlace, Tree};
use loosepin_math::Real;

impl<T: Real> CouplingGeometry<T> {
    /// Φ, rad or m.
    #[inline(always)]
    pub fn residual(&self, places: &CouplingPlace, kinematics: &Kinematics<T>) -> T {
        let [first, second] = [0, 1].map(
            #[inline(always)]
            |side| self.joints[side].motion(&places[side], kinematics)[0],
        );
        second - self.law.at(first)[0]
    }

    /// Adds dΦ/dz over all coordinates to `row`.
    #[inline(always)]
    pub fn add_gradient(&self, places: &CouplingPlace, tree: &Tree, kinematics: &Kinematics<T>, row: &mut [T]) {
        let slope = self.slope(places, kinematics);
        self.joints[1].add_gradient(&places[1], tree, kinematics, T::one(), row);
        self.joints[0].add_gradient(&places[0], tree, kinematics, -slope, row);
    }

    /// dΦ/dt.
    #[inline(always)]
    pub fn rate(&self, places: &CouplingPlace, kinematics: &Kinematics<T>) -> T {
        let [first, second] = [0, 1].map(
            #[inline(always)]
            |side| self.joints[side].motion(&places[side], kinematics),
        );
        second[1] - self.law.at(first[0])[1] * first[1]
    }

    /// d²Φ/dt² when the free coordinates have no acceleration. Needs the biases of `kinematics`.
    #[inline(always)]
    pub fn bias(&self, places: &CouplingPlace, kinematics: &Kinematics<T>) -> T {
        self.acceleration(
            places,
            kinematics,
            #[inline(always)]
            |slot| kinematics.biases[slot],
        )
    }

    /// d²Φ/dt² where `change` is the acceleration of the frame of each slot.
    #[inline(always)]
    pub fn acceleration(
        &self,
        places: &CouplingPlace,
        kinematics: &Kinematics<T>,
        change: impl Fn(usize) -> Twist<T>,
    ) -> T {
        let [coordinate, rate] = self.joints[0].motion(&places[0], kinematics);
        let [_, slope, bend] = self.law.at(coordinate);
        let [first, second] = [0, 1].map(
            #[inline(always)]
            |side| self.joints[side].acceleration(&places[side], kinematics, places[side].slots.map(&change)),
        );
        second - slope * first - bend * rate.squared()
    }

    /// f' at the present position.
    #[inline(always)]
    pub fn slope(&self, places: &CouplingPlace, kinematics: &Kinematics<T>) -> T {
        self.law.at(self.joints[0].motion(&places[0], kinematics)[0])[1]
    }
}
