//! Points of flexible bodies that lie where they cannot.

use crate::mechanism::error::SampleError;
use crate::mechanism::tree::beam::{SAME_SECTION, TreeBeam, share_of};
use crate::model::{Body, BodyId, Model, PointId, Values};

/// Share of the length by which a run may put a point off its section. The section carries it as a rigid arm, which misses ½ w'' Δ² of its
/// deflection and ε Δ of its stretch: 0.2 % of the deflection of a half wave.
const MAX_SHIFT: f64 = 0.02;

/// Names of the first flexible body and of its point that lies beyond the ends of its beam.
pub(in crate::mechanism) fn point_beyond_beam(model: &Model, values: &Values) -> Option<(String, String)> {
    (0..model.bodies.len()).map(BodyId).filter(|body| model.bodies[body.0].beam.is_some()).find_map(|body| {
        let Body { name, points, .. } = &model.bodies[body.0];
        let is_beyond = |point: usize| {
            !(-SAME_SECTION..=1.0 + SAME_SECTION).contains(&share_of(model, PointId { body, point }, values))
        };
        (0..points.len()).find(|point| is_beyond(*point)).map(|point| (name.clone(), points[point].name.clone()))
    })
}

/// The first point of a flexible body that `values` put too far off the section of `tree` that carries it.
pub(in crate::mechanism) fn point_off_section(
    model: &Model,
    beams: &[TreeBeam],
    values: &Values,
) -> Option<SampleError> {
    beams.iter().find_map(|beam| {
        let Body { name, points, .. } = &model.bodies[beam.body.0];
        points.iter().enumerate().find_map(|(index, point)| {
            let share = share_of(model, PointId { body: beam.body, point: index }, values);
            let from_root = if beam.is_reversed { 1.0 - share } else { share };
            let off = from_root - beam.station(beam.places[index]).share;
            (off.abs() > MAX_SHIFT).then(|| SampleError::PointOffSection {
                body: name.clone(),
                point: point.name.clone(),
                share: off,
                largest: MAX_SHIFT,
            })
        })
    })
}
