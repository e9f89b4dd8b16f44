//! One run alone: the equations as they stand, on plain numbers.

use super::column::{Arms, Reading};
use super::memory::{Memory, Named};
use super::motion::Motion;
use super::pass::Pass;
use super::projection::Projection;
use loosepin_math::integrate::System;
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::{Mechanism, Sample};

/// The equations of the one lane there is.
pub struct Plain<'a> {
    motion: Motion<'a, f64>,
    projection: Option<Projection<f64>>,
    readings: Vec<Reading>,
    arms: Arms,
}

impl<'a> Plain<'a> {
    /// With the numbers of `sample` until another one is loaded; `readings` are read at the ends of steps.
    pub fn new(mechanism: &'a Mechanism, sample: &Sample<f64>, arms: &Arms, readings: &[Reading]) -> Self {
        Self {
            motion: Motion::new(mechanism, sample),
            projection: Projection::<f64>::is_needed(mechanism).then(|| Projection::new(mechanism)),
            readings: readings.to_vec(),
            arms: arms.clone(),
        }
    }

    /// Takes the numbers of a run.
    pub fn load(&mut self, sample: &Sample<f64>, arms: &Arms) {
        self.motion.dynamics.sample_mut().clone_from(sample);
        self.arms.clone_from(arms);
    }

    /// Sets the state of a contact.
    pub fn set_contact(&mut self, contact: usize, state: &PlayState<f64>, has_root: bool) {
        self.motion.states[contact] = *state;
        if let Some(root) = &mut self.motion.unknowns[contact].root {
            root.is_unknown = f64::from(u8::from(has_root));
        }
    }

    /// Evaluates at the start of the step.
    pub fn evaluate_start(&mut self, pass: &Pass, memory: &mut Memory) {
        let Named { rows, end_reads, .. } = Named::new(memory.blocks());
        let end = pass.stepper.end_row() * pass.layout.length();
        self.reading(end_reads).derivative_at_end(rows.start, &mut rows.stages[end..end + pass.layout.length()]);
    }

    /// Tries the step.
    pub fn attempt(&mut self, pass: &Pass, memory: &mut Memory) {
        let mut named = Named::new(memory.blocks());
        pass.choose_step(&mut named);
        pass.attempt(&mut named.rows, named.lane, &mut self.reading(named.end_reads));
        pass.judge_attempt(self.motion.dynamics.sample(), &mut named);
    }

    /// Holds the loops of ideal joints.
    pub fn hold_loops(&mut self, pass: &Pass, memory: &mut Memory) {
        if let Some(projection) = &mut self.projection {
            pass.hold_loops(&mut Named::new(memory.blocks()), &mut self.motion, projection);
        }
    }

    /// Computes what looks inside of the step at hand need.
    pub fn prepare_dense(&mut self, pass: &Pass, memory: &mut Memory) {
        let Named { lane, mut rows, .. } = Named::new(memory.blocks());
        pass.prepare_dense(&mut rows, lane, &mut self.motion);
    }

    fn reading<'s>(&'s mut self, reads: &'s mut [f64]) -> ReadingSystem<'s, 'a> {
        ReadingSystem { plain: self, reads }
    }
}

/// The equations, and where they put what is read at the end of a step.
struct ReadingSystem<'s, 'a> {
    plain: &'s mut Plain<'a>,
    reads: &'s mut [f64],
}

impl System for ReadingSystem<'_, '_> {
    fn derivative(&mut self, state: &[f64], slope: &mut [f64]) {
        self.plain.motion.derivative(state, slope);
    }

    fn derivative_at_end(&mut self, state: &[f64], slope: &mut [f64]) {
        let Plain { motion, readings, arms, .. } = self.plain;
        motion.derivative(state, slope);
        motion.read(readings, arms, self.reads);
    }
}
