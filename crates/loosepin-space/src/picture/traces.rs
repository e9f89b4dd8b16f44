//! Paths of points over the turn, and where play takes them.

use crate::accuracy::PoseAccuracy;
use crate::closure::position::Position;
use crate::geometry::pose::Pose;
use crate::geometry::vector::Vec3;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::SpatialOutput;
use loosepin_math::sin_cos;
use loosepin_result::spatial_picture::{PictureTrace, PictureZone};
use std::f64::consts::{PI, TAU};

/// Zones along a path, besides that of its worst position.
const ZONES: usize = 12;
/// Directions of the boundary on half a great circle in each of the planes x-y, y-z and z-x, whose views are then exact to 0.4 %.
const CIRCLE_DIRECTIONS: usize = 18;
/// Further directions over half of the sphere, for other views.
const SPHERE_DIRECTIONS: usize = 66;

/// A point whose path is drawn.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TracedPoint {
    /// Its name.
    pub name: String,
    /// The output that it belongs to.
    pub output: Option<String>,
    /// Its body.
    pub body: usize,
    /// In the frame of the body, m.
    pub point_m: Vec3,
    /// The position with the largest worst case of its output.
    pub worst: Option<usize>,
}

/// The paths of points, with zones where joints have play.
pub(crate) fn traces(
    mechanism: &SpatialMechanism,
    positions: &[Position],
    poses: &[Vec<Pose>],
    points: &[TracedPoint],
) -> Vec<PictureTrace> {
    let has_play = mechanism.joints().iter().any(|joint| joint.play.is_some());
    points
        .iter()
        .map(|point| {
            let at = poses.iter().filter_map(|poses| poses.get(point.body)).map(|pose| pose.point_m(point.point_m));
            let zones = match point.worst.filter(|_| has_play) {
                Some(worst) => zones(mechanism, positions, point, worst),
                None => Vec::new(),
            };
            PictureTrace {
                point: point.name.clone(),
                output: point.output.clone(),
                body: point.body,
                point_m: point.point_m.to_array(),
                at_m: at.map(Vec3::to_array).collect(),
                worst_zone: zones.iter().position(|zone| Some(zone.sample) == point.worst),
                zones,
            }
        })
        .collect()
}

/// Zones at the worst position and at some others. A point that an idle freedom carries has none.
fn zones(mechanism: &SpatialMechanism, positions: &[Position], point: &TracedPoint, worst: usize) -> Vec<PictureZone> {
    // The last position is the first again.
    let step = positions.len().saturating_sub(1).div_ceil(ZONES).max(1);
    let count = positions.len().saturating_sub(1).max(1);
    let mut samples: Vec<usize> = (0..count).step_by(step).chain([worst]).collect();
    samples.sort_unstable();
    samples.dedup();
    let directions = directions();
    let zone = |sample: usize| {
        let accuracy = PoseAccuracy::new(mechanism, positions.get(sample)?).ok()?;
        let components = SpatialOutput::displacement(point.body, point.point_m);
        let gains = components.iter().map(|output| accuracy.gains(output)).collect::<Result<Vec<_>, _>>().ok()?;
        let half = accuracy.farthest(&gains, &directions).ok()?;
        let boundary_m = half.iter().copied().chain(half.iter().map(|own| -*own)).map(Vec3::to_array).collect();
        Some(PictureZone { sample, boundary_m })
    };
    samples.into_iter().filter_map(zone).collect()
}

/// Directions over half of the sphere; the zone is symmetric.
fn directions() -> Vec<Vec3> {
    let planes = [(Vec3::X, Vec3::Y), (Vec3::Y, Vec3::Z), (Vec3::Z, Vec3::X)];
    let on_circles = planes.into_iter().flat_map(|(first, second)| {
        (0..CIRCLE_DIRECTIONS).map(move |k| {
            let (sine, cosine) = sin_cos(PI * k as f64 / CIRCLE_DIRECTIONS as f64);
            first * cosine + second * sine
        })
    });
    // A spiral with the golden angle.
    let on_sphere = (0..SPHERE_DIRECTIONS).map(|k| {
        let height = (k as f64 + 0.5) / SPHERE_DIRECTIONS as f64;
        let (sine, cosine) = sin_cos(TAU * GOLDEN * k as f64);
        let across = (1.0 - height * height).sqrt();
        Vec3::new(across * cosine, across * sine, height)
    });
    on_circles.chain(on_sphere).collect()
}

/// The golden angle as a share of a turn, (3 - √5)/2.
const GOLDEN: f64 = 0.381_966_011_250_105_1;
