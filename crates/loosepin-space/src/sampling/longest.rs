//! The largest length of an offset and what plays add to it.

use crate::accuracy::play_set::PlaySet;
use crate::accuracy::slice::{Planes, dot, largest};

/// Directions from which a search starts, over the whole sphere or circle.
const STARTS: usize = 64;
/// Most steps of a search.
const MAX_STEPS: usize = 500;

/// The largest |d + G p|, with the place that makes it.
#[derive(Debug, Clone)]
pub(super) struct Longest {
    pub length: f64,
    /// Variables in units of the radii.
    pub place: Vec<f64>,
}

/// The largest length of d + G p over the plays with H p = b. It is convex in p, so that its extremes are local: from many directions, each step
/// goes on in the direction of the displacement so far, which never makes it shorter.
pub(super) fn longest(
    set: &PlaySet,
    planes: &Planes,
    right: &[f64],
    offset: &[f64],
    gains: &[Vec<f64>],
) -> Option<Longest> {
    let mut best: Option<Longest> = None;
    for start in 0..STARTS {
        let mut direction = spread_direction(start, offset.len());
        let mut length = -1.0;
        for _ in 0..MAX_STEPS {
            let mut along = vec![0.0; set.variables()];
            for (own, share) in gains.iter().zip(&direction) {
                along.iter_mut().zip(own).for_each(|(sum, gain)| *sum += share * gain);
            }
            let place = largest(set, &along, None, planes, right)?.place;
            let vector: Vec<f64> = offset.iter().zip(gains).map(|(offset, own)| offset + dot(own, &place)).collect();
            let next = dot(&vector, &vector).sqrt();
            if !(next > length * (1.0 + 1e-15)) {
                break;
            }
            if best.as_ref().is_none_or(|best| next > best.length) {
                best = Some(Longest { length: next, place });
            }
            if next == 0.0 {
                break;
            }
            (length, direction) = (next, vector.iter().map(|entry| entry / next).collect());
        }
    }
    best
}

/// Directions spread over the sphere (a spiral with the golden angle), or the circle.
fn spread_direction(number: usize, size: usize) -> Vec<f64> {
    let share = (number as f64 + 0.5) / STARTS as f64;
    if size == 3 {
        let (sine, cosine) = loosepin_math::sin_cos(2.399_963_229_728_653 * number as f64);
        let height = 1.0 - 2.0 * share;
        let across = (1.0 - height * height).sqrt();
        return vec![across * cosine, across * sine, height];
    }
    let (sine, cosine) = loosepin_math::sin_cos(std::f64::consts::TAU * share);
    vec![cosine, sine]
}
