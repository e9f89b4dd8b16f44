//! URDF: links that hang on each other by joints, the frame of each link that of its joint.
//!
//! Source: the XML specification of URDF, <https://wiki.ros.org/urdf/XML>: angles in rad, lengths in m; `rpy` are turns about axes that stay, roll
//! about x first, then pitch about y, then yaw about z; the axis of a joint is in the frame of the joint, which is that of its child.

use super::description::{GROUND, Inertial, JointSide, Link, Robot, RobotJoint, RobotJointKind};
use super::problem::RobotProblem;
use super::turns::{roll_pitch_yaw, turned_inertia};
use super::xml::Element;
use loosepin_space::{Frame, Vec3};
use loosepin_text::diagnostics::Diagnostics;
use loosepin_text::units::{counted, quoted};
use std::collections::HashMap;

/// Links, and joints, at most: they are searched one after the other.
const MAX_LINKS: usize = 1000;

/// A joint between links of the file, by their places there.
struct FileJoint {
    joint: RobotJoint,
    parent: usize,
    child: usize,
}

/// Reads the element `<robot>`.
pub(super) fn read(root: Element<'_>) -> Result<Robot, Diagnostics> {
    if let Some((first, _)) = root.namespaces().find(|(_, namespace)| namespace.contains("xacro")) {
        return Err(first.error(&RobotProblem::Macros));
    }
    let name = root.required_attribute("name")?.text.to_owned();
    let mut notes = Vec::new();
    let elements: Vec<Element<'_>> = root.all("link").collect();
    too_many(elements.get(MAX_LINKS), "links")?;
    too_many(root.all("joint").nth(MAX_LINKS).as_ref(), "joints")?;
    let mut numbers = HashMap::new();
    let mut links = Vec::new();
    for (number, element) in elements.iter().enumerate() {
        let name = element.required_attribute("name")?;
        if numbers.insert(name.text, number).is_some() {
            return Err(name.error(&RobotProblem::SameName { kind: "link", name: name.shown() }));
        }
        links.push(read_link(*element)?);
    }
    let mut joints: Vec<FileJoint> = Vec::new();
    let mut joint_names = HashMap::new();
    for element in root.all("joint") {
        let name = element.required_attribute("name")?;
        if joint_names.insert(name.text, ()).is_some() {
            return Err(name.error(&RobotProblem::SameName { kind: "joint", name: name.shown() }));
        }
        let own = read_joint(element, &numbers, &mut notes)?;
        if let Some(other) = joints.iter().find(|other| other.child == own.child) {
            let (link, joint) = (links[own.child].name.clone(), other.joint.name.clone());
            return Err(element.error(&RobotProblem::TwoParents { link, joint }));
        }
        joints.push(own);
    }
    for element in root.all("joint") {
        refuse_unknown_mimic(element, &joint_names)?;
    }
    let root_link = root_of(root, &elements, &joints)?;
    shapes_note(&elements, &mut notes);
    ordered(name, links, joints, root_link, &elements, notes)
}

fn too_many(beyond: Option<&Element<'_>>, what: &'static str) -> Result<(), Diagnostics> {
    beyond.map_or(Ok(()), |element| Err(element.error(&RobotProblem::TooLarge { what, limit: MAX_LINKS })))
}

fn read_link(element: Element<'_>) -> Result<Link, Diagnostics> {
    let name = element.required_attribute("name")?.text.to_owned();
    let inertial = element.only("inertial")?.map(read_inertial).transpose()?;
    Ok(Link { name, inertial, points: Vec::new() })
}

fn read_inertial(element: Element<'_>) -> Result<Inertial, Diagnostics> {
    let frame = origin(element)?;
    let mass_kg = element.required("mass")?.required_attribute("value")?.number()?;
    let tensor = element.required("inertia")?;
    let mut moments = [0.0; 6];
    for (moment, name) in moments.iter_mut().zip(["ixx", "iyy", "izz", "ixy", "ixz", "iyz"]) {
        *moment = tensor.required_attribute(name)?.number()?;
    }
    Ok(Inertial { mass_kg, centre_m: frame.origin_m, inertia_kg_m2: turned_inertia(&frame.axes, moments) })
}

/// The frame of an element's `<origin>`; that of its parent where there is none.
fn origin(element: Element<'_>) -> Result<Frame, Diagnostics> {
    let Some(origin) = element.only("origin")? else { return Ok(Frame::IDENTITY) };
    let origin_m = origin.attribute("xyz").map_or(Ok(Vec3::ZERO), |own| own.vector())?;
    let turns = origin.attribute("rpy").map_or(Ok([0.0; 3]), |own| own.numbers())?;
    Ok(Frame { origin_m, axes: roll_pitch_yaw(turns) })
}

/// Types of joints that a model in space knows.
const TYPES: &str = "fixed, revolute, continuous, prismatic and planar joints";

