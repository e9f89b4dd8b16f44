//! One search for an extreme deviation.

use crate::accuracy::extreme::{Extreme, SearchOptions};
use crate::accuracy::linear::near::Near;
use crate::accuracy::linear::slice::largest;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::placed::{Placed, Start};
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::closure::newton::largest as largest_entry;
use crate::output::SpatialOutput;
use crate::output::kind_of_output::OutputState;
use crate::random::random;

/// Most steps of a search; about ten are usual.
const MAX_STEPS: usize = 200;
/// A step below this, in units of the radii, is the end.
const LAST_STEP: f64 = 1e-12;
/// An expected improvement below this, relative to the worst case of first order, is the end.
const LAST_IMPROVEMENT: f64 = 1e-14;
/// Pull to the present place in each step, relative to the worst case of first order: blocks that do nothing to first order stay where they are,
/// since they may be what lets the loops close.
const LEAST_PULL: f64 = 1e-9;
/// Pull with which a step is made again that brought nothing, where none was; relative to the worst case of first order, as the next ones.
const FIRST_PULL: f64 = 0.25;
/// Share of the pull that is left after a step that brought something, and by what it grows after one that did not.
const LESS_PULL: f64 = 0.125;
const MORE_PULL: f64 = 4.0;
/// Share of the expected improvement from which a step is as good as expected.
const GOOD_SHARE: f64 = 0.6;
/// Share of the expected improvement up to which a step went too far: again and again from side to side, it comes to an end in many steps only.
const POOR_SHARE: f64 = 0.25;
/// An expected improvement below this is round-off of the poses, rad and relative to the characteristic length.
const ROUND_OFF: f64 = 4.0 * f64::EPSILON;
/// Pull below which there is none. Where many plays do nearly nothing, the best places are those of a small one.
const MIN_PULL: f64 = 1e-8;
/// Pull with which a search ends: its steps are nothing.
const MAX_PULL: f64 = 1e12;

/// A search for the largest `sign` × deviation of an output.
pub(crate) struct Climb<'a, 'b> {
    pub accuracy: &'a PoseAccuracy<'b>,
    pub output: &'a SpatialOutput,
    pub sign: f64,
}

/// A place with what is sought.
struct Reached {
    at: Placed,
    /// `sign` × deviation.
    value: f64,
}

impl Climb<'_, '_> {
    /// From journals in the middle.
    pub(crate) fn climb_from_middle(&self) -> Option<Extreme> {
        self.climb(vec![0.0; self.accuracy.play_set().variables()], self.accuracy.ideal_start())
    }

    /// From places of the journals, m, cut back to their play.
    pub(crate) fn climb_from_variables(&self, variables_m: &[f64]) -> Option<Extreme> {
        let set = &self.accuracy.set;
        if variables_m.len() != set.variables() || !variables_m.iter().all(|value| value.is_finite()) {
            return None;
        }
        let radii = set.radii_m();
        let scaled =
            variables_m.iter().zip(radii).map(|(value, radius)| if radius > 0.0 { value / radius } else { 0.0 });
        let mut scaled: Vec<f64> = scaled.collect();
        set.cut_back(&mut scaled);
        self.climb(scaled, self.accuracy.ideal_start())
    }

    /// From the worst case of first order of some gains, of variables in units of their radii.
    pub(crate) fn climb_from_objective(&self, scaled_gains: &[f64]) -> Option<Extreme> {
        let accuracy = self.accuracy;
        let pairs = accuracy.closed_rows().into_iter().zip(&accuracy.apart);
        let right: Vec<f64> = pairs.map(|(closed, apart)| closed - apart).collect();
        let best = largest(&accuracy.set, scaled_gains, None, &accuracy.planes, &right)?;
        self.climb(best.place, accuracy.ideal_start())
    }

