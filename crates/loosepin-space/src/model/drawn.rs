//! The picture of a model.

use super::parts::{ModelOutputKind, SpatialModel};
use crate::closure::position::Position;
use crate::geometry::pose::Pose;
use crate::geometry::vector::Vec3;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::picture::{PictureSource, TracedPoint, traces};
use loosepin_result::spatial_picture::SpatialPicture;
use loosepin_text::numbers::Values;

impl SpatialModel {
    /// The mechanism as it is drawn, with the paths of these points.
    pub(super) fn picture(
        &self,
        mechanism: &SpatialMechanism,
        values: &Values,
        positions: &[Position],
        poses: &[Vec<Pose>],
        traced: &[TracedPoint],
    ) -> SpatialPicture {
        let points: Vec<Vec<(String, Vec3)>> =
            (0..self.bodies.len()).map(|body| self.points_of(body, values)).collect();
        let speeds: Vec<f64> = self.drives.iter().map(|drive| values[drive.speed]).collect();
        let source = PictureSource { mechanism, poses, points: &points, speeds: &speeds };
        SpatialPicture { traces: traces(mechanism, positions, poses, traced), ..source.picture() }
    }

    fn points_of(&self, body: usize, values: &Values) -> Vec<(String, Vec3)> {
        let position = |point: usize| self.position(super::parts::PointId { body, point }, values);
        let points = self.bodies[body].points.iter().enumerate();
        points.map(|(number, point)| (point.name.clone(), position(number))).collect()
    }

    /// The points of outputs, each with the position in which the worst case of its output is largest; where there is none, the middles of joints
    /// between moving bodies.
    pub(super) fn traced_points(
        &self,
        mechanism: &SpatialMechanism,
        values: &Values,
        worst: &[usize],
    ) -> Vec<TracedPoint> {
        let of_outputs = self.outputs.iter().zip(worst).filter_map(|(output, worst)| {
            let (ModelOutputKind::Position { point, .. } | ModelOutputKind::Path { point }) = output.kind else {
                return None;
            };
            Some(TracedPoint {
                name: self.point_name(point),
                output: Some(output.name.clone()),
                body: point.body,
                point_m: self.position(point, values),
                worst: Some(*worst),
            })
        });
        let mut traced: Vec<TracedPoint> = Vec::new();
        for point in of_outputs {
            // Of several outputs of one point the first.
            if traced.iter().all(|other| other.name != point.name) {
                traced.push(point);
            }
        }
        if !traced.is_empty() {
            return traced;
        }
        let moving = mechanism.joints().iter().filter(|joint| joint.bearing.body != 0 && joint.journal.body != 0);
        moving
            .map(|joint| TracedPoint {
                name: joint.name.clone(),
                output: None,
                body: joint.bearing.body,
                point_m: joint.bearing.point_m,
                worst: None,
            })
            .collect()
    }
}
