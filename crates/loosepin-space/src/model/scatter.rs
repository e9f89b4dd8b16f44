//! What random dimensions do to outputs over a turn, to first order.
//!
//! With the derivative y_i of an output by the dimension x_i at fixed places of the drives, standard deviations σ_i and correlations ρ_ij:
//!
//! ```text
//! variance of y = Σ_i Σ_j ρ_ij (y_i σ_i)(y_j σ_j)
//! ```
//!
//! Derivatives are central differences of loops that are closed exactly, at ± [`STEP`] σ_i. Where constraints repeat others, play takes up what
//! does not fit, as in [`TurnSampler`].

use super::parts::SpatialModel;
use super::problem::SpatialMotionProblem;
use crate::closure::error::ClosureError;
use crate::sampling::{PartOfOutput, SampledPart, SamplingError, TurnSampler};
use crate::stop::IsStopped;
use loosepin_result::motion::DimensionContributor;
use loosepin_result::round_off::round_off_si;
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::document::describe_path;
use loosepin_text::numbers::{QuantityId, Values};

/// Step of a difference, in standard deviations: the error of the formula is of its square, that of the closed loops of its inverse.
const STEP: f64 = 1e-2;

/// What random dimensions do to an output over the turn, to first order; of a path the root of the mean square of the displacement. Empty where
/// none is random.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SpatialScatter {
    /// Standard deviation at each position.
    pub standard_deviation_si: Vec<f64>,
    /// That of each random quantity alone.
    pub contributors: Vec<DimensionContributor>,
}

/// Random dimensions of a model in space.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SpatialScatterPlan {
    /// Values that replace those of the file, SI.
    pub set: Vec<(QuantityId, f64)>,
    /// Each random quantity with its standard deviation, SI.
    pub quantities: Vec<(QuantityId, f64)>,
    /// Linear correlations of two of them, by their places in `quantities`.
    pub correlations: Vec<(usize, usize, f64)>,
}

impl SpatialModel {
    /// What random dimensions do to each output, at the positions of [`SpatialModel::motion_record`], until it is stopped.
    ///
    /// # Errors
    /// Values that break a rule; loops that do not close; drives whose place is uncertain; that it was stopped.
    pub fn scatter_until(
        &self,
        plan: &SpatialScatterPlan,
        is_stopped: IsStopped,
    ) -> Result<Vec<SpatialScatter>, Diagnostics> {
        let values = self.values_of(&plan.set)?;
        let input = self.cycle_input(&values).map_err(|error| self.diagnostic(&error))?;
        let turns: Vec<f64> = (0..=input.samples).map(|sample| sample as f64 / input.samples as f64).collect();
        let mut found = self.scatter_at(plan, &turns, is_stopped)?;
        for own in &mut found {
            let contributors = own.contributors.iter_mut().map(|own| &mut own.standard_deviation_si);
            for values in [&mut own.standard_deviation_si].into_iter().chain(contributors) {
                *values = input.ascending(std::mem::take(values));
            }
        }
        Ok(found)
    }

    /// The same at other places: turns of the cycle since time zero, ascending.
    ///
    /// # Errors
    /// Those of [`SpatialModel::scatter_until`].
    pub fn scatter_at(
        &self,
        plan: &SpatialScatterPlan,
        turns: &[f64],
        is_stopped: IsStopped,
    ) -> Result<Vec<SpatialScatter>, Diagnostics> {
        if plan.quantities.is_empty() || self.outputs.is_empty() {
            return Ok(vec![SpatialScatter::default(); self.outputs.len()]);
        }
        let parts: Vec<SampledPart> = self.sampled_parts();
        let effects = self.effects_on_parts(plan, turns, &parts, is_stopped)?;
        let scatter = (0..self.outputs.len()).map(|output| {
            let own = parts.iter().enumerate().filter(|(_, part)| part.output == output);
            let starts: Vec<usize> = own.map(|(number, _)| number * turns.len()).collect();
            self.scatter_of(plan, &effects, &starts, turns.len())
        });
        Ok(scatter.collect())
    }

