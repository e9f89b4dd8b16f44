//! Summits where slopes meet: with many points a model of something rounded is sure of itself, and misses them.

use rayon::prelude::*;

use crate::Function;
use crate::cases::exact::problem;
use crate::{Sampling, Statistic, evaluate};
use loosepin_uncertainty::uniform;

/// With this many points the search ends by itself.
const POINTS: usize = 256;

/// Fails where the summit 0 of `slopes`, moved and turned otherwise for each seed, lies outside the widened bounds.
#[track_caller]
fn check(slopes: impl Fn(f64, f64) -> f64 + Sync, seeds: &[u64]) {
    let missed = |&seed: &u64| {
        let (x_of_summit, y_of_summit) = (0.2 + 0.6 * uniform(seed, 0), 0.2 + 0.6 * uniform(seed, 1));
        let (sine, cosine) = libm::sincos(core::f64::consts::TAU * uniform(seed, 2));
        let mut problem = problem(&[], &[(0.0, 1.0), (0.0, 1.0)], &[Statistic::Mean]);
        problem.sampling = Sampling { outer: POINTS, seed, ..Sampling::default() };
        let of = |_: &[f64], u: &[f64]| {
            let (x, y) = (u[0] - x_of_summit, u[1] - y_of_summit);
            slopes(cosine * x + sine * y, cosine * y - sine * x)
        };
        let upper = &evaluate(problem, &Function(of)).unwrap().pairs[0].upper;
        // Points that crowd at a kink leave a smooth model unsure elsewhere: 0.18 where four deviations are conceded anywhere in the box,
        // less than 0.1 near the summit alone.
        assert!(upper.value > -0.01 && upper.widened < 0.2, "{upper:?}");
        (upper.widened < 0.0).then_some((seed, upper.value, upper.widened))
    };
    let missed: Vec<(u64, f64, f64)> = seeds.par_iter().filter_map(missed).collect();
    assert!(missed.is_empty(), "seed, attained, widened: {missed:?}");
}

// Each of these seeds is missed without one of: the turned directions, their finer distances, what is conceded where slopes meet. All of
// the first 16 lie within their bounds, but take minutes.

#[test]
fn analytic_the_tip_of_a_cone_lies_within_its_bounds() {
    check(|x, y| -(x * x + 0.5 * y * y).sqrt(), &[7, 8]);
}

#[test]
fn analytic_the_summit_of_a_turned_roof_lies_within_its_bounds() {
    check(|x, y| -x.abs() - 0.3 * y.abs(), &[3, 6]);
}
