//! Way (b): one kernel over a geometry, compiled for the plane and for space.

mod geometry;
mod kernel;
mod kinds;
mod numbers;
mod plane;
mod space;

pub use geometry::{Geometry, Vector};
pub use kernel::{Contact, Kernel};
pub use kinds::{Column, Kind, Moving, Pose, Speeds, Twist};
pub use numbers::{Embeds, LinkNumbers, Numbers, PlayNumbers};
pub use plane::{Plane, PlaneMount};
pub use space::{Space, SpaceMount};

/// An evaluation, compiled here.
#[allow(unused_macros)]
macro_rules! compiled {
    ($name:ident $geometry:ident $number:ty) => {
        /// The evaluation, compiled here.
        #[inline(never)]
        pub fn $name(
            kernel: &mut Kernel<'_, $number, $geometry>,
            coordinates: &[$number],
            speeds: &[$number],
            driven: &[$number],
            states: &[loosepin_mechanics::contact::PlayState<$number>],
        ) {
            kernel.evaluate(coordinates, speeds, driven, states);
        }
    };
}

#[cfg(feature = "plane-plain")]
compiled!(plane_plain Plane f64);
#[cfg(feature = "plane-traced")]
compiled!(plane_traced Plane loosepin_tape::trace::Traced);
#[cfg(feature = "space-plain")]
compiled!(space_plain Space f64);
#[cfg(feature = "space-traced")]
compiled!(space_traced Space loosepin_tape::trace::Traced);
