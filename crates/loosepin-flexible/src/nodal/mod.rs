//! A beam in absolute nodal coordinates: chains of elements whose nodes hold position and slope, for links that bend far.
//! Elements, their forces and their mass. The floating frame stands outside of this folder.

mod beam;
mod element;
mod mesh;
mod statics;
mod tangent;

pub use beam::{MassEntries, NodalBeam};
pub use mesh::{Mesh, Nodal, Rule};
pub use statics::{ClampedRoot, NoStableEquilibrium, TipLoad};
pub use tangent::ElementMatrix;
