//! Controlled joints: actuators that follow a reference.

use crate::model::drive::DriveLaw;
use crate::model::ids::JointId;
use crate::model::load::TimeCourse;
use loosepin_text::numbers::QuantityId;

/// A PID controller with its actuator. With the error e = reference - coordinate of the measured joint, the actuator acts in
/// its own joint, along its coordinate, with
///
///   F = F_ff + k_p e + k_i ∫ e dt + k_d ė,   cut to [-limit, limit],
///
/// a torque on the journal's body against the bearing's (N m), or a force on the slider along the guide against the guide (N).
#[derive(Debug, Clone)]
pub struct Control {
    /// Name in the file.
    pub name: String,
    /// The joint of the actuator.
    pub joint: JointId,
    /// The joint whose coordinate follows the reference.
    pub measured: JointId,
    /// k_p, N m/rad, N/m or mixed, >= 0.
    pub proportional: QuantityId,
    /// k_i, that over a second, >= 0.
    pub integral: Option<QuantityId>,
    /// k_d, that times a second, >= 0.
    pub derivative: Option<QuantityId>,
    /// F_ff.
    pub feed_forward: FeedForward,
    /// Largest torque or force, N m or N, > 0.
    pub limit: Option<QuantityId>,
    /// The reference over time, rad or m.
    pub reference: DriveLaw,
}

/// Action of an actuator beside its feedback.
#[derive(Debug, Clone)]
pub enum FeedForward {
    /// Nothing.
    None,
    /// A course over time, coordinate and rate of the measured joint, N m or N.
    TimeCourse(TimeCourse),
    /// The torque or force that inertia and weight need along the references, without play.
    InverseDynamics,
}
