//! Finding a minimum within bounds by a quasi-Newton method.

use crate::solve::dense::dot;

/// Steps that the approximation of the curvature remembers.
const MEMORY: usize = 10;
/// Share of the promised descent that a step must deliver.
const SUFFICIENT: f64 = 1e-4;

/// The least value that was found.
#[derive(Debug, Clone)]
pub struct Minimum {
    /// Coordinates at which the function has it.
    pub place: Vec<f64>,
    /// The function there.
    pub value: f64,
}

/// L-BFGS on the coordinates that are not held at a bound, with a backtracking line search along the path that the bounds
/// bend; at most `steps` steps, and no more where a step gains less than `tolerance`. A place where `function` has no value
/// is one step too far; nothing is returned where it has none at `start`.
///
/// Source: J. Nocedal and S. J. Wright, "Numerical Optimization", 2nd edition, Springer 2006, algorithms 7.4 and 3.1, and
/// section 16.7 for the bounds.
pub fn minimise(
    function: impl Fn(&[f64]) -> Option<(f64, Vec<f64>)>,
    start: &[f64],
    bounds: &[(f64, f64)],
    steps: usize,
    tolerance: f64,
) -> Option<Minimum> {
    let clamped = |place: &mut Vec<f64>| {
        for (x, (lower, upper)) in place.iter_mut().zip(bounds) {
            *x = x.clamp(*lower, *upper);
        }
    };
    let mut place = start.to_vec();
    clamped(&mut place);
    let (mut value, mut gradient) = function(&place)?;
    let mut pairs: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
    let mut small = 0;
    for _ in 0..steps {
        let is_free: Vec<bool> = (0..place.len())
            .map(|k| !(place[k] <= bounds[k].0 && gradient[k] > 0.0 || place[k] >= bounds[k].1 && gradient[k] < 0.0))
            .collect();
        let free = |vector: &[f64]| -> Vec<f64> {
            vector.iter().zip(&is_free).map(|(x, is_free)| if *is_free { *x } else { 0.0 }).collect()
        };
        let steepest: Vec<f64> = free(&gradient).iter().map(|x| -x).collect();
        let mut direction = free(&curved(&steepest, &pairs));
        if !(dot(&direction, &steepest) > 0.0) {
            pairs.clear();
            direction = steepest.clone();
        }
        let length = dot(&direction, &direction).sqrt();
        if !(length > 0.0) {
            break;
        }
        // No step moves a coordinate by more than 2: of a parameter, its logarithm, a factor e².
        let largest = direction.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        let mut step = if pairs.is_empty() { (0.5 / largest).min(1.0) } else { (2.0 / largest).min(1.0) };
        let mut next = None;
        for _ in 0..20 {
            let mut trial: Vec<f64> = place.iter().zip(&direction).map(|(x, d)| x + step * d).collect();
            clamped(&mut trial);
            let moved: Vec<f64> = trial.iter().zip(&place).map(|(a, b)| a - b).collect();
            if let Some((found, slope)) = function(&trial)
                && found <= value + SUFFICIENT * dot(&gradient, &moved)
            {
                next = Some((trial, moved, found, slope));
                break;
            }
            step *= 0.4;
        }
        let Some((trial, moved, found, slope)) = next else {
            if pairs.is_empty() {
                break;
            }
            pairs.clear();
            continue;
        };
        let change: Vec<f64> = slope.iter().zip(&gradient).map(|(a, b)| a - b).collect();
        if dot(&moved, &change) > 1e-10 * dot(&change, &change) {
            if pairs.len() == MEMORY {
                pairs.remove(0);
            }
            pairs.push((moved, change));
        }
        let gain = value - found;
        (place, value, gradient) = (trial, found, slope);
        small = if gain < tolerance { small + 1 } else { 0 };
        if small == 2 {
            break;
        }
    }
    Some(Minimum { place, value })
}

/// The steepest direction, times the inverse curvature that the steps have shown.
fn curved(steepest: &[f64], pairs: &[(Vec<f64>, Vec<f64>)]) -> Vec<f64> {
    let mut direction = steepest.to_vec();
    let mut shares = Vec::with_capacity(pairs.len());
    for (moved, change) in pairs.iter().rev() {
        let share = dot(moved, &direction) / dot(moved, change);
        for (entry, value) in direction.iter_mut().zip(change) {
            *entry -= share * value;
        }
        shares.push(share);
    }
    if let Some((moved, change)) = pairs.last() {
        let scale = dot(moved, change) / dot(change, change);
        direction.iter_mut().for_each(|entry| *entry *= scale);
    }
    for ((moved, change), share) in pairs.iter().zip(shares.iter().rev()) {
        let back = dot(change, &direction) / dot(moved, change);
        for (entry, value) in direction.iter_mut().zip(moved) {
            *entry += (share - back) * value;
        }
    }
    direction
}

#[cfg(test)]
mod tests {
    use super::minimise;

    /// 100 (y - x²)² + (1 - x)²
    fn rosenbrock(x: &[f64]) -> Option<(f64, Vec<f64>)> {
        let rest = x[1] - x[0] * x[0];
        let value = 100.0 * rest * rest + (1.0 - x[0]) * (1.0 - x[0]);
        Some((value, vec![-400.0 * x[0] * rest - 2.0 * (1.0 - x[0]), 200.0 * rest]))
    }

    #[test]
    fn analytic_the_valley_of_rosenbrock_is_followed_to_its_end() {
        const TOLERANCE: f64 = 1e-5; // the search stops where two steps gain less than 1e-12
        let found = minimise(rosenbrock, &[-1.2, 1.3], &[(-3.0, 3.0); 2], 500, 1e-12).unwrap();
        assert!(found.place.iter().all(|x| (x - 1.0).abs() < TOLERANCE), "{found:?}");
    }

    #[test]
    fn analytic_a_bound_holds_and_the_other_coordinate_goes_on() {
        // With x <= 0.5 the least value is 0.25, at (0.5, 0.25).
        const TOLERANCE: f64 = 1e-5; // as above
        let found = minimise(rosenbrock, &[-1.2, 1.3], &[(-3.0, 0.5), (-3.0, 3.0)], 500, 1e-12).unwrap();
        assert!((found.place[0] - 0.5).abs() < TOLERANCE && (found.place[1] - 0.25).abs() < TOLERANCE, "{found:?}");
    }
}
