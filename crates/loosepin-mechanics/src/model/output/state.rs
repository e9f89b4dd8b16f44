//! The state of a mechanism, as outputs read it.

use super::position::Position;
use crate::model::ids::{Actuator, BodyId, JointId};
use loosepin_math::{Real, Vec2};

/// The state of a mechanism as outputs see it, over any kind of number.
///
/// Kinds of output stand in the model, which knows no equations of motion; `dynamics/output.rs` answers these questions.
pub trait OutputState<T: Real> {
    /// A position or angle, m or rad.
    fn position(&self, of: Position) -> T;

    /// Its first derivative by time, m/s or rad/s.
    fn velocity(&self, of: Position) -> T;

    /// Its second derivative by time, m/s² or rad/s².
    fn acceleration(&self, of: Position) -> T;

    /// Force of a joint on its second body, N, in the frame of the ground.
    fn joint_force_n(&self, joint: JointId) -> Vec2<T>;

    /// Torque, N m, or force, N, of a drive or control, and the rate of the coordinate along which it acts, rad/s or m/s.
    fn effort_and_rate(&self, actuator: Actuator) -> [T; 2];

    /// Largest stress along a flexible body, Pa.
    fn largest_stress_pa(&self, body: BodyId) -> T;
}
