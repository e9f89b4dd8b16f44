//! What every reduction states of itself, held against drawn curves: a new one is in the list, and so in these tests.

use super::{Course, CourseEnds, Reduction};
use crate::drawn::drawn;

const ROUND_OFF: f64 = 1e-12;

fn course(curve: &[f64]) -> Course {
    let count = curve.len() as f64;
    Course {
        largest: curve.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        smallest: curve.iter().copied().fold(f64::INFINITY, f64::min),
        mean: curve.iter().sum::<f64>() / count,
        mean_square: curve.iter().map(|y| y * y).sum::<f64>() / count,
    }
}

/// Of numbers from -2 to 2 in sixteenths.
fn curves() -> Vec<Vec<f64>> {
    let mut draw = drawn(7);
    (0..400).map(|number| (0..1 + number % 7).map(|_| draw(65) as f64 / 16.0 - 2.0).collect()).collect()
}

#[test]
fn identity_the_word_is_what_files_hold() {
    for reduction in Reduction::ALL {
        assert_eq!(serde_json::to_value(reduction).unwrap(), reduction.word());
    }
}

#[test]
fn analytic_each_reduction_of_a_curve() {
    let of = |reduction: Reduction| reduction.of(&course(&[-3.0, 0.5, 2.0]));
    for (reduction, value) in [
        (Reduction::Maximum, 2.0),
        (Reduction::Minimum, -3.0),
        (Reduction::MaximumAbsolute, 3.0),
        (Reduction::RootMeanSquare, (13.25_f64 / 3.0).sqrt()),
        (Reduction::Mean, -0.5 / 3.0),
        (Reduction::Range, 5.0),
    ] {
        assert_eq!(of(reduction), value, "{reduction:?}");
    }
    let unknown = Course { largest: f64::NAN, smallest: f64::NAN, mean: f64::NAN, mean_square: f64::NAN };
    assert!(Reduction::ALL.iter().all(|reduction| reduction.of(&unknown).is_nan()));
}

#[test]
fn analytic_an_extreme_is_decided_by_the_end_that_it_is_about() {
    for (reduction, reach) in [
        (Reduction::Maximum, Some(2.0)),
        (Reduction::Minimum, Some(3.0)),
        (Reduction::MaximumAbsolute, Some(3.0)),
        (Reduction::Mean, None),
    ] {
        assert_eq!(reduction.reach([-3.0, 2.0]), reach, "{reduction:?}");
    }
}

#[test]
fn identity_reductions_of_curves_are_in_the_order_that_is_stated() {
    let mut stated = 0;
    for (a, b) in Reduction::ALL.into_iter().flat_map(|a| Reduction::ALL.into_iter().map(move |b| (a, b))) {
        if a.never_exceeds(b) {
            stated += 1;
            for curve in curves() {
                let [lesser, greater] = [a, b].map(|reduction| reduction.of(&course(&curve)));
                assert!(lesser <= greater + ROUND_OFF, "{a:?} {b:?} {curve:?}");
            }
        }
    }
    assert!(stated >= 9, "{stated}");
}

#[test]
fn identity_a_sign_that_is_excluded_is_that_of_no_curve() {
    for reduction in Reduction::ALL.into_iter().filter(|reduction| reduction.is_never_negative()) {
        assert!(curves().iter().all(|curve| reduction.of(&course(curve)) >= 0.0), "{reduction:?}");
    }
}

#[test]
fn identity_more_turns_move_a_number_the_way_that_is_stated() {
    for reduction in Reduction::ALL {
        let Some(direction) = reduction.moved_by_more_turns() else { continue };
        for curve in curves() {
            let [recorded, longer] = [&curve[..1], &curve].map(|turns| reduction.of(&course(turns)));
            assert!(direction * (longer - recorded) >= 0.0, "{reduction:?} {curve:?}");
        }
    }
}

/// Three positions, each anywhere in its interval: every reduction against a grid of all places.
#[test]
fn analytic_ends_are_those_of_all_curves_between_two() {
    const STEPS: usize = 20;
    let all = [[-0.4, 0.1], [0.2, 0.5], [-0.1, 0.3]];
    let place = |[lower, upper]: [f64; 2], k: usize| lower + (upper - lower) * k as f64 / STEPS as f64;
    let of = |value: fn([f64; 2]) -> f64| course(&all.map(value));
    let between = CourseEnds {
        lower: of(|[lower, _]| lower),
        upper: of(|[_, upper]| upper),
        near: of(|[lower, upper]| lower.max(-upper).max(0.0)),
        far: of(|[lower, upper]| upper.max(-lower)),
    };
    for reduction in Reduction::ALL {
        let mut found = [f64::INFINITY, f64::NEG_INFINITY];
        for k in 0..(STEPS + 1).pow(3) {
            let steps = [k % (STEPS + 1), k / (STEPS + 1) % (STEPS + 1), k / (STEPS + 1).pow(2)];
            let curve: Vec<f64> = all.iter().zip(steps).map(|(ends, k)| place(*ends, k)).collect();
            let value = reduction.of(&course(&curve));
            found = [found[0].min(value), found[1].max(value)];
        }
        let [lower, upper] = reduction.ends(&between);
        // The grid passes within half of its step of zero.
        let is_near = |a: f64, b: f64| (a - b).abs() < 0.02;
        assert!(is_near(lower, found[0]) && is_near(upper, found[1]), "{reduction:?} {lower} {upper} {found:?}");
    }
}
