//! The error of a point from its ideal path over a step.
//!
//! The error has two coordinates, each a polynomial of degree five over the step as every deviation ([`super`]). The velocity of
//! the ideal point is the cubic through its values and rates at both ends, over time: tangent and curvature of the path follow from it.

use super::extremes::{extremes_within, points_within};
use super::plan::FollowedPath;
use super::step_ends::{GAUSS, StepEnds, array, deviation_at};
use crate::ideal::path_error::path_error;
use crate::stepping::search::ROOM;
use loosepin_math::{Quintic, Real, Vec2};
use loosepin_result::study::{Deviation, PathError};

/// Shares of a step at which errors are looked at.
const SHARES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// The numbers of a path, from [`PathLayout::first`] on: two coordinates of the error, two of the ideal point, the passing of time, and
/// four parts.
#[derive(Debug, Clone)]
pub(crate) struct PathLayout {
    /// Offset of its numbers.
    pub first: usize,
    /// The followed path.
    pub path: FollowedPath,
}

/// The polynomials of a step.
struct Over<T> {
    error: [Quintic<T>; 2],
    velocity: [[T; 4]; 2],
    /// The share of the time of the step by the share of its variable.
    passed: Quintic<T>,
    /// One over how long the step lasts, 1/s.
    per_s: T,
}

/// A curve of the ideal motion that a path needs.
pub(crate) struct PathReference {
    /// Offset of its polynomial over the piece, six numbers.
    pub first: usize,
    /// Its reading, and the deviation that is compared with it.
    pub curve: (usize, Deviation),
    /// How many numbers of it at the start of a step stand behind the polynomial: value, rate and acceleration, or the last two.
    pub derivatives: usize,
}

impl PathReference {
    /// Offset of the numbers at the start of a step.
    pub fn before(&self) -> usize {
        self.first + 6
    }
}

impl PathLayout {
    /// Offset for a coordinate of the error: the polynomial of its reference over the piece, its jet at the start of the step, the error
    /// over the step.
    const ERROR: usize = 0;
    const PER_ERROR: usize = 15;
    /// Offset for a coordinate of the ideal point: the polynomial over the piece, its rate and acceleration at the start of the step, its
    /// velocity over the step.
    const IDEAL: usize = 2 * Self::PER_ERROR;
    const PER_IDEAL: usize = 12;
    const PASSED: usize = Self::IDEAL + 2 * Self::PER_IDEAL;
    const PER_S: usize = Self::PASSED + 6;
    const PARTS: usize = Self::PER_S + 1;
    /// Largest, smallest, integral, integral of the square.
    const PER_PART: usize = 4;
    /// How many numbers there are.
    pub const LENGTH: usize = Self::PARTS + 4 * Self::PER_PART;

    /// The curves that are put down piece by piece: two that the coordinates of the error are compared with, two of the ideal point.
    pub fn references(&self) -> [PathReference; 4] {
        let [x, y] = self.path.readings;
        let error = |k: usize, reading: usize| PathReference {
            first: self.first + Self::ERROR + Self::PER_ERROR * k,
            curve: (reading, self.path.deviation),
            derivatives: 3,
        };
        let ideal = |k: usize, reading: usize| PathReference {
            first: self.first + Self::IDEAL + Self::PER_IDEAL * k,
            curve: (reading, self.ideal()),
            derivatives: 2,
        };
        [error(0, x), error(1, y), ideal(0, x), ideal(1, y)]
    }

    /// The deviation that is compared with the ideal motion whose path counts.
    fn ideal(&self) -> Deviation {
        if self.path.deviation.is_by_play_alone() { self.path.deviation } else { Deviation::of_all_causes() }
    }

    /// Offset of the numbers of a part: largest, smallest, integral, integral of the square.
    pub fn part(&self, part: usize) -> usize {
        self.first + Self::PARTS + Self::PER_PART * part
    }

