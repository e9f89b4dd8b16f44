use crate::Function;
use crate::cases::exact::{STANDARD_NORMAL, problem};
use crate::plan::double_loop::{DoubleLoop, PlanError};
use crate::{Problem, ProblemError, Purpose, Request, SampleTable, Sampling, Statistic, execute};
use loosepin_uncertainty::RandomVariable;

fn sum() -> Function<impl Fn(&[f64], &[f64]) -> f64 + Sync> {
    Function(|x: &[f64], u: &[f64]| x[0] + libm::sin(3.0 * u[0]) * u[1])
}

fn small() -> Problem {
    let statistics = [Statistic::Mean, Statistic::Quantile(0.9), Statistic::Cdf];
    let mut problem = problem(&[STANDARD_NORMAL], &[(-0.7, 1.3), (0.2, 0.9)], &statistics);
    problem.compared_columns = vec![0];
    problem.sampling = Sampling { outer: 24, inner: 32, mixture: 64, extreme: 40, seed: 5, ..Sampling::default() };
    problem
}

fn refused(change: impl Fn(&mut Problem)) -> String {
    let mut problem = small();
    change(&mut problem);
    DoubleLoop::try_new(problem).unwrap_err().to_string()
}

#[test]
fn identity_rounds_depend_on_the_results_of_earlier_rounds_alone() {
    let plan = DoubleLoop::try_new(small()).unwrap();
    let mut table = SampleTable::new(1);
    let mut rounds = 0;
    loop {
        let round = plan.next_round(&table).unwrap();
        // A plan made anew, and a table put together anew from stored rows, go on in the same way.
        let mut stored = SampleTable::new(1);
        for (run, inputs) in table.inputs().iter().enumerate() {
            stored.push(inputs.clone(), Ok(table.values(run))).unwrap();
        }
        assert_eq!(DoubleLoop::try_new(small()).unwrap().next_round(&stored).unwrap(), round);
        if round.is_empty() {
            break;
        }
        assert!(round.iter().all(|inputs| inputs.round == rounds));
        rounds += 1;
        execute(round, &sum(), &mut table).unwrap();
    }
    assert!(rounds > 1 && table.len() <= plan.most_runs());
    assert_eq!(plan.results(&table).unwrap().rounds, rounds);
}

#[test]
fn identity_the_first_runs_are_drawn_without_the_others() {
    let plan = DoubleLoop::try_new(small()).unwrap();
    let round = plan.next_round(&SampleTable::new(1)).unwrap();
    assert_eq!(plan.first_runs(1, 5, |_| true), round[..5]);
    // The third outer point begins after two times 32 runs.
    let third = round[64].epistemic.clone();
    assert_eq!(plan.first_runs(2, 1000, |epistemic| epistemic == third), round[64..96]);
    // Samples that no memory holds.
    let mut large = small();
    large.sampling.inner = 1 << 30;
    assert_eq!(DoubleLoop::try_new(large).unwrap().first_runs(1, 2, |_| true).len(), 2);
}

#[test]
fn identity_the_inner_points_are_the_same_at_every_outer_point() {
    let plan = DoubleLoop::try_new(small()).unwrap();
    let round = plan.next_round(&SampleTable::new(1)).unwrap();
    let random_at = |point: u32| -> Vec<u64> {
        let runs = round.iter().filter(|inputs| inputs.purpose == Purpose::DoubleLoop && inputs.point == point);
        runs.map(|inputs| inputs.random[0].to_bits()).collect()
    };
    assert_eq!(random_at(0).len(), 32);
    assert_eq!(random_at(0), random_at(7));
}

#[test]
fn identity_the_centre_is_where_it_is_said_to_be() {
    let plan = DoubleLoop::try_new(small()).unwrap();
    let round = plan.next_round(&SampleTable::new(1)).unwrap();
    let centre = round.iter().find(|inputs| inputs.point == plan.centre_point()).unwrap();
    const TOLERANCE: f64 = 1e-15;
    assert!((centre.epistemic[0] - 0.3).abs() < TOLERANCE && (centre.epistemic[1] - 0.55).abs() < TOLERANCE);
}

