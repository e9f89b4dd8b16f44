//! The runs that come next.

use std::collections::BTreeSet;

use super::double_loop::DoubleLoop;
use super::error::PlanError;
use super::inner_runs::{extreme_run, mixture_runs};
use super::steering::{SoughtExtremes, in_turn};
use crate::data::direction::Direction;
use crate::data::problem::{Reading, Request};
use crate::data::table::{Purpose, RunInputs, SampleTable};
use crate::estimators::pool::{Pool, PoolPoint};
use crate::measures::measure::Measure;
use crate::measures::of_statistic::{estimator, work_out};
use crate::parallel;
use crate::readings::experiment::Experiment;
use crate::readings::random_set::{run_target, values_by_run};
use crate::search::models::of_points::{MAX_LOCATED_TARGETS, Search};
use crate::search::models::shared_grids::SharedGrids;
use crate::search::search_box::BoxPoint;
use crate::search::target::Target;

/// After the first round, the remaining points are spent in this many rounds.
const REFINING_ROUNDS: usize = 6;

/// Reciprocal of the largest share of the points of a round that goes to the u of single runs.
const CALLED_SHARE: usize = 2;

/// Where each run may have its own u, so many inner runs of every column are searched, to this share of their range.
const SINGLE_RUNS: usize = 8;
const SINGLE_RUN_RESOLUTION: f64 = 1e-4;

impl DoubleLoop {
    /// The runs of the next round, in their order; empty when the plan is finished.
    ///
    /// Depends only on the problem and on the results in `table`, which must hold every run of the rounds before. These may be
    /// those of a plan of the same problem with smaller samples: then what its points lack comes first.
    ///
    /// # Errors
    ///
    /// [`PlanError::OtherColumns`] or [`PlanError::UnfinishedPoint`] where the table is not that.
    pub fn next_round(&self, table: &SampleTable) -> Result<Vec<RunInputs>, PlanError> {
        self.check_table(table)?;
        let round = table.rounds();
        if round == 0 {
            return Ok(self.first_round());
        }
        let outer = Pool::gather(table, Purpose::DoubleLoop, []);
        if let Some([replicates, each]) = self.smaller_sample(table, &outer) {
            let of_point = |point: &PoolPoint| self.runs_at(round, point.point, point.epistemic.clone());
            let wanted = outer.points.iter().flat_map(of_point);
            let mut runs: Vec<RunInputs> =
                wanted.filter(|inputs| inputs.replicate >= replicates || inputs.index >= each).collect();
            if self.setup.has_mixture() {
                runs.extend(mixture_runs(&self.setup, round).filter(|inputs| inputs.replicate >= replicates));
            }
            return Ok(runs);
        }
        self.check_points(&outer)?;
        let known = outer.points.len();
        let rest = self.problem().sampling.outer.saturating_sub(known);
        let mut runs = Vec::new();
        if !self.setup.has_no_epistemic_inputs() && rest > 0 {
            let count = rest.min(points_per_round(self.problem().sampling.outer, &self.first_outer));
            for place in self.next_outer(table, round, count) {
                let point = (known + runs.len() / self.inner_runs()) as u32;
                runs.extend(self.runs_at(round, point, self.setup.epistemic_box.values_at(&place)));
            }
        }
        if self.setup.has_extremes() {
            let extremes = Pool::gather(table, Purpose::Extreme, self.problem().compared_columns.iter().copied());
            let rest = self.problem().sampling.extreme.saturating_sub(extremes.points.len());
            let count = rest.min(points_per_round(self.problem().sampling.extreme, &self.first_extreme));
            if count > 0 {
                let next = self.next_extremes(table, &extremes, count);
                let known = extremes.points.len();
                runs.extend(
                    next.iter()
                        .enumerate()
                        .map(|(i, place)| extreme_run(&self.setup, round, (known + i) as u32, place)),
                );
            }
        }
        Ok(runs)
    }

    fn first_round(&self) -> Vec<RunInputs> {
        let mut runs: Vec<RunInputs> = Vec::new();
        for (point, place) in self.first_outer.iter().enumerate() {
            runs.extend(self.runs_at(0, point as u32, self.setup.epistemic_box.values_at(place)));
        }
        if self.setup.has_mixture() {
            runs.extend(mixture_runs(&self.setup, 0));
        }
        if self.setup.has_extremes() {
            let first = self.first_extreme.iter().enumerate();
            runs.extend(first.map(|(point, place)| extreme_run(&self.setup, 0, point as u32, place)));
        }
        runs
    }

