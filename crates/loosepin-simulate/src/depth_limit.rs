//! Limits of what a run may do to its joints.

use loosepin_mechanics::contact::NormalContact;
use loosepin_mechanics::mechanism::{GapMeasure, PlayGeometry};

/// How deep a contact may be pressed in: the centre of a pin must stay inside its hole or slot, the axis of a slider inside its
/// guide, and the penetration where the law has one meaning. Teeth, and a cam and its follower, have no limit but that of the law.
#[derive(Debug, Clone, Copy)]
pub struct DepthLimit {
    /// The largest penetration, m.
    pub penetration_m: f64,
    /// The gap function there.
    pub gap: f64,
    /// The root of it, √m.
    pub root: f64,
    /// Whether the law ends there, and not the bodies.
    pub is_of_law: bool,
}

impl DepthLimit {
    /// The limit of the contacts of a joint with play.
    pub fn new(play: &PlayGeometry<f64>) -> Self {
        let body_m = play.shape.thickness_m(play.clearance_m);
        let law_m = play.normal.limit_m().unwrap_or(f64::INFINITY);
        let penetration_m = body_m.min(law_m);
        let gap = GapMeasure::of(play).gap(penetration_m);
        Self { penetration_m, gap, root: penetration_m.sqrt(), is_of_law: law_m < body_m }
    }
}
