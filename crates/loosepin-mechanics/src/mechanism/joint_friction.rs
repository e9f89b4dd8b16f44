//! The numbers of friction in ideal joints.

use super::points::point_m;
use super::tree::points_of;
use crate::contact::FrictionLaw;
use crate::model::{JointId, JointKind, Model, Values};
use loosepin_math::{Real, Vec2, sin_cos};

/// Numbers of an ideal joint with friction.
#[derive(Debug, Clone, Copy)]
pub struct JointFriction<T> {
    /// The joint.
    pub joint: JointId,
    /// The friction law.
    pub law: FrictionLaw<T>,
    /// Radius of the pin, or length over which the guide holds the slider, m.
    pub size_m: T,
    /// Point of the journal or of the slider in its body's frame, m.
    pub second_arm_m: Vec2<T>,
    /// Direction of the guide in the frame of its body; zero for a revolute joint.
    pub guide_direction: Vec2<T>,
}

impl<T: Real> JointFriction<T> {
    /// Those of all ideal joints of `model` with friction, in the order of the joints.
    pub fn all(model: &Model, values: &Values) -> Vec<Self> {
        let joints = model.joints.iter().enumerate();
        let with_friction = joints.filter_map(|(index, joint)| Some((JointId(index), joint, joint.friction.as_ref()?)));
        with_friction
            .map(|(id, joint, friction)| {
                let numbers: Vec<f64> = friction.friction.numbers.iter().map(|number| values[*number]).collect();
                let [_, second] = points_of(&joint.kind);
                let guide_direction = match joint.kind {
                    JointKind::Prismatic { guide_angle_rad, .. } => {
                        let (sine, cosine) = sin_cos(values[guide_angle_rad]);
                        Vec2::new(T::from_f64(cosine), T::from_f64(sine))
                    }
                    _ => Vec2::zero(),
                };
                Self {
                    joint: id,
                    law: FrictionLaw::broadcast(&friction.friction.law.law(&numbers)),
                    size_m: T::from_f64(values[friction.size_m]),
                    second_arm_m: point_m(model, values, second),
                    guide_direction,
                }
            })
            .collect()
    }

    /// The numbers of `from` as constants of `T`.
    pub fn broadcast(from: &JointFriction<f64>) -> Self {
        Self {
            joint: from.joint,
            law: FrictionLaw::broadcast(&from.law),
            size_m: T::from_f64(from.size_m),
            second_arm_m: Vec2::from_f64(from.second_arm_m),
            guide_direction: Vec2::from_f64(from.guide_direction),
        }
    }

    /// Shows every number.
    pub fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.law.visit(visit);
        visit(&mut self.size_m);
        self.second_arm_m.visit(visit);
        self.guide_direction.visit(visit);
    }
}
