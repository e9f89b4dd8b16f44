//! The double loop's view of the surrogates of a group.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use super::learned::draws_residual;
use super::plan::SurrogatePlan;
use crate::data::table::Failure;
use crate::plan::evaluate::Response;
use loosepin_surrogate::{Surrogate, SurrogateError};

/// Why an evaluation of a surrogate gave nothing: outside the range of its runs.
const OUTSIDE: Failure = Failure(1);

/// Meaning of a column of the double loop on a surrogate for a column of the problem, in the order of [`Self::ALL`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Aspect {
    /// ŝ with its share of the rest.
    Value,
    /// ŝ - kσ
    Low,
    /// ŝ + kσ
    High,
    /// k²σ̄²
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
pub(crate) struct LearnedFunction<'a> {
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

    /// σ at the first inner runs, those of one replicate, at the places; `None` if none has an answer.
    pub fn spread(&self, epistemic: &[f64]) -> Option<DeviationsOverX> {
        let runs = self.plan.direct.runs_at(0, 0, epistemic.to_vec()).filter(|inputs| inputs.replicate == 0);
        let deviations: Vec<Vec<f64>> =
            runs.filter_map(|inputs| Some(self.at(&inputs.random, epistemic).ok()?.1)).collect();
        let of_place = |place: usize| deviations.iter().map(move |row| row[place]);
        let places = 0..deviations.first()?.len();
        let mean_square = |place| of_place(place).map(|x| x * x).sum::<f64>() / deviations.len() as f64;
        Some(DeviationsOverX {
            largest: places.clone().map(|place| of_place(place).fold(0.0, f64::max)).collect(),
            root_mean_square: places.map(|place| mean_square(place).sqrt()).collect(),
        })
    }
}

/// σ of each place over X, at one u.
pub(crate) struct DeviationsOverX {
    pub largest: Vec<f64>,
    /// σ̄
    pub root_mean_square: Vec<f64>,
}

/// A surrogate with its band as a response: for each place, every aspect.
///
/// The band is as wide as it is at its widest over X, at each u by itself: it moves every statistic further than a width that
/// varies, and leaves the response as smooth in X as ŝ is, so that statistics are known as well on its ends as on ŝ. A deviation moves
/// by no more than the root mean square of the error over X: it takes that of σ, where every statistic belongs to a single u.
pub(crate) struct BandResponse<'a> {
    of: LearnedFunction<'a>,
    /// k
    reach: f64,
    /// Whether the band is widened where σ is larger than at any of the first inner runs.
    is_at_least_own: bool,
    /// Whether every statistic belongs to a single u.
    is_at_single_values: bool,
    /// σ by the bits of u.
    deviations: Mutex<BTreeMap<Vec<u64>, Arc<DeviationsOverX>>>,
}

impl<'a> BandResponse<'a> {
    pub fn new(of: LearnedFunction<'a>, reach: f64) -> Self {
        let is_at_single_values = of.plan.is_at_single_values();
        Self { of, reach, is_at_least_own: false, is_at_single_values, deviations: Mutex::default() }
    }

    /// This response for points outside the distribution of the random inputs, such as the corners of their cut intervals.
    pub fn at_least_own(self) -> Self {
        Self { is_at_least_own: true, ..self }
    }

    fn deviations(&self, epistemic: &[f64]) -> Option<Arc<DeviationsOverX>> {
        let key: Vec<u64> = epistemic.iter().map(|value| value.to_bits()).collect();
        let known = self.deviations.lock().unwrap_or_else(PoisonError::into_inner).get(&key).cloned();
        if known.is_some() {
            return known;
        }
        // Others may find the same meanwhile: it is the same.
        let found = Arc::new(self.of.spread(epistemic)?);
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
            let half = self.reach * deviations.largest[slot].max(own);
            let of_square =
                if self.is_at_single_values { self.reach * deviations.root_mean_square[slot] } else { half };
            column.copy_from_slice(&[value, value - half, value + half, of_square * of_square]);
        }
        Ok(())
    }
}
