//! Slender links that bend and stretch: a beam in a floating frame, described by few shapes.
//!
//! [`Shapes`] are what does not depend on length, section and material; [`Beam`] holds the numbers of one beam, over any
//! [`loosepin_math::Real`]. Both know nothing of mechanisms: who has one gives the motion of the frame and the coordinates of the shapes,
//! and gets points, mass matrix, bias forces and elastic forces.

mod beam;
mod cuts;
mod functions;
mod shapes;
mod spectrum;

pub use beam::{Beam, Inertia};
pub use cuts::Cuts;
pub use functions::Frame;
pub use shapes::{AxialFunction, LateralFunction, MassPoint, Shapes, Station, stations};

#[cfg(test)]
mod tests;

/// The program of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
