//! Bounds by surrogates to an accuracy: runs that are added where they narrow the bound that is furthest from it.

use super::learned::draws_residual;
use super::plan::{SurrogatePlan, SurrogatePlanError};
use super::results::{GroupBounds, SurrogateBounds, SurrogatePair};
use super::settings::SurrogateSettings;
use crate::data::bound::Bound;
use crate::data::problem::{Problem, Sampling};
use crate::data::table::{Purpose, RunInputs, SampleTable};
use crate::plan::refinement::{Assessment, Goal, RefinementStatus};

/// Training runs for each combination of the members of lists, at most, where they are not stated to be more: from there on learning
/// takes longer than most runs.
const MAX_TRAINING: usize = 1000;
/// A step adds this share of the training runs, and at least so many.
const TRAINING_SHARE: f64 = 0.5;
const MIN_TRAINING: usize = 8;
/// Direct runs at a witness, at most.
const MAX_CONFIRMING: usize = 1 << 14;
/// From so many training runs for each input on, and at least so many, it is believed that what is left does not fall with more.
const BELIEVED_PER_INPUT: usize = 25;
const MIN_BELIEVED: usize = 100;
/// Two steps of further training runs that together leave more than this share of what the surrogate does not know do not help.
const HARDLY_LESS: f64 = 0.8;

/// The sample that is made larger.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Growth {
    Training,
    Confirming,
}

/// Training and confirming runs that grow until goals are reached.
///
/// A step makes the runs to learn from, learns, and makes the direct runs at the witnesses that are not there yet. The plan as stated is the
/// first. Then the bound that is furthest from its goal decides: where the surrogate's error is the largest part of what it is widened by, half
/// as many training runs again, every other one at the witnesses of bounds that are too wide; where the sampling error of the correction is,
/// twice as many direct runs at each witness. The double loop on the surrogate itself costs no runs, and grows until it takes a quarter of
/// the goal at most. Training runs are not added where what is left of 25 for each input, 100 at least, does not fall with more (noise, a
/// jump, chaos), nor where two steps have hardly helped: where that alone is more than the goal, the goal is not reached, and that is said.
///
/// Step k = 1, 2, ... may err with the probability α/(k (k + 1)), as in [`Refinement`](crate::Refinement).
pub struct SurrogateRounds {
    plan: SurrogatePlan,
    goals: Vec<Goal>,
    /// Steps that were assessed, and this one.
    look: u32,
    /// Training runs for each combination of which the present step has made the last.
    training: usize,
    /// Numbers of the training runs of the present step.
    first: usize,
    /// Points around which its runs are concentrated.
    near: Vec<Vec<f64>>,
    /// Error of the surrogates over the allowed error, after each step of training runs.
    unknown: Vec<f64>,
    history: Vec<Assessment>,
    standing: RefinementStatus,
}

/// One end of a bound that is widened by more than is asked.
struct Wide<'a> {
    /// Widening over the requested accuracy.
    share: f64,
    /// Of that, what the surrogate does not know.
    surrogate: f64,
    sampling: f64,
    bound: &'a Bound,
    is_confirmed: bool,
    /// Whether further training runs may help.
    can_learn: bool,
}

impl SurrogateRounds {
    /// Begins with `plan`; without goals there is one step.
    ///
    /// # Errors
    /// [`SurrogatePlanError`].
    pub fn new(plan: SurrogatePlan, goals: Vec<Goal>) -> Result<Self, SurrogatePlanError> {
        let training = plan.settings.training;
        let plan = if goals.is_empty() { plan } else { at_look(&plan, &goals, 1, plan.settings.confirming)? };
        Ok(Self {
            plan,
            goals,
            look: 1,
            training,
            first: 0,
            near: Vec::new(),
            unknown: Vec::new(),
            history: Vec::new(),
            standing: RefinementStatus::Growing,
        })
    }

    /// The plan of the present step.
    pub fn plan(&self) -> &SurrogatePlan {
        &self.plan
    }

    /// How the goals were approached, step by step.
    pub fn history(&self) -> &[Assessment] {
        &self.history
    }

    /// Whether the goals are reached.
    pub fn status(&self) -> RefinementStatus {
        self.standing
    }

    /// The runs to learn from of the present step, as round `round`; empty where it adds direct runs alone.
    ///
    /// # Errors
    /// More inputs than Sobol' points have dimensions.
    pub fn training_round(&self, round: u32) -> Result<Vec<RunInputs>, SurrogatePlanError> {
        self.plan.training_runs(round, self.first..self.training, &self.near)
    }

