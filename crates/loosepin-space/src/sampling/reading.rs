//! Numbers at one place of a sample.

use super::goal::{Goal, axes, point_m};
use super::longest::{Displacements, Longest};
use super::nominal::{NominalPlace, place_of};
use super::part::{PartOfOutput, PlaySide};
use super::reach::Reach;
use super::shortest::shortest;
use super::turn_sample::Numbers;
use crate::accuracy::AccuracyError;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::output::kind_of_output::{KindOfOutput, OutputState};
use crate::output::{PointOutput, SpatialOutput};
use loosepin_math::{Pose, Vec3};

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
        if let Some(output) = part.part.component().and_then(|number| part.components.get(number)) {
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
        let rotated = part.components.first().and_then(SpatialOutput::rotated_body);
        if let (PartOfOutput::Magnitude, Some(body)) = (part.part, rotated) {
            let [from, to] = [axes(body, &self.place.base.position.poses), axes(body, reach.ideal())];
            let offset = from.transposed_times(&to).rotation_vector();
            let goals = [to, from].map(|from| Goal::Angle { body, from });
            return self.length(reach, part.components, offset.to_array(), goals);
        }
        let [own, nominal] = [part.components, part.nominal].map(|all| all.first().and_then(SpatialOutput::point));
        let (own, nominal) = own.zip(nominal).ok_or(AccuracyError::OutputDoesNotFit)?;
        let displaced = point_m(&own, reach.ideal()) - point_m(&nominal, &self.place.base.position.poses);
        let tangent = self.place.tangents.get(part.number).copied().flatten();
        match (part.part, tangent) {
            (PartOfOutput::Along, Some(tangent)) => {
                let output = PointOutput { direction: tangent, ..own }.into();
                self.number(reach, 0.0, displaced.dot(tangent), &output)
            }
            (PartOfOutput::Across, Some(tangent)) => {
                let across = tangent.across().ok_or(AccuracyError::OutputDoesNotFit)?;
                self.displacement(reach, own, displaced, &[across, tangent.cross(across)])
            }
            (PartOfOutput::Magnitude, _) => self.displacement(reach, own, displaced, &Vec3::AXES),
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
    fn displacement(
        &self,
        reach: &mut dyn Reach,
        point: PointOutput,
        displaced: Vec3,
        directions: &[Vec3],
    ) -> Result<Numbers, AccuracyError> {
        let outputs: Vec<SpatialOutput> =
            directions.iter().map(|direction| PointOutput { direction: *direction, ..point }.into()).collect();
        let mut offset = [0.0; 3];
        offset.iter_mut().zip(directions).for_each(|(entry, direction)| *entry = displaced.dot(*direction));
        let goals = [[0.0; 3], offset].map(|offset| Goal::Length { point, directions, offset });
        self.length(reach, &outputs, offset, goals)
    }

    /// The length of a vector whose components are the deviations of `outputs`, from the ideal position and, with an offset, from the nominal one.
    /// To first order components add to the offset; the goals are the length of both as it is.
    fn length(
        &self,
        reach: &mut dyn Reach,
        outputs: &[SpatialOutput],
        offset: [f64; 3],
        goals: [Goal; 2],
    ) -> Result<Numbers, AccuracyError> {
        let from_nominal = offset.iter().map(|part| part * part).sum::<f64>().sqrt();
        let (by_play, in_all) = match (self.displaced, reach.side()) {
            (Some(poses), _) => {
                let [own, all] = goals.map(|goal| [goal.value(reach.mechanism(), reach.ideal(), poses); 2]);
                (own, all)
            }
            (None, PlaySide::None) => ([0.0; 2], [from_nominal; 2]),
            (None, side) => {
                let gains = outputs.iter().map(|output| reach.gains(output)).collect::<Result<Vec<_>, _>>()?;
                let mut displacements = Displacements::new(reach, &gains);
                let around = displacements.all_around()?;
                let [own, all] = [[0.0; 3], offset].map(|offset| displacements.longest(offset, &around));
                let (own, all) = (own?, all?);
                let smallest = shortest(&mut displacements, offset, all.length)?;
                let mut largest = |found: Longest, goal: &Goal| match side {
                    PlaySide::Exact => reach.climb(goal, &found.place),
                    _ => Ok(found.length),
                };
                ([0.0, largest(own, &goals[0])?], [smallest, largest(all, &goals[1])?])
            }
        };
        Ok(Numbers { ideal: 0.0, from_nominal, by_play, in_all })
    }
}