fn read_joint(
    element: Element<'_>,
    links: &HashMap<&str, usize>,
    notes: &mut Vec<String>,
) -> Result<FileJoint, Diagnostics> {
    let name = element.required_attribute("name")?.text.to_owned();
    let word = element.required_attribute("type")?;
    let kind = match word.text {
        "fixed" => RobotJointKind::Fixed,
        "revolute" | "continuous" => RobotJointKind::Hinge,
        "prismatic" => RobotJointKind::Slide,
        "planar" => RobotJointKind::Planar,
        "floating" => return Err(word.error(&RobotProblem::Floating { element: element.words() })),
        _ => {
            let problem = RobotProblem::OtherKind { element: element.words(), found: word.shown(), known: TYPES };
            return Err(word.error(&problem));
        }
    };
    let end = |tag: &'static str| -> Result<usize, Diagnostics> {
        let link = element.required(tag)?.required_attribute("link")?;
        links.get(link.text).copied().ok_or_else(|| {
            link.error(&RobotProblem::Unknown { element: element.words(), kind: "link", name: link.shown() })
        })
    };
    let (parent, child) = (end("parent")?, end("child")?);
    if parent == child {
        let link = element.required("child")?.required_attribute("link")?.shown();
        return Err(element.error(&RobotProblem::SelfParent { joint: name, link }));
    }
    let frame = origin(element)?;
    let axis = match element.only("axis")? {
        Some(axis) if kind != RobotJointKind::Fixed => axis.required_attribute("xyz")?.direction("axis")?,
        // A fixed joint has no axis, and that of the others is x where none is given.
        _ if kind == RobotJointKind::Fixed => Vec3::Z,
        _ => Vec3::X,
    };
    let mut comments = Vec::new();
    if let Some(mimic) = element.only("mimic")? {
        let other = mimic.required_attribute("joint")?.shown();
        notes.push(format!(
            "joint '{name}' follows joint '{other}' in the description; in the model it has a drive of its own"
        ));
        comments.push(format!("follows {other} in the description"));
    }
    let limits = match element.only("limit")? {
        Some(limit) if word.text == "revolute" || word.text == "prismatic" => {
            let of = |name: &str| limit.attribute(name).map_or(Ok(0.0), |own| own.number());
            Some([of("lower")?, of("upper")?])
        }
        _ => None,
    };
    let side = JointSide::new(child, Vec3::ZERO, axis);
    let joint = RobotJoint {
        name,
        kind,
        parent: side.seen_from(parent, &frame),
        child: side,
        reference: 0.0,
        limits: limits.filter(|[lower, upper]| lower < upper),
        is_actuated: true,
        closes_loop: false,
        comments,
    };
    Ok(FileJoint { joint, parent, child })
}

/// Refuses a joint that follows one that the file does not have.
fn refuse_unknown_mimic(element: Element<'_>, joints: &HashMap<&str, ()>) -> Result<(), Diagnostics> {
    let Some(mimic) = element.only("mimic")? else { return Ok(()) };
    let other = mimic.required_attribute("joint")?;
    if joints.contains_key(other.text) {
        return Ok(());
    }
    Err(other.error(&RobotProblem::Unknown { element: mimic.words(), kind: "joint", name: other.shown() }))
}

/// The one link that is no child.
fn root_of(root: Element<'_>, elements: &[Element<'_>], joints: &[FileJoint]) -> Result<usize, Diagnostics> {
    let is_root = |number: &usize| joints.iter().all(|joint| joint.child != *number);
    let name = |number: usize| elements[number].attribute("name").map_or(String::new(), |name| name.shown());
    let mut roots = (0..elements.len()).filter(is_root);
    match (roots.next(), roots.next()) {
        (Some(first), Some(second)) => {
            let problem = RobotProblem::TwoRoots { first: name(first), second: name(second) };
            Err(elements[second].error(&problem))
        }
        (Some(first), None) if elements.len() > 1 => Ok(first),
        (None, _) if !elements.is_empty() => Err(elements[0].error(&RobotProblem::Circle { link: name(0) })),
        _ => Err(root.error(&RobotProblem::NoLinks)),
    }
}

fn shapes_note(elements: &[Element<'_>], notes: &mut Vec<String>) {
    let shapes = |element: &Element<'_>| element.all("visual").chain(element.all("collision")).count();
    let count: usize = elements.iter().map(shapes).sum();
    if count > 0 {
        notes.push(format!(
            "{} of links, with their meshes, ignored: a model has points and axes",
            counted(count, "shape")
        ));
    }
}

/// The robot with its root first, and each joint after that of its parent, in the order of the file from the root on.
fn ordered(
    name: String,
    links: Vec<Link>,
    mut joints: Vec<FileJoint>,
    root: usize,
    elements: &[Element<'_>],
    mut notes: Vec<String>,
) -> Result<Robot, Diagnostics> {
    let mut places = vec![None; links.len()];
    places[root] = Some(GROUND);
    let mut order = vec![root];
    let mut sorted = Vec::new();
    let mut next = 0;
    while let Some(&parent) = order.get(next) {
        next += 1;
        let (own, others): (Vec<_>, Vec<_>) = joints.into_iter().partition(|joint| joint.parent == parent);
        joints = others;
        for FileJoint { mut joint, parent, child } in own {
            places[child] = Some(order.len());
            joint.parent.link = places[parent].unwrap_or(GROUND);
            joint.child.link = order.len();
            order.push(child);
            sorted.push(joint);
        }
    }
    if let Some(lost) = places.iter().position(Option::is_none) {
        return Err(elements[lost].error(&RobotProblem::Circle { link: links[lost].name.clone() }));
    }
    let links: Vec<Link> = order.into_iter().map(|number| links[number].clone()).collect();
    if let Some(ground) = links.first() {
        let mass = if ground.inertial.is_some() { ", and its mass is left out" } else { "" };
        notes.insert(0, format!("the root link {} is the ground{mass}", quoted(&[&ground.name])));
    }
    Ok(Robot { name, format: "URDF", links, joints: sorted, gravity_m_s2: None, notes })
}
