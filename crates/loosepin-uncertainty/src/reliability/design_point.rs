//! Nearest points of the event: design points of first-order reliability.

use super::{dot, square};
use crate::{hash, normal};
use loosepin_math::sort_by_number;

/// Half the distance of the differences that give a gradient, in standard deviations: wide enough for a simulation that is exact to a
/// hundredth of its scatter, narrow against the curvature of limit states.
const HALF_STEP: f64 = 0.05;
/// A design point is found when the steps fall below this, in standard deviations.
const LAST_STEP: f64 = 1e-3;
/// Two design points nearer than this, in standard deviations, are one.
const MIN_DISTANCE: f64 = 0.5;
/// Design points further than the nearest by more than this contribute less than 1 % of it.
const FURTHEST_BEYOND: f64 = 1.2;
/// A step is halved at most so often.
const MAX_HALVINGS: u32 = 4;
/// No step goes further out than this: no event there is worth a number.
const MAX_RADIUS: f64 = 10.0;
/// Radius at which directions are tried for further starts.
const PROBE_RADIUS: f64 = 3.0;
/// Random directions that are tried, for each dimension and at least.
const PROBES_PER_DIMENSION: usize = 6;
const MIN_PROBES: usize = 24;
/// Two starts make at least this angle: its cosine.
const MAX_COSINE: f64 = 0.75;
/// Separates the stream of random numbers.
const PROBES: u64 = 0x7072_6f62_6573;

/// How far the search goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DesignSearch {
    /// Starts besides the origin, at most. Default: 6.
    pub starts: usize,
    /// Steps from each start, at most. Default: 12.
    pub iterations: usize,
    /// Seed of the directions. Default: 1.
    pub seed: u64,
}

impl Default for DesignSearch {
    fn default() -> Self {
        Self { starts: 6, iterations: 12, seed: 1 }
    }
}

/// A point of the limit state nearest to the origin.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignPoint {
    /// Point in standard normal numbers.
    pub point: Vec<f64>,
    /// Reliability index β: its distance from the origin, negative where the origin itself belongs to the event.
    pub index: f64,
    /// Whether the steps came to an end.
    pub is_converged: bool,
}

/// Design points of `limit_state`, the nearest first, and the number of evaluations. The first one is the best that was found even
/// where it has not converged; there is none only where g has no numbers near the origin.
///
/// The iteration of Hasofer and Lind, Rackwitz and Fiessler,
///
/// ```text
/// u ← (∇g·u - g)/|∇g|² ∇g,   a shorter step where |u|²/2 + c |g| would grow, c = 2 max(|u|/|∇g|, 1)
/// ```
///
/// (P.-L. Liu, A. Der Kiureghian, Structural Safety 9 (1991) 161-177), gradients by central differences; from the origin and from the
/// most dangerous of directions around it that lie apart, so that an event with several parts shows more than one.
///
/// # Errors
/// That of the limit state.
pub fn design_points<E>(
    limit_state: &mut impl FnMut(&[Vec<f64>]) -> Result<Vec<f64>, E>,
    dimensions: usize,
    search: &DesignSearch,
) -> Result<(Vec<DesignPoint>, usize), E> {
    let mut runs = 0;
    let mut counted = |points: &[Vec<f64>]| {
        runs += points.len();
        limit_state(points)
    };
    let origin = vec![0.0; dimensions];
    let at_origin = counted(std::slice::from_ref(&origin))?[0];
    let sign = if at_origin <= 0.0 { -1.0 } else { 1.0 };
    let mut found: Vec<DesignPoint> = Vec::new();
    for start in std::iter::once(origin).chain(further_starts(&mut counted, dimensions, search)?) {
        let Some(mut design) = search_design_point(&mut counted, start, search.iterations)? else { continue };
        design.index *= sign;
        let apart = |other: &DesignPoint| {
            let squares = other.point.iter().zip(&design.point).map(|(a, b)| (a - b) * (a - b));
            squares.sum::<f64>().sqrt() > MIN_DISTANCE
        };
        if found.iter().all(apart) {
            found.push(design);
        }
    }
    found.sort_by(|a, b| (!a.is_converged).cmp(&!b.is_converged).then(a.index.abs().total_cmp(&b.index.abs())));
    let nearest = found.first().map_or(0.0, |design| design.index.abs());
    let mut position = 0;
    found.retain(|design| {
        position += 1;
        position == 1 || design.is_converged && design.index.abs() <= nearest + FURTHEST_BEYOND
    });
    Ok((found, runs))
}

