//! How near the bounds of a study are to be: goals of the double loop, the budget, and what came of them.

use std::time::Instant;

use super::assemble::Material;
use super::columns::{ColumnPlan, PlannedAsk};
use super::file::{AccuracyTarget, Budget, Study, Where, statistic_name};
use loosepin_bounds::{Assessment, Goal, Refinement, Request, Standing, Statistic, SurrogateRounds};
use loosepin_result::study::{AccuracyOutcome, AccuracyRecord, AccuracyStep, AccuracyStop, BoundEnd, BudgetRecord};
use loosepin_text::units::{Dimension, SiUnit};

/// Where no budget is stated, a study ends at so many times the runs that it has without an accuracy, or where its runs, which it
/// holds in memory, are so many numbers (a gibibyte).
const USUAL_GROWTH: usize = 100;
const USUAL_NUMBERS: usize = 1 << 27;

/// Errors fall at least with this power of the number of runs where anything is to be foreseen, and at most with the other one.
const LEAST_PACE: f64 = 0.1;
const MOST_PACE: f64 = 1.5;
/// The power where nothing has been seen yet: that of independent runs.
const USUAL_PACE: f64 = 0.5;

/// The accuracy that `statistic` of question `place` is to have.
fn target(study: &Study, place: usize, planned: &PlannedAsk, statistic: Statistic) -> Option<f64> {
    let name = statistic_name(statistic)?;
    if planned.ask.rare.iter().any(|(rare, _)| *rare == statistic) {
        return None;
    }
    let is_probability = !matches!(statistic, Statistic::Mean | Statistic::StandardDeviation | Statistic::Quantile(_));
    let of_output = study.model.outputs[planned.ask.output].kind.dimension();
    let dimension = if is_probability { Dimension::NUMBER } else { of_output };
    let concerns = |target: &&AccuracyTarget| {
        target.dimension == dimension
            && target.ask.is_none_or(|ask| ask == place)
            && target.output.is_none_or(|output| output == planned.ask.output)
            && target.statistic.is_none_or(|of| of == name)
    };
    let named = |target: &AccuracyTarget| {
        let parts = [target.ask.is_some(), target.output.is_some(), target.statistic.is_some()];
        (target.is_argument, parts.into_iter().filter(|is_named| *is_named).count())
    };
    // The last of those that name most.
    study.accuracy.iter().filter(concerns).max_by_key(|target| named(target)).map(|target| target.most_si)
}

/// Every bound with an accuracy: its question, by its place, and what its statistic may be widened by.
fn targets<'p>(study: &'p Study, plan: &'p ColumnPlan) -> impl Iterator<Item = (&'p PlannedAsk, Statistic, f64)> {
    plan.asks.iter().enumerate().flat_map(move |(place, planned)| {
        let of_statistic =
            move |&statistic: &Statistic| Some((planned, statistic, target(study, place, planned, statistic)?));
        planned.ask.statistics.iter().filter_map(of_statistic)
    })
}

/// The goals of the double loop, column by column.
pub(super) fn goals(study: &Study, plan: &ColumnPlan) -> Vec<Goal> {
    let mut goals: Vec<Goal> = Vec::new();
    for (planned, statistic, most) in targets(study, plan) {
        for &column in &planned.columns {
            let request = Request { column, statistic };
            match goals.iter_mut().find(|goal| goal.request == request) {
                Some(goal) => goal.most = goal.most.min(most),
                None => goals.push(Goal { request, most }),
            }
        }
    }
    goals
}

/// The budget of a study whose samples may grow, or that has one; `stated_runs` of `row_length` numbers each are those without
/// growth.
pub(super) fn budget(study: &Study, stated_runs: usize, row_length: usize) -> Option<Budget> {
    let held = (USUAL_NUMBERS / row_length).max(stated_runs);
    let usual = || Budget::Runs(stated_runs.saturating_mul(USUAL_GROWTH).min(held) as u64);
    study.budget.or_else(|| (!study.accuracy.is_empty()).then(usual))
}

/// Decides before each round whether it is made.
pub(super) struct Watch {
    budget: Option<Budget>,
    /// Runs that follow the rounds.
    reserved: usize,
    began: Instant,
}

impl Watch {
    /// Begins now.
    pub fn new(budget: Option<Budget>, reserved: usize) -> Self {
        Self { budget, reserved, began: Instant::now() }
    }

