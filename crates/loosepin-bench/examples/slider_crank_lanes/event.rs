//! Where in a step a contact begins or ends.

use loosepin::math::Quintic;

/// Pieces in which a step is searched: a polynomial of degree five turns at most four times.
const PIECES: usize = 8;
/// Steps of Newton's method or bisections.
const MAX_STEPS: usize = 60;
/// A step of Newton's method as short as this is the last: its error is the square of it, about.
const NEAR: f64 = 1e-6;

/// The first share of a step of length `step` at which the gap, between `[value, slope, curvature]` at both ends, rises through zero.
pub fn first_rise(start: [f64; 3], end: [f64; 3], step: f64) -> Option<f64> {
    let gap = Quintic::new(start, end, step);
    let mut was_below = start[0] <= 0.0;
    let mut left = 0.0;
    for piece in 1..=PIECES {
        let right = piece as f64 / PIECES as f64;
        let is_above = gap.value(right) > 0.0;
        if was_below && is_above {
            return Some(rise(&gap, left, right));
        }
        if was_below && gap.slope(left) > 0.0 && gap.slope(right) < 0.0 {
            // A maximum inside the piece may reach above zero though both ends are below.
            let top = turning_point(&gap, left, right);
            if gap.value(top) > 0.0 {
                return Some(rise(&gap, left, top));
            }
        }
        was_below |= !is_above;
        left = right;
    }
    None
}

/// The share of a step at which √δ, between `[value, slope]` at both ends, falls through zero.
pub fn separation(start: [f64; 2], end: [f64; 2], step: f64) -> f64 {
    let [p0, v0, p1, v1] = [-start[0], -start[1] * step, -end[0], -end[1] * step];
    let change = p1 - p0;
    let cubic = Quintic { coefficients: [p0, v0, 3.0 * change - 2.0 * v0 - v1, v0 + v1 - 2.0 * change, 0.0, 0.0] };
    rise(&cubic, 0.0, 1.0)
}

/// Where the polynomial rises through zero between `low` (not above) and `high` (above).
fn rise(gap: &Quintic, mut low: f64, mut high: f64) -> f64 {
    let mut share = 0.5 * (low + high);
    for _ in 0..MAX_STEPS {
        let value = gap.value(share);
        if value > 0.0 {
            high = share
        } else {
            low = share
        }
        let newton = share - value / gap.slope(share);
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - share).abs() < NEAR {
            return next;
        }
        share = next;
    }
    share
}

/// Where the slope falls through zero between `low` and `high`.
fn turning_point(gap: &Quintic, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..MAX_STEPS {
        let middle = 0.5 * (low + high);
        if gap.slope(middle) > 0.0 {
            low = middle
        } else {
            high = middle
        }
        if high - low < 1e-9 {
            break;
        }
    }
    0.5 * (low + high)
}