/// One design point from `start`; empty if g has no numbers or no slope there.
pub(super) fn search_design_point<E>(
    limit_state: &mut impl FnMut(&[Vec<f64>]) -> Result<Vec<f64>, E>,
    start: Vec<f64>,
    iterations: usize,
) -> Result<Option<DesignPoint>, E> {
    let mut point = start;
    let mut is_converged = false;
    for _ in 0..iterations {
        let Some((value, gradient)) = slope(limit_state, &point)? else { return Ok(None) };
        let steepness = square(&gradient);
        if !(steepness > 0.0) {
            return Ok(None);
        }
        let straight = (dot(&gradient, &point) - value) / steepness;
        let factor = straight.clamp(-MAX_RADIUS / steepness.sqrt(), MAX_RADIUS / steepness.sqrt());
        let target: Vec<f64> = gradient.iter().map(|g| factor * g).collect();
        let penalty = 2.0 * (square(&point) / steepness).sqrt().max(1.0);
        let merit = |at: &[f64], value: f64| 0.5 * square(at) + penalty * value.abs();
        // All lengths of the step at once: they are few, and a batch takes no longer than its longest run.
        let lengths: Vec<f64> = (0..=MAX_HALVINGS).map(|halvings| 0.5_f64.powi(halvings as i32)).collect();
        let trials: Vec<Vec<f64>> = lengths
            .iter()
            .map(|length| point.iter().zip(&target).map(|(x, y)| x + length * (y - x)).collect())
            .collect();
        let values = limit_state(&trials)?;
        let now = merit(&point, value);
        let better = trials.iter().zip(&values).find(|(trial, value)| value.is_finite() && merit(trial, **value) < now);
        let next = better.map_or_else(|| trials[trials.len() - 1].clone(), |(trial, _)| trial.clone());
        let step: f64 = next.iter().zip(&point).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
        point = next;
        if step < LAST_STEP * (1.0 + square(&point).sqrt()) {
            is_converged = true;
            break;
        }
    }
    Ok(Some(DesignPoint { index: square(&point).sqrt(), point, is_converged }))
}

/// Value and gradient.
fn slope<E>(
    limit_state: &mut impl FnMut(&[Vec<f64>]) -> Result<Vec<f64>, E>,
    point: &[f64],
) -> Result<Option<(f64, Vec<f64>)>, E> {
    let mut points = vec![point.to_vec()];
    for axis in 0..point.len() {
        for step in [HALF_STEP, -HALF_STEP] {
            let mut moved = point.to_vec();
            moved[axis] += step;
            points.push(moved);
        }
    }
    let values = limit_state(&points)?;
    let gradient: Vec<f64> = values[1..].chunks_exact(2).map(|pair| (pair[0] - pair[1]) / (2.0 * HALF_STEP)).collect();
    Ok((values[0].is_finite() && gradient.iter().all(|g| g.is_finite())).then_some((values[0], gradient)))
}

