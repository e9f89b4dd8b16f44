//! The largest linear function on a product of unit balls, cut by one plane.
//!
//! For blocks v_k, |v_k| <= 1, with h·v = b: maximise g·v - τ|v - v0|²/2. For a multiplier λ of the plane each block lies where it is best for
//! g - λ h, and h·v = b is one equation for λ. With g_k = λ_k h_k + p_k, p_k across h_k:
//!
//! ```text
//! τ = 0:  minimise Σ |g_k - λ h_k| + λ b,   slope b + Σ |h_k| t/√(a_k² + t²),   t = λ - λ_k,  a_k = |p_k|/|h_k|
//! ```
//!
//! The slope grows with λ: it has a jump of 2 |h_k| at λ_k where p_k = 0, as of intervals, and is smooth elsewhere. With τ > 0 it has none.

use crate::accuracy::linear::near::Near;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::play_set::{PlacedBlock, PlaySet};

/// Parts of gains below this, relative to all of them, have no direction of their own: where they decide, the place is not unique.
const NO_DIRECTION: f64 = 1e-12;
/// Share of the plane's reach that b is below: where it hardly reaches into the balls, the multiplier has no end.
const REACH: f64 = 1.0 - 1e-6;
/// Most evaluations of the slope; eight are usual.
const MAX_STEPS: usize = 200;
/// Slope that is round-off, relative to the reach of the plane.
const FLAT: f64 = 1e-16;

/// What one block adds to the slope.
struct Part<'a> {
    block: &'a PlacedBlock,
    /// |h|, which is not zero.
    size: f64,
    /// Multiplier at which the gains of the block are across h.
    middle: f64,
    /// Length of what they are there, over |h|; 0 where it is round-off.
    across: f64,
}

impl Part<'_> {
    /// What it adds to the slope, and to its derivative; nothing at its own jump.
    fn slope(&self, multiplier: f64) -> (f64, f64) {
        let t = multiplier - self.middle;
        let square = self.across * self.across + t * t;
        if square == 0.0 {
            return (0.0, 0.0);
        }
        let root = square.sqrt();
        (self.size * t / root, self.size * self.across * self.across / (square * root))
    }
}

/// The place with the largest value, and the multiplier of the plane; `row` is h, a unit vector, and the gains add up to one. `None` where the
/// place is not unique, or the plane hardly reaches into the balls.
pub(crate) fn on_plane(
    set: &PlaySet,
    gains: &[f64],
    near: Option<Near>,
    row: &[f64],
    b: f64,
) -> Option<(Vec<f64>, f64)> {
    let reach = set.blocks().iter().map(|block| PlaySet::length(block, row)).sum::<f64>();
    if !(b.abs() < REACH * reach) {
        return None;
    }
    match near.filter(|near| near.weight > 0.0) {
        Some(near) => near_place(set, gains, &near, row, b, reach),
        None => far_place(set, gains, row, b, reach),
    }
}

