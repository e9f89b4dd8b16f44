//! What play does to the marker of a bearing.

use crate::enclosure::jet::{Jet, PLAY};
use crate::enclosure::vector::JetVector;
use crate::kind::frames::MarkerShift;
use crate::play::SpatialPlay;
use crate::play::kind_of_play::KindOfPlay;
use core::array::from_fn;
use loosepin_math::{Interval, Real};

/// Displacement along the marker's axes, m, and the slope of the journal's axis.
pub(crate) struct EnclosedShift<const C: usize> {
    pub shift_m: JetVector<C>,
    pub slope: [Jet<C>; 2],
}

impl<const C: usize> EnclosedShift<C> {
    pub(crate) fn none() -> Self {
        Self { shift_m: from_fn(|_| Jet::constant(Interval::ZERO)), slope: from_fn(|_| Jet::constant(Interval::ZERO)) }
    }

    /// Of a play whose variables, in units of their radii, all lie in `range`: a polynomial of second degree.
    pub(crate) fn new(play: &SpatialPlay, range: Interval) -> Self {
        let radii: Vec<f64> = play.blocks().iter().flat_map(|block| vec![block.radius_m; block.part.size()]).collect();
        let variable = |k: usize| Jet::<C>::variable(PLAY + k, range).times(Interval::from_f64(radii[k]));
        let mut own = Self::none();
        for (k, by) in play.derivatives(&vec![0.0; radii.len()]).iter().enumerate() {
            own.add(&variable(k), by);
        }
        for (i, j, by) in play.second_derivatives() {
            own.add(&(variable(i) * variable(j)), &by);
        }
        own
    }

    fn add(&mut self, variable: &Jet<C>, by: &MarkerShift) {
        for (own, entry) in
            self.shift_m.iter_mut().zip(by.shift_m.to_array()).chain(self.slope.iter_mut().zip(by.slope))
        {
            if entry != 0.0 {
                // Each is one number or one quotient: right to half a unit in the last place.
                *own = *own + variable.times(Interval::new(entry.next_down(), entry.next_up()));
            }
        }
    }
}
