//! Outputs of bodies that stand still over the whole cycle: most often the loops are closed in another way than meant.

use std::f64::consts::TAU;

use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample};
use loosepin_mechanics::model::{BodyId, Model, Output, Position, Recorded, Relative, TreeAttachment, Values};

use crate::recording::history::input;

/// Positions of a turn that are looked at.
const POSITIONS: usize = 24;
/// Positions that must be reached.
const MIN_POSITIONS: usize = 2;
/// Free coordinates of the tree, at most: positions take the square of them.
const MAX_FREE: usize = 300;
/// A body stands still when it is not further off than this share of the size of the mechanism, or turned by more, rad.
const SAME: f64 = 1e-9;

/// The outputs, by their places in the model, of bodies that do not move with the ideal mechanism over a turn, seen from the ground. None where drives do not
/// move it alone, where it hardly moves at all, and of very many bodies.
pub fn still_outputs(mechanism: &Mechanism, values: &Values) -> Vec<usize> {
    let moved = bodies_that_move(mechanism, values);
    let is_still = |output: &Output| {
        let body = seen_from_ground(output);
        moved.as_ref().zip(body).is_some_and(|(moved, BodyId(body))| body != 0 && !moved[body])
    };
    let outputs = mechanism.model.outputs.iter().enumerate();
    outputs.filter(|(_, output)| is_still(output)).map(|(index, _)| index).collect()
}

/// The body whose position or angle from the ground an output is.
fn seen_from_ground(output: &Output) -> Option<BodyId> {
    match output.kind.recorded() {
        Recorded::Path(Relative { of, to: None }) => Some(of.body),
        Recorded::Number(reading) => match reading.position()? {
            Position::Point(Relative { of, to: None }, _) => Some(of.body),
            Position::Angle(Relative { of, to: None }) => Some(of),
            _ => None,
        },
        _ => None,
    }
}

/// Whether each body moves, the ground first.
fn bodies_that_move(mechanism: &Mechanism, values: &Values) -> Option<Vec<bool>> {
    if !mechanism.is_driven() || mechanism.ideal.free > MAX_FREE {
        return None;
    }
    let turn_s = input(mechanism, values, mechanism.model.cycle.span).ok()?.turn_s();
    let sample = Sample::new(mechanism, values).ok()?;
    let mut motion = IdealMotion::new(mechanism, &sample.ideal, &sample.drives).ok()?;
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
            let turned_rad = now.angle_rad - before.angle_rad;
            *moved |= (now.position_m - before.position_m).length() > SAME * mechanism.size_m
                || (turned_rad - TAU * (turned_rad / TAU).round()).abs() > SAME;
        }
    }
    // Where nothing moves, a structure is meant.
    moved.contains(&true).then(|| without_mounts(&mechanism.model, moved))
}

/// What hangs on the ground by rigid joints alone is a part of it, and is meant to stand still.
fn without_mounts(model: &Model, mut moved: Vec<bool>) -> Vec<bool> {
    let mut is_ground = vec![false; moved.len()];
    is_ground[0] = true;
    loop {
        let mounted =
            model.joints.iter().filter(|joint| joint.kind.tree_attachment() == TreeAttachment::Fixed).find_map(
                |joint| {
                    let [first, second] = joint.kind.points().map(|point| point.body.0);
                    (is_ground[first] != is_ground[second]).then_some(if is_ground[first] { second } else { first })
                },
            );
        let Some(body) = mounted else { return moved };
        (is_ground[body], moved[body]) = (true, true);
    }
}
