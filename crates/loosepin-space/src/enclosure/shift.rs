//! What play does to the marker of a bearing.

use crate::enclosure::jet::{Jet, Number, Variables};
use crate::enclosure::vector::JetVector;
use crate::kind::SpatialPlay;
use crate::kind::frames::MarkerShift;
use core::array::from_fn;
use loosepin_math::{Interval, Real};

/// Displacement along the marker's axes, m, and the slope of the journal's axis.
pub(crate) struct EnclosedShift<T> {
    pub shift_m: JetVector<T>,
    pub slope: [Jet<T>; 2],
}

impl<T: Number> EnclosedShift<T> {
    pub(crate) fn none() -> Self {
        let zero = || Jet::constant(Interval::ZERO);
        Self { shift_m: from_fn(|_| zero()), slope: from_fn(|_| zero()) }
    }

    /// Of a play whose variables, in units of their radii, lie in `ranges`; their derivatives begin at `first`. It is a polynomial of second
    /// degree.
    pub(crate) fn new(play: &SpatialPlay, ranges: &[Interval], first: usize, variables: Variables) -> Self {
        let radii = radii_m(play);
        let variable = |k: usize| {
            let range = ranges.get(k).copied().unwrap_or(Interval::ZERO);
            variables.number(first + k, range).times(Interval::from_f64(radii[k]))
        };
        let mut own = Self::none();
        for (k, by) in play.derivatives(&vec![0.0; radii.len()]).iter().enumerate() {
            own.add(&variable(k), by);
        }
        for (i, j, by) in play.second_derivatives() {
            own.add(&(&variable(i) * &variable(j)), &by);
        }
        own
    }

    fn add(&mut self, variable: &Jet<T>, by: &MarkerShift) {
        let entries = by.shift_m.to_array().into_iter().chain(by.slope);
        for (own, entry) in self.shift_m.iter_mut().chain(&mut self.slope).zip(entries) {
            if entry != 0.0 {
                // Each is one number or one quotient: right to half a unit in the last place.
                *own = own.clone() + &variable.clone().times(Interval::new(entry.next_down(), entry.next_up()));
            }
        }
    }
}

/// Radius of the block of each variable, m.
pub(crate) fn radii_m(play: &SpatialPlay) -> Vec<f64> {
    play.blocks().iter().flat_map(|block| vec![block.radius; block.part.size()]).collect()
}