    /// Looks at what the present step has found; whether there is a further one.
    ///
    /// # Errors
    /// [`SurrogatePlanError`].
    pub fn advance(&mut self, found: &SurrogateBounds, table: &SampleTable) -> Result<bool, SurrogatePlanError> {
        if self.goals.is_empty() {
            return Ok(false);
        }
        let (share, wide) = self.wide(found);
        let largest = |of: fn(&Wide<'_>) -> f64| wide.iter().map(of).fold(0.0, f64::max);
        let count = |purpose| table.inputs().iter().filter(|inputs| inputs.purpose == purpose).count();
        let sampling = self.plan.problem().sampling;
        self.history.push(Assessment {
            rounds: self.look,
            runs: table.len(),
            outer: sampling.outer,
            inner: sampling.inner,
            training: count(Purpose::Training),
            confirming: count(Purpose::Confirming),
            share,
            sampling_share: largest(|end| end.sampling),
            optimisation_share: largest(|end| end.share - end.sampling - end.surrogate),
        });
        if self.first < self.training {
            self.unknown.push(largest(|end| if end.can_learn { end.surrogate } else { 0.0 }));
        }
        let growth = if share <= 1.0 { None } else { self.growth(&wide) };
        let Some(growth) = growth else {
            self.standing = if share <= 1.0 { RefinementStatus::Reached } else { RefinementStatus::Exhausted };
            return Ok(false);
        };
        let mut confirming = self.plan.settings.confirming;
        self.first = self.training;
        match growth {
            Growth::Training => {
                let more = ((TRAINING_SHARE * self.training as f64) as usize).max(MIN_TRAINING);
                self.training = (self.training + more).min(self.most_training());
                self.near.clear();
                for witness in wide.iter().filter_map(|end| end.bound.witness.as_ref()) {
                    if !self.near.contains(&witness.epistemic)
                        && witness.epistemic.iter().all(|value| value.is_finite())
                    {
                        self.near.push(witness.epistemic.clone());
                    }
                }
            }
            Growth::Confirming => confirming *= 2,
        }
        self.look += 1;
        self.plan = at_look(&self.plan, &self.goals, self.look, confirming)?;
        Ok(true)
    }

    fn most_training(&self) -> usize {
        MAX_TRAINING.max(self.plan.settings.training)
    }

    /// The sample whose growth narrows the bounds that are too wide.
    fn growth(&self, wide: &[Wide<'_>]) -> Option<Growth> {
        // What nothing makes smaller keeps the goal from being reached, whatever is added.
        let is_lost = |end: &Wide<'_>| !end.can_learn && end.surrogate > 1.0 || !end.bound.value.is_finite();
        let rest: Vec<&Wide<'_>> = wide.iter().filter(|end| !is_lost(end)).collect();
        let has_helped = match self.unknown[..] {
            [.., before, _, now] => now <= HARDLY_LESS * before,
            _ => true,
        };
        let can_train = has_helped && self.training < self.most_training();
        let can_confirm = !self.plan.problem().random.is_empty() && 2 * self.plan.settings.confirming <= MAX_CONFIRMING;
        let learnable = |end: &&Wide<'_>| end.can_learn && end.surrogate > 0.0;
        let correctable = |end: &&Wide<'_>| end.is_confirmed && end.sampling > 0.0;
        let surrogate = rest.iter().copied().filter(learnable).map(|end| end.surrogate).fold(0.0, f64::max);
        let sampling = rest.iter().copied().filter(correctable).map(|end| end.sampling).fold(0.0, f64::max);
        match (can_train && surrogate > 0.0, can_confirm && sampling > 0.0) {
            (true, true) => Some(if surrogate >= sampling { Growth::Training } else { Growth::Confirming }),
            (true, false) => Some(Growth::Training),
            // More direct runs alone must be able to reach the goal somewhere.
            (false, true) if rest.iter().any(|end| correctable(end) && end.surrogate < 1.0) => Some(Growth::Confirming),
            _ => None,
        }
    }

    /// The largest widening over the requested accuracy, and all ends that are too wide.
    fn wide<'f>(&self, found: &'f SurrogateBounds) -> (f64, Vec<Wide<'f>>) {
        let (mut largest, mut wide) = (0.0_f64, Vec::new());
        for Goal { request, most } in &self.goals {
            let own =
                |pair: &&SurrogatePair| (pair.pair.column, pair.pair.statistic) == (request.column, request.statistic);
            let of_group = |group: &'f GroupBounds| Some((group, group.pairs.iter().find(own)?));
            let Some((group, pair)) = found.groups.iter().find_map(of_group) else {
                // Nothing was learned of it.
                largest = f64::INFINITY;
                continue;
            };
            // Of what fails no training tells more.
            let is_told = group.failed == 0 || !request.statistic.is_by_shares();
            let falls = group.learned.surrogates.iter().flatten().any(|surrogate| !draws_residual(surrogate));
            let is_believed = self.training < (BELIEVED_PER_INPUT * self.plan.inputs().len()).max(MIN_BELIEVED);
            let can_learn = is_told && (falls || is_believed);
            for (bound, is_confirmed) in
                [(&pair.pair.lower, pair.is_confirmed[0]), (&pair.pair.upper, pair.is_confirmed[1])]
            {
                let share = (bound.widened - bound.value).abs() / most;
                let share = if share.is_nan() { f64::INFINITY } else { share };
                largest = largest.max(share);
                if share > 1.0 {
                    let (surrogate, sampling) = (bound.error.surrogate / most, bound.error.sampling / most);
                    wide.push(Wide { share, surrogate, sampling, bound, is_confirmed, can_learn });
                }
            }
        }
        (largest, wide)
    }
}

/// `plan` with `confirming` direct runs at a witness and the confidence that step `look` needs.
fn at_look(
    plan: &SurrogatePlan,
    goals: &[Goal],
    look: u32,
    confirming: usize,
) -> Result<SurrogatePlan, SurrogatePlanError> {
    let problem = plan.problem().clone();
    let miss = (1.0 - plan.stated_confidence) / f64::from(look * (look + 1));
    let inner = problem.sampling.inner.max(confirming);
    let sampling = Sampling { confidence: 1.0 - miss, inner, ..problem.sampling };
    let settings = SurrogateSettings { confirming, ..plan.settings.clone() };
    let grown = SurrogatePlan::try_new(Problem { sampling, ..problem }, settings)?;
    Ok(SurrogatePlan { goals: goals.to_vec(), stated_confidence: plan.stated_confidence, ..grown })
}
