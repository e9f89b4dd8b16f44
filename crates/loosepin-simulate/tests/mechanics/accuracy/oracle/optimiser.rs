//! The largest deviation of an output over the play, by sampling and by climbing from many starts. It shares nothing with the library.

use super::mechanism::{Reach, Rig};
use super::random::Random;

/// Random places that are looked at before the best of them are climbed from.
const SAMPLES: usize = 150;
/// Climbs from the best samples, and from random ones.
const CLIMBS: usize = 7;
/// Rounds over all numbers in a climb.
const ROUNDS: usize = 40;

/// A mechanism at one angle of its crank.
pub(super) struct Poised<'r> {
    rig: &'r Rig,
    crank_rad: f64,
    ideal: Vec<f64>,
    side: f64,
    reaches: Vec<Reach>,
}

impl<'r> Poised<'r> {
    /// Turned there from the start in small steps; `None` if it does not close on the way.
    pub fn new(rig: &'r Rig, crank_rad: f64) -> Option<Self> {
        let mut ideal = rig.start();
        let reaches = rig.reaches();
        let middle = vec![[0.0; 2]; reaches.len()];
        let steps = (crank_rad.abs() / 0.01).ceil().max(1.0) as usize;
        let mut side = 0.0;
        for step in 0..=steps {
            if !rig.close(&mut ideal, crank_rad * step as f64 / steps as f64, &middle, &mut side) {
                return None;
            }
        }
        Some(Self { rig, crank_rad, ideal, side, reaches })
    }

    /// The deviation at a place of the play, two numbers for each joint; `None` if the links cannot follow from the middle.
    fn deviation(&self, at: &[f64]) -> Option<f64> {
        let full: Vec<[f64; 2]> = self.reaches.iter().zip(at.chunks(2)).map(|(reach, at)| place(*reach, at)).collect();
        let mut q = self.ideal.clone();
        let mut side = self.side;
        for share in [0.5, 1.0] {
            let part: Vec<[f64; 2]> = full.iter().map(|e| e.map(|part| part * share)).collect();
            if !self.rig.close(&mut q, self.crank_rad, &part, &mut side) {
                return None;
            }
        }
        Some(self.rig.value(&q) - self.rig.value(&self.ideal))
    }

    /// The largest deviation for the sign 1, the smallest for -1.
    pub fn extreme(&self, sign: f64, random: &mut Random) -> f64 {
        let n = 2 * self.reaches.len();
        let value = |at: &[f64]| self.deviation(at).map_or(f64::NEG_INFINITY, |deviation| sign * deviation);
        let mut starts: Vec<(f64, Vec<f64>)> = (0..SAMPLES)
            .map(|_| {
                let at: Vec<f64> = (0..n)
                    .map(|k| if k % 2 == 0 { random.between(-3.2, 3.2) } else { random.between(0.3, 1.0) })
                    .collect();
                (value(&at), at)
            })
            .collect();
        starts.sort_by(|a, b| b.0.total_cmp(&a.0));
        let rest = starts.split_off(4);
        starts.extend(rest.into_iter().rev().step_by(SAMPLES / 3).take(CLIMBS - 4));
        let mut best = 0.0_f64;
        for (mut found, mut at) in starts {
            let mut steps = vec![0.5; n];
            for _ in 0..ROUNDS {
                let before = found;
                for k in 0..n {
                    // Three values tell a parabola; the step shrinks to where it is one.
                    let mut look = |to: f64, at: &mut Vec<f64>| {
                        let kept = at[k];
                        at[k] = to;
                        let seen = value(at);
                        if seen > found {
                            found = seen;
                        } else {
                            at[k] = kept;
                        }
                        seen
                    };
                    let (middle, h) = (at[k], steps[k]);
                    let centre = value(&at);
                    let [low, high] = [look(middle - h, &mut at), look(middle + h, &mut at)];
                    let bend = low - 2.0 * centre + high;
                    if bend < 0.0 && low.is_finite() && high.is_finite() {
                        let to = middle + (0.5 * h * (low - high) / bend).clamp(-3.0 * h, 3.0 * h);
                        look(to, &mut at);
                    }
                    let moved = (at[k] - middle).abs();
                    steps[k] = if moved > 0.9 * h { 1.5 * h } else { (0.4 * h).max(1e-5) };
                }
                if found - before <= 1e-11 * found.abs() && steps.iter().all(|step| *step < 1e-3) {
                    break;
                }
            }
            best = best.max(found);
        }
        sign * best
    }
}

/// A place of a joint for two numbers: angle and radius, or a wave along a line, or both of a block.
fn place(reach: Reach, at: &[f64]) -> [f64; 2] {
    let radius = at[1].clamp(-1.0, 1.0);
    match reach {
        Reach::Disc(c) => [c * radius * at[0].cos(), c * radius * at[0].sin()],
        Reach::Line(c) => [c * at[0].sin(), 0.0],
        Reach::Block([c, a, b]) => {
            // Tilts up to where a corner meets a face, by halving; then what the corners leave across.
            let left = |tilt: f64| c + b * (1.0 - tilt.cos()) - a * tilt.abs().sin();
            let (mut low, mut high) = (0.0, (a / b).atan());
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if left(middle) >= 0.0 { low = middle } else { high = middle }
            }
            let tilt = low * at[0].sin();
            [left(tilt).max(0.0) * radius, tilt]
        }
    }
}
