//! The double loop's view of the surrogates of a group.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::super::evaluate::Response;
use super::super::table::Failure;
use super::learned::draws_residual;
use super::plan::SurrogatePlan;
use crate::surrogate::{Surrogate, SurrogateError};

/// Why an evaluation of a surrogate gave nothing: outside the range of its runs.
const OUTSIDE: Failure = Failure(1);

/// What a column of the double loop on a surrogate holds about a column of the problem, in the order of [`Self::ALL`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Aspect {
    /// ŝ with its share of the rest.
    Value,
    /// ŝ - kσ
    Low,
    /// ŝ + kσ
    High,
    /// k²σ²
    Square,
}

impl Aspect {
    pub const ALL: [Self; 4] = [Self::Value, Self::Low, Self::High, Self::Square];

    /// Its column among those of a place.
    pub fn position(self) -> usize {
        self as usize
    }
}

/// Surrogates, one for each combination of the members of lists, asked at some places of a group.
pub(super) struct LearnedFunction<'a> {
    pub plan: &'a SurrogatePlan,
    pub surrogates: &'a [Surrogate],
    /// Positions within the group.
    pub places: &'a [usize],
}

impl LearnedFunction<'_> {
    fn surrogate(&self, epistemic: &[f64]) -> &Surrogate {
        &self.surrogates[self.plan.space.combination(epistemic)]
    }

    /// ŝ without the rest, and σ, at the places.
    pub fn at(&self, random: &[f64], epistemic: &[f64]) -> Result<(Vec<f64>, Vec<f64>), SurrogateError> {
        let answers = self.surrogate(epistemic).predict(&self.plan.space.point(random, epistemic))?;
        let of = |values: &[f64]| self.places.iter().map(|&place| values[place]).collect();
        Ok(answers.first().map(|answer| (of(&answer.values), of(&answer.deviations))).unwrap_or_default())
    }

    /// The largest σ at the first inner runs, those of one replicate, at the places; nothing where none has an answer.
    fn largest_deviations(&self, epistemic: &[f64]) -> Option<Vec<f64>> {
        let runs = self.plan.direct.runs_at(0, 0, epistemic.to_vec()).filter(|inputs| inputs.replicate == 0);
        let deviations = runs.filter_map(|inputs| Some(self.at(&inputs.random, epistemic).ok()?.1));
        deviations.reduce(|a, b| a.iter().zip(&b).map(|(a, b)| a.max(*b)).collect())
    }
}

/// The same as a response: for each place, every aspect.
///
/// The band is as wide as it is at its widest over X, at each u by itself: it moves every statistic further than a width that
/// varies, and leaves the response as smooth in X as ŝ is, so that statistics are known as well on its ends as on ŝ.
pub(super) struct BandResponse<'a> {
    of: LearnedFunction<'a>,
    /// k
    reach: f64,
    /// Whether the band is widened where σ is larger than at any of the first inner runs.
    is_at_least_own: bool,
    /// σ by the bits of u.
    deviations: Mutex<BTreeMap<Vec<u64>, Arc<Vec<f64>>>>,
}

impl<'a> BandResponse<'a> {
    pub fn new(of: LearnedFunction<'a>, reach: f64) -> Self {
        Self { of, reach, is_at_least_own: false, deviations: Mutex::default() }
    }

    /// The same for points that the random inputs do not come to, such as the corners of what they are cut to.
    pub fn at_least_own(self) -> Self {
        Self { is_at_least_own: true, ..self }
    }

    fn deviations(&self, epistemic: &[f64]) -> Option<Arc<Vec<f64>>> {
        let key: Vec<u64> = epistemic.iter().map(|value| value.to_bits()).collect();
        let known = self.deviations.lock().unwrap_or_else(PoisonError::into_inner).get(&key).cloned();
        if known.is_some() {
            return known;
        }
        // Others may find the same meanwhile: it is the same.
        let found = Arc::new(self.of.largest_deviations(epistemic)?);
        self.deviations.lock().unwrap_or_else(PoisonError::into_inner).insert(key, Arc::clone(&found));
        Some(found)
    }
}

impl Response for BandResponse<'_> {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        let (values, own) = self.of.at(random, epistemic).map_err(|_| OUTSIDE)?;
        let deviations = self.deviations(epistemic).ok_or(OUTSIDE)?;
        let surrogate = self.of.surrogate(epistemic);
        let space = &self.of.plan.space;
        // Without random inputs there is no scatter that the rest could belong to: it stays in the band.
        let rest = if random.is_empty() || !draws_residual(surrogate) {
            None
        } else {
            surrogate.residual(0, &space.point(random, epistemic), space.share(random)).map_err(|_| OUTSIDE)?
        };
        let row = columns.chunks_exact_mut(Aspect::ALL.len());
        for (slot, column) in row.enumerate() {
            let value = values[slot] + rest.as_ref().map_or(0.0, |rest| rest[self.of.places[slot]]);
            let own = if self.is_at_least_own { own[slot] } else { 0.0 };
            let half = self.reach * deviations[slot].max(own);
            column.copy_from_slice(&[value, value - half, value + half, half * half]);
        }
        Ok(())
    }
}
