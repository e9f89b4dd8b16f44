//! Why no end of a worst case is proven at a position, in words.

use super::cycle::SingularKind;
use super::worst_case::NotProven;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_result::motion::UnprovenSpan;
use std::f64::consts::TAU;

/// Why no end is proven at a position.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Cause {
    /// Joints repeat each other.
    Redundant,
    /// Pins lean out of the plane.
    Lean,
    /// The block of this joint may overhang its guide.
    Overhanging(String),
    /// The loops were not shown to be regular.
    Loops(NotProven),
}

/// Positions of a cycle at which nothing is proven.
pub(super) struct UnprovenPositions<'u> {
    pub mechanism: &'u Mechanism,
    pub drive_angle_rad: &'u [f64],
    /// What moves the positions beside the drive.
    pub moved_by: &'static str,
    /// For each position; `None` where ends are proven.
    pub causes: Vec<Option<Cause>>,
    /// Angles of the drive at which the ideal mechanism is singular.
    pub change_points: &'u [(f64, SingularKind)],
}

impl Cause {
    /// The cause at a position, where the block of `overhanging` may overhang its guide; `None` if ends are proven.
    pub fn of(mechanism: &Mechanism, not_proven: Option<NotProven>, overhanging: Option<&str>) -> Option<Self> {
        if mechanism.ideal.is_redundant() {
            return Some(Self::Redundant);
        }
        overhanging.map(|joint| Self::Overhanging(joint.to_owned())).or(not_proven.map(Self::Loops))
    }

    fn reaches_dead_centre(&self) -> bool {
        matches!(self, Self::Loops(NotProven { reaches_dead_centre: true, .. }))
    }
}

impl UnprovenPositions<'_> {
    /// The reason at each position.
    pub fn reasons(&self) -> Vec<Option<String>> {
        let mut reasons = Vec::with_capacity(self.causes.len());
        let is_of_loops = |cause: &Option<Cause>| matches!(cause, Some(Cause::Loops(_)));
        for stretch in self.causes.chunk_by(|a, b| is_of_loops(a) == is_of_loops(b)) {
            let rows = reasons.len()..reasons.len() + stretch.len();
            let near = self.change_point_near(&self.drive_angle_rad[rows]);
            reasons.extend(stretch.iter().map(|cause| cause.as_ref().map(|cause| self.words(cause, near))));
        }
        reasons
    }

    /// Angles in a row with the same words are one span.
    pub fn spans(&self) -> Vec<UnprovenSpan> {
        let reasons = self.reasons();
        let mut found: Vec<UnprovenSpan> = Vec::new();
        let mut last: Option<&str> = None;
        for ((angle_rad, reason), cause) in self.drive_angle_rad.iter().zip(&reasons).zip(&self.causes) {
            if let (Some(words), Some(cause)) = (reason, cause) {
                match found.last_mut() {
                    Some(span) if last == Some(words) => span.span_rad[1] = *angle_rad,
                    _ => found.push(UnprovenSpan {
                        span_rad: [*angle_rad; 2],
                        words: words.clone(),
                        reaches_dead_centre: cause.reaches_dead_centre(),
                    }),
                }
            }
            last = reason.as_deref();
        }
        found
    }

    /// The change point or dead point of the ideal mechanism next to positions in a row.
    fn change_point_near(&self, angles_rad: &[f64]) -> Option<(f64, SingularKind)> {
        /// Distance from a position, in steps: beside the positions in a row no other is unproven.
        const NEAR: f64 = 1.5;
        let steps = self.drive_angle_rad.windows(2).map(|pair| pair[1] - pair[0]);
        let near_rad = NEAR * steps.fold(0.0, f64::max);
        let distance = |a: f64, b: f64| {
            let apart = (a - b).rem_euclid(TAU);
            apart.min(TAU - apart)
        };
        let is_near = |at: f64| angles_rad.iter().any(|angle_rad| distance(*angle_rad, at) <= near_rad);
        self.change_points.iter().copied().find(|(at, _)| is_near(*at))
    }

    fn words(&self, cause: &Cause, near: Option<(f64, SingularKind)>) -> String {
        match cause {
            Cause::Redundant => "joints are redundant, and the play determines which of them carry the load".to_owned(),
            Cause::Lean => "pins lean out of the plane, which the proof does not know".to_owned(),
            Cause::Overhanging(joint) => format!("the block of '{joint}' may overhang an end of its guide"),
            Cause::Loops(NotProven { coordinate, reaches_dead_centre }) => {
                let near = near.map(|(at_rad, kind)| {
                    let kind = match kind {
                        SingularKind::ChangePoint | SingularKind::Nearly => "change point",
                        SingularKind::DeadPoint => "dead point",
                    };
                    format!("near a {kind} (at {})", degrees(at_rad))
                });
                match (near, reaches_dead_centre) {
                    (Some(near), true) => {
                        format!("{near}: play takes the mechanism through it, and it can go over to its other assembly")
                    }
                    (Some(near), false) => near,
                    (None, true) => {
                        "play takes the mechanism to a dead centre, where it can go over to its other assembly"
                            .to_owned()
                    }
                    (None, false) => format!(
                        "{} and half a step of the drive bring {} too near to a dead centre",
                        self.moved_by,
                        self.body_of(*coordinate)
                    ),
                }
            }
        }
    }

    /// The body that a coordinate moves.
    fn body_of(&self, coordinate: Option<usize>) -> String {
        let mut links = self.mechanism.ideal.links.iter();
        let link = links.find(|link| link.dependences.last().is_some_and(|last| Some(*last) == coordinate));
        link.map_or("the mechanism".to_owned(), |link| format!("'{}'", self.mechanism.model.bodies[link.body.0].name))
    }
}

/// An angle within a turn, to a tenth of a degree.
fn degrees(angle_rad: f64) -> String {
    let tenths = (angle_rad.to_degrees() * 10.0).round().rem_euclid(3600.0);
    format!("{}°", tenths / 10.0)
}
