//! Observers of a run in progress.

use super::resume::MotionState;
use crate::recording::work::KinematicAccount;
use crate::stepping::gap::GapJet;
use crate::stepping::motion::{EnergyTotals, Motion};
use crate::stepping::projection::Projection;
use loosepin_math::Quintic;
use loosepin_mechanics::contact::{Foundation, FoundationMotion};
use loosepin_mechanics::dynamics::{ContactForce, Dynamics, PlayState, foundation_motion};
use loosepin_mechanics::mechanism::{IdealMotion, Sample, SampleError};
use std::sync::Arc;

/// A contact that begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Onset {
    /// Index in [`loosepin_mechanics::mechanism::Mechanism::contacts`].
    pub contact: usize,
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
    /// Index in [`loosepin_mechanics::mechanism::Mechanism::contacts`].
    pub contact: usize,
    /// Time, s.
    pub time_s: f64,
    /// Separation speed -δ̇, m/s.
    pub speed_m_s: f64,
}

/// Sees every accepted step and every event of a run.
pub trait Observer {
    /// After a step of the recorded part, which begins and ends with one.
    fn step(&mut self, step: &mut Step<'_, '_>);
    /// Steps that end before this time need not be shown, s. Asked at the start and after every step that was shown.
    fn awaits_s(&self) -> f64 {
        f64::NEG_INFINITY
    }
    /// A contact begins.
    fn contact_begins(&mut self, _onset: &Onset) {}
    /// A contact ends.
    fn contact_ends(&mut self, _separation: &Separation) {}
    /// Whether the run is to be given up; asked every few steps, the transient ones too.
    fn is_stopped(&self) -> bool {
        false
    }
}

/// An elastic foundation at an instant.
pub(super) struct FoundationAt {
    /// The foundation.
    pub foundation: Arc<Foundation>,
    /// Motion of its journal.
    pub motion: FoundationMotion,
    /// 1/v0 of the contact, s/m.
    pub inverse_impact_speed_s_m: f64,
}

/// An accepted step: the motion between two instants, to be looked at anywhere.
pub struct Step<'s, 'a> {
    pub(super) source: Source<'s, 'a>,
    /// Start of the step, s.
    pub start_s: f64,
    /// End of the step, s.
    pub end_s: f64,
    /// Length of the step in the variable of integration, which is the time except during some contacts.
    pub length: f64,
    /// Time and its derivatives over that variable at both ends.
    pub(super) time: [GapJet; 2],
    /// Values and derivatives over that variable of the followed outputs, at both ends.
    pub outputs: &'s [[[f64; 3]; 2]],
}

/// Source of the states of a step.
pub(super) enum Source<'s, 'a> {
    /// Dense output of an integrated step, put into the equations of motion of one lane.
    Integrated {
        dense: &'s mut dyn DenseOutput,
        sample: &'s Sample<f64>,
        view: &'s mut Motion<'a, f64>,
        projection: Option<&'s mut Projection<f64>>,
        state: &'s mut Vec<f64>,
        /// Number of the run whose sample `view` holds, and number of this run.
        viewed: &'s mut u64,
        run: u64,
    },
    /// The motion of a mechanism without play, solved afresh at each instant.
    Kinematic {
        motion: &'s mut Motion<'a, f64>,
        ideal: &'s mut IdealMotion<'a>,
        failure: &'s mut Option<SampleError>,
        /// Account of springs and loads, if there are any.
        account: Option<&'s KinematicAccount>,
    },
}

/// The inside of an integrated step.
pub(super) trait DenseOutput {
    /// Writes the state at `share` in [0, 1] of the step; `for_forces`: one whose forces and accelerations are those of the motion too.
    fn interpolate(&mut self, share: f64, for_forces: bool, state: &mut [f64]);
    /// The state of a contact during the step.
    fn contact(&self, contact: usize) -> PlayState<f64>;
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

