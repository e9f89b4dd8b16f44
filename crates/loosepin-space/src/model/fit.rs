//! Whether the parts of a mechanism whose constraints repeat each other fit: the least play with which it can be put together and turned.

use super::compile::CycleInput;
use super::parts::SpatialModel;
use super::problem::SpatialMotionProblem;
use crate::accuracy::{LeastPlay, PoseAccuracy};
use crate::closure::assembly::Starts;
use crate::closure::error::ClosureError;
use crate::closure::position::Position;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::stop::IsStopped;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics};
use loosepin_text::document::listed;
use loosepin_text::numbers::Values;
use loosepin_text::units::{Dimension, format_value};

/// A share of a joint below this is round-off.
const MIN_SHARE: f64 = 1e-6;

/// The least play over a turn.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelAssembly {
    /// Constraints that repeat others, the most over the turn: without any the parts fit whatever their errors.
    pub redundant_rows: usize,
    /// The smallest factor s of all plays with which the mechanism can be put together in every position of the turn that is looked at. Above 1 it
    /// cannot; infinite where errors break what no play reaches; 0 where the parts fit without play.
    pub least_factor: f64,
    /// The position that needs most.
    pub sample: usize,
    /// The driven coordinate there, rad or m, or the time, s; `None` where there is no turn.
    pub input: Option<f64>,
    /// Name of that coordinate, and its dimension.
    pub input_name: Option<(String, Dimension)>,
    /// The joints whose play limits, with their shares, which add up to 1; the largest first.
    pub limits: Vec<(String, f64)>,
}

impl ModelAssembly {
    /// Whether the mechanism can be put together.
    pub fn is_possible(&self) -> bool {
        self.least_factor <= 1.0
    }

    /// The answer in a sentence; `None` where no constraint repeats another, so that there is no question.
    pub fn sentence(&self) -> Option<String> {
        if self.redundant_rows == 0 {
            return None;
        }
        if self.least_factor == 0.0 {
            return Some("the parts fit: constraints that repeat others close without play".to_owned());
        }
        let at = match (self.input, &self.input_name) {
            (Some(input), Some((name, dimension))) => format!(" at {name} = {}", format_value(input, *dimension)),
            _ => String::new(),
        };
        if self.least_factor.is_infinite() {
            return Some(format!(
                "the parts do not fit{at}, and no play helps: constraints contradict each other that no play reaches"
            ));
        }
        let names: Vec<String> = self.limits.iter().map(|(name, _)| format!("'{name}'")).collect();
        let joints = if names.len() == 1 { "joint" } else { "joints" };
        let limits = format!("limited by {joints} {}", listed(&names, "and"));
        let factor = format_value(rounded(self.least_factor), Dimension::NUMBER);
        Some(if self.is_possible() {
            format!("the parts fit by their play: {factor} of all plays is needed{at}, {limits}")
        } else {
            format!("the parts do not fit: {factor} times all plays would be needed{at}, {limits}")
        })
    }
}

/// To four digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

impl SpatialModel {
    /// The least play with which the mechanism with these values can be put together, at the positions of the turn, or at the start if there is no
    /// turn; until it is stopped.
    ///
    /// Positions are those of the mechanism without its tilts and shifts; where that does not close either, of the nominal one without them.
    /// At each the least play is exact ([`PoseAccuracy::least_play`]); between them it is not looked at.
    ///
    /// # Errors
    /// What [`SpatialModel::mechanism`] refuses; loops that do not close without errors of manufacture; positions without an answer; that it was
    /// stopped.
    pub fn assembly_until(&self, values: &Values, is_stopped: IsStopped) -> Result<ModelAssembly, Diagnostics> {
        let mechanism = self.mechanism(values).map_err(|error| self.diagnostic(&error))?;
        let aligned = self.aligned(values).map_err(|error| self.diagnostic(&error))?;
        let input = match &self.cycle {
            None => None,
            Some(_) => Some(self.cycle_input(values).map_err(|error| self.diagnostic(&error))?),
        };
        let times_s = input.as_ref().map_or_else(|| vec![0.0], CycleInput::times_s);
        // Of another assembly it would say nothing.
        let positions_of =
            |own: &SpatialMechanism| self.turn(own, values, &times_s, Starts::AsGiven, is_stopped).whole();
        let positions = match positions_of(&aligned) {
            Ok(positions) => positions,
            Err(error @ (ClosureError::Stopped | ClosureError::TooLong { .. })) => {
                return Err(self.not_closed(&error));
            }
            Err(error) => {
                let nominal = self.aligned(&self.quantities.nominal()).map_err(|error| self.diagnostic(&error))?;
                positions_of(&nominal).map_err(|of_nominal| match of_nominal {
                    ClosureError::Stopped => self.not_closed(&of_nominal),
                    _ => self.not_closed(&error),
                })?
            }
        };
        let mut worst = ModelAssembly {
            redundant_rows: 0,
            least_factor: -1.0,
            sample: 0,
            input: None,
            input_name: input.as_ref().map(|own| match &own.drive {
                Some(drive) => (drive.clone(), Dimension::ANGLE),
                None => ("time".to_owned(), Dimension::TIME),
            }),
            limits: Vec::new(),
        };
        for (sample, position) in positions.iter().enumerate() {
            if is_stopped() {
                return Err(self.not_closed(&ClosureError::Stopped));
            }
            let at = input.as_ref().map(|own| own.at(position.input));
            let found = least_play(&mechanism, position).map_err(|why| {
                let input = at.unwrap_or(position.input);
                let subject = "the least play".to_owned();
                let problem = SpatialMotionProblem::NoAnswer { subject, at: self.input_words(input), why };
                Diagnostic::error(&problem, None)
            })?;
            worst.redundant_rows = worst.redundant_rows.max(position.redundant_rows());
            // Round-off decides nothing: the first of several alike.
            if found.factor > worst.least_factor * (1.0 + SAME) || worst.least_factor < 0.0 {
                worst.limits = limits(&mechanism, &found);
                (worst.least_factor, worst.sample, worst.input) = (found.factor, sample, at);
            }
        }
        worst.least_factor = worst.least_factor.max(0.0);
        Ok(worst)
    }
}

/// Relative difference of factors that is round-off.
const SAME: f64 = 1e-9;

fn least_play(mechanism: &SpatialMechanism, position: &Position) -> Result<LeastPlay, String> {
    let accuracy = PoseAccuracy::new(mechanism, position).map_err(|error| error.to_string())?;
    accuracy.least_play().map_err(|error| error.to_string())
}

fn limits(mechanism: &SpatialMechanism, found: &LeastPlay) -> Vec<(String, f64)> {
    let shares = mechanism.joints().iter().zip(&found.by_joint);
    let mut limits: Vec<(String, f64)> =
        shares.filter(|(_, share)| **share > MIN_SHARE).map(|(joint, share)| (joint.name.clone(), *share)).collect();
    limits.sort_by(|a, b| b.1.total_cmp(&a.1));
    limits
}