/// Directions in which g is small, apart from each other.
fn further_starts<E>(
    limit_state: &mut impl FnMut(&[Vec<f64>]) -> Result<Vec<f64>, E>,
    dimensions: usize,
    search: &DesignSearch,
) -> Result<Vec<Vec<f64>>, E> {
    if search.starts == 0 || dimensions == 0 {
        return Ok(Vec::new());
    }
    let mut probes: Vec<Vec<f64>> = Vec::new();
    for axis in 0..dimensions {
        for sign in [1.0, -1.0] {
            let mut probe = vec![0.0; dimensions];
            probe[axis] = sign * PROBE_RADIUS;
            probes.push(probe);
        }
    }
    let key = hash(search.seed, PROBES);
    for index in 0..MIN_PROBES.max(PROBES_PER_DIMENSION * dimensions) / 2 {
        let direction: Vec<f64> = (0..dimensions).map(|axis| normal(hash(key, index as u64), axis as u64)).collect();
        let length = square(&direction).sqrt();
        // A direction and its opposite.
        for sign in [1.0, -1.0] {
            probes.push(direction.iter().map(|x| sign * PROBE_RADIUS * x / length).collect());
        }
    }
    let values = limit_state(&probes)?;
    let mut order: Vec<usize> = (0..probes.len()).filter(|&k| values[k].is_finite()).collect();
    sort_by_number(&mut order, |&probe| values[probe]);
    let mut starts: Vec<Vec<f64>> = Vec::new();
    for index in order {
        let cosine = |other: &Vec<f64>| dot(other, &probes[index]) / (PROBE_RADIUS * PROBE_RADIUS);
        if starts.len() < search.starts && starts.iter().all(|other| cosine(other) < MAX_COSINE) {
            starts.push(probes[index].clone());
        }
    }
    Ok(starts)
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use super::{DesignSearch, design_points};

    /// Standard deviations: differences over 0.05 of a parabola are exact, the steps end at 0.001.
    const TOLERANCE: f64 = 0.01;

    fn batch(g: impl Fn(&[f64]) -> f64) -> impl FnMut(&[Vec<f64>]) -> Result<Vec<f64>, Infallible> {
        move |points| Ok(points.iter().map(|point| g(point)).collect())
    }

    #[test]
    fn analytic_design_point_of_a_plane() {
        let plane = |x: &[f64]| 4.2649 - 0.6 * x[0] - 0.8 * x[2];
        let (found, runs) = design_points(&mut batch(plane), 3, &DesignSearch::default()).unwrap();
        assert_eq!(found.len(), 1, "{found:?}");
        assert!((found[0].index - 4.2649).abs() < TOLERANCE && found[0].is_converged, "{found:?}");
        for (found, expected) in found[0].point.iter().zip([0.6 * 4.2649, 0.0, 0.8 * 4.2649]) {
            assert!((found - expected).abs() < TOLERANCE, "{found}");
        }
        assert!(runs < 600, "{runs}");
    }

    #[test]
    fn analytic_an_origin_that_belongs_to_the_event_has_a_negative_index() {
        let (found, _) = design_points(&mut batch(|x| -1.7 - x[0] - x[1]), 2, &DesignSearch::default()).unwrap();
        assert!((found[0].index + 1.7 / 2.0_f64.sqrt()).abs() < TOLERANCE, "{found:?}");
    }

    #[test]
    fn published_four_branches_have_four_design_points() {
        // P. H. Waarts (2000), branch distances of 3 and 6/√2 · 1/√2 = 3 from the origin.
        let four = |x: &[f64]| {
            let [sum, difference] = [(x[0] + x[1]) / 2.0_f64.sqrt(), x[0] - x[1]];
            let parabola = 3.0 + 0.1 * difference * difference;
            let planes = 6.0 / 2.0_f64.sqrt();
            (parabola - sum).min(parabola + sum).min(planes + difference).min(planes - difference)
        };
        let (found, _) = design_points(&mut batch(four), 2, &DesignSearch::default()).unwrap();
        assert_eq!(found.len(), 4, "{found:?}");
        assert!(found.iter().all(|design| (design.index - 3.0).abs() < TOLERANCE), "{found:?}");
    }

    #[test]
    fn a_limit_state_without_numbers_has_no_design_point() {
        let (found, _) = design_points(&mut batch(|_| f64::NAN), 2, &DesignSearch::default()).unwrap();
        assert!(found.is_empty());
    }
}
