//! From values to the numbers of a sample.

use super::error::SamplingError;
use super::journals::uniforms;
use super::nominal::{Nominal, components_of};
use super::part::{PlaySide, SampledPart};
use super::turn_sample::TurnSample;
use crate::accuracy::PlayDistribution;
use crate::accuracy::play_set::PlaySet;
use crate::model::SpatialModel;
use crate::output::SpatialOutput;
use crate::stop::{IsStopped, NEVER};
use loosepin_text::numbers::Values;

/// Samples of a model over its turn: what is the same for all of them.
///
/// A sample is closed at each place by Newton's method from the nominal position there. That is the same branch where the determinant of the
/// bordered loop equations has kept its sign and the way was short; otherwise the sample is followed from place to place by [`crate::cycle`], from
/// the start that the file gives it.
///
/// Where redundant rows of a sample contradict each other by h0, so that ideal joints do not close, plays with h·p = h0 are counted. The ideal motion
/// is then the one with the rest in these rows, which depends on how they are combined; deviations from the nominal motion do not.
///
/// What play makes is computed to about 1e-9 of it.
#[derive(Debug, Clone)]
pub struct TurnSampler {
    pub(super) model: SpatialModel,
    pub(super) parts: Vec<SampledPart>,
    pub(super) side: PlaySide,
    pub(super) distribution: PlayDistribution,
    values: Values,
    pub(super) motion: Nominal,
    /// Components of the output of each part.
    pub(super) outputs: Vec<Vec<SpatialOutput>>,
    nominal: TurnSample,
}

impl TurnSampler {
    /// Samples of `model` at `turns`, places in the motion in turns of the cycle since time zero, ascending; `parts` are read off. Play is counted
    /// to first order ([`Self::with_play_side`]).
    ///
    /// # Errors
    ///
    /// [`SamplingError`]: places, parts, and a nominal motion that has no answer.
    pub fn new(
        model: &SpatialModel,
        nominal: &Values,
        turns: &[f64],
        parts: &[SampledPart],
    ) -> Result<Self, SamplingError> {
        Self::new_until(model, nominal, turns, parts, NEVER)
    }

    /// The same, until it is stopped.
    ///
    /// # Errors
    ///
    /// As for [`Self::new`]; that it was stopped.
    pub fn new_until(
        model: &SpatialModel,
        nominal: &Values,
        turns: &[f64],
        parts: &[SampledPart],
        is_stopped: IsStopped,
    ) -> Result<Self, SamplingError> {
        let motion = Nominal::new(model, nominal, turns, parts, is_stopped)?;
        let outputs = parts.iter().map(|part| components_of(model, nominal, part)).collect::<Result<_, _>>()?;
        let sampler = Self {
            model: model.clone(),
            parts: parts.to_vec(),
            side: PlaySide::default(),
            distribution: PlayDistribution::Inside,
            values: nominal.clone(),
            motion,
            outputs,
            nominal: TurnSample::default(),
        };
        let of_nominal = sampler.sample_until(nominal, is_stopped)?;
        Ok(Self { nominal: of_nominal, ..sampler })
    }

    /// The same samples with play counted otherwise.
    ///
    /// # Errors
    ///
    /// [`SamplingError`], where the nominal motion has no answer then.
    pub fn with_play_side(self, side: PlaySide) -> Result<Self, SamplingError> {
        let sampler = Self { side, ..self };
        let of_nominal = sampler.sample(&sampler.values)?;
        Ok(Self { nominal: of_nominal, ..sampler })
    }

    /// The same samples with other places of the journals in [`Self::sample_with_play`], which are [`PlayDistribution::Inside`] of their play
    /// before.
    pub fn with_play_distribution(self, distribution: PlayDistribution) -> Self {
        Self { distribution, ..self }
    }

    /// The nominal values as a sample.
    pub fn nominal(&self) -> &TurnSample {
        &self.nominal
    }

    /// Number of places in the turn.
    pub fn places(&self) -> usize {
        self.motion.places.len()
    }

    /// Size of the nominal mechanism, m.
    pub(crate) fn characteristic_length_m(&self) -> f64 {
        self.motion.mechanism.characteristic_length_m()
    }

    /// What is read off at each place.
    pub fn parts(&self) -> &[SampledPart] {
        &self.parts
    }

    /// One sample.
    ///
    /// # Errors
    ///
    /// [`SamplingError`]: values that make no mechanism, drives that are elsewhere than nominally, loops that do not close or cannot be put
    /// together, outputs without an answer.
    pub fn sample(&self, values: &Values) -> Result<TurnSample, SamplingError> {
        self.sample_until(values, NEVER)
    }

    /// The same, until it is stopped.
    ///
    /// # Errors
    ///
    /// As for [`Self::sample`]; that it was stopped.
    pub fn sample_until(&self, values: &Values, is_stopped: IsStopped) -> Result<TurnSample, SamplingError> {
        self.sampled(values, None, is_stopped)
    }

    /// One sample with the journals in places that are drawn from uniform numbers in [0, 1] and that they keep over the turn, loops closed
    /// exactly. Smallest and largest numbers are alike: what these places make.
    ///
    /// # Errors
    ///
    /// Those of [`Self::sample`]; [`SamplingError::BadUniforms`]; [`SamplingError::ConditionsOnPlay`] where the plays must meet conditions
    /// together.
    pub fn sample_with_play(&self, values: &Values, uniforms: &[f64]) -> Result<TurnSample, SamplingError> {
        let expected = self.uniforms_per_sample();
        let found = uniforms.iter().filter(|uniform| (0.0..=1.0).contains(*uniform)).count();
        if found != expected || uniforms.len() != expected {
            return Err(SamplingError::BadUniforms { expected, found });
        }
        self.sampled(values, Some(uniforms), NEVER)
    }

    /// How many numbers [`Self::sample_with_play`] takes: of each ball three, of each end plane two, of each axial play one, however small; on the rims one
    /// fewer of balls and end planes.
    pub fn uniforms_per_sample(&self) -> usize {
        uniforms(&PlaySet::new(&self.motion.mechanism), self.distribution)
    }
}
