//! How far play takes a number of an output, over the turn or in one position of it: what a requirement is judged by.

use crate::accuracy::{AccuracyError, PoseAccuracy, SearchOptions};
use crate::closure::assembly::Starts;
use crate::closure::position::Position;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::model::compile::CycleInput;
use crate::model::course::has_play;
use crate::model::over_turn::ideal;
use crate::model::parts::SpatialModel;
use crate::motion::path_direction;
use crate::output::SpatialOutput;
use crate::output::kind_of_output::OutputState;
use crate::sampling::{PartOfOutput, SampledPart};
use crate::stop::IsStopped;
use loosepin_math::Vec3;
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::numbers::Values;
use std::ops::Range;

/// What is asked of play.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlayQuestion {
    /// The number.
    pub part: SampledPart,
    /// Whether the number itself is meant, with its ideal value, and not its deviation from that.
    pub is_value: bool,
    /// Whether the joints have their play; without it the ends are the ideal values.
    pub has_play: bool,
    /// The place in the turn, from 0 to 1; all positions of the cycle where it is `None`.
    pub turn: Option<f64>,
    /// Limits in m or rad. Where they are found to be broken, nothing is proven.
    pub limits: [f64; 2],
}

/// How far play takes a number, m or rad.
#[derive(Debug, Clone, PartialEq)]
pub struct PlayEnds {
    /// The lowest and the highest that were found, with the loops closed exactly: both are reached. Of a length the lowest is 0.
    pub found: [f64; 2],
    /// Places in the turn at which they were found.
    pub found_at: [f64; 2],
    /// Ends that nothing passes in the positions that were looked at; infinite where nothing is proven.
    pub proven: [f64; 2],
    /// Why nothing is proven, in words.
    pub unproven: Option<String>,
}

const NOTHING: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

impl PlayEnds {
    /// Before anything is found.
    fn new() -> Self {
        Self { found: [f64::INFINITY, f64::NEG_INFINITY], found_at: [0.0; 2], proven: NOTHING, unproven: None }
    }

    /// Takes what was found in a position.
    fn take(&mut self, [low, high]: [f64; 2], turn: f64) {
        if low < self.found[0] {
            (self.found[0], self.found_at[0]) = (low, turn);
        }
        if high > self.found[1] {
            (self.found[1], self.found_at[1]) = (high, turn);
        }
    }

    /// What is known where there is no answer.
    fn unknown(why: String) -> Self {
        Self { found: [f64::NAN; 2], found_at: [f64::NAN; 2], proven: NOTHING, unproven: Some(why) }
    }
}

/// Where play is looked at.
struct Walk<'a> {
    model: &'a SpatialModel,
    mechanism: SpatialMechanism,
    positions: Vec<Position>,
    /// Ideal value in each position; 0 of deviations.
    ideal: Vec<f64>,
    components: Vec<SpatialOutput>,
    part: PartOfOutput,
    input: CycleInput,
    is_stopped: IsStopped<'a>,
}

impl SpatialModel {
    /// How far play takes a number with these values, until it is stopped. Searches are made in the positions in which it is lowest and highest to
    /// first order, and by what is proven; proofs are made in all positions that are looked at, a tenth of a second each and more.
    ///
    /// # Errors
    /// As for [`SpatialModel::motion_record_until`].
    pub fn play_ends_until(
        &self,
        values: &Values,
        question: &PlayQuestion,
        is_stopped: IsStopped,
    ) -> Result<PlayEnds, Diagnostics> {
        let mechanism = self.mechanism(values).map_err(|error| self.diagnostic(&error))?;
        let input = self.cycle_input(values).map_err(|error| self.diagnostic(&error))?;
        let times_s: Vec<f64> = match question.turn {
            None => input.times_s(),
            // Turns of bodies are counted on the way.
            Some(turn) => {
                let before = input.times_s().into_iter().filter(|time_s| *time_s < turn * input.turn_s);
                std::iter::once(0.0).chain(before.skip(1)).chain([turn * input.turn_s]).collect()
            }
        };
        let looked_at = if question.turn.is_some() { times_s.len() - 1..times_s.len() } else { 0..times_s.len() };
        let positions = self.turn(&mechanism, values, &times_s, Starts::Nearby, is_stopped).whole();
        let positions = positions.map_err(|error| self.not_closed(&error))?;
        let components = self.outputs_of(question.part.output, values).map_err(|error| self.diagnostic(&error))?;
        let components = components_of(question.part.part, &components);
        let states: Vec<OutputState> =
            positions.iter().map(|own| OutputState { mechanism: &mechanism, poses: &own.poses }).collect();
        let ideal = match (question.is_value, components.as_slice()) {
            (true, [_]) => ideal(&components, &states, 0),
            _ => vec![0.0; positions.len()],
        };
        let part = question.part.part;
        let walk =
            Walk { model: self, positions, ideal, components, part, input: input.clone(), is_stopped, mechanism };
        walk.ends(question, looked_at).map_err(|(index, error)| {
            let time_s = times_s.get(index).copied().unwrap_or_default();
            self.no_answer(&self.outputs[question.part.output].name, input.at(time_s), error).into()
        })
    }
}

