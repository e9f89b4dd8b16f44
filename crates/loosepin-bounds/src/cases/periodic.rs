//! Angles that may have any value: bounds that do not depend on where the turn is cut open.

use crate::Function;
use crate::cases::exact::{SLIDER_CRANK_EPISTEMIC, SLIDER_CRANK_RANDOM, check, problem, slider_crank};
use crate::{Bounds, Sampling, Statistic, evaluate};
use core::f64::consts::TAU;
use loosepin_uncertainty::{EpistemicVariable, Interval};

/// Bounds of the closed-form slider-crank, ψ on a circle that is cut open at `begin_rad`.
fn slider_crank_bounds(statistics: &[Statistic], begin_rad: f64) -> Bounds {
    let mut problem = problem(&SLIDER_CRANK_RANDOM, &SLIDER_CRANK_EPISTEMIC, statistics);
    let period = Interval::try_new(begin_rad, begin_rad + TAU).unwrap();
    problem.epistemic[1] = EpistemicVariable::Periodic(period);
    problem.sampling = Sampling { inner: 1024, ..Sampling::default() };
    evaluate(problem, &Function(slider_crank)).unwrap()
}

#[test]
fn analytic_slider_crank_whose_play_points_anywhere() {
    let statistics = [
        Statistic::Mean,
        Statistic::StandardDeviation,
        Statistic::ProbabilityBeyond(0.45),
        Statistic::ProbabilityBeyond(0.60),
    ];
    // Cut open at its ends, at the greatest mean (5.9156 rad) and beside the least (2.7708 rad).
    for begin_rad in [0.0, 5.9156 - TAU, 2.78] {
        let bounds = slider_crank_bounds(&statistics, begin_rad);
        // Errors as for an interval: a mean to 0.003 mm, 1024 runs resolve 1 to 2 % of a deviation.
        check(&bounds.pairs[0], (-0.536_290_6, 0.535_951_9), 0.005);
        check(&bounds.pairs[1], (0.032_290_24, 0.032_382_72), 0.001);
        check(&bounds.pairs[2], (0.0, 0.996_176_4), 0.01);
        check(&bounds.pairs[3], (0.0, 0.024_466_6), 0.015);
        // Where the search for a flat extreme stops, as for an interval.
        const WITNESS_TOLERANCE_RAD: f64 = 0.05;
        let psi_rad = |bound: &crate::Bound| bound.witness.clone().unwrap().epistemic[1].rem_euclid(TAU);
        let found = (psi_rad(&bounds.pairs[0].lower), psi_rad(&bounds.pairs[0].upper));
        assert!((found.0 - 2.7708).abs() < WITNESS_TOLERANCE_RAD, "{found:?}");
        assert!((found.1 - 5.9156).abs() < WITNESS_TOLERANCE_RAD, "{found:?}");
    }
}

#[test]
fn analytic_a_wave_on_a_circle_is_found_with_few_points() {
    // Y = cos(ψ - 0.05) + 0.2 cos 3ψ: between both ends of the turn as anywhere. Its greatest value is at a ψ where
    // sin(ψ - 0.05) = -0.6 sin 3ψ, near 0.018; by Newton's method there.
    let wave = |psi: f64| libm::cos(psi - 0.05) + 0.2 * libm::cos(3.0 * psi);
    let mut top_rad = 0.018;
    for _ in 0..20 {
        let slope = -libm::sin(top_rad - 0.05) - 0.6 * libm::sin(3.0 * top_rad);
        top_rad += slope / (libm::cos(top_rad - 0.05) + 1.8 * libm::cos(3.0 * top_rad));
    }
    let run = |known: EpistemicVariable| {
        let mut problem = problem(&[], &[(0.5, 1.5)], &[Statistic::Mean]);
        problem.epistemic = vec![known];
        problem.sampling = Sampling { outer: 24, ..Sampling::default() };
        evaluate(problem, &Function(|_: &[f64], u: &[f64]| wave(u[0]))).unwrap()
    };
    let bounds = run(EpistemicVariable::Periodic(Interval::try_new(0.0, TAU).unwrap()));
    // The wave is odd about a quarter turn but for the phase: the least value is the greatest at ψ + π.
    check(&bounds.pairs[0], (-wave(top_rad), wave(top_rad)), 1e-3);
    let places: Vec<f64> = bounds.outer_points.iter().map(|u| u[0]).collect();
    assert!(places.iter().all(|psi| (0.0..TAU).contains(psi)), "{places:?}");
    assert!(!places.contains(&0.0), "no vertex where the circle was cut open: {places:?}");
}
