//! Slender links that bend and stretch: a beam in a floating frame, described by few shapes, or in absolute nodal coordinates.
//!
//! [`Shapes`] are what does not depend on length, section and material; [`Beam`] holds the numbers of one beam, over any
//! [`loosepin_math::Real`]. Both know nothing of mechanisms: who has one gives the motion of the frame and the coordinates of the shapes,
//! and gets points, mass matrix, bias forces and elastic forces. [`NodalBeam`] is the beam that may bend as far as it likes: a chain of the
//! elements of a [`Mesh`], whose nodes hold position and slope.

mod basis;
mod beam;
mod cuts;
mod functions;
mod held;
mod legendre;
mod nodal;
mod point_shapes;
mod shapes;
mod spectrum;
mod station;

pub use basis::{Basis, Span};
pub use beam::{Beam, Inertia};
pub use cuts::Cuts;
pub use functions::Frame;
pub use held::{HeldBeam, LumpedMass};
pub use nodal::{ClampedRoot, ElementMatrix, MassEntries, Mesh, NoStableEquilibrium, Nodal, NodalBeam, Rule, TipLoad};
pub use shapes::{MassPoint, Shapes};
pub use station::{AxialFunction, LateralFunction, Station, even_shares};

#[cfg(test)]
mod tests;

/// The program of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
