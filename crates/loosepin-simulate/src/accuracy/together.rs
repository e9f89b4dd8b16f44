//! What play does where plays must meet conditions together: position by position to first order, and searches in the worst positions.

use super::in_space::{InSpace, lifted};
use super::path::PathRecorder;
use super::play_effect::PlayEffect;
use super::play_reach::PlayReach;
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism};
use loosepin_mechanics::model::{Position, Values};
use loosepin_result::motion::{OutputMotion, UnprovenSpan};
use loosepin_space::{
    AccuracyError, FirstOrder, Gains, PlayDistribution, PoseAccuracy, SpatialOutput, Worst, WorstPlaces,
    dead_centre_spans,
};

/// Places of the readings that an output is made of, and their weights.
type Weights = Vec<(usize, f64)>;

/// Asks a mechanism in space what play does.
pub(super) struct Together<'a> {
    space: InSpace<'a>,
    /// The same with pins that do not lean, where they do.
    held: Option<InSpace<'a>>,
    /// Names of the outputs.
    names: Vec<String>,
    /// Whether play reaches a dead centre, at each position so far.
    dead_centres: Vec<bool>,
    /// Where each output is to be searched.
    worst: Vec<WorstPlaces<SpatialOutput>>,
}

impl<'a> Together<'a> {
    /// Of a mechanism with these plays and outputs of these names.
    ///
    /// # Errors
    /// Why it cannot be laid into space, in words.
    pub fn new(
        (mechanism, values): (&'a Mechanism, &'a Values),
        reaches: &[PlayReach],
        names: Vec<String>,
    ) -> Result<Self, String> {
        let leans = mechanism.has_leaning_pins();
        let space = InSpace::new(mechanism, values, reaches, leans)?;
        let held = leans.then(|| InSpace::new(mechanism, values, reaches, false)).transpose()?;
        Ok(Self { space, held, dead_centres: Vec::new(), worst: vec![WorstPlaces::default(); names.len()], names })
    }

    /// What play does to each output in a state, with the weights of the readings in each there.
    ///
    /// # Errors
    /// Why nothing is known, in words.
    pub fn effects(
        &self,
        state: &IdealMotion<'_>,
        readings: &[Position],
        weights: &[Weights],
    ) -> Result<Vec<PlayEffect>, String> {
        let effects = asked(&self.space, state, |accuracy| self.effects_of(accuracy, readings, weights))?;
        self.with_held(state, (readings, weights), effects.into_iter().map(|(_, effect)| effect).collect())
    }

    /// Takes the next state: what play does to each output, and how far it takes the points of the paths, whose readings move with `jets`.
    ///
    /// # Errors
    /// Why nothing is known, in words.
    pub fn record(
        &mut self,
        state: &IdealMotion<'_>,
        (readings, weights): (&[Position], &[Weights]),
        (paths, jets): (&mut PathRecorder, &[[f64; 3]]),
    ) -> Result<Vec<PlayEffect>, String> {
        let (found, nearness) = asked(&self.space, state, |accuracy| {
            let found = self.effects_of(accuracy, readings, weights)?;
            paths.record(jets, |places, directions| {
                let reaches_m = self.reaches_m(accuracy, readings, places, directions);
                reaches_m.unwrap_or_else(|| vec![f64::NAN; directions.len()])
            });
            Ok((found, accuracy.dead_centre_nearness()))
        })?;
        let position = self.dead_centres.len();
        self.dead_centres.push(nearness.is_reached);
        let mut effects = Vec::with_capacity(found.len());
        for (worst, (output, effect)) in self.worst.iter_mut().zip(found) {
            // What play does not move is not searched.
            if effect.worst_si > 0.0 {
                worst.add(position, effect.worst_si, !nearness.is_near, &output);
            }
            effects.push(effect);
        }
        self.with_held(state, (readings, weights), effects)
    }

