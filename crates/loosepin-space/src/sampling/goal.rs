//! What play is to make as large as it can.

use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{KindOfOutput, OutputState};
use crate::output::{PointOutput, RotationOutput, SpatialOutput};
use loosepin_math::{Pose, Rotation, Vec3};

/// A convex function of displacements, the angle of a rotation, or the deviation of an output.
#[derive(Debug, Clone, Copy)]
pub(super) enum Goal<'a> {
    /// `sign` × the deviation of an output from the sample's ideal position.
    Deviation { output: &'a SpatialOutput, sign: f64 },
    /// The length of an offset and the displacement of a point in some directions.
    Length { point: PointOutput, directions: &'a [Vec3], offset: [f64; 3] },
    /// The angle by which a body is rotated from these axes.
    Angle { body: usize, from: Rotation },
}

impl Goal<'_> {
    /// What is to be large.
    pub(super) fn value(&self, mechanism: &SpatialMechanism, ideal: &[Pose], poses: &[Pose]) -> f64 {
        match self {
            Self::Deviation { output, sign } => {
                sign * output.deviation(&OutputState { mechanism, poses: ideal }, &OutputState { mechanism, poses })
            }
            Self::Length { point, directions, offset } => {
                displacement(point, directions, *offset, [ideal, poses]).length()
            }
            Self::Angle { body, from } => from.transposed_times(&axes(*body, poses)).rotation_vector().length(),
        }
    }

    /// The output that grows with it at these poses, and in what sense.
    pub(super) fn tangent(&self, ideal: &[Pose], poses: &[Pose]) -> (SpatialOutput, f64) {
        match self {
            Self::Deviation { output, sign } => (**output, *sign),
            Self::Length { point, directions, offset } => {
                let along = displacement(point, directions, *offset, [ideal, poses]).normalised();
                let direction = along.or_else(|| directions.first().copied()).unwrap_or(Vec3::X);
                (PointOutput { direction, ..*point }.into(), 1.0)
            }
            Self::Angle { body, from } => (growing_component(*body, from, [ideal, poses]).into(), 1.0),
        }
    }
}

/// Offset and displacement in some directions, of a length.
fn displacement(point: &PointOutput, directions: &[Vec3], offset: [f64; 3], [from, to]: [&[Pose]; 2]) -> Vec3 {
    let moved = point_m(point, to) - point_m(point, from);
    let parts = directions.iter().zip(offset);
    let parts = parts.map(|(direction, offset)| *direction * (offset + moved.dot(*direction)));
    parts.fold(Vec3::ZERO, |sum, part| sum + part)
}

/// The component of the rotation from the ideal axes that grows as the angle from the axes `from` does.
///
/// A turning ω changes that angle by ω·a, a its axis in ground axes, and the rotation vector θ from the ideal axes by J⁻¹ω: u·J⁻¹ω = ω·a with
/// u = Jᵀa = a - (1 - cos θ)/θ² θ×a + (θ - sin θ)/θ³ θ×(θ×a), in ideal axes. u is no unit vector where both rotations have different axes.
fn growing_component(body: usize, from: &Rotation, [ideal, poses]: [&[Pose]; 2]) -> RotationOutput {
    let [ideal, actual] = [ideal, poses].map(|poses| axes(body, poses));
    let axis = from.transposed_times(&actual).rotation_vector().normalised().unwrap_or(Vec3::X);
    let axis = ideal.apply_transposed(from.apply(axis));
    let theta = ideal.transposed_times(&actual).rotation_vector();
    let angle = theta.length();
    let (first, second) = match angle > SMALL_ANGLE {
        true => {
            let (sine, cosine) = loosepin_math::sin_cos(angle);
            ((1.0 - cosine) / (angle * angle), (angle - sine) / (angle * angle * angle))
        }
        false => (0.5, 1.0 / 6.0),
    };
    let across = theta.cross(axis);
    RotationOutput { body, axis: axis - across * first + theta.cross(across) * second }
}

/// Angle below which quotients of its sine and cosine are at their limits, rad: the error is of its square, and below it of round-off.
const SMALL_ANGLE: f64 = 1e-4;

/// Axes of a body in the ground.
pub(super) fn axes(body: usize, poses: &[Pose]) -> Rotation {
    poses[body].orientation.rotation()
}

pub(super) fn point_m(point: &PointOutput, poses: &[Pose]) -> Vec3 {
    poses[point.body].point_m(point.point_m)
}
