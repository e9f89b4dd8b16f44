//! Couplings as constraints: Φ = q_2 - f(q_1).

use super::cam::CamProfile;
use super::joint_coordinate::{JointGeometry, JointPlace};
use super::kinematics::Kinematics;
use super::tree::Tree;
use crate::model::{Coupling, CouplingLaw, Model, QuantityId, Ratio};
use loosepin_math::Real;

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
    /// The profile of a cam.
    Cam(CamProfile<T>),
}

impl<T: Real> CouplingNumbers<T> {
    fn new(law: &CouplingLaw, number: &dyn Fn(QuantityId) -> T) -> Self {
        let (ratio, offset) = match law {
            CouplingLaw::Ratio { ratio, offset } => (ratio, offset),
            CouplingLaw::Cam { points } => {
                let points: Vec<[T; 2]> = points.iter().map(|point| point.map(number)).collect();
                return Self::Cam(CamProfile::new(&points));
            }
        };
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

    fn broadcast(from: &CouplingNumbers<f64>) -> Self {
        match from {
            CouplingNumbers::Ratio { ratio, offset } => {
                Self::Ratio { ratio: T::from_f64(*ratio), offset: T::from_f64(*offset) }
            }
            CouplingNumbers::Cam(profile) => Self::Cam(CamProfile::broadcast(profile)),
        }
    }

    fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        match self {
            Self::Ratio { ratio, offset } => [ratio, offset].into_iter().for_each(visit),
            Self::Cam(profile) => profile.visit(visit),
        }
    }

    /// f, f' and f'' at `coordinate`.
    #[inline(always)]
    pub fn at(&self, coordinate: T) -> [T; 3] {
        match self {
            Self::Ratio { ratio, offset } => [ratio.mul_add(coordinate, *offset), *ratio, T::zero()],
            Self::Cam(profile) => profile.at(coordinate),
        }
    }
}

impl CouplingNumbers<f64> {
    /// How much faster than the first coordinate the second one changes, about, where a unit of the second counts `scale` of the
    /// first. Eight points to a wave of a profile.
    pub fn gain(&self, scale: f64) -> f64 {
        match self {
            Self::Ratio { ratio, .. } => ratio.abs() * scale,
            Self::Cam(profile) => {
                let [steepest, density] = profile.steepness();
                (steepest * scale).max(density * std::f64::consts::TAU / 8.0)
            }
        }
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
        Self {
            joints: [0, 1].map(|side| JointGeometry::broadcast(&from.joints[side])),
            law: CouplingNumbers::broadcast(&from.law),
        }
    }

    /// Shows every number.
    pub fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.joints.iter_mut().for_each(|joint| joint.visit(visit));
        self.law.visit(visit);
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
