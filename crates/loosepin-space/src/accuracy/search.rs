//! One search for an extreme deviation.

use crate::accuracy::extreme::{Extreme, SearchOptions};
use crate::accuracy::linear::near::Near;
use crate::accuracy::linear::planes::Planes;
use crate::accuracy::linear::slice::largest;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::play_set::PlaySet;
use crate::accuracy::pose_accuracy::{PoseAccuracy, redundant};
use crate::accuracy::random::random;
use crate::closure::bordered::Bordered;
use crate::closure::newton::{Closed, largest as largest_entry};
use crate::geometry::pose::Pose;
use crate::output::SpatialOutput;
use crate::output::kind_of_output::OutputState;

/// Most steps of a search; about ten are usual.
const MAX_STEPS: usize = 200;
/// A step below this, in units of the radii, is the end.
const LAST_STEP: f64 = 1e-12;
/// An expected improvement below this, relative to the worst case of first order, is the end.
const LAST_IMPROVEMENT: f64 = 1e-14;
/// What redundant rows may be apart beyond what they are in the ideal position, lengths over the characteristic length and rad.
const MET: f64 = 1e-13;
/// Most corrections back to closed loops.
const MAX_CORRECTIONS: usize = 12;
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
/// Entries below this relative to the largest are no planes.
const NEGLIGIBLE: f64 = 1e-9;
/// Length of variables, in units of the radius, from which a block counts as on its border.
const BORDER: f64 = 1.0 - 1e-9;

/// A search for the largest `sign` × deviation of an output.
pub(crate) struct Climb<'a, 'b> {
    pub accuracy: &'a PoseAccuracy<'b>,
    pub output: &'a SpatialOutput,
    pub sign: f64,
}

/// A place of the journals that closes all loops.
struct Feasible {
    /// Variables in units of the radii.
    scaled: Vec<f64>,
    closed: Closed,
    /// `sign` × deviation.
    value: f64,
}

/// What a place looks like to first order.
struct Linear {
    gains: Vec<f64>,
    redundant: Vec<Vec<f64>>,
    planes: Planes,
}

impl Climb<'_, '_> {
    /// From journals in the middle.
    pub(crate) fn climb_from_middle(&self) -> Option<Extreme> {
        self.climb(vec![0.0; self.accuracy.play_set().variables()])
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
        self.climb(scaled)
    }

    /// From the worst case of first order of some gains, of variables in units of their radii.
    pub(crate) fn climb_from_objective(&self, scaled_gains: &[f64]) -> Option<Extreme> {
        let accuracy = self.accuracy;
        let pairs = accuracy.closed_rows().into_iter().zip(&accuracy.apart);
        let right: Vec<f64> = pairs.map(|(closed, apart)| closed - apart).collect();
        self.climb(largest(&accuracy.set, scaled_gains, None, &accuracy.planes, &right)?.place)
    }

