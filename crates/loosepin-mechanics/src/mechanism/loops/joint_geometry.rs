//! The numbers of a joint of which the coordinate is read.

use crate::mechanism::tree::points::numbered_point_m;
use crate::model::{JointId, Model, QuantityId};
use loosepin_math::{Real, Vec2, numbers};

/// Numbers of a joint of which the coordinate is read.
#[derive(Debug, Clone, Copy)]
pub struct JointGeometry<T> {
    /// Its points in the frames of its two bodies, m.
    pub arms_m: [Vec2<T>; 2],
    /// Direction of the line of a prismatic joint in the frame of the guide; zero for a revolute one.
    pub line: Vec2<T>,
}

numbers!(struct JointGeometry { arms_m, line });

impl<T: Real> JointGeometry<T> {
    /// Of no joint.
    pub fn none() -> Self {
        Self { arms_m: [Vec2::zero(); 2], line: Vec2::zero() }
    }

    /// Lays out the numbers that `number` gives for the quantities of `joint`.
    pub fn new(model: &Model, joint: JointId, number: &dyn Fn(QuantityId) -> T) -> Self {
        let kind = &model.joints[joint.0].kind;
        Self {
            arms_m: kind.points().map(|point| numbered_point_m(model, number, point)),
            line: kind.line().map_or(Vec2::zero(), |line| {
                let (sine, cosine) = number(line.angle_rad).sin_cos();
                Vec2::new(cosine, sine)
            }),
        }
    }
}
