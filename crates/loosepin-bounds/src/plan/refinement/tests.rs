use crate::Function;
use crate::cases::exact::{STANDARD_NORMAL, paired, problem};
use crate::plan::refinement::{Goal, Refinement, RefinementStatus};
use crate::{
    BoundPair, Bounds, DoubleLoop, Problem, Purpose, Request, Response, RunInputs, SampleTable, Sampling, Statistic,
    execute,
};
use std::collections::BTreeSet;

/// What |X| counts.
const SCATTER: f64 = 0.3;
const QUANTILE: f64 = 0.9;
/// Of the magnitude of a standard normal variable, at [`QUANTILE`].
const MAGNITUDE_QUANTILE: f64 = 1.644_853_626_951_472_2;

/// 0.3 |X| + sin(5 u) + 0.4 u: the mean has both its least and its greatest value inside. With the kink the runs are counted, no
/// polynomial is believed.
fn wave() -> Function<impl Fn(&[f64], &[f64]) -> f64 + Sync> {
    Function(|x: &[f64], u: &[f64]| SCATTER * x[0].abs() + mean(u[0]))
}

/// The part of the mean that depends on u.
fn mean(u: f64) -> f64 {
    libm::sin(5.0 * u) + 0.4 * u
}

/// The extremes of [`mean`] over [0.1, 1.3]: where 5 cos(5 u) + 0.4 = 0.
fn extremes() -> (f64, f64) {
    let turn = libm::acos(-0.08);
    (mean((std::f64::consts::TAU - turn) / 5.0), mean(turn / 5.0))
}

fn small(goals: &[(Statistic, f64)]) -> (Problem, Vec<Goal>) {
    let statistics: Vec<Statistic> = goals.iter().map(|(statistic, _)| *statistic).collect();
    let mut problem = problem(&[STANDARD_NORMAL], &[(0.1, 1.3)], &statistics);
    problem.compared_columns = vec![0];
    problem.sampling =
        Sampling { outer: 8, inner: 32, replicates: 4, mixture: 64, extreme: 40, seed: 9, ..Sampling::default() };
    let goal = |&(statistic, most): &(Statistic, f64)| Goal { request: Request { column: 0, statistic }, most };
    (problem, goals.iter().map(goal).collect())
}

/// Runs rounds until there is none, or until `most_rounds` are made.
fn run(refinement: &mut Refinement, response: &impl Response, most_rounds: usize) -> SampleTable {
    let mut table = SampleTable::new(1);
    for _ in 0..most_rounds {
        let round = refinement.next_round(&table).unwrap();
        if round.is_empty() {
            break;
        }
        execute(round, response, &mut table).unwrap();
    }
    table
}

fn widenings(pair: &BoundPair) -> [f64; 2] {
    [&pair.lower, &pair.upper].map(|bound| (bound.widened - bound.value).abs())
}

fn bits(bounds: &Bounds) -> Vec<u64> {
    let ends = bounds.pairs.iter().flat_map(|pair| [&pair.lower, &pair.upper]);
    ends.flat_map(|bound| [bound.value.to_bits(), bound.widened.to_bits()]).collect()
}

#[test]
fn analytic_bounds_become_as_near_as_is_asked_and_hold() {
    let goals = [(Statistic::Mean, 2e-4), (Statistic::Quantile(QUANTILE), 0.02)];
    let (problem, goals) = small(&goals);
    let first = problem.sampling;
    let mut refinement = Refinement::try_new(problem, goals.clone()).unwrap();
    let table = run(&mut refinement, &wave(), usize::MAX);
    assert_eq!(refinement.status(), RefinementStatus::Reached, "{:#?}", refinement.history());
    let bounds = refinement.results(&table).unwrap();
    let (least, greatest) = extremes();
    let shifts = [libm::sqrt(std::f64::consts::FRAC_2_PI), MAGNITUDE_QUANTILE].map(|shift| SCATTER * shift);
    for ((pair, goal), shift) in paired(&bounds.pairs, &goals).zip(shifts) {
        let exact = (least + shift, greatest + shift);
        assert!(widenings(pair).into_iter().all(|widening| widening <= goal.most), "{pair:#?}");
        assert!(pair.lower.widened <= exact.0 && pair.upper.widened >= exact.1, "{exact:?} {pair:#?}");
    }
    // Both samples had to grow, and the history says how it went.
    let history = refinement.history();
    let last = history[history.len() - 1];
    assert!(history.len() > 2 && history[0].share > 1.0 && last.share <= 1.0, "{history:#?}");
    assert!(last.inner > first.inner && last.outer > first.outer, "{last:?}");
    assert_eq!((last.runs, last.rounds), (table.len(), bounds.rounds));
}

#[test]
fn analytic_a_goal_of_a_statistic_that_was_not_asked_for_is_not_reached() {
    let (problem, _) = small(&[(Statistic::Mean, 10.0)]);
    let request = Request { column: 0, statistic: Statistic::StandardDeviation };
    let mut refinement = Refinement::try_new(problem, vec![Goal { request, most: 10.0 }]).unwrap();
    run(&mut refinement, &wave(), usize::MAX);
    assert_eq!(refinement.status(), RefinementStatus::Exhausted, "{:#?}", refinement.history());
}

