//! The arithmetic of what is followed, on the numbers of one lane. Written once over [`Real`]: done as it stands for one run, written
//! down for many.

use super::plan::Follow;
use loosepin_math::{Quintic, Real};
use loosepin_result::study::Deviation;

/// Gauss's points and weights on [0, 1] for integrals over a step: exact to degree five.
pub const GAUSS: [(f64, f64); 3] =
    [(0.112_701_665_379_258_3, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];
/// Newton's steps to an instant within a step, from a guess that is exact where the pace changes evenly.
const NEWTON_STEPS: usize = 6;

/// Where everything is among the numbers of a lane that belong to what is followed.
#[derive(Debug, Clone)]
pub(crate) struct FollowLayout {
    readings: usize,
    deviations: Vec<(usize, Deviation, bool)>,
}

/// The ends of a step: its length, time and derivatives, and those of the readings, over the variable of integration.
pub(crate) struct StepEnds<'s, T> {
    /// Length.
    pub length: T,
    /// Time at the start and at the end.
    pub time: [[T; 3]; 2],
    /// All readings at the start and at the end, three numbers each.
    pub readings: [&'s [T]; 2],
}

impl<T: Copy> StepEnds<'_, T> {
    fn reading(&self, reading: usize, side: usize) -> [T; 3] {
        array(&self.readings[side][3 * reading..])
    }
}

impl FollowLayout {
    /// Where the piece of the ideal curves at hand begins, s.
    pub const PIECE_START: usize = 0;
    /// One over how long it lasts, 1/s.
    pub const PIECE_RATE: usize = 1;
    /// The instant that is looked at, s.
    pub const INSTANT: usize = 2;
    /// 1 where some deviation may have a new extreme within the step.
    pub const IS_EXTREME: usize = 3;
    /// The readings at the instant.
    pub const VALUES: usize = 4;
    /// Numbers of a deviation, from [`Self::deviation`] on: the polynomial that it is compared with, over the piece.
    pub const REFERENCE: usize = 0;
    /// Value, rate and acceleration of that at the start of the step.
    pub const BEFORE: usize = 6;
    /// Largest value so far.
    pub const LARGEST: usize = 9;
    /// Smallest value so far.
    pub const SMALLEST: usize = 10;
    /// Integral over time.
    pub const INTEGRAL: usize = 11;
    /// Integral of the square.
    pub const INTEGRAL_OF_SQUARE: usize = 12;
    /// The deviation over the step as a polynomial of its share.
    pub const POLYNOMIAL: usize = 13;
    const PER_DEVIATION: usize = 19;

    /// For what `follow` says.
    pub fn new(follow: &Follow) -> Self {
        let deviations = follow.deviations.iter().map(|one| (one.reading, one.deviation, one.is_integrated)).collect();
        Self { readings: follow.readings.len(), deviations }
    }

    /// Readings.
    pub fn readings(&self) -> usize {
        self.readings
    }

    /// Deviations.
    pub fn deviations(&self) -> usize {
        self.deviations.len()
    }

    /// Which reading a deviation is of, and which deviation it is.
    pub fn of(&self, deviation: usize) -> (usize, Deviation) {
        let (reading, of, _) = self.deviations[deviation];
        (reading, of)
    }

    /// Where the numbers of a deviation begin.
    pub fn deviation(&self, deviation: usize) -> usize {
        Self::VALUES + self.readings + Self::PER_DEVIATION * deviation
    }

    /// How many numbers there are.
    pub fn length(&self) -> usize {
        if self.readings == 0 { 0 } else { self.deviation(self.deviations.len()) }
    }

