//! Instants within a step at which pin and hole meet or part.

use loosepin_math::Quintic;
use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::dynamics::PlayState;
use loosepin_mechanics::mechanism::{GapMeasure, PlayGeometry};

/// A function that is positive in contact, and its first two derivatives over the variable of integration: g as
/// [`GapMeasure`] says, or the root u = √δ, √m, where that is an unknown.
#[derive(Debug, Clone, Copy, Default)]
pub struct GapJet {
    /// Value, first and second derivative.
    pub jet: [f64; 3],
}

/// Which way g goes through zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Crossing {
    /// Contact begins: g from negative to positive.
    Onset,
    /// Contact ends: g from positive to negative.
    Separation,
}

impl Crossing {
    /// +1 where g must rise, -1 where it must fall.
    pub fn sign(self) -> f64 {
        match self {
            Self::Onset => 1.0,
            Self::Separation => -1.0,
        }
    }
}

/// The first share τ in [0, 1] of a step of `step_s` at which g, between `start` and `end`, goes through zero in the
/// direction of `crossing`; also when it comes back within the step.
///
/// A start beyond zero is the end of the event before, and off by its tolerance: g must come back first. Where it does not but
/// goes on instead, the event is at the start.
pub fn first_crossing(start: &GapJet, end: &GapJet, step_s: f64, crossing: Crossing) -> Option<f64> {
    /// The step is searched piece by piece: a polynomial of degree five turns at most four times.
    const PIECES: usize = 8;
    /// Boundaries of the pieces, as shares of the step.
    const SHARES: [f64; PIECES + 1] = [0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0];
    let sign = crossing.sign();
    let signed = |[value, slope, curvature]: [f64; 3]| [sign * value, sign * slope, sign * curvature];
    let [p0, v0, a0] = signed(start.jet);
    let [p1, v1, a1] = signed(end.jet);
    let h = step_s;
    // The polynomial lies below the largest of its Bernstein coefficients: mostly that settles it. The first one is g at
    // the start, where the sign is known up to the tolerance of the event before.
    let bernstein = [
        p0 + v0 * h / 5.0,
        p0 + 0.4 * v0 * h + a0 * h * h / 20.0,
        p1 - 0.4 * v1 * h + a1 * h * h / 20.0,
        p1 - v1 * h / 5.0,
        p1,
    ];
    if bernstein.iter().all(|&b| b < 0.0) {
        return None;
    }
    let quintic = Quintic::new([p0, v0, a0], [p1, v1, a1], h);
    // With one change of sign among the coefficients g rises through zero once.
    let changes = bernstein.iter().fold((0, p0 > 0.0), |(changes, was_above), &b| {
        let is_above = b > 0.0;
        (changes + u32::from(is_above != was_above), is_above)
    });
    if p0 <= 0.0 && changes == (1, true) && quintic.value(1.0) > 0.0 {
        // Values at all pieces at once take less time than halving, where one waits for the other.
        let values = SHARES.map(|share| quintic.value(share));
        let piece = values[1..PIECES].iter().map(|&value| usize::from(value <= 0.0)).sum::<usize>();
        let ([low, high], [below, above]) = ([SHARES[piece], SHARES[piece + 1]], [values[piece], values[piece + 1]]);
        // Near the start, which may be a root of its own, no secant tells more than the middle.
        let brackets = piece > 0 && below <= 0.0 && above > 0.0;
        let share = if brackets { below / (below - above) } else { 0.5 };
        return Some(root_from(&quintic, [low, high], low + (high - low) * share));
    }
    let mut has_come_back = p0 <= 0.0;
    let mut left = (0.0, p0);
    for piece in 1..=PIECES {
        let tau = piece as f64 / PIECES as f64;
        let right = (tau, quintic.value(tau));
        if !has_come_back {
            has_come_back = right.1 <= 0.0;
            if right.1 > 0.0 && quintic.slope(left.0) < 0.0 && quintic.slope(tau) > 0.0 {
                // Below zero and up again within the piece.
                let bottom = turning_point(&Quintic::new([-p0, -v0, -a0], [-p1, -v1, -a1], h), left.0, tau);
                if quintic.value(bottom) <= 0.0 {
                    return Some(root(&quintic, bottom, tau));
                }
            }
            left = right;
            continue;
        }
        if right.1 > 0.0 {
            return Some(root(&quintic, left.0, right.0));
        }
        // A maximum inside the piece may touch zero though both ends are below it.
        if quintic.slope(left.0) > 0.0 && quintic.slope(tau) < 0.0 {
            let top = turning_point(&quintic, left.0, tau);
            if quintic.value(top) > 0.0 {
                return Some(root(&quintic, left.0, top));
            }
        }
        left = right;
    }
    (!has_come_back && p1 > p0).then_some(0.0)
}

