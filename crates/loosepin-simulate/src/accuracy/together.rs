//! What play does where plays must meet conditions together: position by position to first order, and searches in the worst positions.

use super::in_space::InSpace;
use super::path::PathRecorder;
use super::play_reach::PlayReach;
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism};
use loosepin_mechanics::model::{Position, Values};
use loosepin_result::motion::{ClearanceAnswer, OutputMotion, SearchedPosition, UnprovenSpan};
use loosepin_space::{PlayDistribution, PoseAccuracy, SearchOptions, SpatialOutput, dead_centre_spans};

/// Relative difference of effects that is round-off.
const SAME: f64 = 1e-9;

/// Places of the readings that an output is made of, and their weights.
type Weights = Vec<(usize, f64)>;

/// Fills the answers of a mechanism in space.
pub(super) struct Together<'a> {
    space: InSpace<'a>,
    /// The same with pins that do not lean, where they do.
    held: Option<InSpace<'a>>,
    /// Whether play reaches a dead centre, at each position so far.
    dead_centres: Vec<bool>,
    /// What each output is at each position so far.
    outputs: Vec<Vec<SpatialOutput>>,
}

impl<'a> Together<'a> {
    /// Of a mechanism with these plays.
    ///
    /// # Errors
    /// Why it cannot be laid into space, in words.
    pub fn new(mechanism: &'a Mechanism, values: &'a Values, reaches: &[PlayReach]) -> Result<Self, String> {
        let leans = mechanism.model.leans;
        let held = leans.then(|| InSpace::new(mechanism, values, reaches, false)).transpose()?;
        let space = InSpace::new(mechanism, values, reaches, leans)?;
        Ok(Self { space, held, dead_centres: Vec::new(), outputs: Vec::new() })
    }

    /// Takes a state: weights of the readings in each output there, and the values of the readings for the paths.
    ///
    /// # Errors
    /// Why nothing is known, in words.
    pub fn record(
        &mut self,
        state: &IdealMotion<'_>,
        (readings, weights): (&[Position], &[Weights]),
        (paths, jets): (&mut PathRecorder, &[[f64; 3]]),
        outputs: &mut [OutputMotion],
    ) -> Result<(), String> {
        let (mechanism, position) = self.space.at(state)?;
        let accuracy = PoseAccuracy::new(&mechanism, &position).map_err(|error| error.to_string())?;
        if let Some(held) = &self.held {
            record_held(held, state, (readings, weights), outputs)?;
        }
        let mut own = Vec::with_capacity(weights.len());
        for (weights, motion) in weights.iter().zip(outputs) {
            let output = self.space.output(readings, weights);
            let output = output.ok_or_else(|| format!("output '{}' is seen from a body", motion.name))?;
            let gains = accuracy.gains(&output).map_err(|error| error.to_string())?;
            let first_order = accuracy.first_order(&gains).map_err(|error| error.to_string())?;
            let answer = &mut motion.clearance;
            answer.first_order_si.push(first_order.worst);
            let deviation = |places: PlayDistribution| accuracy.standard_deviation(&gains, places);
            answer.disc_standard_deviation_si.extend(deviation(PlayDistribution::Inside));
            answer.rim_standard_deviation_si.extend(deviation(PlayDistribution::OnTheRim));
            for (contributor, joint) in answer.contributors.iter_mut().zip(self.space.joint_of_play()) {
                contributor.first_order_si.push(first_order.by_joint[*joint]);
            }
            own.push(output);
        }
        let reach_m = |[x, y]: [usize; 2], direction: Vec2<f64>| -> f64 {
            let output = self.space.output(readings, &[(x, direction.x), (y, direction.y)]);
            let gains = output.and_then(|output| accuracy.gains(&output).ok());
            gains.and_then(|gains| accuracy.first_order(&gains).ok()).map_or(f64::INFINITY, |found| found.worst)
        };
        paths.record(jets, reach_m);
        self.dead_centres.push(accuracy.reaches_dead_centre());
        self.outputs.push(own);
        Ok(())
    }

    /// Searches the worst positions of each output, with the loops closed exactly: that where the first order is largest, and, if play reaches a dead
    /// centre there, that of the positions in which it reaches none.
    ///
    /// # Errors
    /// Why nothing is known, in words.
    pub fn search(
        &self,
        states: &[IdealMotion<'_>],
        outputs: &mut [OutputMotion],
        is_stopped: &dyn Fn() -> bool,
    ) -> Result<(), String> {
        for (number, motion) in outputs.iter_mut().enumerate() {
            let answer = &motion.clearance;
            let worst = largest(answer, |_| true);
            let regular = largest(answer, |position| !self.dead_centres[position]);
            let other =
                regular.filter(|position| worst.is_some_and(|worst| self.dead_centres[worst] && worst != *position));
            let places = worst.into_iter().chain(other);
            let searched = places.map(|position| self.searched(&states[position], position, number, is_stopped));
            motion.clearance.searched = searched.collect::<Result<_, _>>()?;
        }
        Ok(())
    }

    fn searched(
        &self,
        state: &IdealMotion<'_>,
        position: usize,
        output: usize,
        is_stopped: &dyn Fn() -> bool,
    ) -> Result<SearchedPosition, String> {
        let (mechanism, closed) = self.space.at(state)?;
        let accuracy = PoseAccuracy::new(&mechanism, &closed).map_err(|error| error.to_string())?;
        let output = &self.outputs[position][output];
        let exact = accuracy.worst_case_until(output, &SearchOptions::default(), is_stopped);
        let exact = exact.map_err(|error| error.to_string())?;
        let proven = accuracy.proven_end(output).map(|ends| [ends.smallest, ends.largest]);
        Ok(SearchedPosition {
            position,
            found_si: [exact.smallest.deviation, exact.largest.deviation],
            proven_si: Some(proven.unwrap_or([f64::NEG_INFINITY, f64::INFINITY])),
            conditions: accuracy.conditions(),
        })
    }

    /// Positions in a row in which play reaches a dead centre.
    pub fn unproven_spans(&self, angles_rad: &[f64]) -> Vec<UnprovenSpan> {
        dead_centre_spans(angles_rad, &self.dead_centres)
    }
}

/// Takes a state with pins that do not lean.
fn record_held(
    held: &InSpace<'_>,
    state: &IdealMotion<'_>,
    (readings, weights): (&[Position], &[Weights]),
    outputs: &mut [OutputMotion],
) -> Result<(), String> {
    let (mechanism, position) = held.at(state)?;
    let accuracy = PoseAccuracy::new(&mechanism, &position).map_err(|error| error.to_string())?;
    for (weights, motion) in weights.iter().zip(outputs) {
        let output = held.output(readings, weights);
        let output = output.ok_or_else(|| format!("output '{}' is seen from a body", motion.name))?;
        let gains = accuracy.gains(&output).map_err(|error| error.to_string())?;
        let first_order = accuracy.first_order(&gains).map_err(|error| error.to_string())?;
        motion.clearance.held_first_order_si.push(first_order.worst);
    }
    Ok(())
}

/// The position of the largest effect of first order, the first of several alike; `None` where play moves nothing.
fn largest(answer: &ClearanceAnswer, is_asked: impl Fn(usize) -> bool) -> Option<usize> {
    let mut found: Option<(usize, f64)> = None;
    for (position, &effect_si) in answer.first_order_si.iter().enumerate().filter(|(position, _)| is_asked(*position)) {
        if effect_si > found.map_or(0.0, |(_, known)| known * (1.0 + SAME)) {
            found = Some((position, effect_si));
        }
    }
    found.map(|(position, _)| position)
}
