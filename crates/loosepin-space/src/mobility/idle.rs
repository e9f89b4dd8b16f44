//! Parts that may turn or slide alone.

use crate::closure::loops::{Loops, first_column};
use crate::closure::singular::RANK_THRESHOLD;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use loosepin_math::{Pose, SingularValues, Vec3};

/// How a part moves alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IdleKind {
    /// It turns about an axis through this point of the ground's frame, m: a rod that spins between two balls.
    Turn {
        /// The point of the axis nearest to the origin of the first body's frame, m.
        point_m: Vec3,
    },
    /// It slides.
    Slide,
    /// It turns about the axis and moves along it by the pitch for each turn, m.
    Helix {
        /// The point of the axis nearest to the origin of the first body's frame, m.
        point_m: Vec3,
        /// Advance in one turn, m.
        pitch_m: f64,
    },
}

/// A motion of one part, a body or several that rigid joints make one, that no row resists and no other part follows.
#[derive(Debug, Clone, PartialEq)]
pub struct IdleMotion {
    /// Numbers of the bodies.
    pub bodies: Vec<usize>,
    /// Direction of the axis or of the slide, in ground axes; a unit vector.
    pub direction: Vec3,
    /// What it does.
    pub kind: IdleKind,
}

/// Motions of single parts with all others at rest and the drives held: null vectors of the columns of each part.
pub(crate) fn idle_motions(loops: &Loops, jacobian: &[f64], poses: &[Pose]) -> Vec<IdleMotion> {
    let parts = rigid_parts(loops.mechanism).into_iter().filter(|part| !part.contains(&0));
    parts
        .flat_map(|part| {
            let values = SingularValues::new(&part_columns(loops, jacobian, poses, &part), loops.rows.len(), 6);
            let free = values.right_null_space(values.rank(RANK_THRESHOLD));
            free.into_iter().map(move |motion| idle_motion(loops, &part, poses, &motion)).collect::<Vec<_>>()
        })
        .collect()
}

/// Bodies in parts: those that rigid joints hold together.
fn rigid_parts(mechanism: &SpatialMechanism) -> Vec<Vec<usize>> {
    let mut part_of: Vec<usize> = (0..mechanism.bodies().len()).collect();
    for joint in mechanism.joints().iter().filter(|joint| joint.kind.freedoms() == 0) {
        let [kept, joined] = [joint.bearing.body, joint.journal.body].map(|body| part_of[body]);
        part_of.iter_mut().filter(|part| **part == joined).for_each(|part| *part = kept);
    }
    let bodies = 0..part_of.len();
    let parts = bodies.clone().map(|part| bodies.clone().filter(|body| part_of[*body] == part).collect::<Vec<_>>());
    parts.filter(|part| !part.is_empty()).collect()
}

/// Columns of the motion (v/L, ω) of a part, v of the origin of its first body: another body at r moves by v + ω × (r - r_0).
fn part_columns(loops: &Loops, jacobian: &[f64], poses: &[Pose], part: &[usize]) -> Vec<f64> {
    let columns = loops.unknowns();
    let mut sums = vec![0.0; 6 * loops.rows.len()];
    for (row, sums) in jacobian.chunks(columns.max(1)).zip(sums.chunks_mut(6)) {
        for body in part {
            let Some(first) = first_column(*body) else { continue };
            let own = |k: usize| Vec3::new(row[first + k], row[first + k + 1], row[first + k + 2]);
            let arm = (poses[*body].position_m - poses[part[0]].position_m) / loops.length_m;
            let values = [own(0), own(3) + arm.cross(own(0))].into_iter().flat_map(Vec3::to_array);
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
        }
    }
    sums
}

/// What a motion (v/L, ω) of a part is.
fn idle_motion(loops: &Loops, part: &[usize], poses: &[Pose], motion: &[f64]) -> IdleMotion {
    let bodies = part.to_vec();
    let own = |k: usize| Vec3::new(motion[k], motion[k + 1], motion[k + 2]);
    let (velocity, turning) = (own(0) * loops.length_m, own(3));
    let speed = turning.length();
    if speed < RANK_THRESHOLD {
        return IdleMotion { bodies, direction: velocity.normalised().unwrap_or(Vec3::X), kind: IdleKind::Slide };
    }
    let direction = turning / speed;
    let advance = velocity.dot(direction) / speed;
    let point_m = poses[part[0]].position_m + direction.cross(velocity) / speed;
    let kind = if advance.abs() < RANK_THRESHOLD * loops.length_m {
        IdleKind::Turn { point_m }
    } else {
        IdleKind::Helix { point_m, pitch_m: advance * std::f64::consts::TAU }
    };
    IdleMotion { bodies, direction, kind }
}