    /// Searches the worst positions of each output, with the loops closed exactly: that where the first order is largest, and, if play comes near a dead
    /// centre there, that of the positions in which it comes near none. Says in which spans play reaches a dead centre.
    ///
    /// # Errors
    /// Why nothing is known, in words.
    pub fn search(
        &self,
        (states, angles_rad): (&[IdealMotion<'_>], &[f64]),
        outputs: &mut [OutputMotion],
        is_stopped: &dyn Fn() -> bool,
    ) -> Result<Vec<UnprovenSpan>, String> {
        for (worst, motion) in self.worst.iter().zip(outputs) {
            let searched = worst.searched().map(|Worst { position, place: output, .. }| {
                asked(&self.space, &states[*position], |accuracy| {
                    accuracy.searched(*position, output, true, is_stopped).map_err(words)
                })
            });
            motion.clearance.searched = searched.collect::<Result<_, _>>()?;
        }
        Ok(dead_centre_spans(angles_rad, &self.dead_centres))
    }

    /// The effects in a state with those of pins that do not lean, where they do.
    fn with_held(
        &self,
        state: &IdealMotion<'_>,
        (readings, weights): (&[Position], &[Weights]),
        mut effects: Vec<PlayEffect>,
    ) -> Result<Vec<PlayEffect>, String> {
        let Some(held) = &self.held else { return Ok(effects) };
        let worst_si = |accuracy: &PoseAccuracy<'_>, weights: &Weights, name: &str| -> Result<f64, String> {
            Ok(first_order(accuracy, &self.output(readings, weights, name)?)?.1.worst)
        };
        asked(held, state, |accuracy| {
            for ((effect, weights), name) in effects.iter_mut().zip(weights).zip(&self.names) {
                effect.held_si = Some(worst_si(accuracy, weights, name)?);
            }
            Ok(())
        })?;
        Ok(effects)
    }

    /// What an output is in space, held or not.
    fn output(&self, readings: &[Position], weights: &Weights, name: &str) -> Result<SpatialOutput, String> {
        self.space.output(readings, weights).ok_or_else(|| format!("output '{name}' is seen from a body"))
    }

    fn effects_of(
        &self,
        accuracy: &PoseAccuracy<'_>,
        readings: &[Position],
        weights: &[Weights],
    ) -> Result<Vec<(SpatialOutput, PlayEffect)>, String> {
        let effect = |(weights, name): (&Weights, &String)| {
            let output = self.output(readings, weights, name)?;
            let (gains, first_order) = first_order(accuracy, &output)?;
            let effect = PlayEffect {
                worst_si: first_order.worst,
                by_joint_si: self.space.joint_of_play().iter().map(|joint| first_order.by_joint[*joint]).collect(),
                disc_standard_deviation_si: accuracy.standard_deviation(&gains, PlayDistribution::Inside),
                rim_standard_deviation_si: accuracy.standard_deviation(&gains, PlayDistribution::OnTheRim),
                held_si: None,
            };
            Ok((output, effect))
        };
        weights.iter().zip(&self.names).map(effect).collect()
    }

    /// How far play takes the point with its coordinates at two places of the readings along unit vectors, m.
    fn reaches_m(
        &self,
        accuracy: &PoseAccuracy<'_>,
        readings: &[Position],
        places: [usize; 2],
        directions: &[Vec2<f64>],
    ) -> Option<Vec<f64>> {
        let components = self.space.displacement(readings, places)?;
        let gains = components.iter().map(|output| accuracy.gains(output)).collect::<Result<Vec<_>, _>>().ok()?;
        let directions: Vec<_> = directions.iter().copied().map(lifted).collect();
        let farthest = accuracy.farthest(&gains, &directions).ok()?;
        Some(farthest.iter().zip(&directions).map(|(farthest, direction)| farthest.dot(*direction)).collect())
    }
}

/// The lowest and the highest deviation of a reading by play that searches find over `states`, each with its position: in the worst positions, with
/// the loops closed exactly. `None` where nothing is known, and where it was stopped.
pub(super) fn found_over(
    space: &InSpace<'_>,
    states: &[IdealMotion<'_>],
    reading: Position,
    is_stopped: &dyn Fn() -> bool,
) -> Option<[(usize, f64); 2]> {
    let output = space.output(&[reading], &[(0, 1.0)])?;
    let mut worst = WorstPlaces::default();
    for (position, state) in states.iter().enumerate() {
        let effect = |accuracy: &PoseAccuracy<'_>| {
            Ok((first_order(accuracy, &output)?.1.worst, accuracy.dead_centre_nearness().is_near))
        };
        let (size_si, is_near) = asked(space, state, effect).ok().filter(|_| !is_stopped())?;
        if size_si > 0.0 {
            worst.add(position, size_si, !is_near, &());
        }
    }
    let mut found = [(0, 0.0); 2];
    for Worst { position, .. } in worst.searched() {
        let search =
            |accuracy: &PoseAccuracy<'_>| accuracy.searched(*position, &output, false, is_stopped).map_err(words);
        let [low, high] = asked(space, &states[*position], search).ok()?.found_si;
        if low < found[0].1 {
            found[0] = (*position, low);
        }
        if high > found[1].1 {
            found[1] = (*position, high);
        }
    }
    Some(found)
}

/// The gains of an output, and its worst case to first order.
fn first_order(accuracy: &PoseAccuracy<'_>, output: &SpatialOutput) -> Result<(Gains, FirstOrder), String> {
    let gains = accuracy.gains(output).map_err(words)?;
    let first_order = accuracy.first_order(&gains).map_err(words)?;
    Ok((gains, first_order))
}

/// Asks a mechanism in space where it is in a state.
fn asked<T>(
    space: &InSpace<'_>,
    state: &IdealMotion<'_>,
    question: impl FnOnce(&PoseAccuracy<'_>) -> Result<T, String>,
) -> Result<T, String> {
    let (mechanism, position) = space.at(state)?;
    question(&PoseAccuracy::new(&mechanism, &position).map_err(words)?)
}

fn words(error: AccuracyError) -> String {
    error.to_string()
}
