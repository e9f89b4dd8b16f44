//! Bodies that stand still over the whole cycle: most often the loops are closed in another way than meant.

use std::f64::consts::TAU;

use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample};
use loosepin_mechanics::model::Values;

use crate::recording::history::input;

/// Positions of a turn that are looked at: a prime, so that hardly any body is turned by whole turns between them.
const POSITIONS: usize = 23;
/// Positions that must be reached.
const MIN_POSITIONS: usize = 2;
/// Steps of the fastest drive along which a first look at a mechanism follows it, at most, a thousand turns: it may be very much faster than the one
/// that counts.
pub const FIRST_LOOK_STEPS: f64 = 31_416.0;
/// Free coordinates of the tree, at most: positions take the square of them.
const MAX_FREE: usize = 300;
/// A body stands still when it is not further off than this share of the size of the mechanism, or turned by more, rad.
const SAME: f64 = 1e-9;

/// Whether each body moves with the ideal mechanism over a turn, the ground first. `None` where drives do not move it alone, where it hardly moves at
/// all, of very many bodies, and where a drive is very much faster than that of the cycle.
pub fn bodies_that_move(mechanism: &Mechanism, values: &Values) -> Option<Vec<bool>> {
    if !mechanism.is_driven() || mechanism.ideal.free > MAX_FREE {
        return None;
    }
    let turn_s = input(mechanism, values, mechanism.model.cycle.span).ok()?.turn_s();
    let sample = Sample::new(mechanism, values).ok()?;
    let mut motion = IdealMotion::new(mechanism, &sample.ideal, &sample.drives).ok()?;
    if motion.longest_way(turn_s).1 > FIRST_LOOK_STEPS {
        return None;
    }
    let start = motion.kinematics().poses.clone();
    let mut moved = vec![false; mechanism.model.bodies.len()];
    for position in 1..=POSITIONS {
        // Up to a change point, or the end of its range, it says as much.
        if motion.move_to(turn_s * position as f64 / POSITIONS as f64).is_err() {
            if position <= MIN_POSITIONS {
                return None;
            }
            break;
        }
        for (body, moved) in moved.iter_mut().enumerate() {
            let slot = mechanism.ideal.slot_of_body[body];
            let (before, now) = (&start[slot], &motion.kinematics().poses[slot]);
            let turned_rad = now.angle_rad() - before.angle_rad();
            *moved |= (now.position_m - before.position_m).length() > SAME * mechanism.size_m
                || (turned_rad - TAU * (turned_rad / TAU).round()).abs() > SAME;
        }
    }
    Some(moved)
}