    fn climb(&self, start: Vec<f64>) -> Option<Extreme> {
        let (ideal, closed_rows) = (&self.accuracy.position.poses, self.accuracy.closed_rows());
        let mut at = self.feasible(start, ideal, &self.accuracy.system)?;
        let (mut weight, mut last_pull): (f64, f64) = (0.0, 0.0);
        let round_off = ROUND_OFF * self.accuracy.loops.length_m.min(1.0);
        for step in 0..MAX_STEPS {
            let linear = self.linear(&at);
            let scale = self.accuracy.set.support(&linear.gains).iter().sum::<f64>();
            if step == 0 {
                last_pull = FIRST_PULL * scale;
            }
            if scale == 0.0 {
                break;
            }
            // With planes an interior point method is more exact without it.
            let pull = if linear.planes.count() == 0 { weight.max(LEAST_PULL * scale) } else { weight };
            let near = (pull > 0.0).then_some(Near { weight: pull, place: &at.scaled });
            let right: Vec<f64> = linear
                .redundant
                .iter()
                .zip(&at.closed.apart)
                .zip(&closed_rows)
                .map(|((row, apart), closed)| dot(row, &at.scaled) - (apart - closed))
                .collect();
            let next = largest(&self.accuracy.set, &linear.gains, near, &linear.planes, &right);
            let next = next.map(|found| found.place).and_then(|place| {
                let change: Vec<f64> = place.iter().zip(&at.scaled).map(|(a, b)| a - b).collect();
                let expected = dot(&linear.gains, &change);
                let least = (LAST_IMPROVEMENT * scale).max(round_off);
                let is_over = largest_entry(&change) < LAST_STEP || expected <= least;
                let found = self.feasible(place, &at.closed.poses, &at.closed.system)?;
                Some((found, expected, is_over))
            });
            match next {
                Some((next, expected, is_over)) if next.value > at.value => {
                    let share = (next.value - at.value) / expected;
                    at = next;
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
            deviation: self.sign * at.value,
            variables_m: self.accuracy.set.in_metres(&at.scaled),
            poses: at.closed.poses,
        })
    }

    /// Gains and conditions at a place.
    fn linear(&self, at: &Feasible) -> Linear {
        let accuracy = self.accuracy;
        let variables_m = accuracy.set.in_metres(&at.scaled);
        let actual = OutputState { mechanism: accuracy.loops.mechanism, poses: &at.closed.poses };
        let (by_rows, _) = at.closed.system.solve_transposed(&accuracy.gradient(self.output, &actual));
        let mut gains = Vec::with_capacity(variables_m.len());
        accuracy.plays.gains(&accuracy.loops, &at.closed.frames, &by_rows, Some(&variables_m), &mut gains);
        gains.iter_mut().for_each(|gain| *gain *= self.sign);
        let redundant = self.conditions(&at.closed, &variables_m);
        let planes = self.planes(&redundant, &at.closed, &variables_m);
        Linear { gains, redundant, planes }
    }

    fn conditions(&self, closed: &Closed, variables_m: &[f64]) -> Vec<Vec<f64>> {
        let accuracy = self.accuracy;
        if accuracy.conditions() == 0 {
            return Vec::new();
        }
        redundant(&accuracy.loops, &closed.frames, &closed.system, &accuracy.plays, Some(variables_m))
    }

    fn planes(&self, redundant: &[Vec<f64>], closed: &Closed, variables_m: &[f64]) -> Planes {
        let accuracy = self.accuracy;
        let size = match redundant {
            [] => 0.0,
            _ => accuracy.plays.largest_derivative(&accuracy.loops, &closed.frames, Some(variables_m)),
        };
        Planes::new(redundant, accuracy.set.variables(), NEGLIGIBLE * size)
    }

    /// Closes the loops, and moves the variables until redundant rows close as well: by the shortest change that leaves blocks on their
    /// borders there, cut back to the balls.
    fn feasible(&self, mut scaled: Vec<f64>, from: &[Pose], known: &Bordered) -> Option<Feasible> {
        let accuracy = self.accuracy;
        let mut poses = from.to_vec();
        let closed_rows = accuracy.closed_rows();
        for _ in 0..MAX_CORRECTIONS {
            let variables_m = accuracy.set.in_metres(&scaled);
            let closed = accuracy.close_at(&poses, &variables_m, Some(known)).ok()?;
            let apart: Vec<f64> = closed.apart.iter().zip(&closed_rows).map(|(apart, ideal)| apart - ideal).collect();
            if largest_entry(&apart) <= MET {
                // Loops that are closed another way round have the other orientation.
                if closed.system.sign() != accuracy.system.sign() {
                    return None;
                }
                let value = self.sign * accuracy.deviation_of(self.output, &closed.poses);
                return Some(Feasible { scaled, closed, value });
            }
            if accuracy.conditions() == 0 {
                return None;
            }
            let redundant = self.conditions(&closed, &variables_m);
            let along = along_borders(&accuracy.set, &redundant, &scaled);
            let mut planes = self.planes(&along, &closed, &variables_m);
            if planes.count() < accuracy.conditions() {
                planes = self.planes(&redundant, &closed, &variables_m);
            }
            let right: Vec<f64> = apart.iter().map(|apart| -apart).collect();
            let change = planes.shortest(&right, scaled.len());
            scaled.iter_mut().zip(&change).for_each(|(value, change)| *value += change);
            accuracy.set.cut_back(&mut scaled);
            poses = closed.poses;
        }
        None
    }
}

/// Rows without their parts across the borders of the blocks that lie there.
fn along_borders(set: &PlaySet, rows: &[Vec<f64>], scaled: &[f64]) -> Vec<Vec<f64>> {
    let mut rows = rows.to_vec();
    for block in set.blocks().iter().filter(|block| PlaySet::length(block, scaled) > BORDER) {
        let own = &scaled[block.range()];
        for row in &mut rows {
            let share = dot(own, &row[block.range()]) / dot(own, own);
            row[block.range()].iter_mut().zip(own).for_each(|(entry, value)| *entry -= share * value);
        }
    }
    rows
}

impl PoseAccuracy<'_> {
    /// Gains of the combination of rows that the loops follow least, by variables in units of their radii.
    pub(crate) fn weakest_gains(&self) -> Vec<f64> {
        let weakest = self.system.weakest_row();
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
