//! Extreme probabilities of an event in a box of unknown inputs: by the reliability index, which is not flat.

use super::design_point::{DesignPoint, DesignSearch, design_points, search_design_point};
use loosepin_math::sort_by_number;

/// First and last step of the search, in shares of the box.
const FIRST_STEP: f64 = 0.25;
const LAST_STEP: f64 = 1.0 / 32.0;
/// Steps from a design point that is known nearby.
const FOLLOWING_ITERATIONS: usize = 6;

/// How far the search goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BoxSearch {
    /// The search for design points where nothing is known yet.
    pub design: DesignSearch,
    /// Moves of each of the two searches, at most. Default: 24.
    pub moves: usize,
}

impl Default for BoxSearch {
    fn default() -> Self {
        Self { design: DesignSearch::default(), moves: 24 }
    }
}

/// The end of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct IndexExtreme {
    /// Place in the unit box.
    pub at: Vec<f64>,
    /// The design points there, nearest first.
    pub designs: Vec<DesignPoint>,
    /// The largest change of the index to a neighbour at the last step, along axes on which the place is inside the box: what the
    /// search does not resolve.
    pub unresolved: f64,
}

/// Both ends.
#[derive(Debug, Clone, PartialEq)]
pub struct IndexRange {
    /// Place of the smallest index, so of the likeliest event.
    pub smallest: IndexExtreme,
    /// Place of the largest index.
    pub largest: IndexExtreme,
    /// Evaluations of the limit state.
    pub runs: usize,
}

/// The extremes of the reliability index over the unit box, of the `candidates` (at least one) and then by a pattern search along
/// the axes from the best of them; an axis that `closes` has no ends, 0 and 1 are the same there. Empty if a candidate has no
/// design point.
///
/// The probability itself is flat at zero over most of a box and shows no way; the index is smooth. Where the event has several
/// parts the index is that of the nearest, so that a probability of many equal parts may be largest elsewhere.
///
/// # Errors
/// That of the limit state, which is given points and one place of the box.
pub fn index_range<E>(
    limit_state: &mut impl FnMut(&[Vec<f64>], &[f64]) -> Result<Vec<f64>, E>,
    dimensions: usize,
    candidates: &[Vec<f64>],
    closes: &[bool],
    search: &BoxSearch,
) -> Result<Option<IndexRange>, E> {
    let mut runs = 0;
    let mut found: Vec<(Vec<f64>, Vec<DesignPoint>)> = Vec::new();
    for place in candidates {
        let (designs, used) =
            design_points(&mut |points: &[Vec<f64>]| limit_state(points, place), dimensions, &search.design)?;
        runs += used;
        if designs.is_empty() {
            return Ok(None);
        }
        found.push((place.clone(), designs));
    }
    let index = |designs: &[DesignPoint]| designs.first().map_or(f64::NAN, |design| design.index);
    let by_index =
        |a: &&(Vec<f64>, Vec<DesignPoint>), b: &&(Vec<f64>, Vec<DesignPoint>)| index(&a.1).total_cmp(&index(&b.1));
    let (Some(least), Some(most)) = (found.iter().min_by(by_index), found.iter().max_by(by_index)) else {
        return Ok(None);
    };
    let mut ends = Vec::with_capacity(2);
    for (start, sign) in [(least, 1.0), (most, -1.0)] {
        let (mut at, mut designs) = start.clone();
        let mut step = FIRST_STEP;
        let (mut moves, mut unresolved) = (0, 0.0_f64);
        while step >= LAST_STEP && moves < search.moves && !at.is_empty() {
            let mut has_moved = false;
            unresolved = 0.0;
            for axis in 0..at.len() {
                for signed in [step, -step] {
                    let mut trial = at.clone();
                    let moved = trial[axis] + signed;
                    trial[axis] = if closes[axis] { moved.rem_euclid(1.0) } else { moved.clamp(0.0, 1.0) };
                    if trial[axis] == at[axis] {
                        continue;
                    }
                    let mut counted = |points: &[Vec<f64>]| {
                        runs += points.len();
                        limit_state(points, &trial)
                    };
                    let Some(nearby) = follow(&mut counted, &designs)? else { continue };
                    let change = index(&nearby) - index(&designs);
                    if sign * change < 0.0 {
                        // Where the moves end here, a further one may gain as much again.
                        unresolved = unresolved.max(change.abs());
                        (at, designs, has_moved) = (trial, nearby, true);
                        moves += 1;
                        break;
                    }
                    // At a face of the box a worse neighbour shows that the extreme is the face itself.
                    if closes[axis] || at[axis] > 0.0 && at[axis] < 1.0 {
                        unresolved = unresolved.max(change.abs());
                    }
                }
            }
            if !has_moved {
                step *= 0.5;
            }
        }
        // What has been followed may have left another part of the event behind.
        if at != start.0 {
            let (again, used) =
                design_points(&mut |points: &[Vec<f64>]| limit_state(points, &at), dimensions, &search.design)?;
            runs += used;
            if index(&again).is_finite() {
                designs = again;
            }
        }
        ends.push(IndexExtreme { at, designs, unresolved });
    }
    let largest = ends.pop();
    Ok(ends.pop().zip(largest).map(|(smallest, largest)| IndexRange { smallest, largest, runs }))
}

