//! MJCF, the format of MuJoCo: bodies inside each other, each with the joints that connect it to the one around it.
//!
//! Source: the XML reference of MuJoCo 3, <https://mujoco.readthedocs.io/en/stable/XMLreference.html>. Several joints of a body are a chain: each
//! moves what stands behind it, and the body comes last. Joints are written in the frame of the body in the pose of the
//! file, in which the coordinate of each is its `ref`.
//!
//! | Part | File |
//! |---|---|
//! | `<compiler>`: degrees, order of Euler angles | `compiler.rs` |
//! | `<default>`: classes of attributes | `defaults.rs` |
//! | turns in their five forms | `orientation.rs` |
//! | `<worldbody>`: bodies and joints | `body.rs` |
//! | `<inertial>`, and masses of geoms | `inertia.rs` |
//! | `<equality>`: what closes loops | `equality.rs` |
//! | the file | `read.rs` |

mod body;
mod compiler;
mod defaults;
mod equality;
mod inertia;
mod orientation;
mod read;

pub(super) use read::read;
