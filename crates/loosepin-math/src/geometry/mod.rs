//! Vectors, turns and poses in the plane and in space, and what equations ask of both alike ([`Geometry`]). No mechanics.

mod kind;
mod plane;
mod pose;
mod quaternion;
mod rotation;
mod space;
mod vec2;
mod vec3;

pub use kind::{Geometry, Vector};
pub use plane::{Plane, PlaneMount, PlaneRotation, PlaneSwing};
pub use pose::{Frame, Pose};
pub use quaternion::Quaternion;
pub use rotation::Rotation;
pub use space::{Space, SpaceInertia, SpaceMount, SpaceSwing};
pub use vec2::Vec2;
pub use vec3::Vec3;
