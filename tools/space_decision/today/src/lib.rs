//! The planar equations of the program as they are, compiled for the same numbers as the prototypes.

#[cfg(feature = "compiled")]
macro_rules! compiled {
    ($($name:ident $number:ty),*) => {$(
        /// The evaluation, compiled here.
        #[inline(never)]
        pub fn $name(
            dynamics: &mut loosepin_mechanics::dynamics::Dynamics<'_, $number>,
            time_s: $number,
            coordinates: &[$number],
            rates: &[$number],
            states: &[loosepin_mechanics::contact::PlayState<$number>],
        ) {
            dynamics.evaluate(time_s, coordinates, rates, states);
        }
    )*};
}

#[cfg(feature = "compiled")]
compiled!(plain f64, traced loosepin_tape::trace::Traced);