/// Largest value of g within a step.
pub fn largest_gap(start: &GapJet, end: &GapJet, step_s: f64) -> f64 {
    let ends = start.jet[0].max(end.jet[0]);
    if start.jet[1] > 0.0 && end.jet[1] < 0.0 {
        let quintic = Quintic::new(start.jet, end.jet, step_s);
        ends.max(quintic.value(turning_point(&quintic, 0.0, 1.0)))
    } else {
        ends
    }
}

/// A step in contact: the gap or the root at both ends, and the time.
#[derive(Debug, Clone, Copy)]
pub struct ContactStep {
    /// Gap, or root, at the start and at the end.
    pub gap: [GapJet; 2],
    /// Time and its derivatives at both ends.
    pub time: [GapJet; 2],
    /// Length of the step.
    pub step: f64,
    /// Whether `gap` is the root of the penetration.
    pub is_root: bool,
}

impl ContactStep {
    /// Largest penetration within the step, m.
    pub fn largest_penetration_m(&self, measure: GapMeasure) -> f64 {
        let largest = largest_gap(&self.gap[0], &self.gap[1], self.step);
        if self.is_root { largest * largest } else { measure.penetration_m(largest) }
    }

    /// Largest normal force within the step, N, at the ends and three points between. `shares` are the forces at both ends
    /// over those of the law: other than one in a slot or at the end of a guide alone, and taken as growing evenly. On an elastic foundation they are the forces at both ends.
    pub fn largest_force_n(&self, play: &PlayGeometry<f64>, state: &PlayState<f64>, shares: [f64; 2]) -> f64 {
        if play.foundation.is_some() {
            return shares[0].max(shares[1]);
        }
        let gap = Quintic::new(self.gap[0].jet, self.gap[1].jet, self.step);
        let time = Quintic::new(self.time[0].jet, self.time[1].jet, self.step);
        let measure = GapMeasure::of(play);
        let force_n = |tau: f64| {
            let value = gap.value(tau);
            if self.is_root {
                let rate_m_s = 2.0 * gap.slope(tau) / self.step; // u' = δ̇/2 with dt = u ds
                return play.normal.force_at_root(value.max(0.0), rate_m_s, state).total_n;
            }
            let rate_m_s = gap.slope(tau) / (measure.rate_share(value) * time.slope(tau));
            play.normal.force(measure.penetration_m(value), rate_m_s, state).total_n
        };
        let share = |tau: f64| shares[0] + (shares[1] - shares[0]) * tau;
        (0..=4).map(|k| f64::from(k) / 4.0).map(|tau| share(tau) * force_n(tau)).fold(0.0, f64::max)
    }
}

/// Bisections that leave a share of 1e-15 of a step.
const BISECTIONS: usize = 50;
/// Length of a Newton step below which it ends on the root: each squares the remaining error.
const LAST_NEWTON_STEP: f64 = 1e-8;

/// The rising root of the polynomial between `low` (not above) and `high` (above).
fn root(quintic: &Quintic, low: f64, high: f64) -> f64 {
    root_from(quintic, [low, high], 0.5 * (low + high))
}

/// The same, from a guess `tau` in between.
fn root_from(quintic: &Quintic, [mut low, mut high]: [f64; 2], mut tau: f64) -> f64 {
    for _ in 0..BISECTIONS {
        let value = quintic.value(tau);
        if value > 0.0 {
            high = tau
        } else {
            low = tau
        }
        // Newton's step where it stays inside, else the middle. On the root, which is an end by now, it goes nowhere.
        let newton = tau - value / quintic.slope(tau);
        if newton >= low && newton <= high {
            if (newton - tau).abs() <= LAST_NEWTON_STEP {
                return newton;
            }
            tau = newton;
        } else {
            let middle = 0.5 * (low + high);
            if middle == low || middle == high {
                return middle;
            }
            tau = middle;
        }
    }
    tau
}