    /// The effect of a standard deviation of each random quantity, with its sign, on each part at each place: that of a part at a place is at part ×
    /// places + place. Without play. Parts are numbers, not lengths of displacements, which have no derivative where there is none.
    ///
    /// # Errors
    /// Those of [`SpatialModel::scatter_until`]; a path without a direction where a part is read off along it.
    pub fn effects_on_parts(
        &self,
        plan: &SpatialScatterPlan,
        turns: &[f64],
        parts: &[SampledPart],
        is_stopped: IsStopped,
    ) -> Result<Vec<Vec<f64>>, Diagnostics> {
        let values = self.values_of(&plan.set)?;
        let no_scatter = |path: &str, error: SamplingError| {
            if let SamplingError::DoesNotClose { why: why @ ClosureError::Stopped, .. } = &error {
                return self.not_closed(why);
            }
            let problem = SpatialMotionProblem::NoScatter { what: describe_path(path), why: error.to_string() };
            Diagnostics::one(&problem, self.place(path))
        };
        let sampler = TurnSampler::new_until(self, &values, turns, parts, is_stopped);
        let sampler = sampler.map_err(|error| Diagnostics::from(self.not_sampled(&values, &error)))?;
        let threshold =
            |part: &SampledPart| round_off_si(&self.unit_of(part.output), sampler.characteristic_length_m());
        let thresholds: Vec<f64> = parts.iter().map(threshold).collect();
        let effects = plan.quantities.iter().map(|&(quantity, deviation_si)| {
            let at = |side: f64| {
                let own = (quantity, values[quantity] + side * STEP * deviation_si);
                let set: Vec<(QuantityId, f64)> = plan.set.iter().copied().chain([own]).collect();
                let sample = sampler.sample_until(&self.values_of(&set)?, is_stopped);
                sample.map_err(|error| no_scatter(&self.quantities[quantity].path, error))
            };
            let [above, below] = [at(1.0)?.from_nominal_si, at(-1.0)?.from_nominal_si];
            let differences = above.iter().zip(&below).map(|(above, below)| (above - below) / (2.0 * STEP));
            let effects = differences.enumerate().map(|(number, effect)| {
                let is_round_off = effect.abs() < thresholds[number / turns.len()];
                if is_round_off { 0.0 } else { effect }
            });
            Ok(effects.collect())
        });
        effects.collect()
    }

    fn values_of(&self, set: &[(QuantityId, f64)]) -> Result<Values, Diagnostics> {
        let values = self.quantities.evaluate(set);
        values.map_err(|error| Diagnostics::one(&error, self.place(error.path())))
    }

    /// The parts that deviations are read off from: of a vector its three components.
    fn sampled_parts(&self) -> Vec<SampledPart> {
        let parts = |(output, own): (usize, &super::parts::ModelOutput)| {
            let parts: &[PartOfOutput] = match own.kind.is_vector() {
                true => &[PartOfOutput::X, PartOfOutput::Y, PartOfOutput::Z],
                false => &[PartOfOutput::Number],
            };
            parts.iter().map(move |&part| SampledPart { output, part })
        };
        self.outputs.iter().enumerate().flat_map(parts).collect()
    }

    /// Of an output whose parts begin at `starts` in each row of `effects`.
    fn scatter_of(
        &self,
        plan: &SpatialScatterPlan,
        effects: &[Vec<f64>],
        starts: &[usize],
        places: usize,
    ) -> SpatialScatter {
        let product = |first: usize, second: usize, place: usize| -> f64 {
            starts.iter().map(|start| effects[first][start + place] * effects[second][start + place]).sum()
        };
        let variance = |place: usize| -> f64 {
            let own: f64 = (0..effects.len()).map(|input| product(input, input, place)).sum();
            let pairs = plan.correlations.iter();
            own + pairs.map(|&(first, second, linear)| 2.0 * linear * product(first, second, place)).sum::<f64>()
        };
        let contributors = plan.quantities.iter().enumerate().map(|(input, &(quantity, _))| DimensionContributor {
            path: self.quantities[quantity].path.clone(),
            standard_deviation_si: (0..places).map(|place| product(input, input, place).sqrt()).collect(),
        });
        SpatialScatter {
            // Round-off of a correlation of one.
            standard_deviation_si: (0..places).map(|place| variance(place).max(0.0).sqrt()).collect(),
            contributors: contributors.collect(),
        }
    }
}
