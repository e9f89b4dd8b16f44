//! The text of the model of a robot.

use super::description::{GROUND, JointSide, Robot, RobotJoint, RobotJointKind, most_across};
use super::drives::{CYCLE_S, Course, PlannedDrive, TURN_RPM};
use super::model_names::ModelNames;
use super::numbers::{angle, direction, length, lengths, number, shifted, word};
use super::turns::of_roll_pitch_yaw;
use crate::toml_text::quoted;
use loosepin_space::{Vec3, is_inertia};
use std::fmt::Write;

/// The text of `model.toml`.
pub(super) fn model(robot: &Robot, names: &ModelNames, drives: &[PlannedDrive], notes: &mut Vec<String>) -> String {
    let mut text = format!(
        "# Read from a robot description ({}). The frame of each body is that of its link, and angles and positions of joints are those of the\n\
         # description. Meshes and other shapes are not part of a model.\n\
         #\n\
         # To give a joint play, remove the # before its lines and put in its own numbers:\n\
         #   radial_clearance   radius of the hole minus radius of the pin\n\
         #   bearing_length     length over which the pin leans, its middle at the point of the joint\n\
         #   axial_clearance    from the middle to either stop along the axis\n\n\
         name = {}\n\
         geometry = \"space\"\n",
        robot.format,
        quoted(&robot.name)
    );
    if let Some(gravity) = robot.gravity_m_s2 {
        let components = gravity.map(|component| format!("\"{} m/s^2\"", number(component)));
        let _ = writeln!(text, "gravity = [{}]", components.join(", "));
    }
    bodies(&mut text, robot, names, notes);
    for (number, joint) in robot.joints.iter().enumerate() {
        joint_table(&mut text, names, number, joint);
    }
    guesses(&mut text, robot, names);
    drive_tables(&mut text, robot, names, drives);
    outputs(&mut text, robot, names, drives);
    text
}

fn bodies(text: &mut String, robot: &Robot, names: &ModelNames, notes: &mut Vec<String>) {
    for (number, link) in robot.links.iter().enumerate() {
        let _ = writeln!(text, "\n[body.{}]", names.body(number));
        if number == GROUND && !["ground", "world"].contains(&link.name.as_str()) {
            let _ = writeln!(text, "# the link {}", comment(&link.name));
        }
        if let Some(own) = link.inertial.filter(|_| number != GROUND) {
            let moments = own.inertia_kg_m2.map(|moment| format!("\"{} kg m^2\"", number_text(moment)));
            let moments = if own.inertia_kg_m2[3..] == [0.0; 3] { &moments[..3] } else { &moments[..] };
            let moments = format!("inertia = [{}]", moments.join(", "));
            if own.mass_kg > 0.0 {
                let _ = writeln!(text, "mass = \"{} kg\"", number_text(own.mass_kg));
                let _ = writeln!(text, "centre_of_mass = {}", lengths(own.centre_m));
            }
            if is_inertia(own.inertia_kg_m2) {
                let _ = writeln!(text, "{moments}");
            } else if own.inertia_kg_m2 != [0.0; 6] {
                let _ = writeln!(text, "# {moments}   # of no body");
                notes.push(format!(
                    "the inertia of link '{}' is of no body (a principal moment is not above zero, or exceeds the sum of the others): it is a comment",
                    link.name
                ));
            }
            if own.mass_kg < 0.0 {
                notes.push(format!("the mass of link '{}' is below zero and left out", link.name));
            }
        }
        let points = names.points(number).iter().map(|(name, at_m)| format!("{name} = {}", lengths(*at_m)));
        let _ = writeln!(text, "points = {{ {} }}", points.collect::<Vec<_>>().join(", "));
    }
}

fn number_text(value: f64) -> String {
    shifted(value, 0)
}

