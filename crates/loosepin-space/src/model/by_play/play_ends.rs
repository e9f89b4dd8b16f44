//! How far play takes a number of an output, over the turn or in one position of it: what a requirement is judged by.

use crate::accuracy::{AccuracyError, Longest, PoseAccuracy, SearchOptions};
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
    /// As for [`SpatialModel::motion_with_paths_until`].
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
        let components = match question.part.part.component() {
            Some(component) => components.get(component).copied().into_iter().collect(),
            None => components,
        };
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

/// A position that is looked at.
struct Place {
    index: usize,
    /// The components of the part there; there are some.
    components: Vec<SpatialOutput>,
    /// The largest deviation of first order, and the component that has it.
    size: f64,
    along: SpatialOutput,
}

/// An answer, or the position that has none.
type At<T> = Result<T, (usize, AccuracyError)>;

impl Walk<'_> {
    fn ends(&self, question: &PlayQuestion, looked_at: Range<usize>) -> At<PlayEnds> {
        let turn = |index: usize| self.positions[index].input / self.input.turn_s;
        if !question.has_play || !self.mechanism.joints().iter().any(has_play) {
            return Ok(self.ideal_ends(looked_at, &turn));
        }
        let mut places = Vec::with_capacity(looked_at.len());
        for index in looked_at {
            let Some(components) = self.components_at(index) else { return Ok(self.at_rest(index)) };
            let Longest { size, along, .. } = self.answered(index, |accuracy| {
                let gains = components.iter().map(|output| accuracy.gains(output)).collect::<Result<Vec<_>, _>>()?;
                accuracy.longest(&gains)
            })?;
            places.push(Place { index, size, along: along.output, components });
        }
        // The lowest and the highest of first order, the first of several alike.
        let end = |sign: f64| {
            let end = |place: &Place| sign * self.ideal[place.index] + place.size;
            (0..places.len()).reduce(|a, b| if end(&places[b]) > end(&places[a]) { b } else { a })
        };
        let mut searched: Vec<usize> = [end(-1.0), end(1.0)].into_iter().flatten().collect();
        searched.dedup();
        let mut ends = PlayEnds::new();
        for own in &searched {
            ends.take(self.found(&places[*own])?, turn(places[*own].index));
        }
        if ends.found[0] < question.limits[0] || ends.found[1] > question.limits[1] {
            return Ok(ends);
        }
        let mut proven = [(f64::INFINITY, 0), (f64::NEG_INFINITY, 0)];
        for (own, place) in places.iter().enumerate() {
            let Some([low, high]) = self.proven(place)? else {
                return Ok(PlayEnds { unproven: Some(self.why_unproven(place.index)?), ..ends });
            };
            if low < proven[0].0 {
                proven[0] = (low, own);
            }
            if high > proven[1].0 {
                proven[1] = (high, own);
            }
        }
        // The first order may have its ends elsewhere.
        for (_, own) in proven {
            if !searched.contains(&own) {
                searched.push(own);
                ends.take(self.found(&places[own])?, turn(places[own].index));
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

    /// An answer in a position.
    fn answered<T>(&self, index: usize, ask: impl FnOnce(&PoseAccuracy<'_>) -> Result<T, AccuracyError>) -> At<T> {
        ask(&self.accuracy(index)?).map_err(|error| (index, error))
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

    /// The lowest and the highest that a search finds in a position.
    fn found(&self, Place { index, along, components, .. }: &Place) -> At<[f64; 2]> {
        let options = SearchOptions::default();
        let exact = self.answered(*index, |accuracy| accuracy.worst_case_until(along, &options, self.is_stopped))?;
        let [low, high] = [exact.smallest.deviation, exact.largest.deviation];
        Ok(match components.len() {
            1 => [low + self.ideal[*index], high + self.ideal[*index]],
            _ => [0.0, f64::max(-low, high)],
        })
    }

    /// Ends that are proven in a position; of a length by those of its components.
    fn proven(&self, Place { index, components, .. }: &Place) -> At<Option<[f64; 2]>> {
        let accuracy = self.accuracy(*index)?;
        let ends = components.iter().map(|output| accuracy.proven_end(output).map(|own| [own.smallest, own.largest]));
        let Some(ends) = ends.collect::<Option<Vec<[f64; 2]>>>() else { return Ok(None) };
        Ok(Some(match ends[..] {
            [[low, high]] => [low + self.ideal[*index], high + self.ideal[*index]],
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
