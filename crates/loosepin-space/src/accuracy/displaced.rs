//! Positions with the journals at given places in their play.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::closure::bordered::Bordered;
use crate::closure::newton::{Closed, close, largest};
use crate::output::SpatialOutput;
use crate::output::kind_of_output::{KindOfOutput, OutputState};
use loosepin_math::Pose;

/// Parts of a straight way to a displaced position, where one step does not reach it.
const PARTS: usize = 8;

/// A position with play.
#[derive(Debug, Clone, PartialEq)]
pub struct DisplacedPosition {
    /// Pose of each body.
    pub poses: Vec<Pose>,
    /// How far the redundant rows are from closing, lengths over the characteristic length and rad: the largest. With these places of the
    /// journals the mechanism cannot be put together unless it is zero.
    pub apart: f64,
}

impl PoseAccuracy<'_> {
    /// The exact position with all variables of play given, m, on the branch of the ideal position, drives held.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::NoPlace`] if the loops do not close; [`AccuracyError::NotAPosition`] if there are not as many variables as the plays have.
    pub fn displaced(&self, variables_m: &[f64]) -> Result<DisplacedPosition, AccuracyError> {
        if variables_m.len() != self.set.variables() {
            return Err(AccuracyError::NotAPosition);
        }
        let closed = self.close_at(&self.position.poses, variables_m, None)?;
        Ok(DisplacedPosition { apart: largest(&closed.apart), poses: closed.poses })
    }

    /// The deviation of an output in a displaced position from the ideal one, m or rad.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::OutputDoesNotFit`]; [`AccuracyError::NotAPosition`] if the number of bodies differs.
    pub fn deviation(&self, output: &SpatialOutput, poses: &[Pose]) -> Result<f64, AccuracyError> {
        if !output.fits(self.mechanism()) {
            return Err(AccuracyError::OutputDoesNotFit);
        }
        if poses.len() != self.position.poses.len() {
            return Err(AccuracyError::NotAPosition);
        }
        Ok(self.deviation_of(output, poses))
    }

    pub(crate) fn deviation_of(&self, output: &SpatialOutput, poses: &[Pose]) -> f64 {
        output.deviation(&self.ideal_state(), &OutputState { mechanism: self.loops.mechanism, poses })
    }

    /// Closes the loops from poses close by with their system, or from the ideal position with its own; in parts from the ideal position if that fails.
    pub(crate) fn close_at(
        &self,
        from: &[Pose],
        variables_m: &[f64],
        system: Option<&Bordered>,
    ) -> Result<Closed, AccuracyError> {
        let drives = self.position.drive_values();
        let known = Some(system.unwrap_or(&self.system));
        let attempt = |from: &[Pose], share: f64| {
            let variables: Vec<f64> = variables_m.iter().map(|value| value * share).collect();
            let shifts = self.plays.shifts_in_metres(&self.loops, &variables);
            close(&self.loops, from, &shifts, &drives, &self.position.borders, known).ok().filter(|closed| {
                // A long way from a place close by is a way to another branch.
                closed.way < 1.0
            })
        };
        if let Some(closed) = attempt(from, 1.0) {
            return Ok(closed);
        }
        let mut poses = self.position.poses.clone();
        for part in 1..PARTS {
            let closed = attempt(&poses, part as f64 / PARTS as f64).ok_or(AccuracyError::NoPlace)?;
            poses = closed.poses;
        }
        attempt(&poses, 1.0).ok_or(AccuracyError::NoPlace)
    }
}