/// The components of an output that make a part of it.
fn components_of(part: PartOfOutput, all: &[SpatialOutput]) -> Vec<SpatialOutput> {
    let number = match part {
        PartOfOutput::Number | PartOfOutput::X => 0,
        PartOfOutput::Y => 1,
        PartOfOutput::Z => 2,
        PartOfOutput::Along | PartOfOutput::Across | PartOfOutput::Magnitude => return all.to_vec(),
    };
    all.get(number).copied().into_iter().collect()
}

/// An answer, or the position that has none.
type At<T> = Result<T, (usize, AccuracyError)>;

impl Walk<'_> {
    fn ends(&self, question: &PlayQuestion, looked_at: Range<usize>) -> At<PlayEnds> {
        let turn = |index: usize| self.positions[index].input / self.input.turn_s;
        if !question.has_play || !self.mechanism.joints().iter().any(has_play) {
            return Ok(self.ideal_ends(looked_at, &turn));
        }
        let mut sizes = Vec::with_capacity(looked_at.len());
        for index in looked_at.clone() {
            let accuracy = self.accuracy(index)?;
            let Some(components) = self.components_at(index) else { return Ok(self.at_rest(index)) };
            sizes.push((index, self.largest(&accuracy, &components).map_err(|error| (index, error))?.0));
        }
        // The lowest and the highest of first order, the first of several alike.
        let end = |sign: f64| {
            let ends = sizes.iter().map(|(index, size)| (*index, sign * self.ideal[*index] + size));
            ends.reduce(|a, b| if b.1 > a.1 { b } else { a }).map_or(0, |(index, _)| index)
        };
        let mut ends = PlayEnds::new();
        let mut searched = vec![end(-1.0)];
        if end(1.0) != searched[0] {
            searched.push(end(1.0));
        }
        for index in &searched {
            ends.take(self.found(*index)?, turn(*index));
        }
        if ends.found[0] < question.limits[0] || ends.found[1] > question.limits[1] {
            return Ok(ends);
        }
        let mut proven = [(f64::INFINITY, 0), (f64::NEG_INFINITY, 0)];
        for index in looked_at {
            let Some([low, high]) = self.proven(index)? else {
                return Ok(PlayEnds { unproven: Some(self.why_unproven(index)?), ..ends });
            };
            if low < proven[0].0 {
                proven[0] = (low, index);
            }
            if high > proven[1].0 {
                proven[1] = (high, index);
            }
        }
        // The first order may have its ends elsewhere.
        for (_, index) in proven {
            if !searched.contains(&index) {
                searched.push(index);
                ends.take(self.found(index)?, turn(index));
            }
        }
        Ok(PlayEnds { proven: proven.map(|(end, _)| end), ..ends })
    }

    /// Without play: the ideal values.
    fn ideal_ends(&self, looked_at: Range<usize>, turn: &dyn Fn(usize) -> f64) -> PlayEnds {
        let mut ends = PlayEnds::new();
        for index in looked_at {
            ends.take([self.ideal[index]; 2], turn(index));
        }
        PlayEnds { proven: ends.found, ..ends }
    }

    fn accuracy(&self, index: usize) -> At<PoseAccuracy<'_>> {
        if (self.is_stopped)() {
            return Err((index, AccuracyError::Stopped));
        }
        PoseAccuracy::new(&self.mechanism, &self.positions[index]).map_err(|error| (index, error))
    }

    /// The components of the part in a position; `None` where its directions are those of a path whose point rests.
    fn components_at(&self, index: usize) -> Option<Vec<SpatialOutput>> {
        let is_along = match self.part {
            PartOfOutput::Along => true,
            PartOfOutput::Across => false,
            _ => return Some(self.components.clone()),
        };
        let own = self.components.first()?;
        let tangent = path_direction(&self.mechanism, &self.positions[index], &own.point()?, self.input.turn_s)?;
        if is_along {
            return Some(vec![own.component(tangent)?]);
        }
        let across = tangent.across()?;
        Some(vec![own.component(across)?, own.component(tangent.cross(across))?])
    }

    /// The largest deviation of first order, and the component that has it.
    fn largest(
        &self,
        accuracy: &PoseAccuracy<'_>,
        components: &[SpatialOutput],
    ) -> Result<(f64, SpatialOutput), AccuracyError> {
        if let [output] = components {
            return Ok((accuracy.first_order(&accuracy.gains(output)?)?.worst, *output));
        }
        let gains = components.iter().map(|output| accuracy.gains(output)).collect::<Result<Vec<_>, _>>()?;
        let longest = accuracy.largest_norm(&gains)?;
        // Components of a rotation are about x, y and z.
        let axes = components.iter().zip(Vec3::AXES).map(|(own, axis)| own.point().map_or(axis, |own| own.direction));
        let direction = axes.zip(&longest.direction).fold(Vec3::ZERO, |sum, (axis, share)| sum + axis * *share);
        let direction = direction.normalised().unwrap_or(Vec3::X);
        let along = components.first().and_then(|first| first.component(direction));
        Ok((longest.largest, along.ok_or(AccuracyError::OutputDoesNotFit)?))
    }

    /// The lowest and the highest that a search finds in a position.
    fn found(&self, index: usize) -> At<[f64; 2]> {
        let accuracy = self.accuracy(index)?;
        let components = self.components_at(index).unwrap_or_default();
        let found = self.largest(&accuracy, &components).and_then(|(_, along)| {
            let exact = accuracy.worst_case_until(&along, &SearchOptions::default(), self.is_stopped)?;
            Ok([exact.smallest.deviation, exact.largest.deviation])
        });
        let [low, high] = found.map_err(|error| (index, error))?;
        Ok(match components.len() {
            1 => [low + self.ideal[index], high + self.ideal[index]],
            _ => [0.0, f64::max(-low, high)],
        })
    }

    /// Ends that are proven in a position; of a length by those of its components.
    fn proven(&self, index: usize) -> At<Option<[f64; 2]>> {
        let accuracy = self.accuracy(index)?;
        let components = self.components_at(index).unwrap_or_default();
        let ends = components.iter().map(|output| accuracy.proven_end(output).map(|own| [own.smallest, own.largest]));
        let Some(ends) = ends.collect::<Option<Vec<[f64; 2]>>>() else { return Ok(None) };
        Ok(Some(match ends[..] {
            [[low, high]] => [low + self.ideal[index], high + self.ideal[index]],
            _ => [0.0, ends.iter().fold(0.0, |length: f64, [low, high]| length.hypot(f64::max(-low, *high)))],
        }))
    }

    fn why_unproven(&self, index: usize) -> At<String> {
        if !self.accuracy(index)?.redundant.is_empty() {
            return Ok("constraints repeat others, and nothing is proven then".to_owned());
        }
        Ok(format!("the proof fails at {}, where play may come near another assembly", self.place(index)))
    }

    fn at_rest(&self, index: usize) -> PlayEnds {
        PlayEnds::unknown(format!(
            "the point rests at {}, where nothing is along or across its path",
            self.place(index)
        ))
    }

    /// A position for people.
    fn place(&self, index: usize) -> String {
        self.model.input_words(self.input.at(self.positions[index].input))
    }
}
