//! The ideal mechanism beside a run: what every deviation is measured against.

use super::column::{Arms, Reading};
use super::motion::Motion;
use crate::dynamics::Dynamics;
use crate::mechanism::{IdealMotion, Mechanism, Sample, SampleError};

/// The motion of a mechanism with every clearance at zero, to be asked at any time.
pub struct IdealReference<'a> {
    ideal: IdealMotion<'a>,
    motion: Motion<'a, f64>,
}

impl<'a> IdealReference<'a> {
    /// From [`Mechanism::without_play`] and [`Sample::without_play`].
    ///
    /// # Errors
    /// The loops cannot close at time zero.
    pub fn new(mechanism: &'a Mechanism, sample: &Sample<f64>) -> Result<Self, SampleError> {
        Ok(Self {
            ideal: IdealMotion::new(mechanism, &sample.ideal, &sample.drives)?,
            motion: Motion::new(mechanism, sample),
        })
    }

    /// Positions and velocities at `time_s`, and forces and accelerations where asked for.
    ///
    /// # Errors
    /// The loops cannot close there.
    pub fn at(&mut self, time_s: f64, with_forces: bool) -> Result<&Dynamics<'a, f64>, SampleError> {
        if self.ideal.time_s() != time_s {
            self.ideal.move_to(time_s)?;
        }
        let (coordinates, rates) = self.ideal.real_state();
        let n = self.motion.freedoms();
        if with_forces {
            let states = &self.motion.states;
            self.motion.dynamics.evaluate(time_s, &coordinates[..n], &rates[..n], states);
        } else {
            self.motion.dynamics.set_state(time_s, &coordinates[..n], &rates[..n]);
        }
        Ok(&self.motion.dynamics)
    }

    /// Value and first two time derivatives of a position or angle at `time_s`, without forces.
    ///
    /// # Errors
    /// The loops cannot close there.
    pub fn jet(&mut self, reading: &Reading, arms: &Arms, time_s: f64) -> Result<[f64; 3], SampleError> {
        if self.ideal.time_s() != time_s {
            self.ideal.move_to(time_s)?;
        }
        let ideal = &self.ideal;
        Ok(reading
            .position_jet(arms, self.motion.dynamics.mechanism(), ideal.kinematics(), |slot| ideal.acceleration(slot)))
    }

    /// The solved loop equations behind it.
    pub fn ideal(&self) -> &IdealMotion<'a> {
        &self.ideal
    }
}
