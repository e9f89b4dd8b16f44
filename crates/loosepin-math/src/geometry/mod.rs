//! Vectors, turns and poses in the plane and in space. No mechanics.

mod pose;
mod quaternion;
mod rotation;
mod vec2;
mod vec3;

pub use pose::{Frame, Pose};
pub use quaternion::Quaternion;
pub use rotation::Rotation;
pub use vec2::Vec2;
pub use vec3::Vec3;