fn joint_table(text: &mut String, names: &ModelNames, number: usize, joint: &RobotJoint) {
    let (kind, play): (&str, &[&str]) = match joint.kind {
        RobotJointKind::Fixed => ("rigid", &[]),
        RobotJointKind::Hinge => (
            "revolute",
            &["radial_clearance = \"0.05 mm\"", "bearing_length = \"20 mm\"", "axial_clearance = \"0.05 mm\""],
        ),
        RobotJointKind::Slide => ("prismatic", &[]),
        RobotJointKind::Ball => ("spherical", &["radial_clearance = \"0.05 mm\""]),
        RobotJointKind::Planar => ("planar", &[]),
    };
    let _ = writeln!(text, "\n[joint.{}]", names.joint(number));
    for line in &joint.comments {
        let _ = writeln!(text, "# {}", comment(line));
    }
    let [bearing, journal] = [&joint.parent, &joint.child].map(|side| names.point(side.link, side.point_m));
    let _ = writeln!(text, "kind = \"{kind}\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"");
    if joint.kind != RobotJointKind::Ball {
        axes(text, joint);
    }
    for line in play {
        let _ = writeln!(text, "# {line}");
    }
}

/// The axis of a joint, and directions across it where they are not those that a model has without them.
fn axes(text: &mut String, joint: &RobotJoint) {
    let (bearing, journal) = (direction(joint.parent.axis), direction(joint.child.axis));
    if bearing == journal {
        let _ = writeln!(text, "axis = {bearing}");
    } else {
        let _ = writeln!(text, "bearing_axis = {bearing}\njournal_axis = {journal}");
    }
    let is_default =
        |side: &JointSide| word(side.axis).is_some() && direction(side.across) == direction(default_across(side.axis));
    // In a plane no direction across the axis has a meaning.
    if joint.kind != RobotJointKind::Planar && !(is_default(&joint.parent) && is_default(&joint.child)) {
        let [bearing, journal] = [&joint.parent, &joint.child].map(|side| direction(side.across));
        let _ = writeln!(text, "bearing_across = {bearing}\njournal_across = {journal}");
    }
}

/// The direction across a coordinate axis where a model gives none.
fn default_across(axis: Vec3) -> Vec3 {
    most_across(axis)
}

/// Whether a joint leaves places open that drives do not decide.
fn is_open(joint: &RobotJoint) -> bool {
    joint.closes_loop || matches!(joint.kind, RobotJointKind::Ball | RobotJointKind::Planar)
}

/// Where bodies are in the description, if drives and joints alone do not say it: balls, planes and loops leave it open.
fn guesses(text: &mut String, robot: &Robot, names: &ModelNames) {
    if !robot.joints.iter().any(is_open) {
        return;
    }
    let _ = writeln!(text, "\n# Where the description has the bodies: loops are closed from there.\n[assembly.guess]");
    for (number, frame) in robot.frames().iter().enumerate().skip(1) {
        let [roll, pitch, yaw] = of_roll_pitch_yaw(&frame.axes);
        let turns: Vec<String> = [("z", yaw), ("y", pitch), ("x", roll)]
            .into_iter()
            .filter(|(_, turn)| *turn != 0.0)
            .map(|(axis, turn)| format!("\"{axis} {}\"", angle(turn)))
            .collect();
        let turned = if turns.is_empty() { String::new() } else { format!(", turned = [{}]", turns.join(", ")) };
        let _ = writeln!(text, "{} = {{ at = {}{turned} }}", names.body(number), lengths(frame.origin_m));
    }
}

fn drive_tables(text: &mut String, robot: &Robot, names: &ModelNames, drives: &[PlannedDrive]) {
    for drive in drives {
        let joint = &robot.joints[drive.joint];
        let is_turn = joint.kind == RobotJointKind::Hinge;
        let name = names.joint(drive.joint);
        let _ = writeln!(text, "\n[drive.{name}]");
        if let Some([lower, upper]) = joint.limits {
            let limits = match is_turn {
                true => format!("{} to {}", angle(lower), angle(upper)),
                false => format!("{} to {} mm", shifted(lower, 3), shifted(upper, 3)),
            };
            let _ = writeln!(text, "# limits of the description: {limits}");
        }
        let speed = match (drive.course, is_turn) {
            (Course::Turns, _) => format!("{} rpm", number(TURN_RPM)),
            (Course::Sweeps(way), true) => format!("{}/s", angle(way / CYCLE_S)),
            (Course::Sweeps(way), false) => format!("{} mm/s", shifted(way / CYCLE_S, 3)),
            (Course::Held, true) => "0 deg/s".to_owned(),
            (Course::Held, false) => "0 mm/s".to_owned(),
        };
        let start = match is_turn {
            true => format!("start_angle = \"{}\"", angle(drive.start)),
            false => format!("start_position = {}", length(drive.start)),
        };
        let _ = writeln!(text, "joint = \"{name}\"\nspeed = \"{speed}\"\n{start}");
    }
    let Some(moving) = drives.iter().find(|drive| drive.course != Course::Held) else { return };
    let span = match moving.course {
        Course::Turns => format!("drive = \"{}\"", names.joint(moving.joint)),
        _ => format!("duration = \"{} s\"", number(CYCLE_S)),
    };
    let _ = writeln!(
        text,
        "\n# One joint moves, the others are held: give other drives a speed, and other starts, for another motion.\n[cycle]\n{span}\nsamples_per_turn = 36"
    );
}

/// The path of the origin of the last link, and its turn about the axis of the joint that moves.
fn outputs(text: &mut String, robot: &Robot, names: &ModelNames, drives: &[PlannedDrive]) {
    let Some(tool) = robot.tool() else { return };
    let body = names.body(tool);
    let _ = writeln!(text, "\n# The origin of the last link; another point of it under points for another place.");
    let _ = writeln!(text, "[output.{body}]\npath_of = \"{}\"", names.point(tool, Vec3::ZERO));
    // Between balls a body may turn about itself, which no drive decides.
    if robot.joints.iter().any(is_open) {
        return;
    }
    let moving = drives.iter().find(|drive| drive.course != Course::Held);
    let Some(moving) =
        moving.map(|drive| &robot.joints[drive.joint]).filter(|joint| joint.kind == RobotJointKind::Hinge)
    else {
        return;
    };
    // In the pose of the description: where other joints are held elsewhere the axis may be another one of the body.
    let frames = robot.frames();
    let axis = frames[moving.parent.link].axes.apply(moving.parent.axis);
    let axis = frames[tool].axes.apply_transposed(axis);
    let _ = writeln!(
        text,
        "\n# About an axis of its own, which is that of joint {} in the pose of the description.\n[output.{}]\nturn_of = \"{body}\"\nabout = {}",
        comment(&moving.name),
        names.turn_output(),
        direction(axis)
    );
}

/// A text on one line of a comment.
fn comment(text: &str) -> String {
    text.chars().map(|character| if character.is_control() { ' ' } else { character }).collect()
}
