//! What looks at a run while it goes on.

use super::motion::{Motion, Projection};
use crate::dynamics::Dynamics;
use crate::integrate::Stepper;
use crate::mechanism::{IdealMotion, SampleError};

/// A contact that begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Onset {
    /// Index in [`crate::mechanism::Mechanism::plays`].
    pub play: usize,
    /// Time, s.
    pub time_s: f64,
    /// Penetration rate δ̇ at the located onset, m/s, before the floor of the law.
    pub speed_m_s: f64,
    /// Whether the speed is below the floor v_min of the law: then it is no impact.
    pub is_floored: bool,
}

/// A contact that ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separation {
    /// Index in [`crate::mechanism::Mechanism::plays`].
    pub play: usize,
    /// Time, s.
    pub time_s: f64,
    /// Separation speed -δ̇, m/s.
    pub speed_m_s: f64,
}

/// Sees every accepted step and every event of a run.
pub trait Observer {
    /// After a step. Steps that end before the recorded window are not shown; one that straddles its start is.
    fn step(&mut self, step: &mut Step<'_, '_>);
    /// A contact begins.
    fn contact_begins(&mut self, _onset: &Onset) {}
    /// A contact ends.
    fn contact_ends(&mut self, _separation: &Separation) {}
}

/// An accepted step: the motion between two instants, to be looked at anywhere.
pub struct Step<'s, 'a> {
    pub(super) source: Source<'s, 'a>,
    /// Start of the step, s.
    pub start_s: f64,
    /// End of the step, s.
    pub end_s: f64,
}

/// Where the states of a step come from.
pub(super) enum Source<'s, 'a> {
    /// Dense output of an integrated step.
    Integrated {
        motion: &'s mut Motion<'a>,
        stepper: &'s mut Stepper,
        projection: Option<&'s mut Projection>,
        state: &'s mut Vec<f64>,
        /// Whether the equations of motion were evaluated last at the end of the step.
        is_at_end: bool,
    },
    /// The motion of a mechanism without play, solved afresh at each instant.
    Kinematic { motion: &'s mut Motion<'a>, ideal: &'s mut IdealMotion<'a>, failure: &'s mut Option<SampleError> },
}

impl<'a> Step<'_, 'a> {
    /// Sets positions and velocities at `time_s` within the step.
    pub fn set_state(&mut self, time_s: f64) -> &Dynamics<'a, f64> {
        self.look(time_s, false)
    }

    /// Sets positions and velocities at `time_s` within the step and evaluates forces and accelerations.
    pub fn evaluate(&mut self, time_s: f64) -> &Dynamics<'a, f64> {
        self.look(time_s, true)
    }

    /// The end of the step with forces and accelerations; free of cost before anything else was looked at.
    pub fn end(&mut self) -> &Dynamics<'a, f64> {
        if !matches!(&self.source, Source::Integrated { is_at_end: true, .. }) {
            self.look(self.end_s, true);
        }
        match &self.source {
            Source::Integrated { motion, .. } | Source::Kinematic { motion, .. } => &motion.dynamics,
        }
    }

    /// Whether the joint with play `play` is in contact during this step.
    pub fn is_in_contact(&self, play: usize) -> bool {
        match &self.source {
            Source::Integrated { motion, .. } | Source::Kinematic { motion, .. } => motion.states[play].contact > 0.0,
        }
    }

    /// Normal force in the joint with play `play` at `time_s` within the step, N.
    pub fn normal_force_n(&mut self, play: usize, time_s: f64) -> f64 {
        self.look(time_s, false);
        match &self.source {
            Source::Integrated { motion, .. } | Source::Kinematic { motion, .. } => motion.play_force(play).normal_n,
        }
    }

    /// Work of the drives, contact loss and friction loss since time zero at the instant looked at last, J. None where the
    /// motion was not integrated.
    pub fn account_j(&self) -> Option<[f64; 3]> {
        match &self.source {
            Source::Integrated { motion, state, .. } => {
                let first = 2 * motion.freedoms();
                Some([state[first], state[first + 1], state[first + 2]])
            }
            Source::Kinematic { .. } => None,
        }
    }

    fn look(&mut self, time_s: f64, with_forces: bool) -> &Dynamics<'a, f64> {
        match &mut self.source {
            Source::Integrated { motion, stepper, projection, state, is_at_end } => {
                *is_at_end = false;
                let share = ((time_s - stepper.time_s()) / stepper.step_s()).clamp(0.0, 1.0);
                if share == 0.0 {
                    state.copy_from_slice(stepper.start());
                } else if share == 1.0 {
                    state.copy_from_slice(stepper.end());
                } else {
                    stepper.interpolate(*motion, share, state);
                }
                if let Some(projection) = projection {
                    projection.apply(motion, time_s, state);
                }
                if with_forces {
                    motion.evaluate(time_s, state)
                } else {
                    motion.set_state(time_s, state)
                }
                &motion.dynamics
            }
            Source::Kinematic { motion, ideal, failure } => {
                match ideal.move_to(time_s) {
                    Ok(()) => {
                        let (coordinates, rates) = ideal.real_state();
                        let n = motion.freedoms();
                        if with_forces {
                            let states: &[_] = &motion.states;
                            motion.dynamics.evaluate(time_s, &coordinates[..n], &rates[..n], states);
                        } else {
                            motion.dynamics.set_state(time_s, &coordinates[..n], &rates[..n]);
                        }
                    }
                    Err(error) => **failure = failure.take().or(Some(error)),
                }
                &motion.dynamics
            }
        }
    }
}
