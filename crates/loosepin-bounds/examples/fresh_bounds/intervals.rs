//! How often the ends of the treatment that takes every input for an interval are missed, and how much too wide they are.
//!
//! The response is m of a problem, and s beside it, over its unit box. Half of the numbers are random, uniform from 0 to 1, so that their cut is the
//! whole interval; the others are unknown. So the exact ends are those of m and of s.

use super::fresh::Problem;
use super::{Options, quantile};
use loosepin_bounds::{
    DoubleLoop, Failure, Problem as Question, Request, Response, SampleTable, Sampling, Statistic, execute,
};
use loosepin_uncertainty::{Distribution, Interval, RandomVariable, hash};
use rayon::prelude::*;
use std::time::Instant;

/// An end that is short of the exact one by less than this share of the width is not missed: round-off of numbers about 1.
const ROUND_OFF: f64 = 1e-12;

/// Ends that are short by more than this share of the width are counted apart.
const FAR: f64 = 1e-3;

/// m and s over the unit box.
struct Parts<'p>(&'p Problem);

impl Response for Parts<'_> {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        let [m, s, _] = self.0.parts(&[random, epistemic].concat());
        columns.copy_from_slice(&[m, s]);
        Ok(())
    }
}

/// What one seed of one problem says.
struct Outcome {
    is_visible: bool,
    is_rough: bool,
    /// Of each column that varies: whether its ends are missed, how much of the width they are short of the exact ones at most, and by how much of
    /// it they are too wide.
    ends: Vec<([bool; 2], f64, f64)>,
    /// Rounds, runs of the treatment, and s of planning.
    rounds: usize,
    runs: usize,
    planning_s: f64,
}

/// Solves every problem and prints what was missed.
pub fn run(options: &Options) {
    let solve = |&(index, repetition): &(u64, u64)| outcome(options.seed, index, repetition);
    let outcomes: Vec<Outcome> = options.tasks().par_iter().map(solve).collect();
    println!(
        "{:24} {:>6} {:>6} {:>6} {:>6} {:>10} {:>10} {:>10} {:>10} {:>7} {:>6} {:>8}",
        "", "ends", "lower", "upper", "far", "furthest", "too wide", "mean", "90 %", "rounds", "runs", "plan, s"
    );
    for (is_visible, is_rough, name) in [
        (true, false, "visible, smooth"),
        (true, true, "visible, rough"),
        (false, false, "hidden, smooth"),
        (false, true, "hidden, rough"),
    ] {
        let is_own = |own: &&Outcome| own.is_visible == is_visible && own.is_rough == is_rough;
        let group: Vec<&Outcome> = outcomes.iter().filter(is_own).collect();
        let ends: Vec<_> = group.iter().flat_map(|own| &own.ends).collect();
        let missed = |end: usize| ends.iter().filter(|(missed, ..)| missed[end]).count();
        let far = ends.iter().filter(|(_, short, _)| *short > FAR).count();
        let furthest = ends.iter().fold(0.0_f64, |most, (_, short, _)| most.max(*short));
        let excess: Vec<f64> = ends.iter().map(|(.., excess)| *excess).collect();
        let mean =
            |of: &dyn Fn(&Outcome) -> f64| group.iter().map(|own| of(own)).sum::<f64>() / group.len().max(1) as f64;
        println!(
            "{name:24} {:6} {:6} {:6} {far:6} {furthest:10.1e} {:10.1e} {:10.3e} {:10.2e} {:7.1} {:6.1} {:8.4}",
            2 * ends.len(),
            missed(0),
            missed(1),
            quantile(&excess, 0.5),
            excess.iter().sum::<f64>() / excess.len().max(1) as f64,
            quantile(&excess, 0.9),
            mean(&|own| own.rounds as f64),
            mean(&|own| own.runs as f64),
            mean(&|own| own.planning_s),
        );
    }
}

fn outcome(seed: u64, index: u64, repetition: u64) -> Outcome {
    let problem = Problem::draw(seed, index);
    let random_count = problem.dimensions().div_ceil(2);
    let uniform = Distribution::Uniform { lower: 0.0, upper: 1.0 };
    let random = RandomVariable::try_new(uniform).expect("a distribution");
    let unknown = || Interval::try_new(0.0, 1.0).expect("an interval").into();
    let epistemic = (random_count..problem.dimensions()).map(|_| unknown()).collect();
    let request = |column| Request { column, statistic: Statistic::Mean };
    let mut question = Question::new(vec![random; random_count], epistemic, vec![request(0), request(1)]);
    question.compared_columns = vec![0, 1];
    // The runs of the double loop are few: what they find is of no use to the treatment.
    question.sampling = Sampling {
        outer: 17,
        inner: 16,
        mixture: 16,
        seed: hash(hash(seed, index), repetition) >> 32,
        ..Sampling::default()
    };
    let plan = DoubleLoop::try_new(question).expect("a plan");
    let (mut table, mut rounds, mut planning_s) = (SampleTable::new(2), 0, 0.0);
    loop {
        let begin = Instant::now();
        let round = plan.next_round(&table).expect("the next round");
        planning_s += begin.elapsed().as_secs_f64();
        if round.is_empty() {
            break;
        }
        rounds += 1;
        execute(round, &Parts(&problem), &mut table).expect("rows");
    }
    let bounds = plan.results(&table).expect("bounds");
    let ends = bounds.comparisons.iter().zip(problem.part_ends()).filter(|(_, [low, high])| high > low);
    let ends = ends.map(|(own, [low, high])| {
        let (band, width) = (&own.interval_only, high - low);
        let short = [band.lower.widened - low, high - band.upper.widened].map(|short| short / width);
        let allowed = ROUND_OFF * (1.0 + low.abs().max(high.abs()) / width);
        let excess = (band.upper.widened - band.lower.widened) / width - 1.0;
        (short.map(|short| short > allowed), short[0].max(short[1]).max(0.0), excess)
    });
    let is_own = |run: &&loosepin_bounds::RunInputs| run.purpose == loosepin_bounds::Purpose::Extreme;
    Outcome {
        is_visible: problem.is_visible(),
        is_rough: problem.is_rough(),
        ends: ends.collect(),
        rounds,
        runs: table.inputs().iter().filter(is_own).count(),
        planning_s,
    }
}
