//! The numbers of a coupling q_2 = f(q_1).

use super::cam::CamProfile;
use super::joint_geometry::JointGeometry;
use super::tooth_geometry::ToothForce;
use crate::model::{Coupling, CouplingLaw, Model, QuantityId, Ratio};
use loosepin_math::{Real, numbers};

/// Numbers of a coupling.
#[derive(Debug, Clone)]
pub struct CouplingGeometry<T> {
    /// Its first and second joint.
    pub joints: [JointGeometry<T>; 2],
    /// Numbers of f.
    pub law: CouplingNumbers<T>,
    /// r: the radius on which the angle of the second joint counts as a length where the coupling has play, m; else one.
    pub lever: T,
    /// Numbers of teeth whose force the joints feel.
    pub teeth: Option<ToothForce<T>>,
}

numbers!(struct CouplingGeometry { joints, law, lever, teeth });

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

numbers!(enum CouplingNumbers { Ratio { ratio, offset }, Cam(profile) });

impl<T: Real> CouplingNumbers<T> {
    fn new(law: &CouplingLaw, number: &dyn Fn(QuantityId) -> T) -> Self {
        let (ratio, offset) = match law {
            CouplingLaw::Ratio { ratio, offset } => (ratio, offset),
            CouplingLaw::Cam { points, dwells } => {
                let points: Vec<[T; 2]> = points.iter().map(|point| point.map(number)).collect();
                return Self::Cam(CamProfile::new(&points, dwells));
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
            lever: coupling.play.and_then(|play| play.second_radius_m).map_or(T::one(), number),
            teeth: ToothForce::new(coupling, number),
        }
    }

    /// Displaces the second joint by `displacement_m` from where it is in `centred`. A follower stays on its cam.
    pub fn set_displacement(&mut self, displacement_m: T, centred: &CouplingGeometry<T>) {
        if let (CouplingNumbers::Ratio { offset, .. }, CouplingNumbers::Ratio { offset: from, .. }) =
            (&mut self.law, &centred.law)
        {
            *offset = *from + displacement_m / self.lever;
        }
    }
}
