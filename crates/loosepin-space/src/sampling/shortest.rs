//! The smallest length of an offset and what plays add to it, to first order.

use super::reach::Reach;
use crate::accuracy::AccuracyError;
use crate::accuracy::slice::dot;

/// Most steps; fewer than 30 are usual.
const MAX_STEPS: usize = 400;
/// Distance of bound and length, relative to the length, that ends a search.
const GAP: f64 = 1e-9;

/// The smallest length of d + G p over the plays: 0 where they can take the offset back.
///
/// By the method of M. Frank and P. Wolfe (Naval Research Logistics Quarterly 3 (1956) 95): from x towards the s of the set with the smallest x·s, as
/// far as the length falls. The set lies beyond the plane through s across x, so that x·s/|x| is a lower bound; the largest of these is returned.
pub(super) fn shortest(reach: &dyn Reach, offset: &[f64], gains: &[Vec<f64>]) -> Result<f64, AccuracyError> {
    let size = gains.first().map_or(0, Vec::len);
    let (mut place, mut against) = (Vec::new(), vec![0.0; size]);
    // The place that goes farthest against x, and its displacement.
    let mut farthest_against = |x: [f64; 3], place: &mut Vec<f64>| -> Result<[f64; 3], AccuracyError> {
        against.fill(0.0);
        for (own, share) in gains.iter().zip(x) {
            against.iter_mut().zip(own).for_each(|(sum, gain)| *sum -= share * gain);
        }
        reach.farthest(&against, place)?;
        let mut vector = [0.0; 3];
        let parts = vector.iter_mut().zip(offset).zip(gains);
        parts.for_each(|((entry, offset), own)| *entry = offset + dot(own, place));
        Ok(vector)
    };
    let mut start = [0.0; 3];
    start.iter_mut().zip(offset).for_each(|(entry, offset)| *entry = *offset);
    let mut x = farthest_against(start, &mut place)?;
    let mut bound: f64 = 0.0;
    for _ in 0..MAX_STEPS {
        let length = dot(&x, &x).sqrt();
        if !(length > 0.0) {
            return Ok(0.0);
        }
        let s = farthest_against(x, &mut place)?;
        bound = bound.max(dot(&x, &s) / length);
        if length - bound <= GAP * length {
            break;
        }
        let towards = [0, 1, 2].map(|k| s[k] - x[k]);
        let share = (-dot(&x, &towards) / dot(&towards, &towards)).clamp(0.0, 1.0);
        x = [0, 1, 2].map(|k| x[k] + share * towards[k]);
    }
    Ok(bound)
}
