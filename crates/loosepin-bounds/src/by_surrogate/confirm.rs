//! Direct runs at the witnesses of bounds on a surrogate, and what they say of it.

use std::collections::BTreeSet;

use super::learned::{Learned, LearnedGroup};
use super::plan::{SurrogatePlan, SurrogatePlanError};
use super::response::{DeviationsOverX, LearnedFunction};
use super::search::{FIRST_REACH, SurrogateSearchBounds, search_group};
use super::settings::MAX_WITNESSES;
use crate::data::bound::Bound;
use crate::data::direction::Direction;
use crate::data::table::{Purpose, RunInputs, SampleTable};
use crate::estimators::estimate::{Confidence, replicate_error};
use crate::measures::of_statistic::estimator;
use loosepin_terms::Statistic;

/// ŝ for the runs of a replicate; `None` if the surrogate gave no answer.
type Answers = Vec<Option<Vec<f64>>>;
/// Values of the direct runs of a replicate, with ŝ and σ at the same inputs; `None` if a run failed.
type DirectAnswers = Vec<Option<[Vec<f64>; 3]>>;

/// Which direct runs the bounds on the surrogates are to be held against.
pub struct Confirmation {
    pub(crate) searched: Vec<Vec<SurrogateSearchBounds>>,
    /// Values of the epistemic inputs.
    witnesses: Vec<Vec<f64>>,
    /// The runs that are still to be made, in their order.
    pub round: Vec<RunInputs>,
}

impl SurrogatePlan {
    /// The double loop on the surrogates, and the direct runs that its bounds are to be held against, as round `round`, without those
    /// that are in `table`.
    ///
    /// # Errors
    ///
    /// [`SurrogatePlanError::Evaluate`].
    pub fn confirmation(
        &self,
        learned: &Learned,
        round: u32,
        table: &SampleTable,
    ) -> Result<Confirmation, SurrogatePlanError> {
        let searched = learned.groups.iter().map(|group| search_group(self, group, FIRST_REACH));
        let searched = searched.collect::<Result<Vec<_>, _>>()?;
        let mut witnesses: Vec<Vec<f64>> = Vec::new();
        for group in &searched {
            for bound in extreme_bounds(group) {
                let Some(witness) = &bound.witness else { continue };
                if witnesses.len() < MAX_WITNESSES && !witnesses.contains(&witness.epistemic) {
                    witnesses.push(witness.epistemic.clone());
                }
            }
        }
        let per_replicate = self.settings.confirming / self.problem().sampling.replicates;
        let made = || table.inputs().iter().filter(|inputs| inputs.purpose == Purpose::Confirming);
        let key = |inputs: &RunInputs| {
            let bits: Vec<u64> = inputs.epistemic.iter().map(|value| value.to_bits()).collect();
            (bits, inputs.replicate, inputs.index)
        };
        let known: BTreeSet<_> = made().map(key).collect();
        let first = made().map(|inputs| inputs.point + 1).max().unwrap_or(0);
        let runs_at = |(point, epistemic): (usize, &Vec<f64>)| {
            let runs = self.direct.runs_at(round, first + point as u32, epistemic.clone());
            let runs = runs.filter(|inputs| (inputs.index as usize) < per_replicate && !known.contains(&key(inputs)));
            runs.map(|inputs| RunInputs { purpose: Purpose::Confirming, ..inputs }).collect::<Vec<_>>()
        };
        let round = witnesses.iter().enumerate().flat_map(runs_at).collect();
        Ok(Confirmation { searched, witnesses, round })
    }
}

/// The bounds whose witnesses are looked at: of a number all, of a curve for each statistic those of the place where it goes furthest.
fn extreme_bounds(group: &[SurrogateSearchBounds]) -> Vec<&Bound> {
    let mut furthest: Vec<(Statistic, Direction, &Bound)> = Vec::new();
    for searched in group {
        for (request, pair) in searched.values(&searched.bounds.pairs) {
            for (direction, bound) in [(Direction::Minimum, &pair.lower), (Direction::Maximum, &pair.upper)] {
                let known = furthest.iter_mut().find(|(s, d, _)| (*s, *d) == (request.statistic, direction));
                match known {
                    Some((_, _, known)) => {
                        if direction.is_beyond(bound.value, known.value) {
                            *known = bound;
                        }
                    }
                    None => furthest.push((request.statistic, direction, bound)),
                }
            }
        }
    }
    furthest.into_iter().map(|(_, _, bound)| bound).collect()
}