    /// Follows a step to its end, where `is_chosen`, which lies at a `share` of the current piece of the curves, `rate` over time; 1 where
    /// a requested part may have a new extreme between the points.
    pub fn follow<T: Real>(
        &self,
        numbers: &mut [T],
        step: &StepEnds<'_, T>,
        (share, rate): (T, T),
        is_chosen: T::Mask,
    ) -> T {
        let (zero, one) = (T::zero(), T::one());
        let of = self.path.deviation;
        let lasting = step.time[1][0] - step.time[0][0];
        for reference in self.references() {
            let (before, curve) = (reference.before(), Quintic { coefficients: array(&numbers[reference.first..]) });
            let end = [curve.value(share), curve.slope(share) * rate, curve.curvature(share) * rate * rate];
            let end = &end[3 - reference.derivatives..];
            if let &[value, speed, change] = end {
                let ends = [array(&numbers[before..]), [value, speed, change]];
                let reading = |side| step.reading(reference.curve.0, side);
                let [start, last] = [0, 1].map(|side| deviation_at(of, || reading(side), ends[side], step.time[side]));
                let polynomial = Quintic::new(start, last, step.length);
                numbers[before + 3..][..6].copy_from_slice(&polynomial.coefficients);
            } else {
                let cubic = cubic(array(&numbers[before..]), [end[0], end[1]], lasting);
                numbers[before + 2..][..4].copy_from_slice(&cubic);
            }
            for (k, &end) in end.iter().enumerate() {
                numbers[before + k] = T::select(is_chosen, end, numbers[before + k]);
            }
        }
        let start = step.time[0];
        // A step in which time stands still is at its start.
        let per_s = one / lasting.max(T::from_f64(f64::MIN_POSITIVE));
        let time = Quintic::new([zero, start[1], start[2]], [lasting, step.time[1][1], step.time[1][2]], step.length);
        numbers[self.first + Self::PASSED..][..6].copy_from_slice(&time.coefficients.map(|c| c * per_s));
        numbers[self.first + Self::PER_S] = per_s;
        let over = self.over(|place| numbers[place]);
        let mut is_extreme = zero;
        for part in self.asked() {
            let own = self.part(part);
            let points = SHARES.map(|share| over.at(PathError::ALL[part], T::from_f64(share)));
            let [low, high] =
                [points.iter().fold(points[0], |l, p| l.min(*p)), points.iter().fold(points[0], |h, p| h.max(*p))];
            let room = T::from_f64(ROOM) * (high - low);
            // A part without a value anywhere has none from then on: the sum is no number then, and comparisons would pass over it.
            let nothing = points.iter().fold(zero, |sum, point| sum + *point) * zero;
            let (largest, smallest) = (high.max(numbers[own]) + nothing, low.min(numbers[own + 1]) + nothing);
            is_extreme = T::select(largest.less_than(high + room), one, is_extreme);
            is_extreme = T::select((low - room).less_than(smallest), one, is_extreme);
            numbers[own] = T::select(is_chosen, largest, numbers[own]);
            numbers[own + 1] = T::select(is_chosen, smallest, numbers[own + 1]);
            if self.path.is_integrated {
                let (mut integral, mut square) = (numbers[own + 2], numbers[own + 3]);
                for (place, weight) in GAUSS {
                    let place = T::from_f64(place);
                    let (value, weight_s) =
                        (over.at(PathError::ALL[part], place), T::from_f64(weight) * time.slope(place));
                    integral += weight_s * value;
                    square += weight_s * value * value;
                }
                numbers[own + 2] = T::select(is_chosen, integral, numbers[own + 2]);
                numbers[own + 3] = T::select(is_chosen, square, numbers[own + 3]);
            }
        }
        is_extreme
    }

    /// Parts that are asked for.
    fn asked(&self) -> impl Iterator<Item = usize> + use<> {
        let parts = self.path.parts;
        (0..4).filter(move |&part| parts[part])
    }

    fn over<T: Real>(&self, get: impl Fn(usize) -> T) -> Over<T> {
        let error = |k| Quintic {
            coefficients: std::array::from_fn(|c| get(self.first + Self::ERROR + Self::PER_ERROR * k + 9 + c)),
        };
        let velocity = |k| std::array::from_fn(|c| get(self.first + Self::IDEAL + Self::PER_IDEAL * k + 8 + c));
        Over {
            error: [error(0), error(1)],
            velocity: [velocity(0), velocity(1)],
            passed: Quintic { coefficients: std::array::from_fn(|c| get(self.first + Self::PASSED + c)) },
            per_s: get(self.first + Self::PER_S),
        }
    }

    /// The largest and the smallest value of each part with those of the current step where it is asked for, each with its place among the
    /// numbers of the lane, which `get` reads.
    pub fn extremes(&self, get: impl Fn(usize) -> f64) -> [[(usize, f64); 2]; 4] {
        let over = self.over(&get);
        [0, 1, 2, 3].map(|part| {
            let own = self.part(part);
            let known = [get(own), get(own + 1)];
            let [largest, smallest] = if self.path.parts[part] {
                let value = |share: f64| over.at(PathError::ALL[part], share);
                let points = points_within(value);
                let low = points.iter().fold(f64::INFINITY, |low, point| low.min(point.1));
                let high = points.iter().fold(f64::NEG_INFINITY, |high, point| high.max(point.1));
                let room = ROOM * (high - low);
                extremes_within(&points, [low - room, high + room], known, value)
            } else {
                known
            };
            [(own, largest), (own + 1, smallest)]
        })
    }
}

impl<T: Real> Over<T> {
    /// A part of the error at a share of the variable of the step.
    #[inline(always)]
    fn at(&self, part: PathError, share: T) -> T {
        let error = Vec2::new(self.error[0].value(share), self.error[1].value(share));
        let (zero, one) = (T::zero(), T::one());
        let passed = self.passed.value(share).max(zero).min(one);
        let [two, three] = [2.0, 3.0].map(T::from_f64);
        let [velocity, change] = [
            self.velocity.map(|c| c[0] + passed * (c[1] + passed * (c[2] + passed * c[3]))),
            self.velocity.map(|c| c[1] + passed * (two * c[2] + passed * (three * c[3]))),
        ];
        let [velocity, acceleration] =
            [velocity, change.map(|change| change * self.per_s)].map(|[x, y]| Vec2::new(x, y));
        path_error(part, error, velocity, acceleration)
    }
}

/// The cubic through value and rate at both ends of a step, over [0, 1].
fn cubic<T: Real>(start: [T; 2], end: [T; 2], lasting: T) -> [T; 4] {
    let [two, three] = [2.0, 3.0].map(T::from_f64);
    let (first, last, rise) = (start[1] * lasting, end[1] * lasting, end[0] - start[0]);
    [start[0], first, three * rise - two * first - last, first + last - two * rise]
}
