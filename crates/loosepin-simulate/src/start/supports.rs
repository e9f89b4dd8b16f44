//! How the ends of a beam are held, and the push under which it buckles.
//!
//! ```text
//! F = β² EI/L²
//!
//! β   π           between pins; clamped, and at the other end kept from turning but not sideways
//!     π/2         clamped and free
//!     tan β = β   clamped and pinned
//!     2π          clamped at both ends
//! ```
//!
//! A section that a drive or a rigid joint holds is clamped. An end beside a clamped one counts as held sideways where its joint is to the body of the clamp, or to one that slides
//! on that along the beam; on a link that moves otherwise it counts as free, which is the lower load.

use loosepin_mechanics::model::{BodyId, Model, PointId, Values};
use std::f64::consts::PI;

/// Least positive solution of tan β = β.
const CLAMPED_AND_PINNED: f64 = 4.493_409_457_909_064;
/// Angle between a guide and a beam up to which the guide is one along the beam, rad.
const ALONG_RAD: f64 = 0.1;

/// A joint at an end.
#[derive(Clone, Copy)]
struct Hold {
    /// Whether it holds the section.
    is_clamp: bool,
    /// The body that it is to.
    to: BodyId,
    /// Direction of the beam from the x axis of that body at a rigid joint, rad.
    beam_rad: Option<f64>,
}

/// β of a beam with these ends.
pub(crate) fn buckling_factor(model: &Model, values: &Values, ends: [PointId; 2]) -> f64 {
    let holds = ends.map(|end| holds_at(model, values, end, ends));
    let clamps_of = |end: usize| holds[end].iter().filter(|hold| hold.is_clamp);
    let Some(clamped) = (0..2).find(|&end| clamps_of(end).next().is_some()) else { return PI };
    let held = |hold: &Hold| clamps_of(clamped).filter_map(|base| held_against(model, values, hold, base)).max();
    let beside = &holds[1 - clamped];
    match beside.iter().filter_map(|hold| Some((held(hold)?, hold.is_clamp))).max() {
        Some((Held::Sideways, true)) => 2.0 * PI,
        Some((Held::Sideways, false)) => CLAMPED_AND_PINNED,
        Some((Held::Angle, true)) => PI,
        Some((Held::Angle, false)) | None => 0.5 * PI,
    }
}

/// What the other body of a joint does not do against the body of a clamp.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Held {
    /// The end does not turn.
    Angle,
    /// The end does not turn, nor move across the beam.
    Sideways,
}

/// What holds the other body of `hold` against that of the clamp `base`; `None` if neither is so.
fn held_against(model: &Model, values: &Values, hold: &Hold, base: &Hold) -> Option<Held> {
    if hold.to == base.to {
        return Some(Held::Sideways);
    }
    // Guides between both bodies, with their direction in the frame of the first one.
    let guides = model.joints.iter().filter(|joint| joint.kind.line().is_some() && joint.kind.holds_angle());
    let guides = guides.filter_map(|joint| {
        let own = joint.kind.bodies().into_iter().position(|body| body == base.to)?;
        let is_between = joint.kind.bodies()[1 - own] == hold.to;
        joint.kind.angles_rad()[own].filter(|_| is_between).map(|angle_rad| values[angle_rad])
    });
    let held = |guide_rad: f64| {
        let is_along = base.beam_rad.is_some_and(|beam_rad| (guide_rad - beam_rad).sin().abs() <= ALONG_RAD.sin());
        if is_along { Held::Sideways } else { Held::Angle }
    };
    guides.map(held).max()
}

/// The joints at an end of the beam between `ends`.
fn holds_at(model: &Model, values: &Values, end: PointId, ends: [PointId; 2]) -> Vec<Hold> {
    let [root, tip] = ends.map(|id| model.bodies[id.body.0].points[id.point].position_m.map(|id| values[id]));
    let axis_rad = (tip[1] - root[1]).atan2(tip[0] - root[0]);
    let hold = |(index, joint): (usize, &loosepin_mechanics::model::Joint)| {
        let points = joint.kind.points();
        let own = points.into_iter().position(|point| point == end)?;
        // The second body is turned by this angle from the first.
        let turned_rad = joint.kind.held_turn_rad(&|id| values[id]).filter(|_| joint.kind.line().is_none());
        let beam_rad = turned_rad.map(|turned_rad| axis_rad + if own == 1 { turned_rad } else { -turned_rad });
        Some(Hold { is_clamp: model.holds_sections(index), to: points[1 - own].body, beam_rad })
    };
    model.joints.iter().enumerate().filter_map(hold).collect()
}
