//! Description of a mechanism in space.

use loosepin_result::motion::OTHER_START;
use loosepin_space::{
    ClosureError, IdleKind, IdleMotion, IsStopped, JointCoordinate, PoseAccuracy, Position, RedundantDirection,
    SpatialMechanism, SpatialModel, assemble, mobility, stop_after,
};
use loosepin_text::article::{Article, Fact, Section};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::numbers::Values;
use loosepin_text::units::{Dimension, counted, counted_or_no, format_number, format_value, listed};

/// Singular values below this share of the largest are reported as nearly redundant.
const NEARLY_REDUNDANT: f64 = 1e-6;

/// Steps times unknowns that following the motion may take, some seconds: the time of a step grows with the unknowns.
const MAX_WORK: f64 = 1e6;

/// Closes the loops of a model in space over its turn, and reports its bodies, joints, freedoms and play. Where following the whole turn would
/// cost too much, its beginning is followed, and the report says how far. Until it is stopped.
///
/// # Errors
/// What keeps it from moving; that it was stopped.
pub fn check_space(model: &SpatialModel, is_stopped: IsStopped) -> Result<Article, Diagnostics> {
    let values = model.quantities.nominal();
    let mechanism = model.mechanism(&values).map_err(|error| model.diagnostic(&error))?;
    let is_enough = stop_after((MAX_WORK / (6.0 * model.bodies.len() as f64)) as u64, is_stopped);
    let (start, closing) = if model.cycle.is_some() {
        let positions = match model.first_positions(&mechanism, &values, &is_enough) {
            Ok(positions) => positions,
            Err(_) if is_stopped() => return Err(model.not_closed(&ClosureError::Stopped)),
            Err(not_closed) => {
                let fitted = fitted(model, &values, &is_enough);
                let why = if is_stopped() { model.not_closed(&ClosureError::Stopped) } else { not_closed };
                return fitted.ok_or(why);
            }
        };
        if is_stopped() {
            return Err(model.not_closed(&ClosureError::Stopped));
        }
        let (count, all) = (positions.len(), 1 + model.cycle.map_or(0, |cycle| cycle.samples_per_turn));
        (
            positions.into_iter().next(),
            match model.drives.is_empty() {
                true => "The loops close at the start; nothing is driven.".to_owned(),
                false if count == 0 => {
                    "To find where the loops close takes longer than a check; `loosepin motion` does it.".to_owned()
                }
                false if count < all => format!(
                    "The loops close at the first {count} of {all} positions of the cycle; to follow the others takes longer than a check, \
                     `loosepin motion` does it."
                ),
                false => format!("The loops close at all {count} positions of the cycle."),
            },
        )
    } else {
        let found = assemble(&mechanism, &model.drive_values(&values, 0.0));
        let start = found.map_err(|error| model.not_closed(&error))?;
        (Some(start), "The loops close at the start; without [cycle] they are not moved.".to_owned())
    };
    let mut sections = vec![bodies(model, &values), joints(model, &values)];
    if let Some(start) = start {
        sections.push(freedoms(model, &mechanism, &start));
    }
    sections.push(Section::of_sentences("closing", [closing]));
    Ok(Article { title: model.name.clone(), sections })
}

/// Parts that do not close with ideal joints: whether their play takes that up; `None` where that is no question of play.
fn fitted(model: &SpatialModel, values: &Values, is_stopped: IsStopped) -> Option<Article> {
    let words = model.assembly_until(values, is_stopped).ok()?.sentence()?;
    let closing = Section::of_sentences("closing", [format!("The loops do not close with ideal joints: {words}.")]);
    Some(Article { title: model.name.clone(), sections: vec![bodies(model, values), joints(model, values), closing] })
}

fn bodies(model: &SpatialModel, values: &Values) -> Section {
    let moving = model.bodies.iter().skip(1);
    let facts = moving.map(|body| {
        let mass = body.mass_kg.map_or("no mass".to_owned(), |mass| format_value(values[mass], Dimension::MASS));
        let points = counted_or_no(body.points.len(), "point", "points");
        Fact::new(&body.name, [format!("{mass}, {points}")])
    });
    let count = model.bodies.len().saturating_sub(1);
    let heading = format!("{} in space, on the ground", counted_or_no(count, "moving body", "moving bodies"));
    Section::of_facts("bodies", heading, facts)
}

