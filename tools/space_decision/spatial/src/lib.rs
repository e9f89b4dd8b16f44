//! Way (a): one kernel in space; the tracer folds away what a planar mechanism leaves zero or one.

mod joints;
mod kernel;
mod numbers;

pub use kernel::{Contact, Kernel, Pose, Twist};
pub use numbers::{LinkNumbers, Mount, Numbers, PlayNumbers};

#[cfg(feature = "compiled")]
macro_rules! compiled {
    ($($name:ident $number:ty),*) => {$(
        /// The evaluation, compiled here.
        #[inline(never)]
        pub fn $name(
            kernel: &mut Kernel<'_, $number>,
            coordinates: &[$number],
            speeds: &[$number],
            driven: &[$number],
            states: &[loosepin_mechanics::contact::PlayState<$number>],
        ) {
            kernel.evaluate(coordinates, speeds, driven, states);
        }
    )*};
}

#[cfg(feature = "compiled")]
compiled!(plain f64, traced loosepin_tape::trace::Traced);
