//! One sample over its turn.

/// The numbers of one sample, part after part: that of a part at a place is at part × places + place.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TurnSample {
    /// Values with ideal joints, m or rad. Turns are counted from the nominal first place: those of the nominal motion are the sums of the turns
    /// from place to place, those of a sample add the turn between both bodies at the same place. 0 of `Along`, `Across` and `Magnitude`.
    pub ideal_si: Vec<f64>,
    /// Deviation of the ideal motion from the nominal ideal motion at the same values of the drives, m or rad.
    pub from_nominal_si: Vec<f64>,
    /// Smallest deviation from the sample's own ideal motion that play makes, m or rad; 0 of lengths.
    pub smallest_si: Vec<f64>,
    /// Largest deviation from the sample's own ideal motion that play makes, m or rad.
    pub largest_si: Vec<f64>,
    /// Smallest deviation from the nominal ideal motion, dimensions and play together, m or rad; of lengths to first order, 0 where play can take
    /// the displacement back.
    pub smallest_from_nominal_si: Vec<f64>,
    /// Largest deviation from the nominal ideal motion, m or rad: of numbers the sum of both, of lengths the largest length of the sum of both
    /// displacements.
    pub largest_from_nominal_si: Vec<f64>,
}

/// The numbers of a part at a place.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Numbers {
    pub ideal: f64,
    pub from_nominal: f64,
    /// Smallest and largest from the sample's own ideal motion.
    pub by_play: [f64; 2],
    /// Smallest and largest from the nominal one.
    pub in_all: [f64; 2],
}

impl TurnSample {
    /// Room for so many numbers.
    pub(super) fn new(size: usize) -> Self {
        let zeros = || vec![0.0; size];
        Self {
            ideal_si: zeros(),
            from_nominal_si: zeros(),
            smallest_si: zeros(),
            largest_si: zeros(),
            smallest_from_nominal_si: zeros(),
            largest_from_nominal_si: zeros(),
        }
    }

    /// Puts numbers to their place.
    pub(super) fn set(&mut self, number: usize, numbers: &Numbers) {
        let columns = [
            (&mut self.ideal_si, numbers.ideal),
            (&mut self.from_nominal_si, numbers.from_nominal),
            (&mut self.smallest_si, numbers.by_play[0]),
            (&mut self.largest_si, numbers.by_play[1]),
            (&mut self.smallest_from_nominal_si, numbers.in_all[0]),
            (&mut self.largest_from_nominal_si, numbers.in_all[1]),
        ];
        for (column, value) in columns {
            if let Some(entry) = column.get_mut(number) {
                *entry = value;
            }
        }
    }
}
