//! The numbers of a cut joint.

use crate::mechanism::tree::points::numbered_point_m;
use crate::model::{JointId, JointKind, Model, QuantityId};
use loosepin_math::{Geometry, Plane, Real, Vec2, numbers};

/// Numbers of a cut joint.
#[derive(Debug, Clone, Copy)]
pub struct CutNumbers<T: Real, G: Geometry = Plane> {
    /// Joint points in the frames of the first and second body, m.
    pub arms_m: [G::Vector<T>; 2],
    /// How the markers of the joint lie in both frames: in the plane the angles of the direction that both bodies share, rad.
    pub markers: [G::Marker<T>; 2],
    /// Second point minus first point where points coincide, in the ground's frame, m.
    pub eccentricity_m: G::Vector<T>,
    /// Radius of the circle on which the second point stays, m; zero where there is none.
    pub radius_m: T,
}

numbers!(struct CutNumbers { arms_m, markers, eccentricity_m, radius_m });

impl<T: Real> CutNumbers<T> {
    /// Lays out the numbers that `number` gives for the quantities of `joint`, without a displacement.
    pub fn new(model: &Model, joint: JointId, number: &dyn Fn(QuantityId) -> T) -> Self {
        let kind = &model.joints[joint.0].kind;
        Self {
            arms_m: kind.points().map(|point| numbered_point_m(model, number, point)),
            markers: line_angles_rad(kind, number),
            eccentricity_m: Vec2::zero(),
            radius_m: kind.radius_m().map_or(T::zero(), number),
        }
    }
}

/// [`JointKind::angles_rad`] as numbers.
pub(in crate::mechanism) fn line_angles_rad<T: Real>(kind: &JointKind, number: &dyn Fn(QuantityId) -> T) -> [T; 2] {
    kind.angles_rad().map(|id| id.map_or(T::zero(), number))
}
