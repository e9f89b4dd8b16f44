//! Bodies that may turn or slide alone.

use crate::closure::loops::{Loops, first_column};
use crate::closure::singular::RANK_THRESHOLD;
use crate::geometry::pose::Pose;
use crate::geometry::vector::Vec3;
use loosepin_math::SingularValues;

/// How a body moves alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IdleKind {
    /// It turns about an axis through this point of the ground's frame, m: a rod that spins between two balls.
    Turn {
        /// The point of the axis nearest to the origin of the body's frame, m.
        point_m: Vec3,
    },
    /// It slides.
    Slide,
    /// It turns about the axis and moves along it by the pitch for each turn, m.
    Helix {
        /// The point of the axis nearest to the origin of the body's frame, m.
        point_m: Vec3,
        /// Advance in one turn, m.
        pitch_m: f64,
    },
}

/// A motion of one body that no row resists and no other body follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IdleMotion {
    /// Number of the body.
    pub body: usize,
    /// Direction of the axis or of the slide, in ground axes; a unit vector.
    pub direction: Vec3,
    /// What it does.
    pub kind: IdleKind,
}

/// Motions of single bodies with all others at rest and the drives held: null vectors of the columns of each body.
pub(crate) fn idle_motions(loops: &Loops, jacobian: &[f64], poses: &[Pose]) -> Vec<IdleMotion> {
    let columns = loops.unknowns();
    let bodies = 1..poses.len();
    bodies
        .flat_map(|body| {
            let first = first_column(body).unwrap_or(0);
            let block: Vec<f64> =
                jacobian.chunks(columns.max(1)).flat_map(|row| row[first..first + 6].iter().copied()).collect();
            let values = SingularValues::new(&block, loops.rows.len(), 6);
            let free = values.right_null_space(values.rank(RANK_THRESHOLD));
            free.into_iter().map(|motion| idle_motion(loops, body, &poses[body], &motion)).collect::<Vec<_>>()
        })
        .collect()
}

/// What a motion (v/L, ω) of a body is.
fn idle_motion(loops: &Loops, body: usize, pose: &Pose, motion: &[f64]) -> IdleMotion {
    let part = |k: usize| Vec3::new(motion[k], motion[k + 1], motion[k + 2]);
    let (velocity, turning) = (part(0) * loops.length_m, part(3));
    let speed = turning.length();
    if speed < RANK_THRESHOLD {
        return IdleMotion { body, direction: velocity.normalised().unwrap_or(Vec3::X), kind: IdleKind::Slide };
    }
    let direction = turning / speed;
    let advance = velocity.dot(direction) / speed;
    let point_m = pose.position_m + direction.cross(velocity) / speed;
    let kind = if advance.abs() < RANK_THRESHOLD * loops.length_m {
        IdleKind::Turn { point_m }
    } else {
        IdleKind::Helix { point_m, pitch_m: advance * std::f64::consts::TAU }
    };
    IdleMotion { body, direction, kind }
}