    /// The end of the step with forces and accelerations.
    pub fn end(&mut self) -> &Dynamics<'a, f64> {
        self.look(self.end_s, true)
    }

    /// Whether the contact `contact` is closed during this step.
    pub fn is_in_contact(&self, contact: usize) -> bool {
        match &self.source {
            Source::Integrated { dense, .. } => dense.contact(contact).contact > 0.0,
            Source::Kinematic { .. } => false,
        }
    }

    /// Normal force of the contact `contact` at `time_s` within the step, N.
    pub fn normal_force_n(&mut self, contact: usize, time_s: f64) -> f64 {
        self.contact_force(contact, time_s).0.normal_n
    }

    /// Force of the contact `contact` at `time_s` within the step, with positions and velocities there.
    pub(super) fn contact_force(&mut self, contact: usize, time_s: f64) -> (ContactForce<f64>, &Dynamics<'a, f64>) {
        self.look(time_s, false);
        let (Source::Integrated { view: motion, .. } | Source::Kinematic { motion, .. }) = &self.source;
        (motion.contact_force(contact), &motion.dynamics)
    }

    /// The elastic foundation of a joint with play whose contact is `contact`, its motion at `time_s` within the step, and 1/v0, s/m;
    /// `None` if it has no foundation.
    pub(super) fn foundation(&mut self, contact: usize, play: usize, time_s: f64) -> Option<FoundationAt> {
        let dynamics = self.look(time_s, false);
        let foundation = dynamics.sample().plays[play].foundation.clone()?;
        let motion = foundation_motion(&dynamics.plays()[play]);
        let (Source::Integrated { view, .. } | Source::Kinematic { motion: view, .. }) = &self.source;
        Some(FoundationAt {
            foundation,
            motion,
            inverse_impact_speed_s_m: view.states[contact].inverse_impact_speed_s_m,
        })
    }

    /// State at the end of the step, from which another run can resume; `None` if the motion is solved instead of integrated.
    pub(super) fn last_state(&mut self) -> Option<MotionState> {
        self.look(self.end_s, false);
        let Source::Integrated { dense, view, projection, state, .. } = &mut self.source else { return None };
        dense.interpolate(1.0, true, state);
        if let Some(projection) = projection {
            projection.hold(view, self.end_s, state);
        }
        let contacts = (0..view.states.len()).map(|play| dense.contact(play)).collect();
        Some(MotionState::new(&view.layout, state, self.end_s, contacts))
    }

    /// Energy supplied and lost since time zero, J, at `time_s` within the step, which was looked at last. `None` if the work
    /// of the drives is the change of mechanical energy.
    pub(super) fn account(&mut self, time_s: f64) -> Option<EnergyTotals<f64>> {
        match &mut self.source {
            Source::Integrated { view, state, .. } => Some(view.layout.account(state)),
            Source::Kinematic { motion, ideal, failure, account } => {
                match (*account)?.until(motion, ideal, self.start_s, time_s) {
                    Ok(account) => Some(account),
                    Err(error) => {
                        **failure = failure.take().or(Some(error));
                        None
                    }
                }
            }
        }
    }

    /// Which share of the step, in its variable of integration, has passed at `time_s`.
    pub fn share(&self, time_s: f64) -> f64 {
        if time_s == self.start_s {
            return 0.0;
        }
        let [start, end] = &self.time;
        let passed = ((time_s - self.start_s) / (self.end_s - self.start_s)).clamp(0.0, 1.0);
        let (first, last) = (start.jet[1], end.jet[1]);
        if first == 1.0 && last == 1.0 {
            return passed;
        }
        // A pace that changes evenly gives a good guess; Newton's method on the time as a polynomial of degree five the rest.
        let squares = (first * first + passed * (last * last - first * first)).max(0.0);
        let mut share = (passed * (first + last) / (first + squares.sqrt()).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        let time = Quintic::new(start.jet, end.jet, self.length);
        for _ in 0..20 {
            let change = (time.value(share) - time_s) / time.slope(share).max(f64::MIN_POSITIVE);
            share = (share - change).clamp(0.0, 1.0);
            // The next change would be about the square of this one.
            if change.abs() < 1e-5 {
                break;
            }
        }
        share
    }

    /// The time over the share of the step that has passed.
    pub(super) fn time_polynomial(&self) -> Quintic {
        let [start, end] = &self.time;
        Quintic::new(start.jet, end.jet, self.length)
    }

    /// The time and its first two derivatives over the variable of integration at the start (0) or at the end (1).
    pub fn time(&self, side: usize) -> [f64; 3] {
        self.time[side].jet
    }

    fn look(&mut self, time_s: f64, with_forces: bool) -> &Dynamics<'a, f64> {
        let place = self.share(time_s);
        match &mut self.source {
            Source::Integrated { dense, sample, view, projection, state, viewed, run } => {
                if **viewed != *run {
                    **viewed = *run;
                    view.dynamics.sample_mut().clone_from(sample);
                }
                for (contact, state) in view.states.iter_mut().enumerate() {
                    *state = dense.contact(contact);
                }
                dense.interpolate(place, with_forces, state);
                if let Some(projection) = projection {
                    projection.hold(view, time_s, state);
                }
                if with_forces {
                    view.evaluate(time_s, state)
                } else {
                    view.set_state(time_s, state)
                }
                &view.dynamics
            }
            Source::Kinematic { motion, ideal, failure, .. } => {
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
