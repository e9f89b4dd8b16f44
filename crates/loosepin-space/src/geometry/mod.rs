//! Vectors, turns and poses in space. No mechanics.

pub(crate) mod pose;
pub(crate) mod quaternion;
pub(crate) mod rotation;
pub(crate) mod vector;
