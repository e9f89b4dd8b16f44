//! Ends that no deviation passes: a Taylor polynomial of degree two with a remainder on intervals.
//!
//! D(e, τ) = y(e, τ) - y(0, τ) is the deviation of an output by the play e (and the dimensions) while the input is τ. Along the straight
//! way from (0, 0) to (e, τ)
//!
//! ```text
//! D = g·e + e·H̃ e/2 + τ h̃·e
//! ```
//!
//! with the gradient g at the ideal position and with H̃ and h̃ in the intervals of d²y/de² and d²y/de dτ over all positions. So the input
//! is one more number of the quadratic function, without first and second derivatives of its own. The same holds for dimensions that
//! the position without play has too.

use super::enclosure::Enclosed;
use super::path_part::PathPart;
use super::positions::Positions;
use super::variables::balls_and_numbers;
use loosepin_math::{Interval, QuadraticOverBalls, Real};
use loosepin_result::study::Reference;
use std::ops::Range;

/// The lowest and the highest deviation that one output can have, proven.
pub(in super::super) struct Ends {
    balls: Vec<Range<usize>>,
    /// Whether the last number is the input.
    has_input: bool,
    /// From this number on they change the position that deviations are counted from as well: the input, and perhaps dimensions.
    first_of_reference: usize,
}

impl Ends {
    /// `balls` of the play, `dimensions` numbers and perhaps the input. What is counted from zero is counted from the ideal position of nominal
    /// parts at the middle of the input.
    pub fn new(balls: Vec<Range<usize>>, dimensions: usize, has_input: bool, reference: Reference) -> Self {
        let plays = balls.last().map_or(0, |ball| ball.end);
        let first_of_reference = match reference {
            Reference::SameParts => plays,
            Reference::NominalParts => plays + dimensions,
            // The output itself, seen from this position: the input moves it, and nothing moves the position.
            Reference::Zero => usize::MAX,
        };
        let balls = balls_and_numbers(balls, dimensions + usize::from(has_input));
        Self { balls, has_input, first_of_reference }
    }

    /// Ends `[lowest, highest]` of the output that counts positions by `weights`; infinite if unproven.
    pub fn of(&self, positions: &Positions, weights: &[(usize, f64)]) -> [f64; 2] {
        match positions {
            Positions::InOneBox(enclosed) => self.in_one_box(enclosed, weights),
            Positions::InSlices(sliced) => {
                let end = |sign: f64| sliced.upper_end(weights, sign, &self.balls, self.first_of_reference);
                [0.0 - end(-1.0), end(1.0)]
            }
        }
    }

    fn in_one_box(&self, enclosed: &Enclosed, weights: &[(usize, f64)]) -> [f64; 2] {
        let n = self.balls.last().map_or(0, |ball| ball.end);
        let sum = |parts: &[Vec<Interval>], at: usize, sign: f64| {
            weights.iter().fold(Interval::ZERO, |sum, (place, weight)| {
                sum + Interval::from_f64(sign * weight) * parts[*place][at]
            })
        };
        let end = |sign: f64| {
            let is_of_reference = |place: usize| place >= self.first_of_reference;
            let gradient: Vec<Interval> = (0..n)
                .map(|k| if is_of_reference(k) { Interval::ZERO } else { sum(&enclosed.gradients, k, sign) })
                .collect();
            let hessian: Vec<Interval> = (0..n * n)
                .map(|at| {
                    let is_of_both = is_of_reference(at / n) && is_of_reference(at % n);
                    if is_of_both { Interval::ZERO } else { sum(&enclosed.hessians, at, sign) }
                })
                .collect();
            QuadraticOverBalls { balls: &self.balls, gradient: &gradient, hessian: &hessian }.upper_end()
        };
        if n == 0 {
            return [0.0; 2];
        }
        // Zero has no sign here.
        [0.0 - end(-1.0), end(1.0)]
    }

    /// As [`Self::of`] for the error of a path, of which `weights` gives x and y: they turn with the direction of the path while the input
    /// moves.
    pub fn of_path(&self, positions: &Positions, path: PathPart, weights: [f64; 2]) -> [f64; 2] {
        let coordinates = path.coordinates;
        let [low, high] = self.of(positions, &[(coordinates[0], weights[0]), (coordinates[1], weights[1])]);
        if !self.has_input {
            return [low, high];
        }
        let slope = |place: usize| {
            let own = match positions {
                Positions::InOneBox(enclosed) => enclosed.slopes[place].last().copied(),
                Positions::InSlices(sliced) => sliced.slope_by_input(place),
            };
            own.unwrap_or(Interval::WHOLE)
        };
        let turned = path.turned_weights(coordinates.map(slope), weights);
        let mut more = Interval::ZERO;
        for k in 0..2 {
            let [low, high] = self.of(positions, &[(coordinates[k], 1.0)]);
            let reach = Interval::from_f64(f64::max(-low, high));
            more += turned[k].abs() * reach;
        }
        [(Interval::from_f64(low) - more).low(), (Interval::from_f64(high) + more).high()]
    }
}