    /// At most `count` outer points of `round`.
    fn next_outer(&self, table: &SampleTable, round: u32, count: usize) -> Vec<BoxPoint> {
        let searched = &in_turn(self.setup.searched(), round)[..];
        // A row is read once for all of its columns.
        let pool = Pool::gather(table, Purpose::DoubleLoop, self.setup.needed_columns());
        // Of curves only the bounds themselves are worth the time that polynomials take, the search is not.
        let is_curve = searched.len() > MAX_LOCATED_TARGETS;
        let pool = &if is_curve { pool } else { pool.with_kept_polynomials(self.setup.inner_basis()) };
        let points = self.setup.outer_places(pool);
        // Quantiles of several elements together end where the probabilities of all of them add up. For curves, whose targets are
        // many, the quantiles of each element have to do.
        let has_joint_quantiles =
            self.setup.structure.widest().elements.len() > 1 && searched.len() <= MAX_LOCATED_TARGETS;
        let is_joint = |request: &Request| {
            has_joint_quantiles
                && request.statistic.probability_of_quantile().is_some()
                && self.problem().requests.contains(request)
        };
        let requests: Vec<Request> = searched.iter().map(|(request, _)| *request).collect();
        work_out(pool, &requests, &self.setup.confidence);
        let mut targets = parallel::flat_map(searched, |(request, directions)| {
            if is_joint(request) {
                return Vec::new();
            }
            let samples = pool.samples(request.column);
            let measure = estimator(request.statistic).map(|of| of.measure(&samples, &self.setup.confidence));
            let targets = measure.into_iter().flat_map(Measure::into_targets);
            targets.map(|target| (target, directions.clone())).collect()
        });
        if has_joint_quantiles {
            targets.extend(Experiment::new(&self.setup, pool, table).joint_quantile_targets());
        }
        if targets.len() < MAX_LOCATED_TARGETS {
            let squares = Experiment::new(&self.setup, pool, table).square_targets();
            // So many that the others would be taken for a curve are left out.
            if targets.len() + squares.len() <= MAX_LOCATED_TARGETS {
                targets.extend(squares);
            }
        }
        let mut readings =
            std::iter::once(self.problem().reading).chain(self.problem().readings_beside.iter().copied());
        if readings.any(|reading| reading == Reading::RandomSet) {
            targets.extend(self.single_runs(table, searched));
        }
        let grids = SharedGrids::after(table, Purpose::DoubleLoop);
        let search = Search::sharing(
            &grids,
            self.setup.epistemic_box.axes(),
            &points,
            &self.setup.candidates,
            targets.iter().map(|(target, _)| target),
        );
        let called = self.called_places(table, pool, searched, (&search, &grids), count / CALLED_SHARE);
        let next = search.next_places(&targets, &self.searched_elements, count);
        let places = search.new_places(called.into_iter().chain(next), count);
        grids.keep(table, Purpose::DoubleLoop);
        places
    }

    /// The response itself at some of the inner runs: where every sample may have its own u, their extremes are wanted.
    fn single_runs(&self, table: &SampleTable, searched: &[SoughtExtremes]) -> Vec<(Target, Vec<Direction>)> {
        let of_column = |column: usize| {
            let (replicates, points) = values_by_run(table, column);
            let step = replicates.len().div_ceil(SINGLE_RUNS).max(1);
            let runs = (0..replicates.len()).step_by(step);
            let targets = runs.map(move |run| {
                let target = run_target(&points, run, f64::MIN_POSITIVE);
                let resolution = (SINGLE_RUN_RESOLUTION * target.range()).max(f64::MIN_POSITIVE);
                (run_target(&points, run, resolution), Direction::BOTH.to_vec())
            });
            targets.collect::<Vec<_>>()
        };
        let columns: BTreeSet<usize> = searched.iter().map(|(request, _)| request.column).collect();
        columns.into_iter().flat_map(of_column).collect()
    }

    fn next_extremes(&self, table: &SampleTable, pool: &Pool, count: usize) -> Vec<BoxPoint> {
        let points = self.setup.extreme_places(pool);
        let targets: Vec<(Target, Vec<Direction>)> = self
            .problem()
            .compared_columns
            .iter()
            .map(|&column| (self.setup.extreme_target(pool, column), Direction::BOTH.to_vec()))
            .collect();
        let grids = SharedGrids::after(table, Purpose::Extreme);
        let search = Search::sharing(
            &grids,
            self.setup.joint_box.axes(),
            &points,
            &self.setup.joint_candidates,
            targets.iter().map(|(target, _)| target),
        );
        let places = search.filled_places(&targets, &self.whole_joint_box, count);
        grids.keep(table, Purpose::Extreme);
        places
    }

    /// Replicates, and runs in each, at the outer points of `pool`, where the plan has more of either: `table` is then that of a
    /// plan with a smaller sample, whose runs are the first ones of these.
    fn smaller_sample(&self, table: &SampleTable, pool: &Pool) -> Option<[u32; 2]> {
        let known = pool.points.first()?;
        let own = table.inputs().iter().filter(|inputs| inputs.purpose == Purpose::DoubleLoop);
        let [replicates, each] =
            own.filter(|inputs| inputs.point == known.point).fold([0; 2], |[replicates, each], inputs| {
                [replicates.max(inputs.replicate + 1), each.max(inputs.index + 1)]
            });
        let is_whole = known.runs == replicates as usize * each as usize;
        let is_smaller = known.runs < self.inner_runs() && replicates as usize <= self.problem().sampling.replicates;
        let is_same = |point: &PoolPoint| point.runs == known.runs;
        (is_whole && is_smaller && pool.points.iter().all(is_same)).then_some([replicates, each])
    }
}

/// Points of a round after the first one.
fn points_per_round(budget: usize, first: &[BoxPoint]) -> usize {
    (budget - first.len()).div_ceil(REFINING_ROUNDS)
}
