//! Largest values of an output over all poses within the play: augmented Lagrangian (M. J. D. Powell, M. R. Hestenes, 1969) with the
//! quasi-Newton method of Broyden, Fletcher, Goldfarb and Shanno, from random starts.

use super::linear::{add, dot, length, times};
use super::poses::PoseSet;
use crate::random::Random;

/// Central differences in t, in which plays are of order one.
const STEP: f64 = 1e-4;
/// By how much the plays are made smaller, so that what the method leaves of the bounds is inside the play: 2e-7 of the answer.
const MARGIN: f64 = 2e-7;
/// What the method may leave of the bounds.
const SMALL_MISS: f64 = 5e-8;

/// Steps of the quasi-Newton method in a round.
const MAX_QUASI_NEWTON: usize = 150;
/// Rounds of new multipliers that may bring little.
const MAX_SLOW: usize = 7;
/// Starts that may come to no end, for each that does.
const MAX_ATTEMPTS: usize = 3;

/// Where a start ended.
#[derive(Clone, Copy)]
pub struct End {
    /// `sign` × output; all journals are inside their play.
    pub value: f64,
    /// Whether the places determine the motion with another orientation there: on the way the mechanism passed a singular position, so that
    /// this is another assembly, which its play reaches.
    pub is_other_assembly: bool,
}

/// Largest `sign` × output from each of the random starts that came to an end.
pub fn maximise(set: &PoseSet, sign: f64, starts: usize, random: &mut Random) -> Vec<End> {
    (0..MAX_ATTEMPTS * starts).filter_map(|_| climb(set, sign, random)).take(starts).collect()
}

struct Local {
    value: f64,
    slopes: Vec<f64>,
    /// |u|² - (1 - margin)² of each block.
    bounds: Vec<f64>,
    /// Their derivatives, one block after the other.
    bound_slopes: Vec<Vec<f64>>,
}

fn bounds(set: &PoseSet, places: &[f64]) -> Vec<f64> {
    let square = |(first, size): &(usize, usize)| dot(&places[*first..first + size], &places[*first..first + size]);
    set.blocks.iter().map(|block| square(block) - (1.0 - MARGIN).powi(2)).collect()
}

fn local(set: &PoseSet, sign: f64, scale: f64, t: &[f64]) -> Option<Local> {
    let at = set.reach(t)?;
    let count = t.len();
    let mut found = Local {
        value: sign * at.output / scale,
        slopes: vec![0.0; count],
        bounds: bounds(set, &at.places),
        bound_slopes: vec![vec![0.0; count]; set.blocks.len()],
    };
    for k in 0..count {
        let moved = |step: f64| {
            let mut t = t.to_vec();
            t[k] += step;
            set.reach(&t)
        };
        let (plus, minus) = (moved(STEP)?, moved(-STEP)?);
        found.slopes[k] = sign * (plus.output - minus.output) / (2.0 * STEP * scale);
        let pairs = bounds(set, &plus.places).into_iter().zip(bounds(set, &minus.places));
        for (slopes, (plus, minus)) in found.bound_slopes.iter_mut().zip(pairs) {
            slopes[k] = (plus - minus) / (2.0 * STEP);
        }
    }
    Some(found)
}

/// Weights of the bounds.
struct Weights {
    multipliers: Vec<f64>,
    penalty: f64,
}

impl Weights {
    /// -value + Σ (max(0, λ + ρ g)² - λ²)/(2ρ)
    fn merit(&self, value: f64, bounds: &[f64]) -> f64 {
        let parts = self.multipliers.iter().zip(bounds);
        let sum: f64 = parts.map(|(own, bound)| (own + self.penalty * bound).max(0.0).powi(2) - own * own).sum();
        sum / (2.0 * self.penalty) - value
    }
    fn slopes(&self, at: &Local) -> Vec<f64> {
        let mut sum: Vec<f64> = at.slopes.iter().map(|slope| -slope).collect();
        for ((own, bound), slopes) in self.multipliers.iter().zip(&at.bounds).zip(&at.bound_slopes) {
            add(&mut sum, slopes, (own + self.penalty * bound).max(0.0));
        }
        sum
    }
}

