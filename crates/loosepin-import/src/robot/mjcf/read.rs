//! The file.

use super::body::Bodies;
use super::compiler::Compiler;
use super::defaults::Defaults;
use super::equality;
use crate::robot::description::Robot;
use crate::robot::problem::RobotProblem;
use crate::robot::xml::Element;
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::units::{counted, quoted};
use std::collections::HashSet;

/// Gravity where a file gives none, m/s².
const GRAVITY_M_S2: [f64; 3] = [0.0, 0.0, -9.81];
/// The name of a model that has none.
const NAME: &str = "MuJoCo Model";
/// Bodies, and constraints of an element, at most: they are searched one after the other.
const MAX_BODIES: usize = 1000;

/// Reads the element `<mujoco>`.
pub(in crate::robot) fn read(root: Element<'_>) -> Result<Robot, Diagnostics> {
    let mut notes = Vec::new();
    if let Some(include) = root.all("include").next() {
        let why = "other files are not opened; write its content in its place, as MuJoCo does when it saves a model";
        return Err(include.error(&RobotProblem::NotRead { element: include.words(), why }));
    }
    let compiler = Compiler::read(root, &mut notes)?;
    let defaults = Defaults::read(root)?;
    let mut gravity = GRAVITY_M_S2;
    for option in root.all("option") {
        if let Some(own) = option.attribute("gravity") {
            gravity = own.numbers()?;
        }
    }
    let motors = root.all("actuator").flat_map(|all| all.children());
    let actuated: HashSet<&str> = motors
        .filter_map(|motor| Some(motor.attribute("joint").or_else(|| motor.attribute("jointinparent"))?.text))
        .collect();
    let mut bodies = Bodies::new(&compiler, &defaults, actuated);
    for world in root.all("worldbody") {
        bodies.world(world)?;
        if bodies.links.len() > MAX_BODIES {
            return Err(world.error(&RobotProblem::TooLarge { what: "bodies", limit: MAX_BODIES }));
        }
    }
    if bodies.links.len() == 1 {
        return Err(root.error(&RobotProblem::NoLinks));
    }
    notes.extend(findings(&bodies));
    for (tag, words) in [("tendon", "tendons"), ("deformable", "deformable parts")] {
        if root.all(tag).any(|all| all.children().next().is_some()) {
            notes.push(format!("{words} are ignored"));
        }
    }
    let mut robot = Robot {
        name: root.attribute("model").map_or(NAME, |name| name.text).to_owned(),
        format: "MJCF",
        links: bodies.links.clone(),
        joints: bodies.joints.clone(),
        gravity_m_s2: Some(gravity),
        notes,
    };
    for element in root.all("equality") {
        if let Some(beyond) = element.children().nth(MAX_BODIES) {
            return Err(beyond.error(&RobotProblem::TooLarge { what: "constraints", limit: MAX_BODIES }));
        }
        equality::read(element, &bodies, &mut robot)?;
    }
    Ok(robot)
}

/// What became of shapes and of joints.
fn findings(bodies: &Bodies<'_, '_>) -> Vec<String> {
    let mut notes = Vec::new();
    if bodies.geoms > 0 {
        notes.push(format!("{}, with their meshes, ignored as shapes", counted(bodies.geoms, "geom")));
    }
    if bodies.weighed > 0 {
        notes.push(format!("the mass of {} computed from geoms", bodies_words(bodies.weighed)));
    }
    if !bodies.unweighed.is_empty() {
        notes.push(format!("no mass of {}: meshes are not read", quoted(&bodies.unweighed)));
    }
    if bodies.nameless_sites > 0 {
        notes.push(format!(
            "{} without a name left out: points of a model have names",
            counted(bodies.nameless_sites, "site")
        ));
    }
    let between = bodies.links.len() - 1 - bodies.count;
    if between > 0 {
        notes.push(format!("{} without mass between the joints of one body", counted(between, "link")));
    }
    notes
}

fn bodies_words(count: usize) -> String {
    if count == 1 { "1 body is".to_owned() } else { format!("{count} bodies is") }
}