/// The falling root of the slope between `low` and `high`.
fn turning_point(quintic: &Quintic, mut low: f64, mut high: f64) -> f64 {
    let (mut slope_low, mut slope_high) = (quintic.slope(low), quintic.slope(high));
    let mut middle = 0.5 * (low + high);
    for _ in 0..BISECTIONS {
        let slope = quintic.slope(middle);
        if slope > 0.0 {
            (low, slope_low) = (middle, slope);
        } else {
            (high, slope_high) = (middle, slope);
        }
        if high - low < 1e-10 {
            break;
        }
        // The secant where it stays well inside, else the middle.
        let secant = low + (high - low) * slope_low / (slope_low - slope_high);
        let margin = 1e-3 * (high - low);
        let next = if secant > low + margin && secant < high - margin { secant } else { 0.5 * (low + high) };
        if (next - middle).abs() < 1e-10 {
            break;
        }
        middle = next;
    }
    middle
}

#[cfg(test)]
mod tests {
    use super::*;

    fn jet(f: impl Fn(f64) -> [f64; 3], t: f64) -> GapJet {
        GapJet { jet: f(t) }
    }

    #[test]
    fn analytic_crossings_in_every_piece_of_a_step() {
        // Within the pieces, and where they meet.
        let within = (0..=40).map(|k| f64::from(k) / 40.0 * 0.99 + 0.005);
        for root in within.chain((1..8).map(|k| f64::from(k) / 8.0)) {
            // A parabola and a line that rise through zero once.
            for bend in [0.0, 0.9] {
                let f = |t: f64| [(t - root) * (1.0 + bend * t), 1.0 + bend * (2.0 * t - root), 2.0 * bend];
                let found = first_crossing(&jet(f, 0.0), &jet(f, 1.0), 1.0, Crossing::Onset).expect("it rises");
                assert!((found - root).abs() < 1e-14, "{found} {root}");
            }
        }
        // A start on zero itself that falls first is not the crossing.
        let f = |t: f64| [t * (t - 0.05), 2.0 * t - 0.05, 2.0];
        let found = first_crossing(&jet(f, 0.0), &jet(f, 1.0), 1.0, Crossing::Onset).expect("it comes back");
        assert!((found - 0.05).abs() < 1e-12, "{found}");
    }

    #[test]
    fn analytic_crossing_touch_and_miss() {
        // g = (t - 0.3)(0.7 - t) - margin: a hump of height 0.04 - margin.
        let hump = |margin: f64| move |t: f64| [(t - 0.3) * (0.7 - t) - margin, 1.0 - 2.0 * t, -2.0];
        let found =
            |margin: f64, crossing| first_crossing(&jet(hump(margin), 0.0), &jet(hump(margin), 1.0), 1.0, crossing);
        let touch = found(0.0, Crossing::Onset).expect("both ends are below zero, the middle is above");
        assert!((touch - 0.3).abs() < 1e-12);
        let grazing = found(0.04 - 1e-9, Crossing::Onset).expect("the top is 1e-9 above zero");
        assert!((grazing - 0.5).abs() < 1e-4);
        assert!(found(0.04 + 1e-9, Crossing::Onset).is_none(), "the top is 1e-9 below zero");
        // Contact that begins at 0.3 exactly and ends at 0.7, seen over [0.3, 1].
        let f = hump(0.0);
        let end = first_crossing(&jet(f, 0.3), &jet(f, 1.0), 0.7, Crossing::Separation).expect("g falls at 0.7");
        assert!((0.3 + 0.7 * end - 0.7).abs() < 1e-12);
        // Just beyond zero at the start of a flight that goes on: no event. One that turns back at once is one at the start.
        let leaving = |t: f64| [1e-9 - t, -1.0, 0.0];
        assert!(first_crossing(&jet(leaving, 0.0), &jet(leaving, 1e-10), 1e-10, Crossing::Onset).is_none());
        let turning = |t: f64| [1e-9 - t + 40.0 * t * t, -1.0 + 80.0 * t, 80.0];
        let back = first_crossing(&jet(turning, 0.0), &jet(turning, 0.5), 0.5, Crossing::Onset);
        assert!((back.expect("it comes back at 0.025") - 0.05).abs() < 1e-6);
        let largest = largest_gap(&jet(f, 0.0), &jet(f, 1.0), 1.0);
        assert!((largest - 0.04).abs() < 1e-15);
    }
}