fn climb(set: &PoseSet, sign: f64, random: &mut Random) -> Option<End> {
    let count = set.dimensions();
    let spread = random.between(0.2, 1.2);
    let mut t: Vec<f64> = (0..count).map(|_| spread * random.number()).collect();
    // What the output changes by within the play.
    let mut scale: f64 = 0.0;
    for _ in 0..8 {
        let direction: Vec<f64> = (0..count).map(|_| random.number()).collect();
        scale = scale.max(set.reach(&direction).map_or(0.0, |reached| reached.output.abs()));
    }
    if !(scale > 0.0) {
        return None;
    }
    let mut weights = Weights { multipliers: vec![0.0; set.blocks.len()], penalty: 4.0 };
    let (mut before, mut slow) = (f64::INFINITY, 0);
    for _ in 0..25 {
        minimise(set, sign, scale, &mut t, &weights)?;
        let at = bounds(set, &set.reach(&t)?.places);
        let mut miss: f64 = 0.0;
        for (own, bound) in weights.multipliers.iter_mut().zip(&at) {
            miss = miss.max(if *own > 0.0 { bound.abs().min(own.max(*bound)) } else { bound.max(0.0) });
            *own = (*own + weights.penalty * bound).max(0.0);
        }
        if miss < SMALL_MISS {
            break;
        }
        if miss > 0.25 * before {
            weights.penalty = (2.0 * weights.penalty).min(200.0);
        }
        slow += usize::from(miss > 0.7 * before);
        // Near singular positions some starts come to no end.
        if slow > MAX_SLOW {
            return None;
        }
        before = miss;
    }
    let at = set.reach(&t)?;
    if bounds(set, &at.places).iter().any(|bound| *bound > 2.0 * MARGIN) {
        return None;
    }
    Some(End { value: sign * at.output, is_other_assembly: orientation(set, &t)? <= 0.0 })
}

/// Determinant of the derivatives of Qᵀ places by t, which is 1 in the middle: by Gauss's elimination.
fn orientation(set: &PoseSet, t: &[f64]) -> Option<f64> {
    let count = t.len();
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for k in 0..count {
        let moved = |step: f64| {
            let mut t = t.to_vec();
            t[k] += step;
            set.reach(&t)
        };
        let (plus, minus) = (moved(STEP)?, moved(-STEP)?);
        let change: Vec<f64> = plus.places.iter().zip(&minus.places).map(|(a, b)| (a - b) / (2.0 * STEP)).collect();
        rows.push(set.first_order.iter().map(|column| dot(column, &change)).collect());
    }
    let mut determinant = 1.0;
    for k in 0..count {
        let pivot = (k..count).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs()))?;
        if pivot != k {
            rows.swap(pivot, k);
            determinant = -determinant;
        }
        determinant *= rows[k][k];
        let (above, below) = rows.split_at_mut(k + 1);
        for row in below {
            let factor = row[k] / above[k][k];
            add(row, &above[k], -factor);
        }
    }
    Some(determinant)
}

fn minimise(set: &PoseSet, sign: f64, scale: f64, t: &mut Vec<f64>, weights: &Weights) -> Option<()> {
    let count = t.len();
    let unit = |k: usize| (0..count).map(|i| if i == k { 0.25 } else { 0.0 }).collect::<Vec<f64>>();
    let mut inverse: Vec<Vec<f64>> = (0..count).map(unit).collect();
    let mut at = local(set, sign, scale, t)?;
    let mut slopes = weights.slopes(&at);
    for _ in 0..MAX_QUASI_NEWTON {
        if length(&slopes) < 1e-9 {
            break;
        }
        let mut step: Vec<f64> = times(&inverse, &slopes).iter().map(|entry| -entry).collect();
        if dot(&step, &slopes) >= 0.0 {
            inverse = (0..count).map(unit).collect();
            step = slopes.iter().map(|slope| -0.25 * slope).collect();
        }
        let long = length(&step);
        if long > 1.0 {
            step.iter_mut().for_each(|entry| *entry /= long);
        }
        let (merit, fall) = (weights.merit(at.value, &at.bounds), dot(&step, &slopes));
        let mut share = 1.0;
        let next = loop {
            let mut place = t.clone();
            add(&mut place, &step, share);
            let is_lower = set.reach(&place).is_some_and(|reached| {
                let own = weights.merit(sign * reached.output / scale, &bounds(set, &reached.places));
                own <= merit + 1e-4 * share * fall
            });
            if is_lower {
                break Some(place);
            }
            share *= 0.4;
            if share < 1e-9 {
                break None;
            }
        };
        let Some(place) = next else { break };
        let Some(new) = local(set, sign, scale, &place) else { break };
        let new_slopes = weights.slopes(&new);
        let moved: Vec<f64> = place.iter().zip(t.iter()).map(|(a, b)| a - b).collect();
        let change: Vec<f64> = new_slopes.iter().zip(&slopes).map(|(a, b)| a - b).collect();
        update(&mut inverse, &moved, &change);
        (*t, at, slopes) = (place, new, new_slopes);
    }
    Some(())
}

/// H := (1 - s yᵀ/sᵀy) H (1 - y sᵀ/sᵀy) + s sᵀ/sᵀy
fn update(inverse: &mut [Vec<f64>], moved: &[f64], change: &[f64]) {
    let product = dot(moved, change);
    if product <= 1e-12 * length(moved) * length(change) {
        return;
    }
    let image: Vec<f64> = inverse.iter().map(|row| dot(row, change)).collect();
    let factor = (1.0 + dot(change, &image) / product) / product;
    for (i, row) in inverse.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry += factor * moved[i] * moved[j] - (image[i] * moved[j] + moved[i] * image[j]) / product;
        }
    }
}
