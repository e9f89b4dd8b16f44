//! The numbers of teeth whose force the joints of their wheels feel.

use crate::model::{Coupling, Mesh, QuantityId};
use loosepin_math::{Real, numbers};

/// Numbers of teeth whose force the joints feel.
#[derive(Debug, Clone, Copy)]
pub struct ToothForce<T> {
    /// tan α.
    pub slope: T,
    /// Pitch radii on the first and on the second joint, m; one for a rack.
    pub radii_m: [T; 2],
    /// How they mesh.
    pub mesh: Mesh,
    /// Whether the body with the teeth is the second of its joint; of both joints.
    pub is_second: [bool; 2],
}

numbers!(struct ToothForce { slope, radii_m; mesh, is_second });

impl<T: Real> ToothForce<T> {
    /// The geometry of the teeth of a coupling, if its joints carry the force.
    pub fn new(coupling: &Coupling, number: &dyn Fn(QuantityId) -> T) -> Option<Self> {
        let teeth = coupling.teeth?;
        // The force of a rack is one already: no radius makes it of a torque.
        let radii_m = teeth.radii_m.map(|radius_m| radius_m.map_or(T::one(), number));
        let (sine, cosine) = number(teeth.pressure_angle_rad).sin_cos();
        Some(Self { slope: sine / cosine, radii_m, mesh: teeth.mesh, is_second: teeth.is_second })
    }
}
