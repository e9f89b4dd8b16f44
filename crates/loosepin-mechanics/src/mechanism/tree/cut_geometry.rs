//! The numbers of a cut joint.

use crate::mechanism::tree::points::numbered_point_m;
use crate::model::{JointId, JointKind, Model, QuantityId};
use loosepin_math::{Real, Vec2, numbers};

/// Numbers of a cut joint.
#[derive(Debug, Clone, Copy)]
pub struct CutGeometry<T> {
    /// Joint points in the frames of the first and second body, m.
    pub arms_m: [Vec2<T>; 2],
    /// Angles, in both frames, of the direction that both bodies share, rad.
    pub angles_rad: [T; 2],
    /// Revolute: second point minus first point, in the ground's frame, m.
    pub eccentricity_m: Vec2<T>,
    /// Radius of the circle on which the second point stays, m; zero where there is none.
    pub radius_m: T,
}

numbers!(struct CutGeometry { arms_m, angles_rad, eccentricity_m, radius_m });

impl<T: Real> CutGeometry<T> {
    /// Lays out the numbers that `number` gives for the quantities of `joint`, without a displacement.
    pub fn new(model: &Model, joint: JointId, number: &dyn Fn(QuantityId) -> T) -> Self {
        let kind = &model.joints[joint.0].kind;
        Self {
            arms_m: kind.points().map(|point| numbered_point_m(model, number, point)),
            angles_rad: line_angles_rad(kind, number),
            eccentricity_m: Vec2::zero(),
            radius_m: kind.radius_m().map_or(T::zero(), number),
        }
    }
}

/// [`JointKind::angles_rad`] as numbers.
pub(in crate::mechanism) fn line_angles_rad<T: Real>(kind: &JointKind, number: &dyn Fn(QuantityId) -> T) -> [T; 2] {
    kind.angles_rad().map(|id| id.map_or(T::zero(), number))
}