fn joints(model: &SpatialModel, values: &Values) -> Section {
    let facts = model.joints.iter().enumerate().map(|(number, joint)| {
        let kind = joint.kind.word();
        let [journal, bearing] = [&joint.journal, &joint.bearing].map(|marker| model.point_name(marker.point));
        let mut lines = vec![format!("{kind}: {journal} in {bearing}")];
        lines.extend(model.drives.iter().filter(|drive| drive.joint == number).map(|drive| {
            let (speed, start) = match drive.coordinate {
                JointCoordinate::Angle => (Dimension::ANGULAR_VELOCITY, Dimension::ANGLE),
                JointCoordinate::Slide => (Dimension::VELOCITY, Dimension::LENGTH),
            };
            let (speed, start) = (format_value(values[drive.speed], speed), format_value(values[drive.start], start));
            format!("driven by '{}' at {speed}, from {start}", drive.name)
        }));
        lines.extend(joint.play.map(|play| format!("play: {}", play.with(values).words())));
        Fact::new(&joint.name, lines)
    });
    let facts: Vec<Fact> = facts.collect();
    Section::of_facts("joints", counted_or_no(facts.len(), "joint", "joints"), facts)
}

/// Degrees of freedom, idle ones, and rows that repeat others.
fn freedoms(model: &SpatialModel, mechanism: &SpatialMechanism, start: &Position) -> Section {
    let found = mobility(mechanism, start);
    let mut lines = vec![found.words()];
    lines.extend(found.idle.iter().map(|idle| idle_words(model, idle)));
    if !found.redundant.is_empty() {
        let count = found.redundant.len();
        lines.push(format!(
            "{} of the joints {} others: {}",
            counted_or_no(count, "constraint", "constraints"),
            if count == 1 { "repeats" } else { "repeat" },
            listed(&taking_part(model, &found.redundant), "and")
        ));
        lines.push("single reactions of these joints are not determined".to_owned());
        // Only rows that plays reach are conditions of them.
        let conditions = PoseAccuracy::new(mechanism, start).map_or(0, |accuracy| accuracy.conditions());
        if conditions > 0 {
            lines.push(format!("the plays must meet {} together", counted(conditions, "condition")));
        }
    }
    if start.is_other_start {
        lines.push(OTHER_START.to_owned());
    }
    if found.smallest_counted < NEARLY_REDUNDANT {
        lines.push(format!(
            "a constraint is nearly redundant: smallest singular value {} of the largest; numbers with few digits do that",
            format_number(found.smallest_counted)
        ));
    }
    Section::of_sentences("mobility", lines)
}

/// The joints that take part in redundant rows, each once.
fn taking_part(model: &SpatialModel, redundant: &[RedundantDirection]) -> Vec<String> {
    let joints = model.joints.iter().enumerate();
    let takes_part = |number: usize| redundant.iter().any(|own| own.shares.iter().any(|share| share.joint == number));
    joints.filter(|(number, _)| takes_part(*number)).map(|(_, joint)| format!("'{}'", joint.name)).collect()
}

fn idle_words(model: &SpatialModel, idle: &IdleMotion) -> String {
    let names: Vec<String> = idle.bodies.iter().map(|body| format!("'{}'", model.bodies[*body].name)).collect();
    let along = [idle.direction.x, idle.direction.y, idle.direction.z];
    let along = along.map(|own| format_number(1e-3 * (1e3 * own).round())).join(", ");
    let does = match idle.kind {
        IdleKind::Turn { .. } => "turns alone",
        IdleKind::Slide => "slides",
        IdleKind::Helix { .. } => "moves as a screw",
    };
    format!(
        "one freedom is idle: {} {does}, along ({along}) at the start, and moves nothing else",
        listed(&names, "and")
    )
}