/// The design points at a place near one where they are `known`.
fn follow<E>(
    limit_state: &mut impl FnMut(&[Vec<f64>]) -> Result<Vec<f64>, E>,
    known: &[DesignPoint],
) -> Result<Option<Vec<DesignPoint>>, E> {
    let mut found = Vec::with_capacity(known.len());
    let Some(dimensions) = known.first().map(|design| design.point.len()) else { return Ok(None) };
    // The origin may belong to the event here though it does not there.
    let at_origin = limit_state(&[vec![0.0; dimensions]])?[0];
    let sign = if at_origin <= 0.0 { -1.0 } else { 1.0 };
    for design in known {
        if let Some(next) = search_design_point(limit_state, design.point.clone(), FOLLOWING_ITERATIONS)? {
            found.push(DesignPoint { index: sign * next.index, ..next });
        }
    }
    sort_by_number(&mut found, |point| point.index.abs());
    Ok((!found.is_empty()).then_some(found))
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::{BoxSearch, index_range};

    /// Shares of the box: twice the last step.
    const PLACE_TOLERANCE: f64 = 0.07;
    /// Reliability index: what a place off by that much makes.
    const INDEX_TOLERANCE: f64 = 0.01;

    #[test]
    fn analytic_an_index_that_changes_its_sign_is_followed_below_zero() {
        // β(u) = 3 u - 1, searched from the middle alone: from -1 at u = 0 to 2 at u = 1.
        let mut limit_state = |points: &[Vec<f64>], at: &[f64]| -> Result<Vec<f64>, Infallible> {
            Ok(points.iter().map(|x| 3.0 * at[0] - 1.0 - (x[0] - 2.0 * x[1]) / 5.0_f64.sqrt()).collect())
        };
        let range = index_range(&mut limit_state, 2, &[vec![0.5]], &[false], &BoxSearch::default()).unwrap().unwrap();
        for (found, (place, index)) in [(&range.smallest, (0.0, -1.0)), (&range.largest, (1.0, 2.0))] {
            assert_eq!(found.at, [place], "{range:?}");
            assert!((found.designs[0].index - index).abs() < INDEX_TOLERANCE, "{range:?}");
        }
    }

    #[test]
    fn analytic_extremes_inside_and_at_a_corner() {
        // β(u) = 4 + 2 (u_0 - 0.3)² + 0.5 u_1: smallest at (0.3, 0), largest at (1, 1).
        let mut limit_state = |points: &[Vec<f64>], at: &[f64]| -> Result<Vec<f64>, Infallible> {
            let index = 4.0 + 2.0 * (at[0] - 0.3).powi(2) + 0.5 * at[1];
            Ok(points.iter().map(|x| index - (x[0] + 2.0 * x[1]) / 5.0_f64.sqrt()).collect())
        };
        let corners = [[0.5, 0.5], [0.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0]].map(|at| at.to_vec());
        let range = index_range(&mut limit_state, 2, &corners, &[false; 2], &BoxSearch::default()).unwrap().unwrap();
        for (found, expected) in range.smallest.at.iter().zip([0.3, 0.0]) {
            assert!((found - expected).abs() < PLACE_TOLERANCE, "{range:?}");
        }
        assert!((range.smallest.designs[0].index - 4.0).abs() < INDEX_TOLERANCE, "{range:?}");
        assert!(range.smallest.unresolved > range.smallest.designs[0].index - 4.0, "{range:?}");
        assert_eq!((&range.largest.at[..], range.largest.unresolved), (&[1.0, 1.0][..], 0.0));
        assert!((range.largest.designs[0].index - 5.48).abs() < INDEX_TOLERANCE, "{range:?}");
    }

    #[test]
    fn analytic_an_extreme_across_the_seam_of_an_angle() {
        // β(u) = 3 + cos(2π(u - 0.97)): largest at 0.97, which is near 0.05 on a circle and far on a line.
        let mut limit_state = |points: &[Vec<f64>], at: &[f64]| -> Result<Vec<f64>, Infallible> {
            let index = 3.0 + (std::f64::consts::TAU * (at[0] - 0.97)).cos();
            Ok(points.iter().map(|x| index - (x[0] + 2.0 * x[1]) / 5.0_f64.sqrt()).collect())
        };
        let range = index_range(&mut limit_state, 2, &[vec![0.05]], &[true], &BoxSearch::default()).unwrap().unwrap();
        assert!((range.largest.at[0] - 0.97).abs() < PLACE_TOLERANCE, "{range:?}");
        assert!(range.largest.unresolved >= 4.0 - range.largest.designs[0].index, "{range:?}");
    }

    #[test]
    fn analytic_moves_that_run_out_are_told() {
        // β(u) = 3 + 2 u, three moves of a search that needs more than that to the end.
        let mut limit_state = |points: &[Vec<f64>], at: &[f64]| -> Result<Vec<f64>, Infallible> {
            let index = 3.0 + 2.0 * at[0] + 1.5 * at[1] + 1.2 * at[2] + 1.1 * at[3];
            Ok(points.iter().map(|x| index - (x[0] + 2.0 * x[1]) / 5.0_f64.sqrt()).collect())
        };
        let search = BoxSearch { moves: 3, ..BoxSearch::default() };
        let range = index_range(&mut limit_state, 2, &[vec![0.5; 4]], &[false; 4], &search).unwrap().unwrap();
        assert!(range.largest.at != [1.0; 4] && range.largest.unresolved > 0.2, "{range:?}");
    }
}
