//! Numbers at one place of a sample.

use super::goal::{Goal, point_m};
use super::longest::{Displacements, Longest};
use super::nominal::{NominalPlace, component, place_of};
use super::part::{PartOfOutput, PlaySide};
use super::reach::Reach;
use super::shortest::shortest;
use super::turn_sample::Numbers;
use crate::accuracy::AccuracyError;
use crate::geometry::pose::Pose;
use crate::geometry::vector::Vec3;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{KindOfOutput, OutputState};
use crate::output::{PointOutput, SpatialOutput};

/// A part of an output with its components, in the sample and nominally.
pub(super) struct PlacedPart<'a> {
    pub part: PartOfOutput,
    pub components: &'a [SpatialOutput],
    pub nominal: &'a [SpatialOutput],
    /// Number of the part.
    pub number: usize,
}

/// Reads a place of a sample off.
pub(super) struct PlaceReader<'a> {
    pub place: &'a NominalPlace,
    pub nominal_mechanism: &'a SpatialMechanism,
    /// Poses with the journals in their places, where these are known.
    pub displaced: Option<&'a [Pose]>,
}

impl PlaceReader<'_> {
    /// The numbers of a part.
    pub(super) fn read(&self, reach: &mut dyn Reach, part: &PlacedPart<'_>) -> Result<Numbers, AccuracyError> {
        let nominal = self.place.values.get(part.number).copied().unwrap_or_default();
        if let Some(output) = component(part.part).and_then(|number| part.components.get(number)) {
            let ideal = match output.point() {
                Some(_) => place_of(part.part, part.components, reach.ideal()),
                None => {
                    let from =
                        OutputState { mechanism: self.nominal_mechanism, poses: &self.place.base.position.poses };
                    let to = OutputState { mechanism: reach.mechanism(), poses: reach.ideal() };
                    nominal + output.deviation(&from, &to)
                }
            };
            return self.number(reach, ideal, ideal - nominal, output);
        }
        let [own, nominal] = [part.components, part.nominal].map(|all| all.first().and_then(SpatialOutput::point));
        let (own, nominal) = own.zip(nominal).ok_or(AccuracyError::OutputDoesNotFit)?;
        let displacement = point_m(&own, reach.ideal()) - point_m(&nominal, &self.place.base.position.poses);
        let tangent = self.place.tangents.get(part.number).copied().flatten();
        match (part.part, tangent) {
            (PartOfOutput::Along, Some(tangent)) => {
                let output = PointOutput { direction: tangent, ..own }.into();
                self.number(reach, 0.0, displacement.dot(tangent), &output)
            }
            (PartOfOutput::Across, Some(tangent)) => {
                let across = tangent.across().ok_or(AccuracyError::OutputDoesNotFit)?;
                self.length(reach, own, displacement, &[across, tangent.cross(across)])
            }
            (PartOfOutput::Magnitude, _) => self.length(reach, own, displacement, &Vec3::AXES),
            _ => Err(AccuracyError::OutputDoesNotFit),
        }
    }

    /// A number that play changes by a deviation with a sign.
    fn number(
        &self,
        reach: &mut dyn Reach,
        ideal: f64,
        from_nominal: f64,
        output: &SpatialOutput,
    ) -> Result<Numbers, AccuracyError> {
        let by_play = match (self.displaced, reach.side()) {
            (Some(poses), _) => {
                let goal = Goal::Deviation { output, sign: 1.0 };
                [goal.value(reach.mechanism(), reach.ideal(), poses); 2]
            }
            (None, PlaySide::None) => [0.0; 2],
            (None, PlaySide::FirstOrder) => {
                let gains = reach.gains(output)?;
                reach.ends(&gains)?
            }
            (None, PlaySide::Exact) => {
                let (mut gains, mut start) = (reach.gains(output)?, Vec::new());
                let mut ends = [0.0; 2];
                for (end, sign) in ends.iter_mut().zip([-1.0, 1.0]) {
                    gains.iter_mut().for_each(|gain| *gain = -*gain);
                    reach.farthest(&gains, &mut start)?;
                    *end = sign * reach.climb(&Goal::Deviation { output, sign }, &start)?;
                }
                ends
            }
        };
        Ok(Numbers { ideal, from_nominal, by_play, in_all: by_play.map(|own| own + from_nominal) })
    }

    /// The length of a displacement in some directions.
    fn length(
        &self,
        reach: &mut dyn Reach,
        point: PointOutput,
        displacement: Vec3,
        directions: &[Vec3],
    ) -> Result<Numbers, AccuracyError> {
        let parts_of = |vector: Vec3| directions.iter().map(move |direction| vector.dot(*direction));
        let length_of = |vector: Vec3| parts_of(vector).map(|part| part * part).sum::<f64>().sqrt();
        let from_nominal = length_of(displacement);
        let (by_play, in_all) = match (self.displaced, reach.side()) {
            (Some(poses), _) => {
                let moved = point_m(&point, poses) - point_m(&point, reach.ideal());
                ([length_of(moved); 2], [length_of(displacement + moved); 2])
            }
            (None, PlaySide::None) => ([0.0; 2], [from_nominal; 2]),
            (None, side) => {
                let outputs = directions.iter().map(|direction| PointOutput { direction: *direction, ..point }.into());
                let gains = outputs.map(|output| reach.gains(&output)).collect::<Result<Vec<_>, _>>()?;
                let mut offset = [0.0; 3];
                offset.iter_mut().zip(parts_of(displacement)).for_each(|(entry, part)| *entry = part);
                let mut displacements = Displacements::new(reach, &gains);
                let around = displacements.all_around()?;
                let [own, all] = [[0.0; 3], offset].map(|offset| displacements.longest(offset, &around));
                let (own, all) = (own?, all?);
                let smallest = shortest(&mut displacements, offset, all.length)?;
                let mut largest = |found: Longest, offset: [f64; 3]| match side {
                    PlaySide::Exact => reach.climb(&Goal::Length { point, directions, offset }, &found.place),
                    _ => Ok(found.length),
                };
                ([0.0, largest(own, [0.0; 3])?], [smallest, largest(all, offset)?])
            }
        };
        Ok(Numbers { ideal: 0.0, from_nominal, by_play, in_all })
    }
}
