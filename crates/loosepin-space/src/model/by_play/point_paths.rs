//! Paths of points over the turn, with what play makes of them: of outputs that are paths, and of points that a command names.

use crate::accuracy::{AccuracyError, Gains, PoseAccuracy};
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::model::marker::PointId;
use crate::model::parts::SpatialModel;
use crate::model::problem::SpatialMotionProblem;
use crate::model::round_off::drop_round_off_of_path;
use crate::motion::{PathFrame, RESTING, motion};
use crate::output::SpatialOutput;
use loosepin_math::Vec3;
use loosepin_result::point_path::PointPath;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics};
use loosepin_text::numbers::{NamedPoints, Values, place_in_path_argument, points_of_paths};

/// The paths of some points, position by position.
pub(in crate::model) struct PathsOverTurn {
    paths: Vec<PathOverTurn>,
    /// Speeds up to this are round-off, m/s.
    rest_m_s: f64,
    size_m: f64,
}

struct PathOverTurn {
    body: usize,
    point_m: Vec3,
    path: PointPath,
}

impl PathsOverTurn {
    /// Adds the next position; what has no answer is said with the path.
    pub fn add(
        &mut self,
        mechanism: &SpatialMechanism,
        accuracy: &PoseAccuracy<'_>,
    ) -> Result<(), (String, AccuracyError)> {
        if self.paths.is_empty() {
            return Ok(());
        }
        let rates = motion(mechanism, accuracy.position());
        for PathOverTurn { body, point_m, path } in &mut self.paths {
            let pose = &accuracy.position().poses[*body];
            let arm = pose.orientation.rotation().apply(*point_m);
            let velocity = rates.point_velocity_m_s(*body, arm);
            let acceleration = rates.point_acceleration_m_s2(*body, arm);
            let frame = PathFrame::new(velocity, acceleration, self.rest_m_s);
            let [along_m, across_m, longest_m] =
                reach_m(accuracy, *body, *point_m, frame).map_err(|error| (path.name.clone(), error))?;
            push([&mut path.x_m, &mut path.y_m, &mut path.z_m], pose.point_m(*point_m));
            push([&mut path.velocity_x_m_s, &mut path.velocity_y_m_s, &mut path.velocity_z_m_s], velocity);
            push(
                [&mut path.acceleration_x_m_s2, &mut path.acceleration_y_m_s2, &mut path.acceleration_z_m_s2],
                acceleration,
            );
            let tangent = frame.map_or(Vec3::ZERO, |frame| frame.tangent);
            push([&mut path.tangent_x, &mut path.tangent_y, &mut path.tangent_z], tangent);
            path.play_along_m.push(along_m);
            path.play_across_m.push(across_m);
            path.play_longest_m.push(longest_m);
        }
        Ok(())
    }

    /// The paths, without what is nothing but round-off.
    pub fn finished(self) -> Vec<PointPath> {
        let finished = |PathOverTurn { mut path, .. }: PathOverTurn| {
            drop_round_off_of_path(&mut path, self.size_m);
            path
        };
        self.paths.into_iter().map(finished).collect()
    }
}

/// Reach of play along the path, the longest displacement across it, and the longest one, to first order; all the last one where the point rests.
fn reach_m(
    accuracy: &PoseAccuracy<'_>,
    body: usize,
    point_m: Vec3,
    frame: Option<PathFrame>,
) -> Result<[f64; 3], AccuracyError> {
    let components = SpatialOutput::displacement(body, point_m);
    let gains = |outputs: &[SpatialOutput]| {
        outputs.iter().map(|output| accuracy.gains(output)).collect::<Result<Vec<Gains>, AccuracyError>>()
    };
    let longest_m = accuracy.largest_norm(&gains(&components)?)?.largest;
    let Some(PathFrame { tangent, normal, binormal }) = frame else { return Ok([longest_m; 3]) };
    let component = |direction: Vec3| components[0].component(direction).ok_or(AccuracyError::OutputDoesNotFit);
    let along = accuracy.first_order(&accuracy.gains(&component(tangent)?)?)?.worst;
    let across = accuracy.largest_norm(&gains(&[component(normal)?, component(binormal)?])?)?.largest;
    Ok([along, across, longest_m])
}

fn push(lists: [&mut Vec<f64>; 3], vector: Vec3) {
    lists.into_iter().zip(vector.to_array()).for_each(|(list, value)| list.push(value));
}

impl SpatialModel {
    /// The points called `names`, each `BODY.POINT`; a second mention of one counts once.
    ///
    /// # Errors
    /// As for [`points_of_paths`].
    pub fn points_of_paths(&self, names: &[String]) -> Result<Vec<PointId>, Diagnostics> {
        let bodies = self.bodies.iter().map(|body| NamedPoints {
            body: &body.name,
            points: body.points.iter().map(|point| point.name.as_str()).collect(),
        });
        let points = points_of_paths(names, &bodies.collect::<Vec<_>>())?;
        Ok(points.into_iter().map(|[body, point]| PointId { body, point }).collect())
    }

    /// The paths of outputs in file order, then of `points` that are none, before the first position.
    pub(in crate::model) fn paths_over_turn(
        &self,
        mechanism: &SpatialMechanism,
        values: &Values,
        turn_s: f64,
        points: &[PointId],
    ) -> PathsOverTurn {
        let of_paths = self.outputs.iter().filter(|output| output.kind.is_path());
        let of_output = of_paths.filter_map(|output| Some((Some(output.name.clone()), output.kind.point()?)));
        let mut asked: Vec<(Option<String>, PointId)> = of_output.collect();
        for point in points {
            if asked.iter().all(|(_, known)| known != point) {
                asked.push((None, *point));
            }
        }
        let path = |(output, point): (Option<String>, PointId)| {
            let words = self.point_name(point);
            let name = output.clone().unwrap_or_else(|| words.clone());
            PathOverTurn {
                body: point.body,
                point_m: self.position(point, values),
                path: PointPath { name, point: words, output, ..PointPath::default() },
            }
        };
        let size_m = mechanism.characteristic_length_m();
        PathsOverTurn { paths: asked.into_iter().map(path).collect(), rest_m_s: RESTING * size_m / turn_s, size_m }
    }

    /// Why a path has no answer at a place of the input: at its output, or at the argument that names its point.
    pub(in crate::model) fn no_path(&self, path: &str, input: f64, error: AccuracyError) -> Diagnostic {
        if self.outputs.iter().any(|output| output.name == path) || error == AccuracyError::Stopped {
            return self.no_answer(path, input, error);
        }
        let (subject, at) = (format!("the path of {path}"), self.input_words(input));
        let problem = SpatialMotionProblem::NoAnswer { subject, at, why: error.to_string() };
        Diagnostic::error(&problem, Some(place_in_path_argument(path)))
    }
}
