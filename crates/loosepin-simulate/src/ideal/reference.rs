//! The ideal mechanism beside a run: what every deviation is measured against.

use crate::failure::RunFailure;
use crate::ideal::curve::{IdealCurve, IdealNodes};
use crate::ideal::free_motion::FreeMotion;
use crate::settings::Settings;
use crate::stepping::motion::Motion;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{Arms, IdealMotion, Mechanism, Sample, SampleError};
use loosepin_mechanics::model::Reading;
use std::sync::Arc;

/// The motion of a mechanism with every clearance at zero, to be asked at any time.
///
/// Where the drives move every freedom its loops are solved; otherwise it is a dynamic run of its own with the same drives,
/// forces and initial state.
pub struct IdealReference<'a> {
    source: Source<'a>,
    motion: Motion<'a, f64>,
    held_s: Option<f64>,
}

/// Source of positions and velocities.
enum Source<'a> {
    Solved(Box<IdealMotion<'a>>),
    Integrated(Arc<FreeMotion>),
}

impl<'a> IdealReference<'a> {
    /// From [`Mechanism::without_play`] and [`Sample::without_play`], to be asked up to `end_s`.
    ///
    /// # Errors
    /// The loops cannot close at time zero; the run of a mechanism that its drives do not move alone failed.
    pub fn new(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        end_s: f64,
        settings: &Settings,
    ) -> Result<Self, RunFailure> {
        if !mechanism.is_driven() {
            return Ok(Self::of_motion(
                mechanism,
                sample,
                Arc::new(FreeMotion::new(mechanism, sample, end_s, settings)?),
            ));
        }
        let source = Source::Solved(Box::new(IdealMotion::new(mechanism, &sample.ideal, &sample.drives)?));
        Ok(Self { source, motion: Motion::new(mechanism, sample), held_s: None })
    }

    /// The same where the `motion` of a mechanism that its drives do not move alone may have been integrated before.
    ///
    /// # Errors
    /// As for [`IdealReference::new`].
    pub fn with_motion(
        mechanism: &'a Mechanism,
        sample: &Sample<f64>,
        motion: Option<&Arc<FreeMotion>>,
        end_s: f64,
        settings: &Settings,
    ) -> Result<Self, RunFailure> {
        match motion {
            Some(motion) => Ok(Self::of_motion(mechanism, sample, motion.clone())),
            None => Self::new(mechanism, sample, end_s, settings),
        }
    }

    /// Reference from an integrated motion.
    pub fn of_motion(mechanism: &'a Mechanism, sample: &Sample<f64>, motion: Arc<FreeMotion>) -> Self {
        Self { source: Source::Integrated(motion), motion: Motion::new(mechanism, sample), held_s: None }
    }

    /// The motion of a mechanism that its drives do not move alone.
    pub fn free_motion(&self) -> Option<Arc<FreeMotion>> {
        if let Source::Integrated(motion) = &self.source { Some(motion.clone()) } else { None }
    }

    /// Uses the pieces that the motions of drives have at `time_s`: see [`IdealMotion::hold_pieces`].
    pub fn hold_pieces(&mut self, time_s: f64) {
        self.held_s = Some(time_s);
        if let Source::Solved(ideal) = &mut self.source {
            ideal.hold_pieces(self.held_s);
        }
    }

    /// Whether its loops are solved at each instant.
    pub fn is_solved(&self) -> bool {
        matches!(self.source, Source::Solved(_))
    }

    /// The first time after `time_s` at which pieces of its drives or loads meet, s.
    pub fn next_break_s(&self, time_s: f64) -> f64 {
        self.motion.dynamics.sample().next_break_s(time_s)
    }

    /// Positions and velocities at `time_s`, and forces and accelerations where asked for.
    ///
    /// # Errors
    /// The loops cannot close there.
    pub fn at(&mut self, time_s: f64, with_forces: bool) -> Result<&Dynamics<'a, f64>, SampleError> {
        let n = self.motion.freedoms();
        let dynamics = &mut self.motion.dynamics;
        dynamics.sample_mut().take_pieces_at(self.held_s.unwrap_or(time_s));
        let states = &self.motion.states;
        let set = |dynamics: &mut Dynamics<'a, f64>, coordinates: &[f64], rates: &[f64]| {
            if with_forces {
                dynamics.evaluate(time_s, &coordinates[..n], &rates[..n], states);
            } else {
                dynamics.set_state(time_s, &coordinates[..n], &rates[..n]);
            }
        };
        match &mut self.source {
            Source::Solved(ideal) => {
                if ideal.time_s() != time_s {
                    ideal.move_to(time_s)?;
                }
                let (coordinates, rates) = ideal.real_state();
                set(dynamics, coordinates, rates);
            }
            Source::Integrated(motion) => {
                let state = motion.state(time_s);
                dynamics.error_integrals_mut().copy_from_slice(&state.error_integrals);
                for (index, deflection_m) in state.joint_bristles_m.iter().enumerate() {
                    if dynamics.sample().frictions[index].law.has_bristle() {
                        dynamics.set_joint_bristle(index, *deflection_m);
                    }
                }
                set(dynamics, &state.coordinates, &state.rates);
            }
        }
        Ok(&self.motion.dynamics)
    }

    /// Value and first two time derivatives of a position or angle at `time_s`.
    ///
    /// # Errors
    /// The loops cannot close there.
    pub fn jet(&mut self, reading: &Reading, arms: &Arms, time_s: f64) -> Result<[f64; 3], SampleError> {
        let Source::Solved(ideal) = &mut self.source else {
            return Ok(reading.jet(arms, self.at(time_s, true)?));
        };
        if ideal.time_s() != time_s {
            ideal.move_to(time_s)?;
        }
        let mechanism = self.motion.dynamics.mechanism();
        Ok(reading.position_jet(arms, mechanism, ideal.kinematics(), |slot| ideal.acceleration(slot)))
    }

    /// A table of `readings`, which are positions and angles, from `start_s` on for `span_s`.
    ///
    /// # Errors
    /// The loops cannot be closed on the way.
    pub fn curve(
        &mut self,
        readings: &[Reading],
        arms: &Arms,
        (start_s, span_s): (f64, f64),
        nodes: Arc<IdealNodes>,
    ) -> Result<IdealCurve, SampleError> {
        let mut jets = vec![Vec::new(); readings.len()];
        for time_s in nodes.times_s(start_s, span_s) {
            for (jets, reading) in jets.iter_mut().zip(readings) {
                jets.push(self.jet(reading, arms, time_s)?);
            }
        }
        Ok(IdealCurve::of_jets(span_s, nodes, &jets))
    }
}
