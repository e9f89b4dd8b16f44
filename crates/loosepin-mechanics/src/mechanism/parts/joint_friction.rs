//! The numbers of friction in ideal joints.

use crate::contact::FrictionLaw;
use crate::mechanism::tree::points::point_m;
use crate::model::{JointId, Model, Values};
use loosepin_math::{Numbers, Real, Vec2, numbers, sin_cos};

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

numbers!(struct JointFriction { law, size_m, second_arm_m, guide_direction; joint });

impl<T: Real> JointFriction<T> {
    /// The frictions of all ideal joints of `model` with friction, in the order of the joints.
    pub fn all(model: &Model, values: &Values) -> Vec<Self> {
        let joints = model.joints.iter().enumerate();
        let with_friction = joints.filter_map(|(index, joint)| Some((JointId(index), joint, joint.friction.as_ref()?)));
        with_friction
            .map(|(id, joint, friction)| {
                let numbers: Vec<f64> = friction.friction.numbers.iter().map(|number| values[*number]).collect();
                let [_, second] = joint.kind.points();
                let guide_direction = joint.kind.line().map_or(Vec2::zero(), |line| {
                    let (sine, cosine) = sin_cos(values[line.angle_rad]);
                    Vec2::new(T::from_f64(cosine), T::from_f64(sine))
                });
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
}
