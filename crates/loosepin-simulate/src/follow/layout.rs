//! The arithmetic of what is followed, on the numbers of one lane. Written once over [`Real`]: done as it stands for one run, written
//! down for many.

use super::extremes::{extremes_within, points_within};
use super::inside::InsideLayout;
use super::path::PathLayout;
use super::plan::Follow;
use super::step_ends::{GAUSS, StepEnds, array, deviation_at};
use loosepin_math::{Quintic, Real};
use loosepin_result::study::Deviation;

/// Newton's steps to an instant within a step, from a guess that is exact where the pace changes evenly: from a tenth of the step away they
/// end on 1e-16 of it, and guesses are a hundredth away at most. (The third step is 6e-9 at most, the fourth round-off: slider-cranks, a four-bar.)
const NEWTON_STEPS: usize = 4;

/// Layout of the numbers of a lane that belong to the followed quantities.
#[derive(Debug, Clone)]
pub(crate) struct FollowLayout {
    readings: usize,
    deviations: Vec<(usize, Deviation, bool)>,
    paths: Vec<PathLayout>,
    inside: InsideLayout,
}

impl FollowLayout {
    /// Offset of the start of the current piece of the ideal curves, s.
    pub const PIECE_START: usize = 0;
    /// One over how long it lasts, 1/s.
    pub const PIECE_RATE: usize = 1;
    /// The instant that is looked at, s; the next one of a run on a lane.
    pub const INSTANT: usize = 2;
    /// 1 where some deviation may have a new extreme within the step.
    pub const IS_EXTREME: usize = 3;
    /// 1 where some value that is looked at inside the step may be a new extreme between the points.
    pub const IS_PEAK: usize = 4;
    /// The readings at the instant; behind them the readings over the step, each a polynomial of its share.
    pub const VALUES: usize = 5;
    /// Numbers of such a polynomial.
    pub const PER_READING: usize = 6;
    /// Numbers of a deviation, from [`Self::deviation`] on: the polynomial that it is compared with, over the piece.
    pub const REFERENCE: usize = 0;
    /// Value, rate and acceleration of that at the start of the step.
    pub const BEFORE: usize = 6;
    /// Largest value so far; behind it the smallest one, the integral over time and that of the square.
    pub const LARGEST: usize = 9;
    /// Smallest value so far.
    pub const SMALLEST: usize = Self::LARGEST + 1;
    const INTEGRAL: usize = Self::LARGEST + 2;
    const INTEGRAL_OF_SQUARE: usize = Self::LARGEST + 3;
    /// The deviation over the step as a polynomial of its share.
    pub const POLYNOMIAL: usize = 13;
    const PER_DEVIATION: usize = 19;

    /// For what `follow` says.
    pub fn new(follow: &Follow) -> Self {
        let deviations = follow.deviations.iter().map(|one| (one.reading, one.deviation, one.is_integrated)).collect();
        let inside = InsideLayout::default();
        let mut layout = Self { readings: follow.readings.len(), deviations, paths: Vec::new(), inside };
        let first = layout.deviation(layout.deviations.len());
        let paths = follow.paths.iter().enumerate();
        layout.paths = paths.map(|(k, &path)| PathLayout { first: first + PathLayout::LENGTH * k, path }).collect();
        layout.inside =
            InsideLayout { first: first + PathLayout::LENGTH * layout.paths.len(), count: follow.inside.len() };
        layout
    }

    /// Readings.
    pub fn readings(&self) -> usize {
        self.readings
    }

    /// Deviations.
    pub fn deviations(&self) -> usize {
        self.deviations.len()
    }

    /// Paths.
    pub fn paths(&self) -> &[PathLayout] {
        &self.paths
    }

    /// Readings that are looked at inside the steps.
    pub fn inside(&self) -> &InsideLayout {
        &self.inside
    }

    /// Whether any value is reduced over the recorded part from the ends of the steps alone.
    pub fn reduces(&self) -> bool {
        !self.deviations.is_empty() || !self.paths.is_empty()
    }

    /// Which reading a deviation is of, and which deviation it is.
    pub fn of(&self, deviation: usize) -> (usize, Deviation) {
        let (reading, of, _) = self.deviations[deviation];
        (reading, of)
    }

    /// Offset of the polynomial of a reading over the step.
    pub fn reading(&self, reading: usize) -> usize {
        Self::VALUES + self.readings + Self::PER_READING * reading
    }

    /// Offset of the numbers of a deviation.
    pub fn deviation(&self, deviation: usize) -> usize {
        self.reading(self.readings) + Self::PER_DEVIATION * deviation
    }

    /// How many numbers there are.
    pub fn length(&self) -> usize {
        let paths = PathLayout::LENGTH * self.paths.len();
        let is_empty = self.readings == 0 && self.inside.count == 0;
        if is_empty { 0 } else { self.deviation(self.deviations.len()) + paths + self.inside.length() }
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
        for path in &self.paths {
            is_extreme = is_extreme.max(path.follow(numbers, step, (share, rate), is_chosen));
        }
        numbers[Self::IS_EXTREME] = is_extreme;
    }

    /// The largest and the smallest value of all that is reduced with those of the current step, each with its place among the numbers of the
    /// lane, which `get` reads and `set` changes.
    pub fn take_extremes<N>(&self, numbers: &mut N, get: impl Fn(&N, usize) -> f64, set: impl Fn(&mut N, usize, f64)) {
        for deviation in 0..self.deviations.len() {
            for (place, extreme) in self.extremes(deviation, |place| get(numbers, place)) {
                set(numbers, place, extreme);
            }
        }
        for path in &self.paths {
            for (place, extreme) in path.extremes(|place| get(numbers, place)).into_iter().flatten() {
                set(numbers, place, extreme);
            }
        }
    }

    /// The largest and the smallest value of a deviation with those of the current step, each with its place among the numbers of the lane,
    /// which `get` reads.
    fn extremes(&self, deviation: usize, get: impl Fn(usize) -> f64) -> [(usize, f64); 2] {
        let first = self.deviation(deviation);
        let polynomial = Quintic { coefficients: std::array::from_fn(|k| get(first + Self::POLYNOMIAL + k)) };
        let [largest, smallest] = [first + Self::LARGEST, first + Self::SMALLEST];
        let value = |share: f64| polynomial.value(share);
        let found = extremes_within(&points_within(value), polynomial.limits(), [get(largest), get(smallest)], value);
        [(largest, found[0]), (smallest, found[1])]
    }

    /// Puts down the polynomials of the readings over the step.
    pub fn spread<T: Real>(&self, numbers: &mut [T], step: &StepEnds<'_, T>) {
        for reading in 0..self.readings {
            let [start, end] = [0, 1].map(|side| step.reading(reading, side));
            let polynomial = Quintic::new(start, end, step.length);
            numbers[self.reading(reading)..][..Self::PER_READING].copy_from_slice(&polynomial.coefficients);
        }
    }

    /// Reads at the instant, which lies within a step that lasts from one time to another, from the polynomials of the readings.
    pub fn look<T: Real>(&self, numbers: &mut [T], time: [[T; 3]; 2], length: T) {
        let share = share_of(numbers[Self::INSTANT], time, length);
        for reading in 0..self.readings {
            let polynomial = Quintic { coefficients: array(&numbers[self.reading(reading)..]) };
            numbers[Self::VALUES + reading] = polynomial.value(share);
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
