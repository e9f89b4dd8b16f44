//! Bodies that stand still over the whole cycle: most often the loops are closed in another way than meant.

use super::parts::SpatialModel;
use crate::closure::assembly::Starts;
use crate::closure::cycle::Cycle;
use crate::closure::error::ClosureError;
use crate::mobility::mobility;
use crate::stop::{IsStopped, stop_after};
use loosepin_math::Pose;
use loosepin_text::numbers::Values;

/// Steps between positions of a turn that are looked at: a prime, so that hardly any body is turned by whole turns in each of them.
const STEPS: usize = 23;
/// Positions after the first that must be reached.
const MIN_POSITIONS: usize = 2;
/// Bodies, at most: what they are free to do takes the cube of them.
const MAX_BODIES: usize = 60;
/// Steps times bodies that following the motion may take, a tenth of a second: a warning is not worth more.
const MAX_WORK: usize = 20_000;
/// A body stands still when it is not further off than this share of the size of the mechanism, or turned by more, rad.
const SAME: f64 = 1e-9;

impl SpatialModel {
    /// Whether each body moves with the ideal mechanism over a turn, or can move alone, the ground first. `None` where there is no turn, where drives do not move it
    /// alone, where it hardly moves at all, of very many bodies, and where it was stopped.
    pub fn bodies_that_move(&self, values: &Values, is_stopped: IsStopped) -> Option<Vec<bool>> {
        if self.bodies.len() > MAX_BODIES {
            return None;
        }
        let mechanism = self.mechanism(values).ok()?;
        let turn_s = self.cycle_input(values).ok()?.turn_s;
        let times_s: Vec<f64> = (0..=STEPS).map(|step| turn_s * step as f64 / STEPS as f64).collect();
        let is_enough = stop_after((MAX_WORK / self.bodies.len()) as u64, is_stopped);
        let Cycle { positions, stopped } = self.turn(&mechanism, values, &times_s, Starts::Nearby, &is_enough);
        let (first, others) = positions.split_first()?;
        // Up to a change point, or the end of its range, it says as much.
        let is_cut = matches!(stopped, Some(ClosureError::Stopped | ClosureError::TooLong { .. }));
        let freedoms = mobility(&mechanism, first);
        if is_cut || others.len() < MIN_POSITIONS || freedoms.undriven_freedoms > 0 {
            return None;
        }
        let size_m = mechanism.characteristic_length_m();
        let moves =
            |(body, before): (usize, &Pose)| others.iter().any(|now| is_moved(before, &now.poses[body], size_m));
        let mut moved: Vec<bool> = first.poses.iter().enumerate().map(moves).collect();
        // What can move alone is not held still, where anything else moves.
        if moved.contains(&true) {
            freedoms.idle.iter().flat_map(|idle| &idle.bodies).for_each(|body| moved[*body] = true);
        }
        Some(moved)
    }
}

fn is_moved(before: &Pose, now: &Pose, size_m: f64) -> bool {
    let turned = before.orientation.rotation().transposed_times(&now.orientation.rotation());
    (now.position_m - before.position_m).length() > SAME * size_m || turned.rotation_vector().length() > SAME
}
