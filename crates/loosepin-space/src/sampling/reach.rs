//! What play reaches at one place of a sample.

use super::goal::Goal;
use super::part::PlaySide;
use crate::accuracy::AccuracyError;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::SpatialOutput;
use loosepin_math::Pose;

/// A closed position of a sample, and what play makes of it. Variables of play are in units of their radii.
pub(super) trait Reach {
    /// The mechanism of the sample.
    fn mechanism(&self) -> &SpatialMechanism;
    /// Its ideal position.
    fn ideal(&self) -> &[Pose];
    /// What play may do.
    fn side(&self) -> PlaySide;
    /// Whether the opposite of a place is one, too.
    fn is_symmetric(&self) -> bool;
    /// Gains of an output.
    fn gains(&mut self, output: &SpatialOutput) -> Result<Vec<f64>, AccuracyError>;
    /// The smallest and the largest g·p to first order.
    fn ends(&self, gains: &[f64]) -> Result<[f64; 2], AccuracyError>;
    /// The place with the largest g·p to first order.
    fn farthest(&self, gains: &[f64], place: &mut Vec<f64>) -> Result<(), AccuracyError>;
    /// The largest value that one climb from a place finds, loops closed exactly.
    fn climb(&mut self, goal: &Goal, start: &[f64]) -> Result<f64, AccuracyError>;
}
