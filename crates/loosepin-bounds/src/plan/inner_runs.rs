//! Runs at the points of a plan.

use std::sync::OnceLock;

use crate::data::points::{inner_points, mixture_points};
use crate::data::table::{Purpose, RunInputs};
use crate::readings::setup::Setup;
use crate::search::search_box::BoxPoint;
use loosepin_uncertainty::{QuantileLevel, RandomVariable};

/// A point of the random inputs, the same at every u (common random numbers).
#[derive(Debug, Clone)]
struct InnerRun {
    replicate: u32,
    index: u32,
    /// Values of the random inputs; of those that move, at no particular u.
    random: Vec<f64>,
    /// Quantile levels of those that move.
    levels: Vec<QuantileLevel>,
}

/// Inner runs, each computed on first use: a sample of millions is planned in no time.
#[derive(Debug, Clone)]
pub(crate) struct InnerRuns {
    runs: OnceLock<Vec<InnerRun>>,
    /// The random inputs whose values differ from one u to another, since parameters are among the epistemic inputs.
    moving: Vec<usize>,
}

impl InnerRuns {
    /// The inner runs of `setup`.
    pub fn new(setup: &Setup) -> Self {
        Self { runs: OnceLock::new(), moving: setup.problem.inputs_with_parameters() }
    }

    /// Every inner run at the outer point `point`.
    pub fn at(&self, setup: &Setup, round: u32, point: u32, epistemic: Vec<f64>) -> impl Iterator<Item = RunInputs> {
        let moved: Vec<(usize, Option<RandomVariable>)> =
            self.moving.iter().map(|&input| (input, setup.problem.variable_at(input, &epistemic))).collect();
        let runs = self.runs.get_or_init(|| self.all(setup));
        runs.iter().map(move |run| {
            let mut random = run.random.clone();
            for ((input, variable), &level) in moved.iter().zip(&run.levels) {
                random[*input] = variable.as_ref().map_or(f64::NAN, |variable| variable.at(level));
            }
            let (purpose, epistemic) = (Purpose::DoubleLoop, epistemic.clone());
            RunInputs { round, purpose, point, replicate: run.replicate, index: run.index, random, epistemic }
        })
    }

    /// The first of them at the outer point `point` of the first round, without working out the others.
    pub fn first(&self, setup: &Setup, most: usize, point: u32, epistemic: Vec<f64>) -> Vec<RunInputs> {
        let first = Self { runs: OnceLock::from(self.drawn(setup, most)), moving: self.moving.clone() };
        first.at(setup, 0, point, epistemic).collect()
    }

    /// All of them.
    fn all(&self, setup: &Setup) -> Vec<InnerRun> {
        self.drawn(setup, usize::MAX)
    }

    /// The first of them; a single one where nothing is random.
    fn drawn(&self, setup: &Setup, most: usize) -> Vec<InnerRun> {
        let problem = &setup.problem;
        if problem.random.is_empty() {
            return vec![InnerRun { replicate: 0, index: 0, random: Vec::new(), levels: Vec::new() }];
        }
        let run = |(replicate, index, point): (u32, u32, Vec<f64>)| {
            let levels = problem.levels(&point);
            InnerRun {
                replicate,
                index,
                random: problem.random.iter().zip(&levels).map(|(variable, &level)| variable.at(level)).collect(),
                levels: self.moving.iter().map(|&input| levels[input]).collect(),
            }
        };
        inner_points(&problem.sampling, &setup.inner).take(most).map(run).collect()
    }
}

/// The runs of the probability-only treatment.
pub(crate) fn mixture_runs(setup: &Setup, round: u32) -> impl Iterator<Item = RunInputs> {
    let problem = &setup.problem;
    mixture_points(&problem.sampling, &setup.mixture).map(move |(replicate, index, point)| {
        let (random, epistemic) = point.split_at(problem.random.len());
        let epistemic = problem.epistemic.iter().zip(epistemic);
        let epistemic: Vec<f64> = epistemic.map(|(variable, &fraction)| variable.at(fraction)).collect();
        let random = problem.random_at(&epistemic, &problem.levels(random));
        RunInputs { round, purpose: Purpose::Mixture, point: 0, replicate, index, random, epistemic }
    })
}

/// The run at a place of the joint box.
pub(crate) fn extreme_run(setup: &Setup, round: u32, point: u32, place: &BoxPoint) -> RunInputs {
    let mut random = setup.joint_box.values_at(place);
    let epistemic = random.split_off(setup.problem.random.len());
    RunInputs { round, purpose: Purpose::Extreme, point, replicate: 0, index: 0, random, epistemic }
}
