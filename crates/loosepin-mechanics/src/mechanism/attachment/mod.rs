//! How a body hangs on its parent in the tree: a file for each kind of attachment, and the kinds that each geometry has.
//!
//! Nothing else knows a kind by its name. Those that a geometry alone has say so by their type: sections of beams are kinds of the plane.

mod ball;
mod form;
mod free;
mod kind;
mod list;
mod node;
mod plane;
mod prismatic;
mod revolute;
mod rigid;
mod section;
mod space;

pub use ball::Ball;
pub use form::{FormOfAttachment, TreeGeometry};
pub use free::Free;
pub use kind::{Columns, Hung, KindOfAttachment, MovingGeometry, Place, Rates};
pub use node::Node;
pub use plane::PlaneAttachment;
pub use prismatic::Prismatic;
pub use revolute::Revolute;
pub use rigid::Rigid;
pub use section::Section;
pub use space::SpaceAttachment;
