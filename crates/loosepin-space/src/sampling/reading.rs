//! Numbers at one place of a sample.

use super::longest::longest;
use super::nominal::{NominalPlace, component, place_of};
use super::part::{PartOfOutput, PlaySide};
use super::turn_sample::Numbers;
use crate::accuracy::search::Climb;
use crate::accuracy::slice::{dot, largest};
use crate::accuracy::{AccuracyError, Extreme, PoseAccuracy};
use crate::geometry::pose::Pose;
use crate::geometry::vector::Vec3;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{KindOfOutput, OutputState};
use crate::output::{PointOutput, SpatialOutput};

/// Most climbs of a length, each in the direction of the displacement so far.
const MAX_CLIMBS: usize = 50;

/// A part of an output with its components, in the sample and nominally.
pub(super) struct PlacedPart<'a> {
    pub part: PartOfOutput,
    pub components: &'a [SpatialOutput],
    pub nominal: &'a [SpatialOutput],
    /// Number of the part.
    pub number: usize,
}

/// One place of a sample.
pub(super) struct PlaceReader<'a> {
    pub place: &'a NominalPlace,
    pub nominal_mechanism: &'a SpatialMechanism,
    pub accuracy: &'a PoseAccuracy<'a>,
    /// What the plays must make of each redundant row: h·p.
    pub right: &'a [f64],
    pub play: PlacePlay<'a>,
}

/// What is known of the play at a place.
#[derive(Debug, Clone, Copy)]
pub(super) enum PlacePlay<'a> {
    /// It may do anything.
    Any(PlaySide),
    /// The journals have places, and these are the poses.
    Displaced(&'a [Pose]),
}