/// One group at one witness: the surrogate at all inner runs, and direct runs at some of them.
pub(crate) struct Confirmed {
    epistemic: Vec<f64>,
    /// Replicate by replicate and run by run, ŝ of every place; empty if the surrogate gave no answer.
    surrogate: Vec<Answers>,
    /// Replicate by replicate and run by run, the direct runs: their values, ŝ and σ.
    direct: Vec<DirectAnswers>,
    /// σ over X; `None` if the surrogate gave no answer.
    deviations: Option<DeviationsOverX>,
}

/// A corrected estimate with the distances to both ends of its confidence interval.
pub(crate) struct Corrected {
    pub value: f64,
    pub below: f64,
    pub above: f64,
}

/// `group` against the direct runs in `table`, witness by witness.
pub(crate) fn confirmed(
    plan: &SurrogatePlan,
    group: &LearnedGroup,
    confirmation: &Confirmation,
    table: &SampleTable,
) -> Vec<Confirmed> {
    let Ok(surrogates) = &group.surrogates else { return Vec::new() };
    let places: Vec<usize> = (0..group.group.columns.len()).collect();
    let function = LearnedFunction { plan, surrogates, places: &places };
    let replicates = if plan.problem().random.is_empty() { 1 } else { plan.problem().sampling.replicates };
    let mut all: Vec<Confirmed> = confirmation
        .witnesses
        .iter()
        .map(|epistemic| {
            let mut surrogate = vec![Vec::new(); replicates];
            for inputs in plan.direct.runs_at(0, 0, epistemic.clone()) {
                let answer = function.at(&inputs.random, epistemic).ok();
                surrogate[inputs.replicate as usize].push(answer.map(|(values, _)| values));
            }
            let deviations = function.spread(epistemic);
            Confirmed { epistemic: epistemic.clone(), surrogate, direct: vec![Vec::new(); replicates], deviations }
        })
        .collect();
    for (run, inputs) in table.inputs().iter().enumerate() {
        if inputs.purpose != Purpose::Confirming {
            continue;
        }
        let Some(confirmed) = all.iter_mut().find(|confirmed| confirmed.is_at(&inputs.epistemic)) else { continue };
        let answer = function.at(&inputs.random, &inputs.epistemic).ok();
        let row = group.group.row(table, run).zip(answer).map(|(own, (values, deviations))| [own, values, deviations]);
        confirmed.direct[inputs.replicate as usize].push(row);
    }
    all
}

impl Confirmed {
    /// Whether these runs were made at `epistemic`.
    pub fn is_at(&self, epistemic: &[f64]) -> bool {
        self.epistemic == epistemic
    }

    /// Root mean square of the surrogate's error over that of its σ, at the place where it is largest; 0 without runs.
    pub fn ratio(&self) -> f64 {
        let rows: Vec<&[Vec<f64>; 3]> = self.direct.iter().flatten().flatten().collect();
        let Some(first) = rows.first() else { return 0.0 };
        let of_place = |place: usize| {
            let (mut error, mut stated) = (0.0, 0.0);
            for [direct, surrogate, deviation] in &rows {
                error += (direct[place] - surrogate[place]) * (direct[place] - surrogate[place]);
                stated += deviation[place] * deviation[place];
            }
            // An error of round-off where nothing was left is none.
            let size = rows.iter().map(|[direct, ..]| direct[place].abs()).fold(0.0, f64::max);
            let least = (1e-12 * size) * (1e-12 * size) * rows.len() as f64;
            if error <= least { 0.0 } else { (error / stated.max(least)).sqrt() }
        };
        (0..first[0].len()).map(of_place).fold(0.0, f64::max)
    }