    /// Whether a round of `next` runs stays within the budget, `made` runs and `rounds` rounds being made. A time is foreseen from that
    /// of the runs so far, so that the first round is always made.
    pub fn allows(&self, next: usize, made: usize, rounds: u32) -> bool {
        match self.budget {
            None => true,
            Some(Budget::Runs(most)) => (made + next + self.reserved) as u64 <= most,
            Some(Budget::Rounds(most)) => rounds < most,
            Some(Budget::Time { seconds }) => {
                let elapsed_s = self.began.elapsed().as_secs_f64();
                made == 0 || elapsed_s * (made + next + self.reserved) as f64 / made as f64 <= seconds
            }
        }
    }

    /// Runs at most, `planned` being those of the samples as they stand.
    pub fn most_runs(&self, planned: usize) -> usize {
        match self.budget {
            Some(Budget::Runs(most)) => usize::try_from(most).unwrap_or(usize::MAX),
            _ => planned,
        }
    }
}

/// How the rounds ended.
pub(super) struct Ended {
    pub standing: Standing,
    /// Runs of the round that the budget did not allow.
    pub left: Option<usize>,
    /// Rounds and runs that were made.
    pub rounds: u32,
    pub runs: usize,
    pub history: Vec<Assessment>,
    pub budget: Option<Budget>,
}

impl Ended {
    /// Ends `rounds` of surrogates, of which `made` were made with `runs` runs.
    pub fn of_surrogates(
        rounds: &SurrogateRounds,
        left: Option<usize>,
        (made, runs): (u32, usize),
        budget: Option<Budget>,
    ) -> Self {
        Self { standing: rounds.standing(), left, rounds: made, runs, history: rounds.history().to_vec(), budget }
    }

    /// Ends `refinement` after `runs` runs in `rounds` rounds.
    pub fn new(
        refinement: &Refinement,
        left: Option<usize>,
        (rounds, runs): (u32, usize),
        budget: Option<Budget>,
    ) -> Self {
        let (standing, history) = (refinement.standing(), refinement.history().to_vec());
        Self { standing, left, rounds, runs, history, budget }
    }
}

/// What came of accuracy and budget; nothing where neither was stated.
pub(super) fn record(material: &Material<'_>, ended: &Ended) -> Option<AccuracyRecord> {
    let budget = match ended.budget? {
        Budget::Runs(runs) => BudgetRecord::Runs { runs },
        Budget::Time { seconds } => BudgetRecord::Time { seconds },
        Budget::Rounds(rounds) => BudgetRecord::Rounds { rounds },
    };
    let plan = &material.response.shared.plan;
    let outcomes: Vec<AccuracyOutcome> = targets(material.study, plan)
        .filter_map(|(planned, statistic, asked)| outcome(material, planned, statistic, asked, ended))
        .collect();
    let stop = match (ended.standing, ended.left) {
        (_, Some(_)) => AccuracyStop::Budget,
        (Standing::Exhausted, None) => AccuracyStop::Exhausted,
        (Standing::Growing | Standing::Reached, None) => AccuracyStop::Reached,
    };
    let step = |assessment: &Assessment| AccuracyStep {
        rounds: assessment.rounds,
        runs: assessment.runs as u64,
        outer: assessment.outer as u64,
        inner: assessment.inner as u64,
        training: assessment.training as u64,
        confirming: assessment.confirming as u64,
        share: assessment.share,
    };
    Some(AccuracyRecord {
        // Limits that other columns set may have brought near what the rounds did not.
        stop: if !outcomes.is_empty() && outcomes.iter().all(AccuracyOutcome::is_reached) {
            AccuracyStop::Reached
        } else {
            stop
        },
        budget,
        is_budget_stated: material.study.budget.is_some(),
        rounds: ended.rounds,
        runs: ended.runs as u64,
        next_round_runs: ended.left.map(|runs| runs as u64),
        targets: outcomes,
        steps: ended.history.iter().map(step).collect(),
    })
}