    /// From a place in units of the radii, on the branch of `from`.
    pub(crate) fn climb(&self, start: Vec<f64>, from: Start<'_>) -> Option<Extreme> {
        let accuracy = self.accuracy;
        let mut now = self.reached(start, from)?;
        let (mut weight, mut last_pull): (f64, f64) = (0.0, 0.0);
        let round_off = ROUND_OFF * accuracy.loops.length_m.min(1.0);
        for step in 0..MAX_STEPS {
            let gains = self.gains(&now.at);
            let scale = accuracy.set.support(&gains).iter().sum::<f64>();
            if step == 0 {
                last_pull = FIRST_PULL * scale;
            }
            if scale == 0.0 {
                break;
            }
            let (planes, right) = accuracy.linear_conditions(&now.at);
            // With planes an interior point method is more exact without it.
            let pull = if planes.count() == 0 { weight.max(LEAST_PULL * scale) } else { weight };
            let near = (pull > 0.0).then_some(Near { weight: pull, place: &now.at.scaled });
            let next = largest(&accuracy.set, &gains, near, &planes, &right);
            let next = next.map(|found| found.place).and_then(|place| {
                let change: Vec<f64> = place.iter().zip(&now.at.scaled).map(|(a, b)| a - b).collect();
                let expected = dot(&gains, &change);
                let least = (LAST_IMPROVEMENT * scale).max(round_off);
                let is_over = largest_entry(&change) < LAST_STEP || expected <= least;
                let found = self.reached(place, now.at.start())?;
                Some((found, expected, is_over))
            });
            match next {
                Some((next, expected, is_over)) if next.value > now.value => {
                    let share = (next.value - now.value) / expected;
                    now = next;
                    if weight > 0.0 {
                        last_pull = weight;
                    }
                    // As in methods of trust regions: a step that brought what was expected may be longer, one that brought little shorter.
                    weight = match share {
                        share if share > GOOD_SHARE => LESS_PULL * weight,
                        share if share < POOR_SHARE => MORE_PULL * weight.max(MIN_PULL * scale),
                        _ => weight,
                    };
                    if weight < MIN_PULL * scale {
                        weight = 0.0;
                    }
                    if is_over {
                        break;
                    }
                }
                Some((_, _, true)) => break,
                _ => {
                    weight = if weight > 0.0 { MORE_PULL * weight } else { last_pull.max(MIN_PULL * scale) };
                    if weight > MAX_PULL * scale {
                        break;
                    }
                }
            }
        }
        Some(Extreme {
            deviation: self.sign * now.value,
            variables_m: accuracy.set.in_metres(&now.at.scaled),
            poses: now.at.closed.poses,
        })
    }

    fn reached(&self, scaled: Vec<f64>, from: Start<'_>) -> Option<Reached> {
        let at = self.accuracy.placed(scaled, from)?;
        let value = self.sign * self.accuracy.deviation_of(self.output, &at.closed.poses);
        Some(Reached { at, value })
    }

    /// Gains of `sign` × deviation at a place.
    fn gains(&self, at: &Placed) -> Vec<f64> {
        let accuracy = self.accuracy;
        let variables_m = accuracy.set.in_metres(&at.scaled);
        let actual = OutputState { mechanism: accuracy.loops.mechanism, poses: &at.closed.poses };
        let (by_rows, _) = at.closed.system.solve_transposed(&accuracy.gradient(self.output, &actual));
        let mut gains = Vec::with_capacity(variables_m.len());
        accuracy.plays.gains(&accuracy.loops, &at.closed.frames, &by_rows, Some(&variables_m), &mut gains);
        gains.iter_mut().for_each(|gain| *gain *= self.sign);
        gains
    }
}

impl PoseAccuracy<'_> {
    /// Gains of the combination of rows that the loops follow least, by variables in units of their radii.
    pub(crate) fn weakest_gains(&self) -> Vec<f64> {
        let weakest = self.system.weakest().row;
        let mut gains = Vec::with_capacity(self.set.variables());
        self.plays.gains(&self.loops, &self.frames, &weakest, None, &mut gains);
        gains
    }
}

/// Gains of random outputs.
pub(crate) fn random_starts(variables: usize, options: &SearchOptions) -> Vec<Vec<f64>> {
    let mut state = options.seed;
    (0..options.random_starts).map(|_| (0..variables).map(|_| random(&mut state)).collect()).collect()
}
