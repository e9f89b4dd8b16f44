//! The largest length of an output that is a vector.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::gains::Gains;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::accuracy::slice::{dot, largest};

/// Directions from which a search starts, over half of the sphere.
const STARTS: usize = 64;
/// Most steps of a search.
const MAX_STEPS: usize = 500;

/// The largest length of a vector output to first order: the largest worst case of its component along n, over all directions n.
#[derive(Debug, Clone, PartialEq)]
pub struct LargestNorm {
    /// The length, m or rad.
    pub largest: f64,
    /// The direction n, in the components of the output.
    pub direction: Vec<f64>,
    /// Variables of play that reach it, m.
    pub variables_m: Vec<f64>,
}

impl PoseAccuracy<'_> {
    /// The largest length of the vector with these components, up to three, to first order: across a path with those along its normal and its
    /// binormal.
    ///
    /// The length is a convex function of the plays, so that its extremes are local; from 64 directions each step goes on in the direction of
    /// the largest displacement so far, which never makes it shorter.
    ///
    /// # Errors
    ///
    /// As for [`Self::first_order`].
    pub fn largest_norm(&self, components: &[Gains]) -> Result<LargestNorm, AccuracyError> {
        if self.is_open() {
            return Err(AccuracyError::PartsDoNotFit);
        }
        let scaled: Vec<Vec<f64>> = components.iter().map(|gains| self.scaled_gains(gains)).collect();
        let zero = vec![0.0; self.redundant.len()];
        let mut best = LargestNorm { largest: 0.0, direction: vec![0.0; components.len()], variables_m: Vec::new() };
        for start in 0..STARTS {
            let mut direction = spread_direction(start, components.len());
            let mut length = 0.0;
            for _ in 0..MAX_STEPS {
                let mut gains = vec![0.0; self.set.variables()];
                for (own, share) in scaled.iter().zip(&direction) {
                    gains.iter_mut().zip(own).for_each(|(sum, gain)| *sum += share * gain);
                }
                let found = largest(&self.set, &gains, None, &self.planes, &zero).ok_or(AccuracyError::NoPlace)?;
                let vector: Vec<f64> = scaled.iter().map(|own| dot(own, &found.place)).collect();
                let next = dot(&vector, &vector).sqrt();
                let is_done = !(next > length * (1.0 + 1e-15));
                if next > best.largest {
                    best = LargestNorm {
                        largest: next,
                        direction: vector.iter().map(|entry| entry / next).collect(),
                        variables_m: self.set.in_metres(&found.place),
                    };
                }
                if is_done {
                    break;
                }
                (length, direction) = (next, vector.iter().map(|entry| entry / next).collect());
            }
        }
        Ok(best)
    }
}

/// Directions spread over half of the sphere (a spiral with the golden angle), the half circle, or the line.
fn spread_direction(number: usize, size: usize) -> Vec<f64> {
    let share = (number as f64 + 0.5) / STARTS as f64;
    match size {
        3 => {
            let (sine, cosine) = loosepin_math::sin_cos(2.399_963_229_728_653 * number as f64);
            let across = (1.0 - share * share).sqrt();
            vec![across * cosine, across * sine, share]
        }
        2 => {
            let (sine, cosine) = loosepin_math::sin_cos(std::f64::consts::PI * share);
            vec![cosine, sine]
        }
        _ => (0..size).map(|k| f64::from(u8::from(k == number % size.max(1)))).collect(),
    }
}
