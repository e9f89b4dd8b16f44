//! Least play with which a mechanism whose parts do not fit can be put together.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::linear::near::Near;
use crate::accuracy::linear::slice::largest;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::multiple::{MAX_MULTIPLE, Multiple, largest_multiple};
use crate::accuracy::pose_accuracy::{PoseAccuracy, redundant};
use crate::closure::newton::{Closed, largest as largest_entry};
use crate::closure::step::CLOSED;
use loosepin_math::Pose;

/// Most linearisations; five are usual.
const MAX_STEPS: usize = 40;
/// Change of the factor that is the last one, relative for factors above 1.
const LAST_CHANGE: f64 = 1e-9;
/// Change of places, in units of the play, that is the last one.
const LAST_STEP: f64 = 1e-11;
/// Multiples of the play beyond which the first order is the answer: journals that far outside lean too much.
const MAX_EXACT: f64 = 20.0;

/// The least play of a position.
#[derive(Debug, Clone, PartialEq)]
pub struct LeastPlay {
    /// The smallest s with which all plays may be multiplied so that the loops close; above 1 the mechanism cannot be put together in this
    /// position. Infinite where errors break a redundant row that no play reaches; 0 where nothing is wrong.
    pub factor: f64,
    /// The same from multipliers of the last linearisation, λ·h0/Σ c |λ·h|: a lower bound of it, equal but for round-off.
    pub bound: f64,
    /// Places of the journals with all plays multiplied by the factor, m.
    pub variables_m: Vec<f64>,
    /// Share of each joint in the bound: those that have one are at the border of their play, and a larger play of them is what helps. They add
    /// up to 1 where the factor is above 0.
    pub by_joint: Vec<f64>,
}

/// A position of a mechanism whose parts do not fit without play.
#[derive(Debug, Clone, PartialEq)]
pub struct ClosedByPlay {
    /// Places of the journals within their play, m.
    pub variables_m: Vec<f64>,
    /// Pose of each body.
    pub poses: Vec<Pose>,
}

impl PoseAccuracy<'_> {
    /// ν of the position without play, one number for each redundant row: how far it is from closing, lengths over the characteristic length and
    /// rad, in the order of [`Self::conditions_by_play`]. To first order the loops close where h·p = -ν.
    pub fn open_rows(&self) -> &[f64] {
        &self.apart
    }

    /// The smallest factor of all plays with which the loops close:
    ///
    /// ```text
    /// s = min { s : h·p = h0, p in s P }  =  max over λ of λ·h0/Σ c |λ·h|,   h0 = -ν
    /// ```
    ///
    /// The loops are linearised again at the places found until they close exactly there. [`Self::new`] may be given a position of a mechanism
    /// that is alike but for its errors.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::NoPlace`] if the linearisations do not come to an end.
    pub fn least_play(&self) -> Result<LeastPlay, AccuracyError> {
        if largest_entry(&self.apart) <= CLOSED {
            return Ok(self.no_play(0.0));
        }
        let mut at = vec![0.0; self.set.variables()];
        let mut before = f64::INFINITY;
        let (mut rows, mut apart) = (self.redundant.clone(), self.apart.clone());
        for _ in 0..MAX_STEPS {
            let right: Vec<f64> = rows.iter().zip(&apart).map(|(row, apart)| dot(row, &at) - apart).collect();
            let Some(found) = largest_multiple(&self.set, &rows, &right, CLOSED) else {
                return Ok(self.no_play(f64::INFINITY));
            };
            if found.factor >= MAX_MULTIPLE {
                return Ok(self.no_play(0.0));
            }
            let factor = 1.0 / found.factor;
            at = found.place.iter().map(|value| value * factor).collect();
            if (factor - before).abs() <= LAST_CHANGE * factor.max(1.0) || factor > MAX_EXACT {
                return Ok(self.with_shares(&found, &at));
            }
            before = factor;
            let closed = self.close_scaled(&at)?;
            rows = self.rows_at(&closed, &at);
            apart = closed.apart;
        }
        Err(AccuracyError::NoPlace)
    }

    fn no_play(&self, factor: f64) -> LeastPlay {
        let (variables_m, by_joint) = (vec![0.0; self.set.variables()], vec![0.0; self.mechanism().joints().len()]);
        LeastPlay { factor, bound: factor, variables_m, by_joint }
    }

    fn with_shares(&self, found: &Multiple, scaled: &[f64]) -> LeastPlay {
        let sum: f64 = found.parts.iter().sum();
        let mut by_joint = vec![0.0; self.mechanism().joints().len()];
        for (block, part) in self.set.blocks().iter().zip(&found.parts) {
            by_joint[block.joint] += part / sum;
        }
        let variables_m = self.set.in_metres(scaled);
        LeastPlay { factor: 1.0 / found.factor, bound: 1.0 / found.bound, variables_m, by_joint }
    }

    /// A position with the journals at the places of least square within their play, in units of it, that close the loops: of a mechanism whose
    /// parts do not fit without play.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::NoPlace`] if the plays leave none.
    pub fn closed_by_play(&self) -> Result<ClosedByPlay, AccuracyError> {
        let least = self.least_play()?;
        if !(least.factor <= 1.0) {
            return Err(AccuracyError::NoPlace);
        }
        if let Some(found) = self.closed_by_least_squares() {
            return Ok(found);
        }
        // Where the plays are hardly enough, no place is far inside.
        let closed = self.close_at(&self.position.poses, &least.variables_m, None)?;
        if largest_entry(&closed.apart) > CLOSED {
            return Err(AccuracyError::NoPlace);
        }
        Ok(ClosedByPlay { variables_m: least.variables_m, poses: closed.poses })
    }

    fn closed_by_least_squares(&self) -> Option<ClosedByPlay> {
        let middle = vec![0.0; self.set.variables()];
        let mut at = middle.clone();
        for _ in 0..MAX_STEPS {
            let closed = self.close_scaled(&at).ok()?;
            let rows = self.rows_at(&closed, &at);
            let right: Vec<f64> = rows.iter().zip(&closed.apart).map(|(row, apart)| dot(row, &at) - apart).collect();
            let near = Some(Near { weight: 1.0, place: &middle });
            let next = largest(&self.set, &middle, near, &self.planes_of(&rows), &right)?.place;
            let change: Vec<f64> = next.iter().zip(&at).map(|(a, b)| a - b).collect();
            if largest_entry(&change) <= LAST_STEP {
                let is_closed = largest_entry(&closed.apart) <= CLOSED;
                return is_closed.then(|| ClosedByPlay { variables_m: self.set.in_metres(&at), poses: closed.poses });
            }
            at = next;
        }
        None
    }

    fn close_scaled(&self, scaled: &[f64]) -> Result<Closed, AccuracyError> {
        self.close_at(&self.position.poses, &self.set.in_metres(scaled), None)
    }

    /// h in units of the radii at places of the journals.
    fn rows_at(&self, closed: &Closed, scaled: &[f64]) -> Vec<Vec<f64>> {
        let variables_m = self.set.in_metres(scaled);
        redundant(&self.loops, &closed.frames, &closed.system, &self.plays, Some(&variables_m))
    }
}
