//! Points whose paths are drawn, and where play takes them.

use crate::accuracy::PoseAccuracy;
use crate::output::SpatialOutput;
use loosepin_math::{Vec3, sin_cos};
use loosepin_result::spatial_picture::PictureZone;
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
    /// The number of the output that it belongs to.
    pub output: Option<usize>,
    /// Its body.
    pub body: usize,
    /// In the frame of the body, m.
    pub point_m: Vec3,
    /// Whether it is drawn where play takes it.
    pub has_zones: bool,
}

/// Zones of points, while a mechanism moves over its turn.
pub(crate) struct Zones {
    /// From position to position with zones.
    step: usize,
    count: usize,
    directions: Vec<Vec3>,
}

impl Zones {
    /// For a number of positions, of which the last is the first again.
    pub(crate) fn new(positions: usize) -> Self {
        let step = positions.saturating_sub(1).div_ceil(ZONES).max(1);
        Self { step, count: positions.saturating_sub(1).max(1), directions: directions() }
    }

    /// Whether there is a zone in a position, whatever the worst one is.
    pub(crate) fn has(&self, sample: usize) -> bool {
        sample.is_multiple_of(self.step) && sample < self.count
    }

    /// The zone of a point in a position. A point that an idle freedom carries has none.
    pub(crate) fn zone(&self, accuracy: &PoseAccuracy<'_>, point: &TracedPoint, sample: usize) -> Option<PictureZone> {
        let components = SpatialOutput::displacement(point.body, point.point_m);
        let gains = components.iter().map(|output| accuracy.gains(output)).collect::<Result<Vec<_>, _>>().ok()?;
        let half = accuracy.farthest(&gains, &self.directions).ok()?;
        let boundary_m = half.iter().copied().chain(half.iter().map(|own| -*own)).map(Vec3::to_array).collect();
        Some(PictureZone { sample, boundary_m })
    }
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
