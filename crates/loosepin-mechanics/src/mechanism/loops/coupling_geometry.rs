//! The numbers of a coupling q_2 = f(q_1).

use crate::mechanism::loops::joint_geometry::JointGeometry;
use crate::mechanism::loops::tooth_geometry::ToothForce;
use crate::model::{Coupling, CouplingNumbers, Model, QuantityId};
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

impl<T: Real> CouplingGeometry<T> {
    /// Lays out the numbers that `number` gives for the quantities of a coupling of `model`.
    pub fn new(model: &Model, coupling: &Coupling, number: &dyn Fn(QuantityId) -> T) -> Self {
        Self {
            joints: [coupling.first, coupling.second].map(|joint| JointGeometry::new(model, joint, number)),
            law: coupling.kind.curve(number),
            lever: coupling.play.and_then(|play| play.second_radius_m).map_or(T::one(), number),
            teeth: ToothForce::new(coupling, number),
        }
    }

    /// Displaces the second joint by `displacement_m` from where it is in `centred`. A follower stays on its cam.
    pub fn set_displacement(&mut self, displacement_m: T, centred: &CouplingGeometry<T>) {
        if let (Some(offset), Some(from)) = (self.law.offset_mut(), centred.law.offset()) {
            *offset = from + displacement_m / self.lever;
        }
    }
}