    /// How far the error moves the mean at `place`, at most: the mean of it with its own error, over the largest σ. Infinite where that
    /// is 0, where runs are missing, and without replicates that tell the error.
    pub fn shift_of_mean(&self, place: usize, confidence: &Confidence) -> f64 {
        let means: Option<Vec<f64>> = self.differences(place).into_iter().map(mean_of).collect();
        let Some(means) = means.filter(|means| means.len() > 1) else { return f64::INFINITY };
        let (below, above) = replicate_error(&means, confidence);
        let mean = means.iter().sum::<f64>() / means.len() as f64;
        self.over(|of| of.largest[place], mean.abs() + below.max(above))
    }

    /// How far it moves the deviation at `place`, at most: the deviation of it, over σ̄. Infinite where that is 0 and where runs are
    /// missing.
    pub fn shift_of_deviation(&self, place: usize) -> f64 {
        let Some(errors) = self.errors(place).filter(|errors| errors.len() > 1) else { return f64::INFINITY };
        let (mean, mean_square) = mean_and_mean_square(&errors);
        let count = errors.len() as f64;
        let deviation = ((mean_square - mean * mean).max(0.0) * count / (count - 1.0)).sqrt();
        self.over(|of| of.root_mean_square[place], deviation)
    }

    /// Square of the mean of the error at `place`, and its mean square; `None` if runs are missing.
    pub fn squares(&self, place: usize) -> Option<[f64; 2]> {
        let (mean, mean_square) = mean_and_mean_square(&self.errors(place).filter(|errors| !errors.is_empty())?);
        Some([mean * mean, mean_square])
    }

    /// Errors in all replicates; `None` if runs are missing.
    fn errors(&self, place: usize) -> Option<Vec<f64>> {
        Some(self.differences(place).into_iter().collect::<Option<Vec<Vec<f64>>>>()?.concat())
    }

    /// Differences of direct runs from ŝ, replicate by replicate; `None` for replicates with missing runs.
    fn differences(&self, place: usize) -> Vec<Option<Vec<f64>>> {
        let difference = |row: &Option<[Vec<f64>; 3]>| row.as_ref().map(|[direct, own, _]| direct[place] - own[place]);
        self.direct.iter().map(|rows| rows.iter().map(difference).collect()).collect()
    }

    fn over(&self, of: impl Fn(&DeviationsOverX) -> f64, error: f64) -> f64 {
        match self.deviations.as_ref().map(of) {
            Some(deviation) if deviation > 0.0 => error / deviation,
            _ => f64::INFINITY,
        }
    }

    /// Direct runs without a difference: those that gave nothing, and those at which the surrogate gave no answer.
    pub fn without_difference(&self) -> usize {
        self.direct.iter().flatten().filter(|row| row.is_none()).count()
    }

    /// The share of the inner runs at which the surrogate gave no answer: outside of the range of its runs.
    pub fn share_outside(&self) -> f64 {
        let inner = self.surrogate.iter().map(Vec::len).sum::<usize>();
        let outside = self.surrogate.iter().flatten().filter(|answer| answer.is_none()).count();
        outside as f64 / inner.max(1) as f64
    }

    /// The mean or probability at `place`, corrected; `None` for statistics that are no mean of a function, and where runs are missing.
    /// `known` is that of the surrogate with its error, where it is better known than from the inner runs themselves.
    pub fn corrected(
        &self,
        place: usize,
        statistic: Statistic,
        known: Option<(f64, f64)>,
        confidence: &Confidence,
    ) -> Option<Corrected> {
        let of = estimator(statistic)?.averaged()?;
        let of_replicate = |(surrogate, direct): (&Answers, &DirectAnswers)| {
            let differences = direct.iter().map(|row| {
                let [direct, surrogate, _] = row.as_ref()?;
                Some(of(direct[place]) - of(surrogate[place]))
            });
            let difference = mean_of(differences.collect())?;
            if known.is_some() {
                return Some(difference);
            }
            let all = surrogate.iter().map(|row| Some(of(row.as_ref()?[place])));
            Some(mean_of(all.collect())? + difference)
        };
        let means: Vec<f64> = self.surrogate.iter().zip(&self.direct).map(of_replicate).collect::<Option<_>>()?;
        let (start, error) = known.unwrap_or((0.0, 0.0));
        let value = start + means.iter().sum::<f64>() / means.len() as f64;
        let (below, above) = if means.len() == 1 { (0.0, 0.0) } else { replicate_error(&means, confidence) };
        let (below, above) = (below + error, above + error);
        if !statistic.is_probability() {
            return Some(Corrected { value, below, above });
        }
        let kept = value.clamp(0.0, 1.0);
        Some(Corrected { value: kept, below: below + (kept - value).abs(), above: above + (kept - value).abs() })
    }
}

