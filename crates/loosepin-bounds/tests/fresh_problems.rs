//! Problems that are drawn from a seed: are their exact bounds exact, and does the program hold them? The long version, with another seed
//! each time, is `just campaign fresh-bounds`.

#[allow(dead_code, reason = "the campaign reads the rest of it")]
mod fresh;

use fresh::{Exact, Problem};
use loosepin_bounds::{Sampling, Statistic, evaluate};
use loosepin_uncertainty::{hash, uniform};
use rayon::prelude::*;
use std::sync::LazyLock;

/// Of the set that each commit is tested with. The search was developed with other ones.
const SEED: u64 = 20_261_123;
/// They are drawn once for all tests.
static PROBLEMS: LazyLock<Vec<Problem>> =
    LazyLock::new(|| (0..150_u64).into_par_iter().map(|index| Problem::draw(SEED, index)).collect());

/// A place of the unit box.
fn place(key: u64, point: u64, dimensions: usize) -> Vec<f64> {
    (0..dimensions as u64).map(|axis| uniform(hash(key, point), axis)).collect()
}

#[test]
fn analytic_the_ends_of_location_spread_and_shape_are_attained_together() {
    /// Of the places on both sides of an edge, which are 1e-14 from it.
    const TOLERANCE: f64 = 1e-10;
    for (index, problem) in (0..).zip(PROBLEMS.iter()) {
        let ends = problem.part_ends();
        for corner in (0..8).map(|corner| [corner & 1, corner >> 1 & 1, corner >> 2 & 1]) {
            let Some(place) = problem.corner(corner) else { continue };
            let parts = problem.parts(&place);
            for ((part, end), ends) in parts.into_iter().zip(corner).zip(ends) {
                let allowed = TOLERANCE * (ends[1] - ends[0]) + 1e-14 * ends[end].abs();
                assert!((part - ends[end]).abs() <= allowed, "{index}: {part} at end {end} of {ends:?}: {problem:?}");
            }
        }
    }
}

/// In one and two dimensions so many places come near to every extreme that is not narrower than they are dense.
#[test]
fn analytic_no_place_of_the_box_lies_beyond_the_exact_ends_and_some_come_near() {
    const PLACES: u64 = 10_000;
    /// Of numbers about 1.
    const ROUND_OFF: f64 = 1e-12;
    /// Share of the range of m, s or k that places leave out, in one and two dimensions: the narrowest visible bump of height
    /// 1 and width 0.04 in two dimensions is missed by 0.5 %, beside it a slope.
    const LEFT_OUT: f64 = 0.05;
    let mut compared = 0;
    for (index, problem) in (0..).zip(PROBLEMS.iter()) {
        let ends = problem.part_ends();
        let mut seen = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for point in 0..PLACES {
            let parts = problem.parts(&place(index, point, problem.dimensions()));
            for ((seen, part), [low, high]) in seen.iter_mut().zip(parts).zip(ends) {
                let allowed = ROUND_OFF * (1.0 + low.abs().max(high.abs()));
                let is_inside = low - allowed <= part && part <= high + allowed;
                assert!(is_inside, "{index}: {part} is outside of [{low}, {high}]: {problem:?}");
                *seen = [seen[0].min(part), seen[1].max(part)];
            }
        }
        for ([seen_low, seen_high], [low, high]) in seen.into_iter().zip(ends) {
            if problem.dimensions() <= 2 && problem.is_visible() {
                compared += 1;
                let left_out = (seen_low - low).max(high - seen_high);
                assert!(
                    left_out <= LEFT_OUT * (high - low) + ROUND_OFF,
                    "{index}: [{low}, {high}], seen to {seen_low}, {seen_high}: {problem:?}"
                );
            }
        }
    }
    assert!(compared > 60, "{compared}");
}

/// The statistics of many runs at a few places of the box lie between the exact ends, and at each they lie where the formulas say.
#[test]
fn analytic_statistics_of_many_runs_lie_between_the_exact_ends() {
    const PLACES: u64 = 2;
    const RUNS: u64 = 4_000;
    /// So many standard errors; of the deviation of a lognormal number with σ = 1.5 these are themselves not known from so few runs, so
    /// a quarter of the value is allowed beside.
    const STANDARD_ERRORS: f64 = 6.0;
    for (index, problem) in (0..).zip(PROBLEMS.iter()) {
        for point in 0..PLACES {
            let values = problem.runs(&place(index, point, problem.dimensions()), RUNS);
            for exact in &problem.exact {
                let (value, error) = estimate(&values, exact.statistic);
                let heavy = if problem.has_heavy_tail() { 0.25 * value.abs() } else { 0.0 };
                let allowed = STANDARD_ERRORS * error + heavy + 1e-9 * exact.magnitude;
                let is_inside = exact.ends[0] - allowed <= value && value <= exact.ends[1] + allowed;
                assert!(is_inside, "{index}: {value} ± {error} is outside of {exact:?}: {problem:?}");
            }
        }
    }
}

