//! Way (b): one kernel over a geometry, compiled for the plane and for space.

mod geometry;
mod kernel;
mod numbers;
mod plane;
mod space;

pub use geometry::{Geometry, Vector};
pub use kernel::{Contact, Kernel, Pose, Twist};
pub use numbers::{Embeds, LinkNumbers, Numbers, PlayNumbers};
pub use plane::{Plane, PlaneMount};
pub use space::{Space, SpaceMount};

#[cfg(any(feature = "plane", feature = "space"))]
macro_rules! compiled {
    ($($name:ident $geometry:ident $number:ty),*) => {$(
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
    )*};
}

#[cfg(feature = "plane")]
compiled!(plane_plain Plane f64, plane_traced Plane loosepin_tape::trace::Traced);
#[cfg(feature = "space")]
compiled!(space_plain Space f64, space_traced Space loosepin_tape::trace::Traced);
