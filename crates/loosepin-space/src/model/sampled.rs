//! Why a model cannot be sampled, at the part of its file that is at fault.

use super::parts::SpatialModel;
use super::problem::SpatialMotionProblem;
use crate::sampling::SamplingError;
use loosepin_text::diagnostics::{Diagnostic, Place};
use loosepin_text::numbers::Values;

impl SpatialModel {
    /// What keeps the mechanism with these values from being sampled, at its place in the file; as far as a motion says the same, in its words.
    pub fn not_sampled(&self, values: &Values, error: &SamplingError) -> Diagnostic {
        let of_output = |problem: &SpatialMotionProblem, output: &str| {
            Diagnostic::error(problem, self.place(&format!("output.{output}")))
        };
        match error {
            SamplingError::Model(error) => {
                let found = self.diagnostic(error);
                // What is not written has no place: the file is the one of the model.
                let place = found.place.clone().or_else(|| Some(Place::new(self.source(), 0..0)));
                Diagnostic { place, ..found }
            }
            SamplingError::DoesNotClose { why, .. } => self.open(why),
            SamplingError::NoAnswer { turn, output, why } => self.no_answer(output, self.input_at(values, *turn), *why),
            SamplingError::CoarseTurn { output } => {
                of_output(&SpatialMotionProblem::CoarseTurn { output: output.clone() }, output)
            }
            SamplingError::AtRest { output, turn } => {
                let at = self.input_words(self.input_at(values, *turn));
                of_output(&SpatialMotionProblem::AtRest { output: output.clone(), at }, output)
            }
            SamplingError::DeadCentre { turn } => {
                let at = self.input_words(self.input_at(values, *turn));
                Diagnostic::error(&SpatialMotionProblem::ReachesDeadCentre { at }, self.place("cycle"))
            }
            other => {
                let problem = SpatialMotionProblem::NotSampled { why: other.to_string() };
                Diagnostic::error(&problem, self.place_of_joint(other.joint()))
            }
        }
    }

    /// The input of the cycle at a place in turns: an angle or a time.
    fn input_at(&self, values: &Values, turn: f64) -> f64 {
        self.cycle_input(values).map_or(turn, |input| input.at(turn * input.turn_s))
    }
}
