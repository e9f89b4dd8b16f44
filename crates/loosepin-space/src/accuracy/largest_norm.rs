//! The largest length of an output that is a vector.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::first_order::FirstOrder;
use crate::accuracy::gains::Gains;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::accuracy::vector_reach::VectorReach;
use loosepin_math::Vec3;

/// Directions from which a search starts, over half of the sphere.
const STARTS: usize = 64;
/// Most steps of a search.
const MAX_STEPS: usize = 500;
/// Growth of a length that ends a search, relative to it.
const GROWTH: f64 = 1e-15;
/// Turn of the direction that ends a search, rad.
const LAST_TURN: f64 = 1e-12;
/// Relative difference of components that are alike but for round-off.
const ALIKE: f64 = 1e-6;
/// Relative difference of lengths that is round-off: the first of several ends that are alike counts.
const SAME: f64 = 1e-12;

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

/// The largest deviation of an output that may be a vector.
pub(crate) struct Longest {
    /// Its size; of a vector the longest that a search over directions found.
    pub size: f64,
    /// Gains of the output, or of a vector those of its component along the direction in which it is longest.
    pub along: Gains,
    /// The worst case of these.
    pub first_order: FirstOrder,
}

impl PoseAccuracy<'_> {
    /// The largest deviation to first order of an output that has these components.
    ///
    /// # Errors
    ///
    /// As for [`Self::largest_norm`]; [`AccuracyError::OutputDoesNotFit`] without components.
    pub(crate) fn longest(&self, components: &[Gains]) -> Result<Longest, AccuracyError> {
        let [first, others @ ..] = components else { return Err(AccuracyError::OutputDoesNotFit) };
        if others.is_empty() {
            let first_order = self.first_order(first)?;
            return Ok(Longest { size: first_order.worst, along: first.clone(), first_order });
        }
        let longest = self.largest_norm(components)?;
        // Components of a rotation are about x, y and z.
        let axes = components.iter().zip(Vec3::AXES);
        let axes = axes.map(|(own, axis)| own.output.point().map_or(axis, |own| own.direction));
        let direction = axes.zip(&longest.direction).fold(Vec3::ZERO, |sum, (axis, share)| sum + axis * *share);
        // What nothing moves is as long in each direction.
        let along = match direction.normalised() {
            Some(direction) => first.output.component(direction).ok_or(AccuracyError::OutputDoesNotFit)?,
            None => first.output,
        };
        let along = self.gains(&along)?;
        Ok(Longest { size: longest.largest, first_order: self.first_order(&along)?, along })
    }

    /// The largest length of the vector with these components, up to three, to first order: across a path with those along its normal and its
    /// binormal.
    ///
    /// The length is a convex function of the plays, so that its extremes are local; from 64 directions each step goes on in the direction of
    /// the largest displacement so far, which never makes it shorter. Where an end is proven to be the longest of all, no other is looked for.
    ///
    /// # Errors
    ///
    /// As for [`Self::first_order`]; [`AccuracyError::OutputDoesNotFit`] with more than three components.
    pub fn largest_norm(&self, components: &[Gains]) -> Result<LargestNorm, AccuracyError> {
        if self.is_open() {
            return Err(AccuracyError::PartsDoNotFit);
        }
        let size = components.len();
        let mut reach = VectorReach::new(self, components)?;
        let mut starts = Vec::with_capacity(STARTS);
        for start in 0..STARTS {
            starts.push(length_and_direction(reach.farthest(spread_direction(start, size))?));
        }
        // The best first: it may be proven to be enough.
        starts.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut best = LargestNorm { largest: 0.0, direction: vec![0.0; size], variables_m: Vec::new() };
        for (mut length, mut direction) in starts.into_iter().filter(|(length, _)| *length > 0.0) {
            let mut is_at_end = false;
            for _ in 0..MAX_STEPS {
                let (next, turned) = length_and_direction(reach.farthest(direction)?);
                is_at_end = is_at_end || !(next > length * (1.0 + GROWTH));
                let turn = turned.iter().zip(direction).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
                // The direction has half of the digits of the length: it is what goes on a little. With planes it has no more.
                let has_turned = turn > LAST_TURN && self.planes.count() == 0;
                if is_at_end && !(has_turned && length > best.largest * (1.0 + SAME)) {
                    break;
                }
                (length, direction) = (next.max(length), turned);
            }
            if length > best.largest * (1.0 + SAME) {
                let (along, place) = reach.gains_and_place(direction);
                best = LargestNorm {
                    largest: length,
                    direction: direction[..size].to_vec(),
                    variables_m: self.set.in_metres(&place),
                };
                if reach.is_longest(length, &along) {
                    break;
                }
            }
        }
        // Of both senses, which are alike, that in which the largest component is positive.
        let size = best.direction.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
        let first = best.direction.iter().find(|own| own.abs() > size * (1.0 - ALIKE));
        if first.is_some_and(|own| *own < 0.0) {
            best.direction.iter_mut().chain(&mut best.variables_m).for_each(|value| *value = -*value);
        }
        Ok(best)
    }
}

/// Length of a vector, and the unit vector along it; the first axis where there is no length.
fn length_and_direction(vector: [f64; 3]) -> (f64, [f64; 3]) {
    let length = dot(&vector, &vector).sqrt();
    (length, if length > 0.0 { vector.map(|entry| entry / length) } else { [1.0, 0.0, 0.0] })
}

/// Directions spread over half of the sphere (a spiral with the golden angle), the half circle, or the line.
fn spread_direction(number: usize, size: usize) -> [f64; 3] {
    let share = (number as f64 + 0.5) / STARTS as f64;
    match size {
        3 => {
            let (sine, cosine) = loosepin_math::sin_cos(2.399_963_229_728_653 * number as f64);
            let across = (1.0 - share * share).sqrt();
            [across * cosine, across * sine, share]
        }
        2 => {
            let (sine, cosine) = loosepin_math::sin_cos(std::f64::consts::PI * share);
            [cosine, sine, 0.0]
        }
        _ => [1.0, 0.0, 0.0],
    }
}
