//! `<equality>`: constraints that close loops.

use super::body::Bodies;
use super::defaults::MAIN;
use super::orientation::quaternion;
use crate::robot::description::{GROUND, JointSide, Robot, RobotJoint, RobotJointKind};
use crate::robot::problem::RobotProblem;
use crate::robot::xml::Element;
use loosepin_space::{Frame, Vec3};
use loosepin_text::diagnostics::Diagnostics;

/// Reads `<equality>`: joints that close loops are added to the robot, closed in the pose of the file.
pub(super) fn read<'d>(element: Element<'d>, bodies: &Bodies<'_, 'd>, robot: &mut Robot) -> Result<(), Diagnostics> {
    let frames = robot.frames();
    for constraint in element.children() {
        let words = constraint
            .attribute("name")
            .map_or_else(|| constraint.words(), |name| format!("{} '{}'", constraint.tag(), name.shown()));
        let styled = bodies.defaults.styled(constraint, MAIN)?;
        let active = constraint.attribute("active").or_else(|| styled.inherited("equality", "active"));
        if !active.map_or(Ok(true), |own| own.flag("active"))? {
            robot.notes.push(format!("{words} is not active, and ignored"));
            continue;
        }
        let (kind, [parent, child]) = match constraint.tag() {
            "connect" => (RobotJointKind::Ball, connect(constraint, bodies, &frames)?),
            "weld" => (RobotJointKind::Fixed, weld(constraint, bodies, &frames)?),
            _ => {
                robot.notes.push(format!("{words} is ignored: only connect and weld become joints"));
                continue;
            }
        };
        if parent.link == child.link {
            let body = robot.links.get(child.link).map_or(String::new(), |link| link.name.clone());
            return Err(constraint.error(&RobotProblem::SameBody { element: words, body }));
        }
        let number = robot.joints.len() + 1;
        let name = constraint
            .attribute("name")
            .map_or_else(|| format!("{}{number}", constraint.tag()), |own| own.text.to_owned());
        robot.joints.push(RobotJoint {
            name,
            kind,
            parent,
            child,
            reference: 0.0,
            limits: None,
            is_actuated: false,
            closes_loop: true,
            comments: vec!["closes a loop".to_owned()],
        });
    }
    Ok(())
}

/// Both sides of the point at which two bodies are connected.
fn connect(constraint: Element<'_>, bodies: &Bodies<'_, '_>, frames: &[Frame]) -> Result<[JointSide; 2], Diagnostics> {
    if let Some(sides) = sites(constraint, bodies)? {
        return Ok(sides.map(|(link, point_m)| JointSide::new(link, point_m, Vec3::Z)));
    }
    let [first, second] = two(constraint, bodies)?;
    let point_m = constraint.required_attribute("anchor")?.vector()?;
    let in_second = frames[second].inverse().compose(&frames[first]).point_m(point_m);
    Ok([JointSide::new(first, point_m, Vec3::Z), JointSide::new(second, in_second, Vec3::Z)])
}

/// Both sides of the origin of the second body, which stays where it is in the first.
fn weld(constraint: Element<'_>, bodies: &Bodies<'_, '_>, frames: &[Frame]) -> Result<[JointSide; 2], Diagnostics> {
    if constraint.attribute("site1").is_some() {
        let why = "the axes of its sites are not read; give body1 and body2";
        return Err(constraint.error(&RobotProblem::NotRead { element: constraint.words(), why }));
    }
    let [first, second] = two(constraint, bodies)?;
    let given = match constraint.attribute("relpose") {
        None => None,
        Some(pose) => {
            let [x, y, z, quaternion_w, a, b, c] = pose.numbers()?;
            let axes = quaternion([quaternion_w, a, b, c]);
            // A quaternion of zeros stands for the pose in which the file has both.
            axes.map(|axes| Frame { origin_m: Vec3::new(x, y, z), axes })
        }
    };
    let frame = given.unwrap_or_else(|| frames[first].inverse().compose(&frames[second]));
    let side = JointSide::new(second, Vec3::ZERO, Vec3::Z);
    Ok([side.seen_from(first, &frame), side])
}

/// Two bodies; the second is the world if it is omitted.
fn two(constraint: Element<'_>, bodies: &Bodies<'_, '_>) -> Result<[usize; 2], Diagnostics> {
    let of = |name: &str| {
        constraint.attribute(name).map(|own| {
            bodies.by_name.get(own.text).copied().ok_or_else(|| {
                own.error(&RobotProblem::Unknown { element: constraint.words(), kind: "body", name: own.shown() })
            })
        })
    };
    let first = of("body1").transpose()?;
    let Some(first) = first else { return constraint.required_attribute("body1").map(|_| [GROUND; 2]) };
    Ok([first, of("body2").transpose()?.unwrap_or(GROUND)])
}

/// Two sites, if it has them.
fn sites(constraint: Element<'_>, bodies: &Bodies<'_, '_>) -> Result<Option<[(usize, Vec3); 2]>, Diagnostics> {
    if constraint.attribute("site1").is_none() {
        return Ok(None);
    }
    let of = |name: &str| {
        let own = constraint.required_attribute(name)?;
        bodies.sites.get(own.text).copied().ok_or_else(|| {
            own.error(&RobotProblem::Unknown { element: constraint.words(), kind: "site", name: own.shown() })
        })
    };
    Ok(Some([of("site1")?, of("site2")?]))
}
