//! The ideal mechanism beside a run: what every deviation is measured against.

use super::motion::Motion;
use crate::dynamics::Dynamics;
use crate::mechanism::{IdealMotion, Mechanism, Sample, SampleError};
use crate::model::Values;

/// A mechanism with every clearance at zero and one sample of it.
#[derive(Debug, Clone)]
pub struct Twin {
    mechanism: Mechanism,
    sample: Sample<f64>,
}

impl Twin {
    /// The twin of `mechanism` with the dimensions of `values`.
    ///
    /// # Errors
    /// The sample does not fit the mechanism.
    pub fn new(mechanism: &Mechanism, values: &Values) -> Result<Self, SampleError> {
        let sample = Sample::new(mechanism, values)?.without_play();
        Ok(Self { mechanism: mechanism.without_play(), sample })
    }

    /// Its motion, to be asked at any time.
    ///
    /// # Errors
    /// The loops cannot close at time zero.
    pub fn motion(&self) -> Result<IdealReference<'_>, SampleError> {
        Ok(IdealReference {
            mechanism: &self.mechanism,
            ideal: IdealMotion::new(&self.mechanism, &self.sample.ideal, &self.sample.drives)?,
            motion: Motion::new(&self.mechanism, &self.sample),
        })
    }
}

/// The motion of a [`Twin`].
pub struct IdealReference<'a> {
    mechanism: &'a Mechanism,
    ideal: IdealMotion<'a>,
    motion: Motion<'a>,
}

impl<'a> IdealReference<'a> {
    /// The mechanism without play.
    pub fn mechanism(&self) -> &'a Mechanism {
        self.mechanism
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

    /// The solved loop equations behind it.
    pub fn ideal(&self) -> &IdealMotion<'a> {
        &self.ideal
    }
}
