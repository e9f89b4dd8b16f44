//! How finely a box was seen: the largest cube of it in which no point lies.
//!
//! ```text
//! r(c) = min over points of max_j |c_j - u_j|,   gap = max over c of the volume of [c - r, c + r] inside the unit box
//! ```
//!
//! sought from the candidates of the search, the best of which climb by steps along the axes, so that a slightly larger one may exist. A hill within a gap of that size may have been
//! missed, whatever its height: the model of what lies between points knows the points alone.

use super::search_box::{Axes, BoxPoint};
use loosepin_math::sort_by_number;

/// So many of the largest gaps among the candidates are widened.
const CLIMBS: usize = 8;
/// First step of a climb in units of the box, and the last one.
const FIRST_STEP: f64 = 0.1;
const LAST_STEP: f64 = 1e-3;

/// The largest gap between `places` in any of the `combinations` of the discrete inputs, as a share of its box; 1 if one has no place.
pub(crate) fn largest_gap(axes: &Axes, combinations: usize, places: &[BoxPoint], candidates: &[Vec<f64>]) -> f64 {
    let of_combination = |combination: usize| {
        let own: Vec<&[f64]> =
            places.iter().filter(|place| place.combination == combination).map(|place| &place.at[..]).collect();
        if own.is_empty() { 1.0 } else { largest_of(axes, &own, candidates) }
    };
    (0..combinations).map(of_combination).fold(0.0, f64::max)
}

fn largest_of(axes: &Axes, places: &[&[f64]], candidates: &[Vec<f64>]) -> f64 {
    let mut gaps: Vec<(f64, &Vec<f64>)> = candidates.iter().map(|at| (gap_at(axes, places, at), at)).collect();
    sort_by_number(&mut gaps, |a| -a.0);
    let climbed = gaps.iter().take(CLIMBS).map(|(gap, at)| climb(axes, places, at, *gap));
    climbed.fold(0.0, f64::max)
}

/// The volume of the empty cube about `at` inside the box.
fn gap_at(axes: &Axes, places: &[&[f64]], at: &[f64]) -> f64 {
    let mut radius = f64::INFINITY;
    for place in places {
        // Most places are known to be no nearer from their first coordinates.
        let mut steps = (0..at.len()).map(|axis| axes.step(axis, at[axis], place[axis]).abs());
        let nearer = steps.try_fold(0.0_f64, |distance, step| (step < radius).then_some(distance.max(step)));
        radius = nearer.unwrap_or(radius);
    }
    let side = |axis: usize| {
        if axes.is_periodic(axis) {
            (2.0 * radius).min(1.0)
        } else {
            (at[axis] + radius).min(1.0) - (at[axis] - radius).max(0.0)
        }
    };
    (0..at.len()).map(side).product()
}

fn climb(axes: &Axes, places: &[&[f64]], from: &[f64], mut gap: f64) -> f64 {
    let (mut at, mut step) = (from.to_vec(), FIRST_STEP);
    while step >= LAST_STEP {
        let mut is_better = false;
        for axis in 0..at.len() {
            for sign in [-1.0, 1.0] {
                let before = at[axis];
                at[axis] = axes.inside(axis, before + sign * step, [0.0, 1.0]);
                let moved = gap_at(axes, places, &at);
                if moved > gap {
                    (gap, is_better) = (moved, true);
                } else {
                    at[axis] = before;
                }
            }
        }
        if !is_better {
            step *= 0.5;
        }
    }
    gap
}

#[cfg(test)]
mod tests {
    use super::largest_gap;
    use crate::search::design::candidates;
    use crate::search::search_box::{Axes, BoxPoint};

    fn place(at: &[f64]) -> BoxPoint {
        BoxPoint { combination: 0, at: at.to_vec() }
    }

    #[test]
    fn analytic_the_largest_gap_between_points_of_a_line() {
        let axes = Axes::open(1);
        let points = [0.0, 0.1, 0.45, 0.6, 1.0].map(|x| place(&[x]));
        let gap = largest_gap(&axes, 1, &points, &candidates(1).unwrap());
        assert!((gap - 0.4).abs() < 2e-3, "{gap}");
        // Beyond the last point of an open line, and round a closed one.
        let inner = [0.3, 0.45, 0.5].map(|x| place(&[x]));
        assert!((largest_gap(&axes, 1, &inner, &candidates(1).unwrap()) - 0.5).abs() < 2e-3);
        let closed = Axes { is_periodic: vec![true] };
        assert!((largest_gap(&closed, 1, &inner, &candidates(1).unwrap()) - 0.8).abs() < 2e-3);
    }

    #[test]
    fn analytic_the_largest_gap_of_corners_and_middle_of_a_square() {
        // A cube beside the middle: half the square.
        let points: Vec<BoxPoint> =
            [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0], [0.5, 0.5]].iter().map(|at| place(at)).collect();
        let gap = largest_gap(&Axes::open(2), 1, &points, &candidates(2).unwrap());
        assert!((0.24..=0.51).contains(&gap), "{gap}");
        assert_eq!(largest_gap(&Axes::open(2), 2, &points, &candidates(2).unwrap()), 1.0);
    }
}
