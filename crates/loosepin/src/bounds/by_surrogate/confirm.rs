//! Direct runs at the witnesses of bounds on a surrogate, and what they say of it.

use std::collections::BTreeSet;

use super::super::bound::Bound;
use super::super::sample::{Confidence, replicate_error};
use super::super::search::Direction;
use super::super::statistic::Statistic;
use super::super::table::{Purpose, RunInputs, SampleTable};
use super::learned::LearnedGroup;
use super::plan::SurrogatePlan;
use super::response::LearnedFunction;
use super::search::Searched;

/// ŝ for the runs of a replicate; nothing where the surrogate gave no answer.
type Answers = Vec<Option<Vec<f64>>>;
/// Values of the direct runs of a replicate, with ŝ and σ at the same inputs; nothing where a run failed.
type DirectAnswers = Vec<Option<[Vec<f64>; 3]>>;

/// Values of the epistemic inputs at which direct runs are made, at most.
pub const MOST_WITNESSES: usize = 24;

/// Which direct runs the bounds on the surrogates are to be held against.
pub struct Confirmation {
    pub(super) searched: Vec<Vec<Searched>>,
    /// Values of the epistemic inputs.
    witnesses: Vec<Vec<f64>>,
    /// The runs that are still to be made, in their order.
    pub round: Vec<RunInputs>,
}

impl Confirmation {
    pub(super) fn new(plan: &SurrogatePlan, searched: Vec<Vec<Searched>>, round: u32, table: &SampleTable) -> Self {
        let mut witnesses: Vec<Vec<f64>> = Vec::new();
        for group in &searched {
            for bound in extreme_bounds(group) {
                let Some(witness) = &bound.witness else { continue };
                if witnesses.len() < MOST_WITNESSES && !witnesses.contains(&witness.epistemic) {
                    witnesses.push(witness.epistemic.clone());
                }
            }
        }
        let per_replicate = plan.settings.confirming / plan.problem().sampling.replicates;
        let made = || table.inputs().iter().filter(|inputs| inputs.purpose == Purpose::Confirming);
        let key = |inputs: &RunInputs| {
            let bits: Vec<u64> = inputs.epistemic.iter().map(|value| value.to_bits()).collect();
            (bits, inputs.replicate, inputs.index)
        };
        let known: BTreeSet<_> = made().map(key).collect();
        let first = made().map(|inputs| inputs.point + 1).max().unwrap_or(0);
        let runs_at = |(point, epistemic): (usize, &Vec<f64>)| {
            let runs = plan.direct.runs_at(round, first + point as u32, epistemic.clone());
            let runs = runs.filter(|inputs| (inputs.index as usize) < per_replicate && !known.contains(&key(inputs)));
            runs.map(|inputs| RunInputs { purpose: Purpose::Confirming, ..inputs }).collect::<Vec<_>>()
        };
        let round = witnesses.iter().enumerate().flat_map(runs_at).collect();
        Self { searched, witnesses, round }
    }
}

/// The bounds whose witnesses are looked at: of a number all, of a curve for each statistic those of the place where it goes furthest.
fn extreme_bounds(group: &[Searched]) -> Vec<&Bound> {
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
pub(super) struct Confirmed {
    epistemic: Vec<f64>,
    /// Replicate by replicate and run by run, ŝ of every place; nothing where the surrogate gave no answer.
    surrogate: Vec<Answers>,
    /// The same for the direct runs: their values, ŝ and σ.
    direct: Vec<DirectAnswers>,
}

/// A corrected estimate with the distances to both ends of its confidence interval.
pub(super) struct Corrected {
    pub value: f64,
    pub below: f64,
    pub above: f64,
}

/// What the direct runs in `table` say of `group`, witness by witness.
pub(super) fn confirmed(
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
            Confirmed { epistemic: epistemic.clone(), surrogate, direct: vec![Vec::new(); replicates] }
        })
        .collect();
    for (run, inputs) in table.inputs().iter().enumerate() {
        if inputs.purpose != Purpose::Confirming {
            continue;
        }
        let Some(confirmed) = all.iter_mut().find(|confirmed| confirmed.is_at(&inputs.epistemic)) else { continue };
        let own: Vec<f64> = group.group.columns.iter().map(|&column| table.values(run)[column]).collect();
        let answer = function.at(&inputs.random, &inputs.epistemic).ok();
        let answer = answer.filter(|_| own.iter().all(|value| value.is_finite()));
        let row = answer.map(|(values, deviations)| [own, values, deviations]);
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

    /// Direct runs that gave nothing, or at which the surrogate gave no answer.
    pub fn failed(&self) -> usize {
        self.direct.iter().flatten().filter(|row| row.is_none()).count()
    }

    /// The mean or probability at `place`, corrected; nothing for other statistics and where runs are missing. `known` is that of the
    /// surrogate with its error, where it is better known than from the inner runs themselves.
    pub fn corrected(
        &self,
        place: usize,
        statistic: Statistic,
        known: Option<(f64, f64)>,
        confidence: &Confidence,
    ) -> Option<Corrected> {
        let of: Box<dyn Fn(f64) -> f64> = match statistic {
            Statistic::Mean => Box::new(|y| y),
            Statistic::ProbabilityAbove(limit) => Box::new(move |y| f64::from(u8::from(y > limit))),
            Statistic::ProbabilityBelow(limit) => Box::new(move |y| f64::from(u8::from(y < limit))),
            Statistic::ProbabilityBeyond(limit) => Box::new(move |y| f64::from(u8::from(y.abs() > limit))),
            Statistic::StandardDeviation | Statistic::Quantile(_) | Statistic::Cdf => return None,
        };
        let mean = |values: Option<Vec<f64>>| {
            let values = values.filter(|values| !values.is_empty())?;
            Some(values.iter().sum::<f64>() / values.len() as f64)
        };
        let of_replicate = |(surrogate, direct): (&Answers, &DirectAnswers)| {
            let differences = direct.iter().map(|row| {
                let [direct, surrogate, _] = row.as_ref()?;
                Some(of(direct[place]) - of(surrogate[place]))
            });
            let difference = mean(differences.collect())?;
            if known.is_some() {
                return Some(difference);
            }
            let all = surrogate.iter().map(|row| Some(of(row.as_ref()?[place])));
            Some(mean(all.collect())? + difference)
        };
        let means: Vec<f64> = self.surrogate.iter().zip(&self.direct).map(of_replicate).collect::<Option<_>>()?;
        let (start, error) = known.unwrap_or((0.0, 0.0));
        let value = start + means.iter().sum::<f64>() / means.len() as f64;
        let (below, above) = if means.len() == 1 { (0.0, 0.0) } else { replicate_error(&means, confidence) };
        let (below, above) = (below + error, above + error);
        if statistic == Statistic::Mean {
            return Some(Corrected { value, below, above });
        }
        let kept = value.clamp(0.0, 1.0);
        Some(Corrected { value: kept, below: below + (kept - value).abs(), above: above + (kept - value).abs() })
    }
}
