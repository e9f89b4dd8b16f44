//! Couplings as constraints: Φ = q_2 - f(q_1).

use super::joint_coordinate::{JointGeometry, JointPlace};
use super::kinematics::Kinematics;
use super::tree::Tree;
use crate::math::Real;
use crate::model::{Coupling, CouplingLaw, Model, QuantityId, Ratio};

/// Places of the first and the second joint of a coupling in a tree.
pub type CouplingPlace = [JointPlace; 2];

/// Numbers of a coupling.
#[derive(Debug, Clone)]
pub struct CouplingGeometry<T> {
    /// Its first and second joint.
    pub joints: [JointGeometry<T>; 2],
    /// Numbers of f.
    pub law: CouplingNumbers<T>,
}

/// Numbers of the coordinate of the second joint over that of the first.
#[derive(Debug, Clone)]
pub enum CouplingNumbers<T> {
    /// ratio · q + offset.
    Ratio {
        /// Slope.
        ratio: T,
        /// Value at zero.
        offset: T,
    },
}

impl<T: Real> CouplingNumbers<T> {
    fn new(law: &CouplingLaw, number: &dyn Fn(QuantityId) -> T) -> Self {
        let CouplingLaw::Ratio { ratio, offset } = law;
        let signed = |value: T, is_reversed: bool| if is_reversed { -value } else { value };
        let ratio = match *ratio {
            Ratio::Given(id) => number(id),
            Ratio::Wheels { sizes: [first, second], is_reversed } => {
                signed(number(first) / number(second), is_reversed)
            }
            Ratio::Rack { radius_m, is_reversed } => signed(number(radius_m), is_reversed),
        };
        Self::Ratio { ratio, offset: number(*offset) }
    }

    /// The largest |f'|, about.
    pub fn steepest(&self) -> T {
        let Self::Ratio { ratio, .. } = self;
        ratio.abs()
    }

    /// f, f' and f'' at `coordinate`.
    #[inline(always)]
    pub fn at(&self, coordinate: T) -> [T; 3] {
        let Self::Ratio { ratio, offset } = self;
        [ratio.mul_add(coordinate, *offset), *ratio, T::zero()]
    }
}

impl<T: Real> CouplingGeometry<T> {
    /// Lays out the numbers that `number` gives for the quantities of a coupling of `model`.
    pub fn new(model: &Model, coupling: &Coupling, number: &dyn Fn(QuantityId) -> T) -> Self {
        Self {
            joints: [coupling.first, coupling.second].map(|joint| JointGeometry::new(model, joint, number)),
            law: CouplingNumbers::new(&coupling.law, number),
        }
    }

    /// The same numbers in every lane.
    pub fn broadcast(from: &CouplingGeometry<f64>) -> Self {
        let CouplingNumbers::Ratio { ratio, offset } = &from.law;
        Self {
            joints: [0, 1].map(|side| JointGeometry::broadcast(&from.joints[side])),
            law: CouplingNumbers::Ratio { ratio: T::from_f64(*ratio), offset: T::from_f64(*offset) },
        }
    }

    /// Shows every number.
    pub fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.joints.iter_mut().for_each(|joint| joint.visit(visit));
        let CouplingNumbers::Ratio { ratio, offset } = &mut self.law;
        visit(ratio);
        visit(offset);
    }

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

    /// d²Φ/dt² when the free coordinates have no acceleration. Needs the biases of `kinematics`.
    #[inline(always)]
    pub fn bias(&self, places: &CouplingPlace, kinematics: &Kinematics<T>) -> T {
        let [coordinate, rate] = self.joints[0].motion(&places[0], kinematics);
        let [_, slope, bend] = self.law.at(coordinate);
        let [first, second] = [0, 1].map(
            #[inline(always)]
            |side| self.joints[side].bias(&places[side], kinematics),
        );
        second - slope * first - bend * rate.squared()
    }

    /// f' at the present position.
    #[inline(always)]
    pub fn slope(&self, places: &CouplingPlace, kinematics: &Kinematics<T>) -> T {
        self.law.at(self.joints[0].motion(&places[0], kinematics)[0])[1]
    }
}
