//! The picture of a model.

use super::marker::PointId;
use super::parts::SpatialModel;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::picture::{PictureSource, TracedPoint};
use loosepin_math::{Pose, Vec3};
use loosepin_result::spatial_picture::{PictureTrace, PictureZone, SpatialPicture};
use loosepin_text::numbers::Values;

/// A point whose path is drawn, with what play makes of it.
pub(super) struct Trace {
    pub point: TracedPoint,
    /// In the order of the positions.
    pub zones: Vec<PictureZone>,
}

impl SpatialModel {
    /// The mechanism as it is drawn, with the paths of these points; `worst` is the position with the largest worst case of each output.
    pub(super) fn picture(
        &self,
        mechanism: &SpatialMechanism,
        values: &Values,
        poses: &[Vec<Pose>],
        traces: Vec<Trace>,
        worst: &[usize],
    ) -> SpatialPicture {
        let points: Vec<Vec<(String, Vec3)>> =
            (0..self.bodies.len()).map(|body| self.points_of(body, values)).collect();
        let speeds: Vec<f64> = self.drives.iter().map(|drive| values[drive.speed]).collect();
        let source = PictureSource { mechanism, poses, points: &points, speeds: &speeds };
        let picture_trace = |Trace { point, zones }: Trace| {
            let at = poses.iter().filter_map(|poses| poses.get(point.body)).map(|pose| pose.point_m(point.point_m));
            let worst = point.output.and_then(|output| worst.get(output));
            PictureTrace {
                at_m: at.map(Vec3::to_array).collect(),
                worst_zone: zones.iter().position(|zone| Some(&zone.sample) == worst),
                output: point.output.and_then(|output| self.outputs.get(output)).map(|output| output.name.clone()),
                point: point.name,
                body: point.body,
                point_m: point.point_m.to_array(),
                zones,
            }
        };
        SpatialPicture { traces: traces.into_iter().map(picture_trace).collect(), ..source.picture() }
    }

    fn points_of(&self, body: usize, values: &Values) -> Vec<(String, Vec3)> {
        let position = |point: usize| self.position(PointId { body, point }, values);
        let points = self.bodies[body].points.iter().enumerate();
        points.map(|(number, point)| (point.name.clone(), position(number))).collect()
    }

    /// The points of outputs and those that are `asked` for; where there is none, the middles of joints between moving bodies.
    pub(super) fn traced_points(
        &self,
        mechanism: &SpatialMechanism,
        values: &Values,
        asked: &[PointId],
    ) -> Vec<TracedPoint> {
        let traced = |point: PointId, output: Option<usize>| TracedPoint {
            name: self.point_name(point),
            output,
            body: point.body,
            point_m: self.position(point, values),
            has_zones: true,
        };
        let of_outputs = self.outputs.iter().enumerate().filter_map(|(number, output)| {
            let point = output.kind.point()?;
            Some(traced(point, Some(number)))
        });
        let mut points: Vec<TracedPoint> = Vec::new();
        for point in of_outputs.chain(asked.iter().map(|point| traced(*point, None))) {
            // Of several outputs of one point the first.
            if points.iter().all(|other| other.name != point.name) {
                points.push(point);
            }
        }
        if !points.is_empty() {
            return points;
        }
        let moving = mechanism.joints().iter().filter(|joint| joint.bearing.body != 0 && joint.journal.body != 0);
        moving
            .map(|joint| TracedPoint {
                name: joint.name.clone(),
                output: None,
                body: joint.bearing.body,
                point_m: joint.bearing.point_m,
                has_zones: false,
            })
            .collect()
    }
}
