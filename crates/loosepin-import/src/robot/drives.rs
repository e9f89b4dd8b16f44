//! Which joints of a robot are driven, and how far the first one moves.

use super::description::{Robot, RobotJointKind};
use super::mechanism::{coordinate, mechanism};
use loosepin_space::{DriveValue, Mobility, assemble, mobility};
use loosepin_text::units::{counted, quoted};
use std::f64::consts::TAU;

/// Speed of a joint that can turn all round: 10 turns a minute.
pub(super) const TURN_RPM: f64 = 10.0;
/// Way of a slide without limits in the time of the cycle, m.
const SLIDE_M: f64 = 0.1;
/// Time of a cycle that is not counted by turns, s.
pub(super) const CYCLE_S: f64 = 1.0;

/// Links of a robot with loops whose freedoms are counted, at most: beyond, counting takes minutes, and no model has as many bodies.
const MAX_COUNTED_LINKS: usize = 100;

/// A drive of the model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PlannedDrive {
    /// The joint.
    pub joint: usize,
    /// Its coordinate at time zero, rad or m.
    pub start: f64,
    /// What it does.
    pub course: Course,
}

/// What a drive does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Course {
    /// It stands still.
    Held,
    /// It turns all round.
    Turns,
    /// It goes this far in the time of the cycle, rad or m.
    Sweeps(f64),
}

/// The drives of a robot, in the order of its joints.
///
/// Without loops each hinge and each slide has one. With loops, joints with motors come first, and others as long as freedoms are left. The first
/// one on the way to the tool moves, over its limits if it has any; the others are held where the description has them, or at the limit that is
/// nearest to that.
pub(super) fn planned(robot: &Robot, notes: &mut Vec<String>) -> Vec<PlannedDrive> {
    let mut joints = driven_joints(robot, notes);
    joints.sort_unstable();
    let on_way = robot.way_to_tool();
    let first = |kind: RobotJointKind, any: bool| {
        let fits = |joint: &usize| robot.joints[*joint].kind == kind && (any || on_way.contains(joint));
        joints.iter().copied().find(fits)
    };
    let (hinge, slide) = (RobotJointKind::Hinge, RobotJointKind::Slide);
    let moving = [(hinge, false), (slide, false), (hinge, true), (slide, true)];
    let moving = moving.into_iter().find_map(|(kind, any)| first(kind, any));
    let drives = joints.iter().map(|&joint| {
        let own = &robot.joints[joint];
        let nearest = own.limits.map_or(own.reference, |[lower, upper]| {
            if lower <= upper { own.reference.clamp(lower, upper) } else { own.reference }
        });
        if Some(joint) != moving {
            return PlannedDrive { joint, start: nearest, course: Course::Held };
        }
        let (start, course) = match (own.kind, own.limits) {
            (RobotJointKind::Hinge, Some([lower, upper])) if upper - lower < TAU => {
                (lower, Course::Sweeps(upper - lower))
            }
            (RobotJointKind::Hinge, _) => (nearest, Course::Turns),
            (_, Some([lower, upper])) => (lower, Course::Sweeps(upper - lower)),
            (_, None) => (nearest, Course::Sweeps(SLIDE_M)),
        };
        PlannedDrive { joint, start, course }
    });
    drives.collect()
}

fn driven_joints(robot: &Robot, notes: &mut Vec<String>) -> Vec<usize> {
    let can_be_driven =
        |joint: &usize| !robot.joints[*joint].closes_loop && coordinate(robot.joints[*joint].kind).is_some();
    let (mut driven, others): (Vec<usize>, Vec<usize>) =
        (0..robot.joints.len()).filter(can_be_driven).partition(|joint| robot.joints[*joint].is_actuated);
    if !robot.joints.iter().any(|joint| joint.closes_loop) {
        driven.extend(others);
        note_of_free(robot, notes);
        return driven;
    }
    let alone = if robot.links.len() > MAX_COUNTED_LINKS { None } else { freedoms(robot, &[]) };
    let Some(alone) = alone else {
        notes.push("the freedoms of its loops could not be counted: drives are those of its motors".to_owned());
        return driven;
    };
    let (mut left, mut taken) = (alone.undriven_freedoms, Vec::new());
    // All motors at once, where none of them repeats others; else one after the other.
    for candidates in [vec![driven.clone()], singly(&driven), singly(&others)].concat() {
        if left == 0 || candidates.iter().any(|joint| taken.contains(joint)) {
            continue;
        }
        let more = [taken.clone(), candidates].concat();
        if let Some(found) = freedoms(robot, &more).filter(|found| found.repeated_drives == 0) {
            left = found.undriven_freedoms;
            taken = more;
        }
    }
    if left > 0 {
        notes.push(format!("{} left that no drive holds", counted(left, "freedom")));
    }
    taken
}

fn singly(joints: &[usize]) -> Vec<Vec<usize>> {
    joints.iter().map(|joint| vec![*joint]).collect()
}

/// How the robot can move with these drives in the pose of the description.
fn freedoms(robot: &Robot, driven: &[usize]) -> Option<Mobility> {
    let mechanism = mechanism(robot, driven).ok()?;
    let held = driven.iter().map(|joint| DriveValue::held(robot.joints[*joint].reference));
    let position = assemble(&mechanism, &held.collect::<Vec<_>>()).ok()?;
    Some(mobility(&mechanism, &position))
}

/// Joints of a tree that no drive can hold.
fn note_of_free(robot: &Robot, notes: &mut Vec<String>) {
    let is_free = |kind| matches!(kind, RobotJointKind::Ball | RobotJointKind::Planar);
    let names: Vec<&String> =
        robot.joints.iter().filter(|joint| is_free(joint.kind)).map(|joint| &joint.name).collect();
    if !names.is_empty() {
        let (joints, they) = if names.len() == 1 { ("joint", "it moves") } else { ("joints", "they move") };
        notes.push(format!(
            "no drive can hold {joints} {}: {they} freely, so that the motion is not determined",
            quoted(&names)
        ));
    }
}