    /// Follows a step to its end, where `is_chosen`: integrals, the polynomials of the deviations, and whether their extremes may be new.
    pub fn follow<T: Real>(&self, numbers: &mut [T], step: &StepEnds<'_, T>, is_chosen: T::Mask) {
        let (zero, one) = (T::zero(), T::one());
        let rate = numbers[Self::PIECE_RATE];
        let share = (step.time[1][0] - numbers[Self::PIECE_START]) * rate;
        let time = Quintic::new(step.time[0], step.time[1], step.length);
        let mut is_extreme = zero;
        for (deviation, &(reading, of, is_integrated)) in self.deviations.iter().enumerate() {
            let own = &mut numbers[self.deviation(deviation)..][..Self::PER_DEVIATION];
            let reference = Quintic { coefficients: array(&own[Self::REFERENCE..]) };
            let end = [reference.value(share), reference.slope(share) * rate, reference.curvature(share) * rate * rate];
            let ends = [array(&own[Self::BEFORE..]), end];
            let [start, last] =
                [0, 1].map(|side| deviation_at(of, || step.reading(reading, side), ends[side], step.time[side]));
            let polynomial = Quintic::new(start, last, step.length);
            let [low, high] = polynomial.limits();
            // The ends of the step are known; between them an extreme is where the limits are beyond both.
            let ends = [polynomial.value(zero), polynomial.value(one)];
            let largest = own[Self::LARGEST].max(ends[0]).max(ends[1]);
            let smallest = own[Self::SMALLEST].min(ends[0]).min(ends[1]);
            is_extreme = T::select(largest.less_than(high), one, is_extreme);
            is_extreme = T::select(low.less_than(smallest), one, is_extreme);
            own[Self::LARGEST] = T::select(is_chosen, largest, own[Self::LARGEST]);
            own[Self::SMALLEST] = T::select(is_chosen, smallest, own[Self::SMALLEST]);
            if is_integrated {
                let (mut integral, mut integral_of_square) = (own[Self::INTEGRAL], own[Self::INTEGRAL_OF_SQUARE]);
                for (place, weight) in GAUSS {
                    let place = T::from_f64(place);
                    let (value, weight_s) = (polynomial.value(place), T::from_f64(weight) * time.slope(place));
                    integral += weight_s * value;
                    integral_of_square += weight_s * value * value;
                }
                own[Self::INTEGRAL] = T::select(is_chosen, integral, own[Self::INTEGRAL]);
                own[Self::INTEGRAL_OF_SQUARE] = T::select(is_chosen, integral_of_square, own[Self::INTEGRAL_OF_SQUARE]);
            }
            for k in 0..3 {
                own[Self::BEFORE + k] = T::select(is_chosen, end[k], own[Self::BEFORE + k]);
            }
            own[Self::POLYNOMIAL..].copy_from_slice(&polynomial.coefficients);
        }
        numbers[Self::IS_EXTREME] = is_extreme;
    }

    /// Reads at the instant, which lies within the step.
    pub fn look<T: Real>(&self, numbers: &mut [T], step: &StepEnds<'_, T>) {
        let share = share_of(numbers[Self::INSTANT], step.time, step.length);
        for reading in 0..self.readings {
            let [start, end] = [0, 1].map(|side| step.reading(reading, side));
            numbers[Self::VALUES + reading] = Quintic::new(start, end, step.length).value(share);
        }
    }
}

/// A deviation at an end of a step with its derivatives over the variable of integration; `reference`: those of what it is compared with,
/// over time.
fn deviation_at<T: Real>(of: Deviation, reading: impl FnOnce() -> [T; 3], reference: [T; 3], time: [T; 3]) -> [T; 3] {
    // d/ds = w d/dt, d²/ds² = w² d²/dt² + w' d/dt.
    let [value, rate, acceleration] = reference;
    let over_step = [value, rate * time[1], acceleration * time[1] * time[1] + rate * time[2]];
    match of {
        Deviation::Value => reading(),
        Deviation::Dimensional => over_step,
        Deviation::Total | Deviation::Clearance => {
            let actual = reading();
            [0, 1, 2].map(|k| actual[k] - over_step[k])
        }
    }
}

/// Which share of a step, in its variable of integration, has passed at `time_s`.
fn share_of<T: Real>(time_s: T, [start, end]: [[T; 3]; 2], length: T) -> T {
    let (zero, one, least) = (T::zero(), T::one(), T::from_f64(f64::MIN_POSITIVE));
    let within = |share: T| share.max(zero).min(one);
    let passed = within((time_s - start[0]) / (end[0] - start[0]));
    // A pace that changes evenly gives a good guess; Newton's method on the time as a polynomial of degree five the rest.
    let (first, last) = (start[1], end[1]);
    let squares = (first * first + passed * (last * last - first * first)).max(zero);
    let mut share = within(passed * (first + last) / (first + squares.sqrt()).max(least));
    let time = Quintic::new(start, end, length);
    for _ in 0..NEWTON_STEPS {
        share = within(share - (time.value(share) - time_s) / time.slope(share).max(least));
    }
    share
}

fn array<T: Copy, const N: usize>(numbers: &[T]) -> [T; N] {
    std::array::from_fn(|k| numbers[k])
}