#[test]
fn an_unfinished_round_is_refused() {
    let plan = DoubleLoop::try_new(small()).unwrap();
    let mut round = plan.next_round(&SampleTable::new(1)).unwrap();
    round.remove(3);
    let mut table = SampleTable::new(1);
    execute(round, &sum(), &mut table).unwrap();
    assert_eq!(
        plan.next_round(&table).unwrap_err().to_string(),
        "point 0 has 31 runs; its plan has 32\nhint: add all runs of a round before asking for the next"
    );
    assert_eq!(plan.results(&SampleTable::new(1)).unwrap_err(), PlanError::NoRuns);
    assert_eq!(
        plan.next_round(&SampleTable::new(3)).unwrap_err().to_string(),
        "the table has 3 columns; the problem has 1"
    );
}

#[test]
fn each_broken_rule_is_told_with_its_numbers() {
    assert_eq!(
        refused(|problem| problem.requests.push(Request { column: 4, statistic: Statistic::Mean })),
        "request 3 asks for column 4; the response has 1 columns, counted from 0"
    );
    assert_eq!(
        refused(|problem| problem.requests[1].statistic = Statistic::Quantile(1.0)),
        "quantile 1; must lie between 0 and 1, both excluded"
    );
    assert_eq!(
        refused(|problem| problem.requests[1].statistic = Statistic::SimultaneousBand(0.9)),
        "request 1 asks for a simultaneous band of a single column; such a band belongs to the columns of a curve\n\
         hint: `DoubleLoop::simultaneous_band` gives it from the finished runs"
    );
    assert_eq!(
        refused(|problem| problem.requests[1].statistic = Statistic::ProbabilityBeyond(-0.1)),
        "limit -0.1 of a probability; must be finite, and >= 0 where it limits a magnitude"
    );
    assert_eq!(
        refused(|problem| problem.sampling.inner = 100),
        "inner 100; must be a multiple of the 8 replicates, at least 2 runs in each, at most 2^31\n\
         hint: 8 times a power of two is best"
    );
    assert_eq!(
        refused(|problem| problem.sampling.outer = 3),
        "outer 3; the corners and the centre of a box with 2 inputs need at least 5\nhint: 64 is a good start"
    );
    assert_eq!(
        refused(|problem| problem.sampling.confidence = 1.0),
        "confidence 1; must lie between 0 and 1, both excluded"
    );
    assert_eq!(
        refused(|problem| problem.sampling.replicates = 1),
        "1 replicates; must be at least 2\nhint: 8 give a useful estimate of the sampling error"
    );
    assert_eq!(
        refused(|problem| problem.cut_standard_deviations = f64::NAN),
        "cut at NaN standard deviations; must be > 0 and at most 8"
    );
    assert_eq!(
        refused(|problem| problem.random = vec![RandomVariable::try_new(STANDARD_NORMAL).unwrap(); 300]),
        "302 uncertain inputs; at most 256\nhint: fix the inputs that matter least"
    );
    assert!(matches!(
        DoubleLoop::try_new(Problem { sampling: Sampling { outer: 5_000_000, ..small().sampling }, ..small() }),
        Err(PlanError::Problem(ProblemError::TooManyPoints { most: 1_048_576, .. }))
    ));
}

#[test]
fn identity_a_pilot_has_the_first_runs_of_its_plan() {
    let mut problem = small();
    problem.sampling.inner = 128;
    let plan = DoubleLoop::try_new(problem).unwrap();
    let all = plan.next_round(&SampleTable::new(1)).unwrap();
    let pilot = plan.draft(|request| request.statistic == Statistic::Mean).unwrap().pilot(all.len() / 4).unwrap();
    let first = pilot.next_round(&SampleTable::new(1)).unwrap();
    assert!(!first.is_empty() && first.len() <= all.len() / 4, "{} of {}", first.len(), all.len());
    assert!(first.iter().all(|inputs| all.contains(inputs)));
    let mut table = SampleTable::new(1);
    execute(first, &sum(), &mut table).unwrap();
    assert_eq!(pilot.results(&table).unwrap().pairs.len(), 1);
    assert_eq!(plan.pilot(usize::MAX).unwrap().inner_runs() * 4, plan.inner_runs());
    // A plan that is no larger needs none; what asks for nothing has no draft.
    assert!(pilot.pilot(usize::MAX).unwrap().pilot(usize::MAX).is_none());
    assert!(plan.draft(|_| false).is_none());
}