fn far_place(set: &PlaySet, gains: &[f64], row: &[f64], b: f64, reach: f64) -> Option<(Vec<f64>, f64)> {
    let mut parts = Vec::with_capacity(set.blocks().len());
    for block in set.blocks() {
        let (g, h) = (&gains[block.range()], &row[block.range()]);
        let square = dot(h, h);
        if square == 0.0 {
            continue;
        }
        let middle = dot(g, h) / square;
        let across = g.iter().zip(h).map(|(g, h)| (g - middle * h) * (g - middle * h)).sum::<f64>().sqrt();
        let is_along = g.len() == 1 || across <= NO_DIRECTION;
        parts.push(Part {
            block,
            size: square.sqrt(),
            middle,
            across: if is_along { 0.0 } else { across / square.sqrt() },
        });
    }
    let slope = |multiplier: f64| {
        let add = |sum: (f64, f64), part: &Part| {
            let own = part.slope(multiplier);
            (sum.0 + own.0, sum.1 + own.1)
        };
        parts.iter().fold((b, 0.0), add)
    };
    let mut jumps: Vec<&Part> = parts.iter().filter(|part| part.across == 0.0).collect();
    jumps.sort_by(|a, b| a.middle.total_cmp(&b.middle));
    // All gains against all of the plane: no multiplier is larger.
    let farthest = 2.0 / (reach - b.abs());
    let (mut from, mut to) = (-farthest, farthest);
    let (mut first, mut last) = (0, jumps.len());
    let mut at_jump = None;
    while first < last {
        let middle = usize::midpoint(first, last);
        let (jump, value) = (jumps[middle], slope(jumps[middle].middle).0);
        let size: f64 = jumps.iter().filter(|other| other.middle == jump.middle).map(|other| other.size).sum();
        if value + size < 0.0 {
            (from, first) = (jump.middle, middle + 1);
        } else if value - size > 0.0 {
            (to, last) = (jump.middle, middle);
        } else {
            at_jump = Some((jump, value));
            break;
        }
    }
    let multiplier = match at_jump {
        Some((jump, _)) => jump.middle,
        None => root(from, to, FLAT * reach, &slope)?,
    };
    let mut place = vec![0.0; gains.len()];
    for block in set.blocks() {
        let (g, h, own) = (&gains[block.range()], &row[block.range()], &mut place[block.range()]);
        if let Some((_, value)) = at_jump.filter(|(jump, _)| jump.block.first == block.first) {
            // What the others leave of the plane.
            let share = value / dot(h, h);
            own.iter_mut().zip(h).for_each(|(place, h)| *place = share * h);
            continue;
        }
        own.iter_mut().zip(g).zip(h).for_each(|((place, g), h)| *place = g - multiplier * h);
        let length = dot(own, own).sqrt();
        if length > NO_DIRECTION {
            own.iter_mut().for_each(|place| *place /= length);
        } else if g.iter().chain(h).all(|value| *value == 0.0) {
            own.fill(0.0);
        } else {
            return None;
        }
    }
    Some((place, multiplier))
}

/// As above with a pull τ to a place v0: c = v0 + g/τ in place of g, and multipliers over τ.
fn near_place(set: &PlaySet, gains: &[f64], near: &Near, row: &[f64], b: f64, reach: f64) -> Option<(Vec<f64>, f64)> {
    let pulled: Vec<f64> = near.place.iter().zip(gains).map(|(at, gain)| at + gain / near.weight).collect();
    let mut parts = Vec::with_capacity(set.blocks().len());
    for block in set.blocks() {
        let (c, h) = (&pulled[block.range()], &row[block.range()]);
        let square = dot(h, h);
        if square > 0.0 {
            let middle = dot(c, h) / square;
            let across = c.iter().zip(h).map(|(c, h)| (c - middle * h) * (c - middle * h)).sum::<f64>();
            parts.push((square, middle, across));
        }
    }
    // b - h·v, and its derivative.
    let slope = |multiplier: f64| {
        parts.iter().fold((b, 0.0), |(value, by), (square, middle, across)| {
            let t = multiplier - middle;
            let length_square = across + t * t * square;
            if length_square <= 1.0 {
                return (value + t * square, by + square);
            }
            let length = length_square.sqrt();
            (value + t * square / length, by + square * across / (length_square * length))
        })
    };
    let start = slope(0.0).0;
    // Beyond the place at which the slope has the other sign.
    let mut end = if start > 0.0 { -1.0 } else { 1.0 };
    let mut steps = 0;
    while slope(end).0 * start > 0.0 {
        end *= 4.0;
        steps += 1;
        if steps > MAX_STEPS {
            return None;
        }
    }
    let multiplier = root(end.min(0.0), end.max(0.0), FLAT * reach, &slope)?;
    let mut place: Vec<f64> = pulled.iter().zip(row).map(|(c, h)| c - multiplier * h).collect();
    set.cut_back(&mut place);
    Some((place, multiplier * near.weight))
}

/// Where a function that grows is zero between two places, by Newton's method within a bracket.
fn root(mut from: f64, mut to: f64, flat: f64, function: &dyn Fn(f64) -> (f64, f64)) -> Option<f64> {
    let mut at = if from < 0.0 && to > 0.0 { 0.0 } else { 0.5 * (from + to) };
    for _ in 0..MAX_STEPS {
        let (value, by) = function(at);
        if value.abs() <= flat {
            return Some(at);
        }
        if value > 0.0 {
            to = at;
        } else {
            from = at;
        }
        let newton = at - value / by;
        let next = if newton > from && newton < to { newton } else { 0.5 * (from + to) };
        // Nothing is between.
        if next == at || !(to - from > f64::EPSILON * at.abs()) {
            return Some(at);
        }
        at = next;
    }
    None
}
