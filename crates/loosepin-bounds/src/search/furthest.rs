//! The furthest of many predictions, several at once.

use loosepin_math::with_vector_instructions;

/// Predictions that are compared side by side: as many as there are numbers in two vectors.
const AT_ONCE: usize = 8;

/// Range of a target at a place by its model, from the mean and the deviation of its process there, for σ = 1:
///
/// ```text
/// sign · (centre + mean + sign · many · scale · deviation)
/// ```
#[derive(Debug, Clone, Copy)]
pub(super) struct Ends {
    /// Centre of the values.
    pub centre: f64,
    /// σ
    pub scale: f64,
    /// Deviations that are allowed.
    pub many: f64,
    /// 1 upwards, -1 downwards.
    pub sign: f64,
}

/// A value, upwards in the direction that is asked for, and its place.
pub(super) type Furthest = (f64, usize);

impl Ends {
    /// The most that is allowed and the most that is expected.
    #[inline(always)]
    pub fn at(self, mean: f64, deviation: f64) -> (f64, f64) {
        let mean = self.centre + mean;
        let most = self.sign * (mean + self.sign * (self.many * (self.scale * deviation)));
        // A model that overflows allows anything.
        (if most.is_nan() { f64::INFINITY } else { most }, self.sign * mean)
    }
}

/// The most that is allowed, and the most that is expected, over all places, each with the first place that has it.
pub(super) fn furthest(means: &[f64], deviations: &[f64], ends: Ends) -> [Furthest; 2] {
    debug_assert_eq!(means.len(), deviations.len(), "one deviation for each mean");
    let (blocks, last) = means.as_chunks::<AT_ONCE>();
    let (of_blocks, of_last) = deviations.as_chunks::<AT_ONCE>();
    let mut most = [[f64::NEG_INFINITY; AT_ONCE]; 2];
    // Numbers of blocks as floating-point numbers, which are chosen in the same vectors.
    let mut blocks_of_most = [[0.0; AT_ONCE]; 2];
    with_vector_instructions(
        #[inline(always)]
        || {
            let mut number = 0.0;
            for (means, deviations) in blocks.iter().zip(of_blocks) {
                for place in 0..AT_ONCE {
                    let (allowed, expected) = ends.at(means[place], deviations[place]);
                    let is_more = allowed > most[0][place];
                    most[0][place] = if is_more { allowed } else { most[0][place] };
                    blocks_of_most[0][place] = if is_more { number } else { blocks_of_most[0][place] };
                    let is_more = expected > most[1][place];
                    most[1][place] = if is_more { expected } else { most[1][place] };
                    blocks_of_most[1][place] = if is_more { number } else { blocks_of_most[1][place] };
                }
                number += 1.0;
            }
        },
    );
    let mut found = [(f64::NEG_INFINITY, 0); 2];
    let mut take = |end: usize, value: f64, place: usize| {
        let (furthest, first) = found[end];
        if value > furthest || value == furthest && place < first {
            found[end] = (value, place);
        }
    };
    for end in 0..2 {
        for place in 0..AT_ONCE {
            take(end, most[end][place], blocks_of_most[end][place] as usize * AT_ONCE + place);
        }
    }
    for (place, (mean, deviation)) in last.iter().zip(of_last).enumerate() {
        let (allowed, expected) = ends.at(*mean, *deviation);
        take(0, allowed, blocks.len() * AT_ONCE + place);
        take(1, expected, blocks.len() * AT_ONCE + place);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{Ends, furthest};
    use loosepin_uncertainty::{hash, normal};

    #[test]
    fn identity_the_furthest_is_the_first_that_a_plain_loop_finds() {
        for (case, count) in [1, 7, 8, 9, 31, 64, 611].into_iter().enumerate() {
            let key = hash(3, case as u64);
            // In steps, so that many are equal.
            let mut means: Vec<f64> = (0..count).map(|i| (2.0 * normal(key, i)).round()).collect();
            let deviations: Vec<f64> = (0..count).map(|i| (normal(hash(key, 1), i)).abs().round()).collect();
            if count > 8 {
                means[3] = f64::NAN;
            }
            for sign in [-1.0, 1.0] {
                let ends = Ends { centre: 0.5, scale: 2.0, many: 4.0, sign };
                let mut expected = [(f64::NEG_INFINITY, 0); 2];
                for (place, (mean, deviation)) in means.iter().zip(&deviations).enumerate() {
                    let mean = 0.5 + mean;
                    let allowed = sign * (mean + sign * 8.0 * deviation);
                    let allowed = if allowed.is_nan() { f64::INFINITY } else { allowed };
                    for (own, value) in expected.iter_mut().zip([allowed, sign * mean]) {
                        if value > own.0 {
                            *own = (value, place);
                        }
                    }
                }
                assert_eq!(furthest(&means, &deviations, ends), expected, "{count}, {sign}");
            }
        }
    }
}
