//! Scatter of plays that must meet conditions together.

use crate::accuracy::gains::Gains;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::play_set::PlaySet;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::random::random;

/// Batches whose means tell the error.
const BATCHES: usize = 50;

/// A standard deviation from samples.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampledDeviation {
    /// The standard deviation, m or rad.
    pub standard_deviation: f64,
    /// Standard error of it, from the means of 50 batches.
    pub standard_error: f64,
    /// Steps that were made.
    pub samples: usize,
}

impl PoseAccuracy<'_> {
    /// Standard deviation of an output to first order, the plays uniform over all places within their bounds in which redundant rows close:
    /// that is uniform in the section of the product of discs and balls with h·p = 0.
    ///
    /// By hit and run (R. L. Smith, Operations Research 32 (1984) 1296): from a place in a random direction within the section to a uniform
    /// place of the chord. The mean is zero by symmetry.
    /// `samples` are rounded up to whole batches.
    pub fn sampled_deviation(&self, gains: &Gains, samples: usize, seed: u64) -> SampledDeviation {
        let scaled = self.scaled_gains(gains);
        let batch = samples.div_ceil(BATCHES).max(1);
        let (mut place, mut state) = (vec![0.0; self.set.variables()], seed);
        let mut step = |place: &mut Vec<f64>| {
            let direction: Vec<f64> = place.iter().map(|_| random(&mut state)).collect();
            let direction = self.planes.along(&direction);
            let (from, to) = chord(&self.set, place, &direction);
            let share = from + (to - from) * 0.5 * (random(&mut state) + 1.0);
            if share.is_finite() {
                place.iter_mut().zip(&direction).for_each(|(value, part)| *value += share * part);
            }
        };
        // The middle is no place of its own.
        (0..batch).for_each(|_| step(&mut place));
        let squares: Vec<f64> = (0..BATCHES)
            .map(|_| {
                let mut sum = 0.0;
                for _ in 0..batch {
                    step(&mut place);
                    let value = dot(&scaled, &place);
                    sum += value * value;
                }
                sum / batch as f64
            })
            .collect();
        let count = BATCHES as f64;
        let variance = squares.iter().sum::<f64>() / count;
        let spread = squares.iter().map(|square| (square - variance) * (square - variance)).sum::<f64>()
            / (count * (count - 1.0));
        let standard_deviation = variance.sqrt();
        let standard_error = if variance > 0.0 { spread.sqrt() / (2.0 * standard_deviation) } else { 0.0 };
        SampledDeviation { standard_deviation, standard_error, samples: batch * BATCHES }
    }
}

/// From where to where a line is within all balls, in units of the direction.
fn chord(set: &PlaySet, place: &[f64], direction: &[f64]) -> (f64, f64) {
    let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
    for block in set.blocks() {
        let (v, d) = (&place[block.range()], &direction[block.range()]);
        let (a, half, c) = (dot(d, d), dot(v, d), dot(v, v) - 1.0);
        if a > 0.0 {
            let root = (half * half - a * c).max(0.0).sqrt();
            from = from.max((-half - root) / a);
            to = to.min((root - half) / a);
        }
    }
    (from.min(0.0), to.max(0.0))
}
