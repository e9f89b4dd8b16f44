//! Ranges of the play of all joints and of the input: numbers in balls of radius one.

use super::super::play_reach::PlayReach;
use loosepin_math::{Real, Vec2};
use std::ops::Range;

/// The displacements of all joints with play as linear functions of numbers v in balls of radius one.
///
/// | reach | numbers | displacement |
/// |---|---|---|
/// | disc of radius r | v₁² + v₂² ≤ 1 | (r v₁, r v₂) |
/// | slot of clearance c | \|v\| ≤ 1 | (c v, 0) |
/// | guide of clearance c and largest tilt θ | \|u\| ≤ 1, \|v\| ≤ 1 | (c (u + v)/2, θ (u - v)/2) |
///
/// The last holds a little more than the guide allows: its border is bent inwards between the four ends that both have.
#[derive(Debug, Clone)]
pub(in super::super) struct Variables {
    plays: Vec<PlayVariables>,
    /// Places of the numbers of each ball.
    pub balls: Vec<Range<usize>>,
}

#[derive(Debug, Clone, Copy)]
enum PlayVariables {
    /// The joint cannot be displaced.
    Fixed,
    Disc {
        first: usize,
        radius_m: f64,
    },
    Line {
        place: usize,
        clearance_m: f64,
    },
    Guide {
        first: usize,
        half_clearance_m: f64,
        half_tilt_rad: f64,
    },
}

/// The largest tilt comes from an iteration that ends at round-off.
const TILT_ROUND_OFF: f64 = 1e-13;

impl Variables {
    /// The numbers of joints with these reaches.
    pub fn new(reaches: &[PlayReach]) -> Self {
        let mut balls: Vec<Range<usize>> = Vec::new();
        let mut take = |dimensions: &[usize]| {
            let first = balls.last().map_or(0, |ball| ball.end);
            let mut next = first;
            for dimension in dimensions {
                balls.push(next..next + dimension);
                next += dimension;
            }
            first
        };
        let plays = reaches
            .iter()
            .map(|reach| match *reach {
                PlayReach::Disc { radius_m } if radius_m > 0.0 => PlayVariables::Disc { first: take(&[2]), radius_m },
                PlayReach::Slot { clearance_m } if clearance_m > 0.0 => {
                    PlayVariables::Line { place: take(&[1]), clearance_m }
                }
                PlayReach::Guide { clearance_m, largest_tilt_rad, .. } if clearance_m > 0.0 => PlayVariables::Guide {
                    first: take(&[1, 1]),
                    half_clearance_m: 0.5 * clearance_m,
                    half_tilt_rad: 0.5 * largest_tilt_rad * (1.0 + TILT_ROUND_OFF),
                },
                _ => PlayVariables::Fixed,
            })
            .collect();
        Self { plays, balls }
    }

    /// How many numbers there are.
    pub fn count(&self) -> usize {
        self.balls.last().map_or(0, |ball| ball.end)
    }

    /// The displacement of each joint with play for these numbers.
    pub fn displacements<'a, T: Real>(&'a self, numbers: &'a [T]) -> impl Iterator<Item = Vec2<T>> + 'a {
        self.plays.iter().map(|play| match *play {
            PlayVariables::Fixed => Vec2::zero(),
            PlayVariables::Disc { first, radius_m } => {
                Vec2::new(numbers[first], numbers[first + 1]) * T::from_f64(radius_m)
            }
            PlayVariables::Line { place, clearance_m } => {
                Vec2::new(numbers[place] * T::from_f64(clearance_m), T::zero())
            }
            PlayVariables::Guide { first, half_clearance_m, half_tilt_rad } => {
                let [u, v] = [numbers[first], numbers[first + 1]];
                Vec2::new((u + v) * T::from_f64(half_clearance_m), (u - v) * T::from_f64(half_tilt_rad))
            }
        })
    }
}

/// Balls of the play, and behind them so many numbers that lie between -1 and 1 each.
pub(super) fn balls_and_numbers(mut balls: Vec<Range<usize>>, numbers: usize) -> Vec<Range<usize>> {
    for _ in 0..numbers {
        let next = balls.last().map_or(0, |ball| ball.end);
        balls.push(next..next + 1);
    }
    balls
}