/// A statistic of runs and its standard error.
fn estimate(values: &[f64], statistic: Statistic) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let moment = |power: i32| values.iter().map(|value| (value - mean).powi(power)).sum::<f64>() / count;
    let share = |holds: &dyn Fn(f64) -> bool| {
        let share = values.iter().filter(|value| holds(**value)).count() as f64 / count;
        // One run more or less where none or all hold.
        (share, (share * (1.0 - share) / count).sqrt() + 1.0 / count)
    };
    match statistic {
        Statistic::Mean => (mean, (moment(2) / count).sqrt()),
        Statistic::StandardDeviation => {
            let deviation = moment(2).sqrt();
            let error = ((moment(4) - moment(2) * moment(2)).max(0.0) / count).sqrt();
            (deviation, if deviation > 0.0 { 0.5 * error / deviation } else { 0.0 })
        }
        Statistic::ProbabilityAbove(limit) => share(&|value| value > limit),
        Statistic::ProbabilityBeyond(limit) => share(&|value| value.abs() > limit),
        Statistic::Quantile(p) => {
            let mut sorted = values.to_vec();
            sorted.sort_by(f64::total_cmp);
            let at = |p: f64| sorted[((p * count) as usize).min(sorted.len() - 1)];
            let error = (p * (1.0 - p) / count).sqrt();
            (at(p), (at((p + error).min(1.0)) - at((p - error).max(0.0))).abs())
        }
        other => panic!("no estimate of {other:?}"),
    }
}

#[test]
fn identity_visible_features_are_not_smaller_than_runs_are_dense() {
    /// Where one of 1,024 independent runs is in 99 %.
    const MIN_VOLUME: f64 = 0.0045;
    let visible = PROBLEMS.iter().filter(|problem| problem.is_visible());
    for problem in visible.clone() {
        let is_large = |feature: &fresh::Feature| feature.volume >= MIN_VOLUME;
        assert!(problem.features.iter().all(|(feature, height)| is_large(feature) && *height > 0.25), "{problem:?}");
    }
    let share = visible.count() as f64 / PROBLEMS.len() as f64;
    assert!((0.6..0.8).contains(&share), "{share}");
}

/// The short version of the campaign: a fixed set, two statistics of each problem, fewer runs but for those of the mixture.
#[test]
fn analytic_bounds_of_visible_problems_hold() {
    const SOLVED: usize = 40;
    /// Each of four ends may be missed in 0.5 %, so 2 % of the problems: more than three are missed in one of 120 such sets.
    const MAX_MISSED: usize = 3;
    let visible = (0..).zip(PROBLEMS.iter()).filter(|(_, problem)| problem.is_visible() && problem.dimensions() <= 4);
    let problems: Vec<(usize, Problem)> =
        visible.map(|(index, problem)| (index, problem.clone())).take(SOLVED).collect();
    assert_eq!(problems.len(), SOLVED);
    let missed: Vec<String> = problems.into_par_iter().filter_map(|(index, problem)| missed(index, problem)).collect();
    assert!(missed.len() <= MAX_MISSED, "at most {MAX_MISSED} missed, not {}\n{}", missed.len(), missed.join("\n"));
}

/// What is missed of a problem; `None` if all holds.
fn missed(index: usize, mut problem: Problem) -> Option<String> {
    // Another pair of statistics for each problem.
    let count = problem.exact.len();
    problem.exact = [index, index + 1].map(|place| problem.exact[place % count]).to_vec();
    let sampling = Sampling { outer: 32, inner: 128, extreme: 32, ..Sampling::default() };
    let bounds = evaluate(problem.question(0, sampling), &problem).expect("the problem can be planned");
    assert_eq!(bounds.pairs.len(), problem.exact.len());
    let pairs = bounds.pairs.iter().zip(&problem.exact);
    let lines = pairs.flat_map(|(pair, exact): (_, &Exact)| {
        let widened = [pair.lower.widened, pair.upper.widened];
        let missed = exact.missed_by(widened).into_iter().flatten();
        missed
            .map(|inside| format!("{index}: {exact:?} missed by {inside}: {widened:?}, {:?}", problem.kinds()))
            .collect::<Vec<_>>()
    });
    lines.reduce(|all, line| all + "\n" + &line)
}
