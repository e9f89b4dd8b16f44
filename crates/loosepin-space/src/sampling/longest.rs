//! The largest length of an offset and what plays add to it, to first order.

use super::reach::Reach;
use crate::accuracy::AccuracyError;
use crate::accuracy::linear::vectors::dot;

/// Directions that are looked at, over the half sphere or half circle, and their opposites.
const DIRECTIONS: usize = 32;
/// Of these the best are searched from, as far as they are not near an end that is found.
const STARTS: usize = 8;
/// Cosine of the angle from an end within which a start is not looked at.
const NEAR: f64 = 0.95;
/// Most steps of a search.
const MAX_STEPS: usize = 200;
/// Growth of a length that ends a search, relative to it.
const GROWTH: f64 = 1e-12;

/// The largest |d + G p|, with the place that makes it.
#[derive(Debug, Clone)]
pub(super) struct Longest {
    pub length: f64,
    /// Variables in units of the radii.
    pub place: Vec<f64>,
}

/// Displacements G p by plays, in up to three directions.
pub(super) struct Displacements<'a> {
    reach: &'a dyn Reach,
    gains: &'a [Vec<f64>],
    along: Vec<f64>,
    place: Vec<f64>,
}

impl<'a> Displacements<'a> {
    /// With the gains in each direction.
    pub(super) fn new(reach: &'a dyn Reach, gains: &'a [Vec<f64>]) -> Self {
        Self { reach, gains, along: Vec::new(), place: Vec::new() }
    }

    /// The displacement that goes farthest in a direction, which need not be a unit vector.
    pub(super) fn farthest(&mut self, direction: [f64; 3]) -> Result<[f64; 3], AccuracyError> {
        self.along.clear();
        self.along.resize(self.gains.first().map_or(0, Vec::len), 0.0);
        for (own, share) in self.gains.iter().zip(direction) {
            self.along.iter_mut().zip(own).for_each(|(sum, gain)| *sum += share * gain);
        }
        self.reach.farthest(&self.along, &mut self.place)?;
        let mut vector = [0.0; 3];
        vector.iter_mut().zip(self.gains).for_each(|(entry, own)| *entry = dot(own, &self.place));
        Ok(vector)
    }

    /// Those in directions all around.
    pub(super) fn all_around(&mut self) -> Result<Vec<[f64; 3]>, AccuracyError> {
        let mut all = Vec::with_capacity(2 * DIRECTIONS);
        for number in 0..DIRECTIONS {
            let direction = spread_direction(number, self.gains.len());
            let own = self.farthest(direction)?;
            all.push(own);
            let is_symmetric = self.reach.is_symmetric();
            let opposite = direction.map(|entry| -entry);
            all.push(if is_symmetric { own.map(|entry| -entry) } else { self.farthest(opposite)? });
        }
        Ok(all)
    }

    /// The largest length of d + G p. It is convex in p, so that its extremes are local: from the best of `starts`, each step goes on in the
    /// direction of the displacement so far, which never makes it shorter.
    pub(super) fn longest(&mut self, offset: [f64; 3], starts: &[[f64; 3]]) -> Result<Longest, AccuracyError> {
        let mut starts: Vec<(f64, [f64; 3])> =
            starts.iter().map(|start| length_and_direction(sum(offset, *start))).collect();
        starts.sort_by(|a, b| b.0.total_cmp(&a.0));
        let is_even = offset == [0.0; 3] && self.reach.is_symmetric();
        let mut best = Longest { length: -1.0, place: Vec::new() };
        let mut ends: Vec<[f64; 3]> = Vec::with_capacity(STARTS);
        for (mut length, mut direction) in starts {
            if ends.len() == STARTS {
                break;
            }
            // Without an offset, opposite displacements are alike.
            let cosine = |end: &[f64; 3]| if is_even { dot(end, &direction).abs() } else { dot(end, &direction) };
            if ends.iter().any(|end| cosine(end) > NEAR) {
                continue;
            }
            for _ in 0..MAX_STEPS {
                let (next, turned) = length_and_direction(sum(offset, self.farthest(direction)?));
                if next > best.length {
                    best.length = next;
                    best.place.clone_from(&self.place);
                }
                if !(next > length * (1.0 + GROWTH)) {
                    break;
                }
                (length, direction) = (next, turned);
            }
            ends.push(direction);
        }
        Ok(best)
    }
}

pub(super) fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Length and unit vector; along the first direction where there is no length.
fn length_and_direction(vector: [f64; 3]) -> (f64, [f64; 3]) {
    let length = dot(&vector, &vector).sqrt();
    (length, if length > 0.0 { vector.map(|entry| entry / length) } else { [1.0, 0.0, 0.0] })
}

/// Directions spread over the half sphere (a spiral with the golden angle), or the half circle.
fn spread_direction(number: usize, size: usize) -> [f64; 3] {
    let share = (number as f64 + 0.5) / DIRECTIONS as f64;
    if size == 3 {
        let (sine, cosine) = loosepin_math::sin_cos(2.399_963_229_728_653 * number as f64);
        let across = (1.0 - share * share).sqrt();
        return [across * cosine, across * sine, share];
    }
    let (sine, cosine) = loosepin_math::sin_cos(std::f64::consts::PI * share);
    [cosine, sine, 0.0]
}
