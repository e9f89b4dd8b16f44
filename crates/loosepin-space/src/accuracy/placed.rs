//! Places of the journals at which all loops close, and what play does from there to first order.

use crate::accuracy::linear::planes::Planes;
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::play_set::PlaySet;
use crate::accuracy::pose_accuracy::{PoseAccuracy, redundant};
use crate::closure::bordered::Bordered;
use crate::closure::newton::{Closed, largest as largest_entry};
use loosepin_math::Pose;

/// What redundant rows may be apart beyond what they are in the ideal position, lengths over the characteristic length and rad.
const MET: f64 = 1e-13;
/// Most corrections back to closed loops.
const MAX_CORRECTIONS: usize = 12;
/// Entries below this relative to the largest are no planes.
const NEGLIGIBLE: f64 = 1e-9;
/// Length of variables, in units of the radius, from which a block counts as on its border.
const BORDER: f64 = 1.0 - 1e-9;

/// A place of the journals that closes all loops.
#[derive(Clone)]
pub(crate) struct Placed {
    /// Variables in units of the radii.
    pub scaled: Vec<f64>,
    pub closed: Closed,
}

impl Placed {
    /// Its poses as a start.
    pub(crate) fn start(&self) -> Start<'_> {
        let Closed { poses, system, .. } = &self.closed;
        Start { poses, system, orientation: system.sign() }
    }
}

/// Poses from which the loops are closed.
#[derive(Clone, Copy)]
pub(crate) struct Start<'a> {
    pub poses: &'a [Pose],
    pub system: &'a Bordered,
    /// Sign of the determinant of the loop equations on the branch: loops that are closed another way round have the other one.
    pub orientation: f64,
}

impl PoseAccuracy<'_> {
    /// The ideal position as a start.
    pub(crate) fn ideal_start(&self) -> Start<'_> {
        Start { poses: &self.position.poses, system: &self.system, orientation: self.system.sign() }
    }

    /// Whether the loops close on the branch of the ideal position with the journals in these places, m.
    pub(crate) fn stays_at(&self, variables_m: &[f64]) -> bool {
        let closed = self.close_at(&self.position.poses, variables_m, None);
        closed.is_ok_and(|closed| closed.system.sign() == self.system.sign())
    }

    /// Closes the loops, and moves the variables until redundant rows close as well: by the shortest change that leaves blocks on their
    /// borders there, cut back to the balls.
    pub(crate) fn placed(&self, mut scaled: Vec<f64>, from: Start<'_>) -> Option<Placed> {
        let mut poses = from.poses.to_vec();
        let closed_rows = self.closed_rows();
        for _ in 0..MAX_CORRECTIONS {
            let variables_m = self.set.in_metres(&scaled);
            let closed = self.close_at(&poses, &variables_m, Some(from.system)).ok()?;
            let apart: Vec<f64> = closed.apart.iter().zip(&closed_rows).map(|(apart, ideal)| apart - ideal).collect();
            if largest_entry(&apart) <= MET {
                return (closed.system.sign() == from.orientation).then_some(Placed { scaled, closed });
            }
            if self.conditions() == 0 {
                return None;
            }
            let redundant = self.conditions_at(&closed, &variables_m);
            let along = along_borders(&self.set, &redundant, &scaled);
            let mut planes = self.planes_at(&along, &closed, &variables_m);
            if planes.count() < self.conditions() {
                planes = self.planes_at(&redundant, &closed, &variables_m);
            }
            let right: Vec<f64> = apart.iter().map(|apart| -apart).collect();
            let change = planes.shortest(&right, scaled.len());
            scaled.iter_mut().zip(&change).for_each(|(value, change)| *value += change);
            self.set.cut_back(&mut scaled);
            poses = closed.poses;
        }
        None
    }

    /// What the conditions are at a place: their rows, the planes of these, and their right-hand sides.
    pub(crate) fn linear_conditions(&self, at: &Placed) -> (Planes, Vec<f64>) {
        let variables_m = self.set.in_metres(&at.scaled);
        let redundant = self.conditions_at(&at.closed, &variables_m);
        let planes = self.planes_at(&redundant, &at.closed, &variables_m);
        let pairs = redundant.iter().zip(&at.closed.apart).zip(self.closed_rows());
        let right = pairs.map(|((row, apart), closed)| dot(row, &at.scaled) - (apart - closed)).collect();
        (planes, right)
    }

    fn conditions_at(&self, closed: &Closed, variables_m: &[f64]) -> Vec<Vec<f64>> {
        if self.conditions() == 0 {
            return Vec::new();
        }
        redundant(&self.loops, &closed.frames, &closed.system, &self.plays, Some(variables_m))
    }

    fn planes_at(&self, redundant: &[Vec<f64>], closed: &Closed, variables_m: &[f64]) -> Planes {
        let size = match redundant {
            [] => 0.0,
            _ => self.plays.largest_derivative(&self.loops, &closed.frames, Some(variables_m)),
        };
        Planes::new(redundant, self.set.variables(), NEGLIGIBLE * size)
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