fn mean_and_mean_square(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    (values.iter().sum::<f64>() / count, values.iter().map(|value| value * value).sum::<f64>() / count)
}

/// The mean of what is all there and not empty.
fn mean_of(values: Option<Vec<f64>>) -> Option<f64> {
    let values = values.filter(|values| !values.is_empty())?;
    Some(values.iter().sum::<f64>() / values.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::Confirmed;
    use crate::by_surrogate::response::DeviationsOverX;
    use crate::estimators::estimate::Confidence;

    const CONFIDENCE: f64 = 0.95;

    /// Four replicates of four direct runs with these errors; σ is 0.8 at the most over X, σ̄ = 0.5.
    fn confirmed(errors: [[f64; 4]; 4]) -> Confirmed {
        let row = |error: f64| Some([vec![7.0 + error], vec![7.0], vec![0.5]]);
        Confirmed {
            epistemic: vec![0.3],
            surrogate: Vec::new(),
            direct: errors.map(|errors| errors.map(row).to_vec()).to_vec(),
            deviations: Some(DeviationsOverX { largest: vec![0.8], root_mean_square: vec![0.5] }),
        }
    }

    #[test]
    fn analytic_an_error_to_one_side_moves_the_mean_and_not_the_deviation() {
        const ROUND_OFF: f64 = 1e-12;
        let confidence = Confidence::new(CONFIDENCE, 4);
        let biased = confirmed([[-0.2; 4]; 4]);
        assert!((biased.shift_of_mean(0, &confidence) - 0.25).abs() < ROUND_OFF);
        assert!(biased.shift_of_deviation(0) < ROUND_OFF);
        // Errors of 0.2 to either side: their deviation is 0.2 √(16/15), their mean 0 in every replicate.
        let balanced = confirmed([[-0.2, 0.2, 0.2, -0.2]; 4]);
        assert!(balanced.shift_of_mean(0, &confidence) < ROUND_OFF);
        assert!((balanced.shift_of_deviation(0) - 0.4 * (16.0_f64 / 15.0).sqrt()).abs() < ROUND_OFF);
    }

    #[test]
    fn analytic_the_mean_of_the_error_is_taken_with_its_own_error() {
        // Means of the replicates 0.1, 0.3, 0.1, 0.3: 0.2 ± t √(0.04/3/4), t = 3.182446 of three degrees of freedom.
        const TOLERANCE: f64 = 1e-5;
        let scattered = confirmed([[0.1; 4], [0.3; 4], [0.1; 4], [0.3; 4]]);
        let expected = (0.2 + 3.182_446 * (0.04_f64 / 12.0).sqrt()) / 0.8;
        let shift = scattered.shift_of_mean(0, &Confidence::new(CONFIDENCE, 4));
        assert!((shift - expected).abs() < TOLERANCE, "{shift} {expected}");
    }

    #[test]
    fn what_is_not_known_may_move_a_statistic_any_distance() {
        let confidence = Confidence::new(CONFIDENCE, 4);
        let known = || confirmed([[0.1; 4]; 4]);
        let mut failed = known();
        failed.direct[2][1] = None;
        let without_answer = Confirmed { deviations: None, ..known() };
        let of_one_run = Confirmed { direct: vec![vec![known().direct[0][0].clone()]], ..known() };
        for unknown in [failed, without_answer, of_one_run] {
            assert_eq!(unknown.shift_of_mean(0, &confidence), f64::INFINITY);
            assert_eq!(unknown.shift_of_deviation(0), f64::INFINITY);
        }
    }
}
