//! How the ends of a beam are held, and the push under which it buckles.
//!
//! ```text
//! F = β² EI/L²,   β = π between pins, π/2 clamped and free, tan β = β clamped and pinned, 2π clamped at both ends
//! ```
//!
//! A section that a drive or a rigid joint holds is clamped. An end beside a clamped one counts as held sideways where its joint is to the body of the clamp, or to one that slides
//! on that; on a link that moves otherwise it counts as free, which is the lower load.

use loosepin_mechanics::model::{BodyId, JointKind, Model, PointId};
use std::f64::consts::PI;

/// Least positive solution of tan β = β.
const CLAMPED_AND_PINNED: f64 = 4.493_409_457_909_064;

/// A joint at an end.
#[derive(Clone, Copy)]
struct Hold {
    /// Whether it holds the section.
    is_clamp: bool,
    /// The body that it is to.
    to: BodyId,
}

/// β of a beam with these ends.
pub(super) fn buckling_factor(model: &Model, ends: [PointId; 2]) -> f64 {
    let holds = ends.map(|end| holds_at(model, end));
    let clamps: Vec<usize> = (0..2).filter(|&end| holds[end].iter().any(|hold| hold.is_clamp)).collect();
    let Some(&clamped) = clamps.first() else { return PI };
    let bases = || holds[clamped].iter().filter(|hold| hold.is_clamp).map(|hold| hold.to);
    let is_beside = |hold: &Hold| bases().any(|base| hold.to == base || slides_on(model, hold.to, base));
    let beside: Vec<&Hold> = holds[1 - clamped].iter().filter(|hold| is_beside(hold)).collect();
    if beside.iter().any(|hold| hold.is_clamp) {
        2.0 * PI
    } else if beside.is_empty() {
        0.5 * PI
    } else {
        CLAMPED_AND_PINNED
    }
}

/// The joints at an end.
fn holds_at(model: &Model, end: PointId) -> Vec<Hold> {
    let driven = |index: usize| model.drives.iter().any(|drive| drive.joint.0 == index);
    let hold = |(index, joint): (usize, &loosepin_mechanics::model::Joint)| {
        let points = joint.kind.points();
        let own = points.into_iter().position(|point| point == end)?;
        let is_clamp = matches!(joint.kind, JointKind::Rigid { .. }) || driven(index);
        Some(Hold { is_clamp, to: points[1 - own].body })
    };
    model.joints.iter().enumerate().filter_map(hold).collect()
}

/// Whether a body moves along a line of another one and does not turn against it.
fn slides_on(model: &Model, body: BodyId, base: BodyId) -> bool {
    model.joints.iter().any(|joint| {
        let bodies = joint.kind.points().map(|point| point.body);
        matches!(joint.kind, JointKind::Prismatic { .. }) && bodies.contains(&body) && bodies.contains(&base)
    })
}
