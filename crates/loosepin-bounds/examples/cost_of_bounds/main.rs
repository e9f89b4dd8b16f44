//! Processor time of planning and of bounds, without that of any run: `cost_of_bounds [OUTER INNER POSES]`.
//!
//! A response like that of a worn pin: curves of POSES poses of three deviations, one of which is smooth in all inputs, one of which does not
//! depend on what is in intervals, and one with scatter that no model foresees; then the largest magnitude of the first. The digest is that
//! of every bound to the last bit: it must not change where only the time is to.

#![allow(clippy::disallowed_methods, reason = "a program of developers")]

use loosepin_bounds::{DoubleLoop, Failure, Problem, Request, Response, SampleTable, Statistic, execute};
use loosepin_uncertainty::{Distribution, Interval, RandomVariable, hash, normal};
use rayon::prelude::*;
use std::collections::hash_map::DefaultHasher;
use std::f64::consts::TAU;
use std::hash::{Hash, Hasher};

/// The response.
struct Curves {
    poses: usize,
}

impl Response for Curves {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        let (mut most, poses) = (0.0_f64, self.poses);
        let key = random.iter().chain(epistemic).fold(7, |key, number| hash(key, number.to_bits()));
        for pose in 0..poses {
            let angle = TAU * pose as f64 / poses as f64;
            let dimensional = random[0] * angle.cos() + random[1] * (2.0 * angle).sin();
            // Impacts: the later the pose, the more of it no model foresees.
            let unforeseen = normal(key, pose as u64) * angle / TAU;
            let clearance = epistemic[0] * ((angle + epistemic[1]).sin() + unforeseen + 0.1 * dimensional);
            columns[pose] = dimensional + clearance;
            columns[poses + pose] = dimensional;
            columns[2 * poses + pose] = clearance;
            most = most.max(columns[pose].abs());
        }
        columns[3 * poses] = most;
        Ok(())
    }
}

/// Nanoseconds for which the threads of this process have had a processor, as Linux tells them; 0 elsewhere.
fn processor_ns() -> u64 {
    let tasks = std::fs::read_dir("/proc/self/task").into_iter().flatten().flatten();
    let of_task = |task: std::fs::DirEntry| {
        let text = std::fs::read_to_string(task.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse::<u64>().ok()
    };
    tasks.filter_map(of_task).sum()
}

fn main() {
    let words: Vec<usize> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let [outer, inner, poses] =
        [(0, 64), (1, 256), (2, 180)].map(|(place, usual)| words.get(place).copied().unwrap_or(usual));
    let normal = |standard_deviation| {
        RandomVariable::try_new(Distribution::Normal { mean: 0.0, standard_deviation }).expect("a distribution")
    };
    let interval = |lower, upper| Interval::try_new(lower, upper).expect("an interval").into();
    let statistics =
        [Statistic::Mean, Statistic::StandardDeviation, Statistic::Quantile(0.025), Statistic::Quantile(0.975)];
    let of_column = |column| statistics.map(|statistic| Request { column, statistic });
    let mut requests: Vec<Request> = (0..=3 * poses).flat_map(of_column).collect();
    requests.push(Request { column: 3 * poses, statistic: Statistic::ProbabilityAbove(0.85) });
    requests.push(Request { column: 3 * poses, statistic: Statistic::Cdf });
    let mut problem =
        Problem::new(vec![normal(0.02), normal(0.03)], vec![interval(0.1, 0.5), interval(0.7, 0.9)], requests);
    problem.compared_columns = vec![3 * poses];
    (problem.sampling.outer, problem.sampling.inner) = (outer, inner);
    let columns = problem.columns;
    let plan = DoubleLoop::try_new(problem).expect("a plan");
    let response = Curves { poses };
    // Threads are there before the first time is read.
    (0..1000).into_par_iter().for_each(|_| std::hint::black_box(()));
    let (mut table, mut planning_ns, mut rounds) = (SampleTable::new(columns), 0, 0);
    loop {
        let begin = processor_ns();
        let round = plan.next_round(&table).expect("the next round");
        planning_ns += processor_ns() - begin;
        if round.is_empty() {
            break;
        }
        rounds += 1;
        execute(round, &response, &mut table).expect("rows");
    }
    let begin = processor_ns();
    let bounds = plan.results(&table).expect("bounds");
    let results_ns = processor_ns() - begin;
    let mut hasher = DefaultHasher::new();
    format!("{bounds:?}").hash(&mut hasher);
    let [planning, results] = [planning_ns, results_ns].map(|ns| 1e-6 * ns as f64);
    println!(
        "{} runs, {rounds} rounds: planning {planning:.0} ms, results {results:.0} ms, digest {:016x}",
        table.len(),
        hasher.finish()
    );
}
