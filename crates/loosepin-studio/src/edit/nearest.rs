//! The position of a new mechanism that is shown while it is dragged.

use loosepin::result::simulation::Drawing;

use super::grip::DragOutcome;
use super::reshape::{length, minus};
use crate::drawing::still::Pose;

/// A position of a mechanism among those of its turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Angle of the drive, degrees.
    pub angle_deg: f64,
    /// How far its joints lie from where they are expected: root of the sum of squares, m.
    pub far_m: f64,
}

/// The position at which joints lie nearest to where they are expected; between two poses they go straight. `None` if nothing is
/// expected of them.
pub fn nearest(gripped: &DragOutcome, drawing: &Drawing) -> Option<Nearest> {
    let poses = &drawing.poses;
    let joints: Vec<(usize, [f64; 2])> = drawing
        .joints
        .iter()
        .map(|joint| {
            let point = drawing.bodies.get(joint.first.body)?.points.get(joint.first.point)?;
            Some((joint.first.body, [point.x_m, point.y_m]))
        })
        .collect::<Option<_>>()?;
    let due_m = gripped.expected_m();
    if joints.len() != due_m.len() {
        return None;
    }
    let at = |pose: usize| -> Vec<[f64; 2]> {
        let placed = |(body, local): &(usize, [f64; 2])| {
            let origin_m = [poses.x_m[*body][pose], poses.y_m[*body][pose]];
            Pose { origin_m, angle_rad: poses.angle_rad[*body][pose] }.world_m(*local)
        };
        joints.iter().map(placed).collect()
    };
    let cost = |found: &[[f64; 2]]| -> f64 {
        (0..due_m.len()).map(|joint| length(minus(found[joint], due_m[joint])).powi(2)).sum()
    };
    let count = poses.drive_angle_rad.len();
    let all: Vec<Vec<[f64; 2]>> = (0..count).map(at).collect();
    let mut best = (f64::INFINITY, None);
    for pose in 0..count {
        let angle_rad = poses.drive_angle_rad[pose];
        let own = cost(&all[pose]);
        if own < best.0 {
            best = (own, Some(angle_rad));
        }
        // The least of a parabola: the joints go straight from one pose to the next, and from the last one nowhere.
        let next = all.get(pose + 1).unwrap_or(&all[pose]);
        let next_rad = poses.drive_angle_rad.get(pose + 1).copied().unwrap_or(angle_rad);
        let (mut along, mut square) = (0.0, 0.0);
        for joint in 0..due_m.len() {
            let first = all[pose][joint];
            let (way, missing) = (minus(next[joint], first), minus(due_m[joint], first));
            along += way[0] * missing[0] + way[1] * missing[1];
            square += way[0] * way[0] + way[1] * way[1];
        }
        let share = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
        let between = own - share * (2.0 * along - share * square);
        if between < best.0 {
            best = (between, Some(angle_rad + share * (next_rad - angle_rad)));
        }
    }
    let (cost, angle_rad) = best;
    Some(Nearest { angle_deg: angle_rad?.to_degrees(), far_m: cost.max(0.0).sqrt() })
}
