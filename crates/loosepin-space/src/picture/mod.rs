//! The geometry of a picture: what is drawn of bodies, joints and drives, each in the frame of its body, and paths of points with where play
//! takes them. Projection, depth and colours are no part of it.
//!
//! | Drawn | File |
//! |---|---|
//! | a mechanism in positions, of which a picture is made; the picture | `source.rs`; `whole.rs` |
//! | sizes of what has none of its own | `sizes.rs` |
//! | a body between its points; the faces of a body with many | `bodies.rs`; `hull.rs` |
//! | a joint by the sign of its kind | `joints.rs`, of simple shapes in `shapes.rs` |
//! | feet on the ground; arrows of drives | `ground.rs`; `drives.rs` |
//! | points whose paths are drawn, and zones of play about them | `traces.rs` |

mod bodies;
mod drives;
mod ground;
mod hull;
mod joints;
mod shapes;
mod sizes;
mod source;
mod traces;
mod whole;

pub use source::PictureSource;
pub(crate) use traces::{TracedPoint, Zones};
