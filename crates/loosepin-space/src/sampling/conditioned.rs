//! Play that must meet conditions together: loops with redundant rows.

use super::goal::Goal;
use super::part::PlaySide;
use super::reach::Reach;
use crate::accuracy::linear::slice::largest;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::search::Climb;
use crate::accuracy::{AccuracyError, PoseAccuracy};
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::SpatialOutput;
use loosepin_math::Pose;

/// Most climbs of a length, each in the direction of the displacement so far.
const MAX_CLIMBS: usize = 50;
/// Growth of a length, relative to it, that is round-off.
const GROWTH: f64 = 1e-12;

/// A position of a sample in which plays with h·p = `right` close the loops.
pub(super) struct Conditioned<'a> {
    pub accuracy: PoseAccuracy<'a>,
    /// What the plays must make of each redundant row.
    pub right: Vec<f64>,
    pub side: PlaySide,
}

impl Conditioned<'_> {
    fn largest(&self, gains: &[f64]) -> Result<Vec<f64>, AccuracyError> {
        let accuracy = &self.accuracy;
        let found = largest(&accuracy.set, gains, None, &accuracy.planes, &self.right);
        Ok(found.ok_or(AccuracyError::NoPlace)?.place)
    }
}

impl Reach for Conditioned<'_> {
    fn mechanism(&self) -> &SpatialMechanism {
        self.accuracy.mechanism()
    }

    fn ideal(&self) -> &[Pose] {
        &self.accuracy.position.poses
    }

    fn side(&self) -> PlaySide {
        self.side
    }

    fn is_symmetric(&self) -> bool {
        self.right.iter().all(|value| *value == 0.0)
    }

    fn gains(&mut self, output: &SpatialOutput) -> Result<Vec<f64>, AccuracyError> {
        Ok(self.accuracy.scaled_gains(&self.accuracy.gains(output)?))
    }

    fn ends(&self, gains: &[f64]) -> Result<[f64; 2], AccuracyError> {
        let largest = dot(gains, &self.largest(gains)?);
        if self.is_symmetric() {
            return Ok([-largest, largest]);
        }
        let opposite: Vec<f64> = gains.iter().map(|gain| -gain).collect();
        Ok([dot(gains, &self.largest(&opposite)?), largest])
    }

    fn farthest(&self, gains: &[f64], place: &mut Vec<f64>) -> Result<(), AccuracyError> {
        *place = self.largest(gains)?;
        Ok(())
    }

    fn climb(&mut self, goal: &Goal, start: &[f64]) -> Result<f64, AccuracyError> {
        climb(&self.accuracy, goal, start)
    }
}

/// Climbs from a place, again and again in the direction of the displacement so far where that changes. From the middle if the loops do not close
/// there.
pub(super) fn climb(accuracy: &PoseAccuracy, goal: &Goal, start: &[f64]) -> Result<f64, AccuracyError> {
    let ideal = &accuracy.position.poses;
    let mut variables_m = accuracy.set.in_metres(start);
    let mut poses = match accuracy.close_at(ideal, &variables_m, None) {
        Ok(closed) => closed.poses,
        Err(_) => {
            variables_m.fill(0.0);
            ideal.clone()
        }
    };
    let mut best = f64::NEG_INFINITY;
    for _ in 0..MAX_CLIMBS {
        let (output, sign) = goal.tangent(ideal, &poses);
        let climb = Climb { accuracy, output: &output, sign };
        let end = climb.climb_from_variables(&variables_m).ok_or(AccuracyError::NoPlace)?;
        let value = goal.value(accuracy.mechanism(), ideal, &end.poses);
        let has_grown = value > best + GROWTH * best.abs();
        best = best.max(value);
        // Of a deviation one climb is all.
        if !has_grown || matches!(goal, Goal::Deviation { .. }) {
            break;
        }
        (variables_m, poses) = (end.variables_m, end.poses);
    }
    Ok(best)
}
