//! What play does where plays must meet conditions together: position by position to first order, and searches in the worst positions.

use super::in_space::{InSpace, lifted};
use super::path::PathRecorder;
use super::play_effect::PlayEffect;
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::IdealMotion;
use loosepin_mechanics::model::Position;
use loosepin_result::motion::{OutputMotion, UnprovenSpan};
use loosepin_space::{
    AccuracyError, PlayDistribution, PoseAccuracy, SpatialOutput, Worst, WorstPlaces, dead_centre_spans,
};

/// Places of the readings that an output is made of, and their weights.
type Weights = Vec<(usize, f64)>;

/// Asks a mechanism in space what play does.
pub(super) struct Together<'a> {
    space: InSpace<'a>,
    /// Names of the outputs.
    names: Vec<String>,
    /// Whether play reaches a dead centre, at each position so far.
    dead_centres: Vec<bool>,
    /// Where each output is to be searched.
    worst: Vec<WorstPlaces<SpatialOutput>>,
}

impl<'a> Together<'a> {
    /// Of a mechanism with outputs of these names.
    pub fn new(space: InSpace<'a>, names: Vec<String>) -> Self {
        Self { space, dead_centres: Vec::new(), worst: vec![WorstPlaces::default(); names.len()], names }
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
        let effects = self.asked(state, |accuracy| self.effects_of(accuracy, readings, weights))?;
        Ok(effects.into_iter().map(|(_, effect)| effect).collect())
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
        let (found, nearness) = self.asked(state, |accuracy| {
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
        Ok(effects)
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
                self.asked(&states[*position], |accuracy| {
                    accuracy.searched(*position, output, true, is_stopped).map_err(words)
                })
            });
            motion.clearance.searched = searched.collect::<Result<_, _>>()?;
        }
        Ok(dead_centre_spans(angles_rad, &self.dead_centres))
    }

    /// Asks the mechanism where it is in a state.
    fn asked<T>(
        &self,
        state: &IdealMotion<'_>,
        question: impl FnOnce(&PoseAccuracy<'_>) -> Result<T, String>,
    ) -> Result<T, String> {
        let (mechanism, position) = self.space.at(state)?;
        question(&PoseAccuracy::new(&mechanism, &position).map_err(words)?)
    }

    fn effects_of(
        &self,
        accuracy: &PoseAccuracy<'_>,
        readings: &[Position],
        weights: &[Weights],
    ) -> Result<Vec<(SpatialOutput, PlayEffect)>, String> {
        let effect = |(weights, name): (&Weights, &String)| {
            let output = self.space.output(readings, weights);
            let output = output.ok_or_else(|| format!("output '{name}' is seen from a body"))?;
            let gains = accuracy.gains(&output).map_err(words)?;
            let first_order = accuracy.first_order(&gains).map_err(words)?;
            let effect = PlayEffect {
                worst_si: first_order.worst,
                by_joint_si: self.space.joint_of_play().iter().map(|joint| first_order.by_joint[*joint]).collect(),
                disc_standard_deviation_si: accuracy.standard_deviation(&gains, PlayDistribution::Inside),
                rim_standard_deviation_si: accuracy.standard_deviation(&gains, PlayDistribution::OnTheRim),
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

fn words(error: AccuracyError) -> String {
    error.to_string()
}