/// The bounds of a statistic against what was asked: the pose that is furthest from it.
fn outcome(
    material: &Material<'_>,
    planned: &PlannedAsk,
    statistic: Statistic,
    asked_si: f64,
    ended: &Ended,
) -> Option<AccuracyOutcome> {
    let widening = |end: &BoundEnd| {
        let widening_si = (end.widened_si - end.value_si).abs();
        if widening_si.is_nan() { f64::INFINITY } else { widening_si }
    };
    let ends = planned.columns.iter().filter_map(|&column| Some((column, material.ends(column, statistic)?)));
    let ends = ends.flat_map(|(column, ends)| ends.map(|end| (column, end)));
    let (column, end) = ends.max_by(|(_, a), (_, b)| widening(a).total_cmp(&widening(b)))?;
    let reached_si = widening(&end);
    Some(AccuracyOutcome {
        output: material.name_of(column),
        of: planned.ask.deviation,
        at: material.point_of(column, planned.ask.location == Where::Cycle),
        statistic,
        unit: if statistic.is_probability() { SiUnit::NONE } else { material.unit_of(column) },
        asked_si,
        reached_si,
        sampling_si: end.error.sampling_si,
        optimisation_si: end.error.optimisation_si,
        surrogate_si: end.error.surrogate_si,
        runs_needed: if reached_si > asked_si { runs_needed(reached_si / asked_si, ended) } else { None },
    })
}

/// Runs at which an error that is `share` times too large would not be: error ~ runs^-p, p from the first and the last size of the
/// samples, that of independent runs where there was one size only.
fn runs_needed(share: f64, ended: &Ended) -> Option<u64> {
    let pace = match (ended.history.first(), ended.history.last()) {
        (Some(first), Some(last)) if last.runs > first.runs && first.share.is_finite() => {
            let pace = (first.share / last.share).ln() / (last.runs as f64 / first.runs as f64).ln();
            if pace < LEAST_PACE {
                return None;
            }
            pace.min(MOST_PACE)
        }
        _ => USUAL_PACE,
    };
    let needed = ended.runs as f64 * share.powf(1.0 / pace);
    (needed < u64::MAX as f64).then_some(needed.ceil() as u64)
}

#[cfg(test)]
mod tests {
    use super::{Budget, Ended, Watch, runs_needed};
    use loosepin_bounds::{Assessment, Standing};

    fn ended(sizes: &[(usize, f64)]) -> Ended {
        let assessment = |&(runs, share): &(usize, f64)| Assessment {
            rounds: 3,
            runs,
            outer: 12,
            inner: 64,
            training: 0,
            confirming: 0,
            share,
            sampling_share: share,
            optimisation_share: 0.5 * share,
        };
        let runs = sizes.last().map_or(700, |(runs, _)| *runs);
        let history = sizes.iter().map(assessment).collect();
        Ended { standing: Standing::Growing, left: Some(90), rounds: 3, runs, history, budget: None }
    }

    #[test]
    fn analytic_runs_needed_by_the_power_seen() {
        // Four times the runs, a third of the error: p = ln 3/ln 4, and an error 2.5 times too large needs 2.5^(1/p) times the runs.
        let factor = 2.5_f64.powf(4_f64.ln() / 3_f64.ln());
        let expected = (12_000.0 * factor).ceil() as u64;
        let found = runs_needed(2.5, &ended(&[(3000, 7.5), (12_000, 2.5)])).unwrap();
        assert!(found.abs_diff(expected) <= 1, "{found} {expected}");
        // Nothing seen yet: that of independent runs.
        assert_eq!(runs_needed(3.0, &ended(&[])), Some(6300));
        // More runs that did not help tell nothing.
        assert_eq!(runs_needed(3.0, &ended(&[(3000, 3.1), (12_000, 3.0)])), None);
        assert_eq!(runs_needed(f64::INFINITY, &ended(&[])), None);
    }

    #[test]
    fn a_budget_of_runs_counts_what_follows_the_rounds() {
        let watch = Watch::new(Some(Budget::Runs(1000)), 150);
        assert!(watch.allows(350, 500, 4) && !watch.allows(351, 500, 4));
        let watch = Watch::new(Some(Budget::Rounds(5)), 150);
        assert!(watch.allows(9999, 500, 4) && !watch.allows(1, 500, 5));
        assert!(
            Watch::new(Some(Budget::Time { seconds: 1e-9 }), 150).allows(350, 0, 0),
            "the first round is always made"
        );
        assert!(!Watch::new(Some(Budget::Time { seconds: 1e-9 }), 150).allows(350, 1, 1));
        assert!(Watch::new(None, 150).allows(usize::MAX, 500, 4));
    }
}
