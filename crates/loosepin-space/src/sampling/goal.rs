//! What play is to make as large as it can.

use crate::geometry::pose::Pose;
use crate::geometry::vector::Vec3;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{KindOfOutput, OutputState};
use crate::output::{PointOutput, SpatialOutput};

/// A convex function of displacements, or the deviation of an output.
#[derive(Debug, Clone, Copy)]
pub(super) enum Goal<'a> {
    /// `sign` × the deviation of an output from the sample's ideal position.
    Deviation { output: &'a SpatialOutput, sign: f64 },
    /// The length of an offset and the displacement of a point in some directions.
    Length { point: PointOutput, directions: &'a [Vec3], offset: [f64; 3] },
}

impl Goal<'_> {
    /// What is to be large.
    pub(super) fn value(&self, mechanism: &SpatialMechanism, ideal: &[Pose], poses: &[Pose]) -> f64 {
        match self {
            Self::Deviation { output, sign } => {
                sign * output.deviation(&OutputState { mechanism, poses: ideal }, &OutputState { mechanism, poses })
            }
            Self::Length { .. } => self.displacement(ideal, poses).length(),
        }
    }

    /// The output that grows with it at these poses, and in what sense.
    pub(super) fn tangent(&self, ideal: &[Pose], poses: &[Pose]) -> (SpatialOutput, f64) {
        match self {
            Self::Deviation { output, sign } => (**output, *sign),
            Self::Length { point, directions, .. } => {
                let along = self.displacement(ideal, poses).normalised();
                let direction = along.or_else(|| directions.first().copied()).unwrap_or(Vec3::X);
                (PointOutput { direction, ..*point }.into(), 1.0)
            }
        }
    }

    /// Offset and displacement, of a length.
    fn displacement(&self, ideal: &[Pose], poses: &[Pose]) -> Vec3 {
        let Self::Length { point, directions, offset } = self else { return Vec3::ZERO };
        let moved = point_m(point, poses) - point_m(point, ideal);
        let parts = directions.iter().zip(offset);
        let parts = parts.map(|(direction, offset)| *direction * (offset + moved.dot(*direction)));
        parts.fold(Vec3::ZERO, |sum, part| sum + part)
    }
}

pub(super) fn point_m(point: &PointOutput, poses: &[Pose]) -> Vec3 {
    poses[point.body].point_m(point.point_m)
}
