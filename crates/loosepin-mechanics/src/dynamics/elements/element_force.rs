//! Forces of springs, loads and actuators at one evaluation.

use loosepin_math::{Real, Vec2};

/// Force and torque of a spring on its two bodies.
#[derive(Debug, Clone, Copy)]
pub struct SpringForce<T> {
    /// Its ends from the origins of the bodies, m, in the ground's frame.
    pub arms_m: [Vec2<T>; 2],
    /// Force on the second body, N, in the ground's frame; the first gets the opposite.
    pub on_second_n: Vec2<T>,
    /// Torque on the second body, N m; the first gets the opposite.
    pub moment_on_second_n_m: T,
    /// Stored energy, J.
    pub stored_j: T,
    /// Power that the damper turns into heat, W.
    pub damping_loss_w: T,
}

/// Force and torque of a load on its body.
#[derive(Debug, Clone, Copy)]
pub struct LoadForce<T> {
    /// Slot of the body.
    pub slot: usize,
    /// Point of attack from the origin of the body, m, in the ground's frame.
    pub arm_m: Vec2<T>,
    /// Force, N, in the ground's frame.
    pub force_n: Vec2<T>,
    /// Torque, N m.
    pub torque_n_m: T,
}

/// Reference, error and effort of a control.
#[derive(Debug, Clone, Copy)]
pub struct ActuatorForce<T> {
    /// The reference, rad or m.
    pub reference: T,
    /// Reference minus coordinate of the measured joint, rad or m.
    pub error: T,
    /// Torque on the journal's body, N m, or force on the slider along the guide, N; the other body gets the opposite.
    pub effort: T,
    /// Rate of the coordinate of its joint, rad/s or m/s.
    pub rate: T,
    /// Force on the slider, N, in the ground's frame; zero for a revolute joint.
    pub on_second_n: Vec2<T>,
}

impl<T: Real> ActuatorForce<T> {
    /// Of no evaluation yet.
    pub fn none() -> Self {
        let zero = T::zero();
        Self { reference: zero, error: zero, effort: zero, rate: zero, on_second_n: Vec2::zero() }
    }
}
