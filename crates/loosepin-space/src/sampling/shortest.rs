//! The smallest length of an offset and what plays add to it, to first order.

use super::longest::{Displacements, sum};
use crate::accuracy::AccuracyError;
use crate::accuracy::slice::dot;

/// Most steps; fewer than 30 are usual.
const MAX_STEPS: usize = 300;
/// Distance of bound and length, relative to the largest length, that ends a search.
const GAP: f64 = 1e-7;

/// A lower bound of the length of d + G p over the plays, near to the smallest: 0 where they can take the offset back. `largest` is the largest
/// length.
///
/// By the method of M. Frank and P. Wolfe (Naval Research Logistics Quarterly 3 (1956) 95): from x towards the s of the set with the smallest x·s, as
/// far as the length falls. The set lies beyond the plane through s across x, so that x·s/|x| is a lower bound; the largest of these is returned.
pub(super) fn shortest(
    displacements: &mut Displacements,
    offset: [f64; 3],
    largest: f64,
) -> Result<f64, AccuracyError> {
    let mut against = |x: [f64; 3]| Ok(sum(offset, displacements.farthest(x.map(|entry| -entry))?));
    let mut x = against(offset)?;
    let mut bound: f64 = 0.0;
    for _ in 0..MAX_STEPS {
        let length = dot(&x, &x).sqrt();
        if length - bound <= GAP * largest {
            break;
        }
        let s = against(x)?;
        bound = bound.max(dot(&x, &s) / length);
        let towards = [0, 1, 2].map(|k| s[k] - x[k]);
        let share = -dot(&x, &towards) / dot(&towards, &towards);
        // None at all where s is x.
        if !(share > 0.0) {
            break;
        }
        x = [0, 1, 2].map(|k| x[k] + share.min(1.0) * towards[k]);
    }
    Ok(bound)
}
