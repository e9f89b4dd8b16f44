//! The largest length of an offset and what plays add to it, to first order.

use super::reach::Reach;
use crate::accuracy::AccuracyError;
use crate::accuracy::slice::dot;

/// Directions that are looked at, over the whole sphere or circle.
const DIRECTIONS: usize = 64;
/// Of these the best are searched from.
const STARTS: usize = 8;
/// Most steps of a search.
const MAX_STEPS: usize = 500;

/// The largest |d + G p|, with the place that makes it.
#[derive(Debug, Clone)]
pub(super) struct Longest {
    pub length: f64,
    /// Variables in units of the radii.
    pub place: Vec<f64>,
}

/// The largest length of d + G p over the plays. It is convex in p, so that its extremes are local: from the best of many directions, each step
/// goes on in the direction of the displacement so far, which never makes it shorter.
pub(super) fn longest(reach: &dyn Reach, offset: &[f64], gains: &[Vec<f64>]) -> Result<Longest, AccuracyError> {
    let mut step = Step { reach, offset, gains, along: Vec::new(), place: Vec::new() };
    let mut starts: Vec<(f64, [f64; 3])> = Vec::with_capacity(DIRECTIONS);
    for number in 0..DIRECTIONS {
        starts.push(step.from(spread_direction(number, offset.len()))?);
    }
    starts.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut best = Longest { length: -1.0, place: Vec::new() };
    for (mut length, mut direction) in starts.into_iter().take(STARTS) {
        for _ in 0..MAX_STEPS {
            let (next, turned) = step.from(direction)?;
            let has_grown = next > length * (1.0 + 1e-15);
            if next > best.length {
                best = Longest { length: next, place: step.place.clone() };
            }
            if !has_grown {
                break;
            }
            (length, direction) = (next, turned);
        }
    }
    Ok(best)
}

/// From directions to displacements.
struct Step<'a> {
    reach: &'a dyn Reach,
    offset: &'a [f64],
    gains: &'a [Vec<f64>],
    along: Vec<f64>,
    place: Vec<f64>,
}

impl Step<'_> {
    /// Length and direction of the displacement that goes farthest in a direction.
    fn from(&mut self, direction: [f64; 3]) -> Result<(f64, [f64; 3]), AccuracyError> {
        self.along.clear();
        self.along.resize(self.gains.first().map_or(0, Vec::len), 0.0);
        for (own, share) in self.gains.iter().zip(direction) {
            self.along.iter_mut().zip(own).for_each(|(sum, gain)| *sum += share * gain);
        }
        self.reach.farthest(&self.along, &mut self.place)?;
        let mut vector = [0.0; 3];
        for ((entry, offset), own) in vector.iter_mut().zip(self.offset).zip(self.gains) {
            *entry = offset + dot(own, &self.place);
        }
        let length = dot(&vector, &vector).sqrt();
        Ok((length, if length > 0.0 { vector.map(|entry| entry / length) } else { direction }))
    }
}

/// Directions spread over the sphere (a spiral with the golden angle), or the circle.
fn spread_direction(number: usize, size: usize) -> [f64; 3] {
    let share = (number as f64 + 0.5) / DIRECTIONS as f64;
    if size == 3 {
        let (sine, cosine) = loosepin_math::sin_cos(2.399_963_229_728_653 * number as f64);
        let height = 1.0 - 2.0 * share;
        let across = (1.0 - height * height).sqrt();
        return [across * cosine, across * sine, height];
    }
    let (sine, cosine) = loosepin_math::sin_cos(std::f64::consts::TAU * share);
    [cosine, sine, 0.0]
}
