//! The three treatments on the surrogates of a group.
//!
//! Every treatment goes over ŝ and over both ends of its band ŝ ± kσ. An end of a treatment's band lies on ŝ; the furthest of the same end
//! over all three is what it can be when the surrogate errs by kσ to the same side everywhere. The share inside is that of ŝ; how much
//! smaller it can be is the least share of ŝ - kσ and of ŝ + kσ in the same band.
//!
//! Extremes lie where few runs were learned from: a direct run at each of them tells how far ŝ is off there, and k grows for
//! interval-only bands until it is so far.

use super::learned::LearnedGroup;
use super::plan::SurrogatePlan;
use super::response::{Aspect, BandResponse, LearnedFunction};
use crate::data::bound::{Bound, BoundError, Guarantee};
use crate::data::direction::Direction;
use crate::data::problem::Problem;
use crate::data::table::{Purpose, RunInputs, SampleTable};
use crate::estimators::pool::Pool;
use crate::plan::double_loop::DoubleLoop;
use crate::plan::evaluate::{EvaluateError, Response, execute_all};
use crate::readings::coverage::Coverage;
use crate::readings::treatment::{Band, TreatmentComparison};

/// Aspects that are compared: the surrogate, and both ends of its band.
const ASKED: [Aspect; 3] = [Aspect::Value, Aspect::Low, Aspect::High];

/// The three treatments of the numbers of a group.
#[derive(Debug, Clone)]
pub struct LearnedTreatments {
    /// One entry for each compared column. Ends have their part `surrogate` of the error.
    pub comparisons: Vec<LearnedComparison>,
    /// Values of the epistemic inputs, in the order of the outer index of the shares inside: probability only, interval only, mixed.
    pub outer_points: [Vec<Vec<f64>>; 3],
}

/// One column by the three treatments.
#[derive(Debug, Clone)]
pub struct LearnedComparison {
    /// The bands on the surrogate.
    pub comparison: TreatmentComparison,
    /// Largest decrease of the least share inside by the error of the surrogate: probability only, interval only, mixed.
    pub coverage_surrogate: [f64; 3],
}

/// The treatments of `group` where the surrogate errs by `reach` standard deviations; `None` if nothing was learned or compared.
pub(crate) fn treatments(
    plan: &SurrogatePlan,
    group: &LearnedGroup,
    reach: f64,
) -> Result<Option<LearnedTreatments>, EvaluateError> {
    let Ok(surrogates) = &group.surrogates else { return Ok(None) };
    let direct = plan.problem();
    let columns = &group.group.columns;
    let is_compared = |place: &usize| direct.compared_columns.contains(&columns[*place]);
    let places: Vec<usize> = (0..columns.len()).filter(is_compared).collect();
    if places.is_empty() {
        return Ok(None);
    }
    let column_of = |slot: usize, aspect| slot * Aspect::ALL.len() + Aspect::position(aspect);
    let problem = Problem {
        columns: places.len() * Aspect::ALL.len(),
        requests: Vec::new(),
        compared_columns: (0..places.len()).flat_map(|slot| ASKED.map(|aspect| column_of(slot, aspect))).collect(),
        percentiles: Vec::new(),
        readings_beside: Vec::new(),
        ..direct.clone()
    };
    let response = BandResponse::new(LearnedFunction { plan, surrogates, places: &places }, reach).at_least_own();
    let double_loop = DoubleLoop::try_new(problem)?;
    let table = execute_all(&double_loop, &response)?;
    let bounds = double_loop.results(&table)?;
    let pool = Pool::gather(&table, Purpose::DoubleLoop, double_loop.setup.needed_columns());
    let pool = double_loop.setup.with_polynomials(pool, &table);
    let shares = double_loop.setup.shares_of_mechanisms(&pool);
    // Where the surrogate gave no answer inside the box it was not looked at: nothing bounds the extremes.
    let is_extreme = |run: &usize| table.inputs()[*run].purpose == Purpose::Extreme;
    let has_gaps = (0..table.len()).filter(is_extreme).any(|run| table.failure(run).is_some());
    let of_aspect = |slot, aspect| bounds.comparisons.iter().find(|found| found.column == column_of(slot, aspect));
    let comparison = |(slot, &place): (usize, &usize)| {
        let found: Vec<&TreatmentComparison> =
            ASKED.into_iter().map(|aspect| of_aspect(slot, aspect)).collect::<Option<_>>()?;
        let (own, band_columns) = (found[0], ASKED.map(|aspect| column_of(slot, aspect)));
        let of_all = |of: fn(&TreatmentComparison) -> &Band| found.iter().map(|each| of(each)).collect::<Vec<&Band>>();
        let put = |of: fn(&TreatmentComparison) -> &Band, has_gaps| with_error(&of_all(of), has_gaps);
        let share = |band: &Band| {
            let least = band_columns.map(|column| {
                let ends = [&band.lower, &band.upper].map(|end| end.value);
                Coverage::of_band(&pool, column, ends, &shares, &double_loop.setup.confidence).minimum
            });
            let lost = band.coverage.minimum - least.into_iter().fold(f64::INFINITY, f64::min);
            if lost.is_nan() { 1.0 } else { lost.max(0.0) }
        };
        let bands = [&own.probability_only, &own.interval_only, &own.mixed];
        Some(LearnedComparison {
            coverage_surrogate: bands.map(share),
            comparison: TreatmentComparison {
                column: columns[place],
                probability: own.probability,
                probability_only: put(|all| &all.probability_only, false),
                interval_only: put(|all| &all.interval_only, has_gaps),
                mixed: put(|all| &all.mixed, false),
            },
        })
    };
    let comparisons = places.iter().enumerate().filter_map(comparison).collect();
    Ok(Some(LearnedTreatments { comparisons, outer_points: [(); 3].map(|()| bounds.outer_points.clone()) }))
}