impl PlaceReader<'_> {
    /// The numbers of a part.
    pub(super) fn read(&self, part: &PlacedPart<'_>) -> Result<Numbers, AccuracyError> {
        let poses = &self.accuracy.position().poses;
        let nominal = self.place.values.get(part.number).copied().unwrap_or_default();
        if let Some(output) = component(part.part).and_then(|number| part.components.get(number)) {
            let ideal = match output.point() {
                Some(_) => place_of(part.part, part.components, poses),
                None => {
                    let from = OutputState { mechanism: self.nominal_mechanism, poses: &self.place.position.poses };
                    nominal + output.deviation(&from, &OutputState { mechanism: self.accuracy.mechanism(), poses })
                }
            };
            return self.number(ideal, ideal - nominal, output);
        }
        let [own, nominal] = [part.components, part.nominal].map(|all| all.first().and_then(SpatialOutput::point));
        let (own, nominal) = own.zip(nominal).ok_or(AccuracyError::OutputDoesNotFit)?;
        let start_m = point_m(&nominal, &self.place.position.poses);
        let displacement = point_m(&own, poses) - start_m;
        let tangent = self.place.tangents.get(part.number).copied().flatten();
        match (part.part, tangent) {
            (PartOfOutput::Along, Some(tangent)) => {
                self.number(0.0, displacement.dot(tangent), &PointOutput { direction: tangent, ..own }.into())
            }
            (PartOfOutput::Across, Some(tangent)) => {
                let across = tangent.across().ok_or(AccuracyError::OutputDoesNotFit)?;
                self.length(own, displacement, &[across, tangent.cross(across)])
            }
            (PartOfOutput::Magnitude, _) => self.length(own, displacement, &Vec3::AXES),
            _ => Err(AccuracyError::OutputDoesNotFit),
        }
    }

    /// A number that play changes by a deviation with a sign.
    fn number(&self, ideal: f64, from_nominal: f64, output: &SpatialOutput) -> Result<Numbers, AccuracyError> {
        let by_play = match self.play {
            PlacePlay::Displaced(poses) => [self.accuracy.deviation_of(output, poses); 2],
            PlacePlay::Any(PlaySide::None) => [0.0; 2],
            PlacePlay::Any(PlaySide::FirstOrder) => {
                let gains = self.scaled_gains(output)?;
                let opposite: Vec<f64> = gains.iter().map(|gain| -gain).collect();
                [-self.worst(&opposite)?, self.worst(&gains)?]
            }
            PlacePlay::Any(PlaySide::Exact) => {
                let gains = self.scaled_gains(output)?;
                let climb = |sign: f64| self.climb(output, sign, &gains).map(|found| found.deviation);
                [climb(-1.0)?, climb(1.0)?]
            }
        };
        Ok(Numbers { ideal, from_nominal, by_play, in_all: by_play.map(|own| own + from_nominal) })
    }

    /// The length of a displacement in some directions.
    fn length(&self, own: PointOutput, displacement: Vec3, directions: &[Vec3]) -> Result<Numbers, AccuracyError> {
        let offset: Vec<f64> = directions.iter().map(|direction| displacement.dot(*direction)).collect();
        let from_nominal = dot(&offset, &offset).sqrt();
        let side = match self.play {
            PlacePlay::Displaced(poses) => {
                let moved = point_m(&own, poses) - point_m(&own, &self.accuracy.position().poses);
                let along = |vector: Vec3| {
                    let parts = directions.iter().map(|direction| vector.dot(*direction));
                    parts.map(|part| part * part).sum::<f64>().sqrt()
                };
                let [by_play, in_all] = [along(moved), along(displacement + moved)];
                return Ok(Numbers { ideal: 0.0, from_nominal, by_play: [by_play; 2], in_all: [in_all; 2] });
            }
            PlacePlay::Any(PlaySide::None) => {
                return Ok(Numbers { ideal: 0.0, from_nominal, by_play: [0.0; 2], in_all: [from_nominal; 2] });
            }
            PlacePlay::Any(side) => side,
        };
        let along = directions.iter().map(|direction| PointOutput { direction: *direction, ..own }.into());
        let gains = along.map(|output| self.scaled_gains(&output)).collect::<Result<Vec<_>, _>>()?;
        let none = vec![0.0; offset.len()];
        let largest = |offset: &[f64]| self.longest(side, own, offset, directions, &gains);
        Ok(Numbers { ideal: 0.0, from_nominal, by_play: [0.0, largest(&none)?], in_all: [0.0, largest(&offset)?] })
    }

    fn longest(
        &self,
        side: PlaySide,
        own: PointOutput,
        offset: &[f64],
        directions: &[Vec3],
        gains: &[Vec<f64>],
    ) -> Result<f64, AccuracyError> {
        let accuracy = self.accuracy;
        let found =
            longest(&accuracy.set, &accuracy.planes, self.right, offset, gains).ok_or(AccuracyError::NoPlace)?;
        if side == PlaySide::FirstOrder {
            return Ok(found.length);
        }
        // Exactly: from that place along the displacement so far, as long as it grows.
        let ideal_m = point_m(&own, &accuracy.position().poses);
        let displacement = |poses: &[Pose]| {
            let moved = point_m(&own, poses) - ideal_m;
            let parts = directions.iter().zip(offset);
            let vector = parts.map(|(direction, offset)| *direction * (offset + moved.dot(*direction)));
            vector.fold(Vec3::ZERO, |sum, part| sum + part)
        };
        let linear = gains.iter().zip(directions).zip(offset);
        let vector = linear.map(|((gain, direction), offset)| *direction * (offset + dot(gain, &found.place)));
        let mut direction = vector.fold(Vec3::ZERO, |sum, part| sum + part).normalised();
        let (mut variables, mut best) = (accuracy.set.in_metres(&found.place), -1.0);
        for _ in 0..MAX_CLIMBS {
            let Some(along) = direction else { break };
            let output = PointOutput { direction: along, ..own }.into();
            let climb = Climb { accuracy, output: &output, sign: 1.0 };
            let end = climb.climb_from_variables(&variables).ok_or(AccuracyError::NoPlace)?;
            let vector = displacement(&end.poses);
            if !(vector.length() > best * (1.0 + 1e-12)) {
                break;
            }
            (best, direction, variables) = (vector.length(), vector.normalised(), end.variables_m);
        }
        Ok(best.max(0.0))
    }

    fn scaled_gains(&self, output: &SpatialOutput) -> Result<Vec<f64>, AccuracyError> {
        Ok(self.accuracy.scaled_gains(&self.accuracy.gains(output)?))
    }

    /// The largest g·p to first order.
    fn worst(&self, gains: &[f64]) -> Result<f64, AccuracyError> {
        let accuracy = self.accuracy;
        let found = largest(&accuracy.set, gains, None, &accuracy.planes, self.right).ok_or(AccuracyError::NoPlace)?;
        Ok(dot(gains, &found.place))
    }

    fn climb(&self, output: &SpatialOutput, sign: f64, gains: &[f64]) -> Result<Extreme, AccuracyError> {
        let accuracy = self.accuracy;
        let gains: Vec<f64> = gains.iter().map(|gain| sign * gain).collect();
        let start =
            largest(&accuracy.set, &gains, None, &accuracy.planes, self.right).ok_or(AccuracyError::NoPlace)?.place;
        let climb = Climb { accuracy, output, sign };
        climb.climb_from_variables(&accuracy.set.in_metres(&start)).ok_or(AccuracyError::NoPlace)
    }
}

fn point_m(point: &PointOutput, poses: &[Pose]) -> Vec3 {
    poses[point.body].point_m(point.point_m)
}