#[test]
fn identity_a_grown_sample_holds_the_runs_of_a_plan_of_its_size() {
    let (problem, goals) = small(&[(Statistic::Quantile(QUANTILE), 0.01)]);
    let mut refinement = Refinement::try_new(problem.clone(), goals).unwrap();
    let table = run(&mut refinement, &wave(), usize::MAX);
    let grown = refinement.plan(&table).problem().sampling;
    assert!(grown.inner >= 4 * problem.sampling.inner, "{grown:?}");
    let key = |inputs: &RunInputs| (inputs.purpose, inputs.point, inputs.replicate, inputs.index);
    let keys: BTreeSet<_> = table.inputs().iter().map(key).collect();
    assert_eq!(keys.len(), table.len(), "no run is made twice");
    // The runs of the first points are those of a plan that begins with as many.
    let plan = DoubleLoop::try_new(Problem { sampling: Sampling { outer: 8, ..grown }, ..problem.clone() }).unwrap();
    let fresh = plan.next_round(&SampleTable::new(1)).unwrap();
    let fresh = fresh.iter().filter(|inputs| inputs.purpose == Purpose::DoubleLoop);
    let mut compared = 0;
    for wanted in fresh {
        let found = table.inputs().iter().find(|inputs| key(inputs) == key(wanted)).unwrap();
        assert_eq!((&found.random, &found.epistemic), (&wanted.random, &wanted.epistemic));
        compared += 1;
    }
    assert!(compared >= 4 * grown.inner, "{compared}");
}

#[test]
fn identity_the_same_number_of_rounds_gives_the_same_bits() {
    let goals = [(Statistic::Mean, 2e-3), (Statistic::Quantile(QUANTILE), 0.03)];
    let new = || {
        let (problem, goals) = small(&goals);
        Refinement::try_new(problem, goals).unwrap()
    };
    let mut whole = new();
    let rounds =
        run(&mut whole, &wave(), usize::MAX).inputs().iter().map(|inputs| inputs.round).max().unwrap() as usize;
    assert!(rounds > 8);
    // Ended after any round, also between the two parts of a sample that grows, there are results.
    for stop in 1..=rounds {
        let mut stopped = new();
        let mut table = run(&mut stopped, &wave(), stop);
        let results = stopped.results(&table).unwrap();
        assert_eq!(results.rounds as usize, stop);
        // One more round may be asked for and left.
        let _ = stopped.next_round(&table).unwrap();
        assert_eq!(bits(&stopped.results(&table).unwrap()), bits(&results));
        table = run(&mut new(), &wave(), stop);
        assert_eq!(bits(&stopped.results(&table).unwrap()), bits(&results));
    }
}

/// Seeds of the test of frequencies.
const SEEDS: u64 = 16;

#[test]
fn analytic_bounds_miss_as_rarely_as_stated_wherever_they_end() {
    // Five random inputs and a fold: the error falls hardly faster than that of independent runs, so that the end is decided by
    // an estimate of it. Y = u + 0.5 |sum of X|/√5; the mean of |Z| is √(2/π).
    let function = Function(|x: &[f64], u: &[f64]| u[0] + 0.5 * x.iter().sum::<f64>().abs() / 5_f64.sqrt());
    let centre = 0.5 * libm::sqrt(std::f64::consts::FRAC_2_PI);
    let (mut misses, mut runs) = (0, 0);
    for seed in 0..SEEDS {
        let (mut problem, goals) = small(&[(Statistic::Mean, 0.03)]);
        problem.random = vec![problem.random[0].clone(); 5];
        problem.sampling.seed = seed;
        problem.compared_columns.clear();
        let mut refinement = Refinement::try_new(problem, goals).unwrap();
        let table = run(&mut refinement, &function, usize::MAX);
        assert_eq!(refinement.status(), RefinementStatus::Reached);
        let pair = &refinement.results(&table).unwrap().pairs[0];
        misses += u32::from(pair.lower.widened > 0.1 + centre || pair.upper.widened < 1.3 + centre);
        runs += table.len();
    }
    // P(Binomial(16, 0.01) > 2) = 5e-4.
    assert!(misses <= 2, "{misses} of {SEEDS}, {} runs each", runs / SEEDS as usize);
}

#[test]
fn goals_that_no_run_helps_are_given_up() {
    let (problem, goals) = small(&[(Statistic::Mean, 0.01)]);
    let mut refinement = Refinement::try_new(problem, goals).unwrap();
    let table = run(&mut refinement, &Function(|_: &[f64], _: &[f64]| f64::NAN), usize::MAX);
    assert_eq!(refinement.status(), RefinementStatus::Exhausted);
    assert_eq!(refinement.history().len(), 1);
    assert!(refinement.history()[0].share.is_infinite());
    assert!(table.len() <= refinement.plan(&table).most_runs());
}

#[test]
fn identity_without_goals_there_is_the_plan_alone() {
    let (problem, _) = small(&[(Statistic::Mean, 0.01)]);
    let plan = DoubleLoop::try_new(problem.clone()).unwrap();
    let mut table = SampleTable::new(1);
    loop {
        let round = plan.next_round(&table).unwrap();
        if round.is_empty() {
            break;
        }
        execute(round, &wave(), &mut table).unwrap();
    }
    let mut refinement = Refinement::try_new(problem, Vec::new()).unwrap();
    let refined = run(&mut refinement, &wave(), usize::MAX);
    assert_eq!(refined.inputs(), table.inputs());
    assert_eq!((refinement.status(), refinement.history().len()), (RefinementStatus::Growing, 0));
}