/// The first of `bands`, that on ŝ, whose ends can go as far as those of the others.
fn with_error(bands: &[&Band], has_gaps: bool) -> Band {
    let end = |of: fn(&Band) -> &Bound, direction: Direction| {
        let sign = direction.sign();
        let own = of(bands[0]);
        let furthest = bands.iter().map(|band| sign * of(band).widened).fold(f64::NEG_INFINITY, f64::max);
        let known = own.error.sampling + own.error.optimisation;
        let values = bands.iter().map(|band| sign * of(band).value).fold(f64::NEG_INFINITY, f64::max);
        // Where too few runs bound the end by themselves, what the surrogate adds is told by the values.
        let furthest = if known.is_finite() { furthest - known } else { values };
        let surrogate = furthest - sign * own.value;
        let surrogate = if has_gaps || surrogate.is_nan() { f64::INFINITY } else { surrogate.max(0.0) };
        let error = BoundError { surrogate, ..own.error };
        Bound { widened: own.value + sign * error.total(), error, guarantee: Guarantee::unconfirmed(), ..own.clone() }
    };
    let lower = end(|band| &band.lower, Direction::Minimum);
    let upper = end(|band| &band.upper, Direction::Maximum);
    Band { lower, upper, ..bands[0].clone() }
}

/// Direct runs at the extremes of the interval-only bands of `all`, as round `round`.
pub(crate) fn extreme_runs<'t>(all: impl Iterator<Item = &'t LearnedTreatments>, round: u32) -> Vec<RunInputs> {
    let mut runs: Vec<RunInputs> = Vec::new();
    for learned in all.flat_map(|treatments| &treatments.comparisons) {
        let band = &learned.comparison.interval_only;
        for witness in [&band.lower, &band.upper].into_iter().filter_map(|end| end.witness.as_ref()) {
            let (random, epistemic) = (witness.random.clone(), witness.epistemic.clone());
            let has_all = random.len() + epistemic.len() > 0 && random.iter().chain(&epistemic).all(|x| x.is_finite());
            if has_all && runs.iter().all(|run| (&run.random, &run.epistemic) != (&random, &epistemic)) {
                let (purpose, index) = (Purpose::Confirming, runs.len() as u32);
                runs.push(RunInputs { round, purpose, point: 0, replicate: 0, index, random, epistemic });
            }
        }
    }
    runs
}

/// The largest error of the surrogates of `group`, in σ, at the runs of `table` from `first` on; 0 without runs.
pub(crate) fn largest_ratio(plan: &SurrogatePlan, group: &LearnedGroup, table: &SampleTable, first: usize) -> f64 {
    let Ok(surrogates) = &group.surrogates else { return 0.0 };
    let columns = &group.group.columns;
    let places: Vec<usize> = (0..columns.len()).collect();
    let band = BandResponse::new(LearnedFunction { plan, surrogates, places: &places }, 1.0).at_least_own();
    let ratio = |run: usize| {
        let inputs = &table.inputs()[run];
        let mut row = vec![f64::NAN; places.len() * Aspect::ALL.len()];
        if band.evaluate(&inputs.random, &inputs.epistemic, &mut row).is_err() {
            return 0.0;
        }
        let of_place = |(place, learned): (usize, &[f64])| {
            let direct = table.values(run)[columns[place]];
            let (value, high) = (learned[Aspect::Value.position()], learned[Aspect::High.position()]);
            // An error of round-off where nothing was left is none.
            let deviation = (high - value).max(1e-12 * direct.abs());
            if direct.is_finite() && deviation > 0.0 { (direct - value).abs() / deviation } else { 0.0 }
        };
        row.chunks(Aspect::ALL.len()).enumerate().map(of_place).fold(0.0, f64::max)
    };
    (first..table.len()).map(ratio).fold(0.0, f64::max)
}
