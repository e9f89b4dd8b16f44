//! URDF: the frame of a link is that of the joint that moves it, so that it stands at the point of its joint, with the axes of its body.

use super::closed_model::Export;
use super::element::Element;
use super::link::Mass;
use super::problem::ExportProblem;
use crate::robot::{Names, of_roll_pitch_yaw};
use loosepin_space::{Frame, TreeJoint, Vec3};
use loosepin_text::units::quoted;

/// Limits of slides, which must have some, m.
const SLIDE_LIMIT_M: f64 = 10.0;
/// Force and speed of a limit, which must be there.
const LIMIT_EFFORT: f64 = 1000.0;
const LIMIT_SPEED: f64 = 10.0;

/// The root element; what it does not say is added to the notes.
pub(super) fn robot(export: &Export<'_>, notes: &mut Vec<String>) -> Result<Element, ExportProblem> {
    if let Some(joint) = export.tree.closing.first().and_then(|number| export.mechanism.joints().get(*number)) {
        let other = ["spherical", "revolute", "rigid"].contains(&joint.kind.word());
        return Err(ExportProblem::ClosesLoop { joint: joint.name.clone(), other });
    }
    let bodies = export.mechanism.bodies();
    // Where the frame of each link is in its body.
    let mut origins = vec![Vec3::ZERO; bodies.len()];
    for own in &export.tree.joints {
        let [_, child] = own.markers(&export.mechanism.joints()[own.joint]);
        origins[own.child] = child.point_m;
    }
    let taken: Vec<&str> = bodies.iter().map(|body| body.name.as_str()).collect();
    let mut names = Names::without(&taken);
    let mut root = Element::new("robot").text("name", &export.model.name);
    for (number, origin_m) in origins.iter().enumerate() {
        root = root.with(link(export, number, *origin_m));
    }
    let mut slides = Vec::new();
    for own in &export.tree.joints {
        let parts = joint(export, own, &origins, &mut names)?;
        if parts.iter().any(|part| part.is_slide) {
            slides.push(export.mechanism.joints()[own.joint].name.clone());
        }
        root = root.with_all(parts.into_iter().flat_map(|part| [part.between, Some(part.joint)]).flatten());
    }
    let without: Vec<&String> = bodies
        .iter()
        .enumerate()
        .skip(1)
        .filter(|(body, _)| Mass::of(export, *body).is_none())
        .map(|(_, own)| &own.name)
        .collect();
    if !without.is_empty() {
        notes.push(format!("no mass of {}: mass and inertia are not both given", quoted(&without)));
    }
    if !slides.is_empty() {
        notes.push(format!("limits of {} are put in, since URDF needs some", quoted(&slides)));
    }
    let moved: Vec<&String> =
        origins.iter().zip(bodies).skip(1).filter(|(at, _)| **at != Vec3::ZERO).map(|(_, own)| &own.name).collect();
    if !moved.is_empty() {
        notes.push(format!("the frame of {} is at its joint", quoted(&moved)));
    }
    Ok(root)
}

fn link(export: &Export<'_>, body: usize, origin_m: Vec3) -> Element {
    let link = Element::new("link").text("name", &export.mechanism.bodies()[body].name);
    let Some(own) = Mass::of(export, body) else { return link };
    let mut inertia = Element::new("inertia");
    for (name, moment) in ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"].into_iter().zip(own.inertia_kg_m2) {
        inertia = inertia.numbers(name, &[moment]);
    }
    let centre = (own.centre_m - origin_m).to_array();
    let inertial = Element::new("inertial")
        .with(Element::new("origin").numbers("xyz", &centre).numbers("rpy", &[0.0; 3]))
        .with(Element::new("mass").numbers("value", &[own.mass_kg]))
        .with(inertia);
    link.with(inertial)
}

/// A joint of URDF, with the link without mass that it moves where a joint of the model becomes two.
struct Part {
    joint: Element,
    between: Option<Element>,
    is_slide: bool,
}

fn joint(
    export: &Export<'_>,
    own: &TreeJoint,
    origins: &[Vec3],
    names: &mut Names,
) -> Result<Vec<Part>, ExportProblem> {
    let joint = &export.mechanism.joints()[own.joint];
    let [parent, child] = own.markers(joint);
    let bodies = export.mechanism.bodies();
    let (parent_name, child_name) = (&bodies[own.parent].name, &bodies[own.child].name);
    // Axes of the child in those of the parent, both markers together.
    let aligned = parent.axes.compose(&child.axes.transposed_times(&loosepin_space::Rotation::IDENTITY));
    let at_start = export.frames[own.parent].axes.transposed_times(&export.frames[own.child].axes);
    let origin = |axes| Frame { origin_m: parent.point_m - origins[own.parent], axes };
    let axis = child.axes.z * own.sign();
    let between = |names: &mut Names| names.claim(&format!("{}_between", joint.name));
    let second = |what: &str| export.second(&joint.name, what);
    let kind = joint.kind.word();
    let one = |element: Element, is_slide: bool| vec![Part { joint: element, between: None, is_slide }];
    Ok(match kind {
        "revolute" => one(
            element(&joint.name, "continuous", &origin(aligned), parent_name, child_name).with(of_axis(axis)),
            false,
        ),
        "rigid" => one(element(&joint.name, "fixed", &origin(aligned), parent_name, child_name), false),
        "prismatic" => {
            let own = element(&joint.name, "prismatic", &origin(aligned), parent_name, child_name);
            one(own.with(of_axis(axis)).with(limit()), true)
        }
        "planar" => {
            // Its directions in the plane have no meaning: zero is where it starts.
            let start = export.frames[own.parent].inverse().compose(&export.frames[own.child]);
            let at = start.point_m(child.point_m) - origins[own.parent];
            let frame = Frame { origin_m: at, axes: start.axes };
            one(element(&joint.name, "planar", &frame, parent_name, child_name).with(of_axis(axis)), false)
        }
        "cylindrical" => {
            let middle = between(names);
            let turn = element(&joint.name, "continuous", &origin(aligned), parent_name, &middle);
            let slide = element(&second("slide"), "prismatic", &Frame::IDENTITY, &middle, child_name);
            vec![
                Part {
                    joint: turn.with(of_axis(axis)),
                    between: Some(Element::new("link").text("name", &middle)),
                    is_slide: false,
                },
                Part { joint: slide.with(of_axis(axis)).with(limit()), between: None, is_slide: true },
            ]
        }
        "universal" => {
            let middle = between(names);
            let pin = at_start.apply_transposed(parent.axes.z);
            let first = element(&joint.name, "continuous", &origin(at_start), parent_name, &middle);
            let other = element(&second("cross"), "continuous", &Frame::IDENTITY, &middle, child_name);
            vec![
                Part {
                    joint: first.with(of_axis(pin)),
                    between: Some(Element::new("link").text("name", &middle)),
                    is_slide: false,
                },
                Part { joint: other.with(of_axis(child.axes.z)), between: None, is_slide: false },
            ]
        }
        _ => {
            let other = kind == "spherical";
            return Err(ExportProblem::Kind { joint: joint.name.clone(), kind, format: "URDF", other });
        }
    })
}

fn element(name: &str, kind: &str, origin: &Frame, parent: &str, child: &str) -> Element {
    Element::new("joint")
        .text("name", name)
        .text("type", kind)
        .with(
            Element::new("origin")
                .numbers("xyz", &origin.origin_m.to_array())
                .numbers("rpy", &of_roll_pitch_yaw(&origin.axes)),
        )
        .with(Element::new("parent").text("link", parent))
        .with(Element::new("child").text("link", child))
}

fn of_axis(axis: Vec3) -> Element {
    Element::new("axis").numbers("xyz", &axis.to_array())
}

fn limit() -> Element {
    Element::new("limit")
        .numbers("lower", &[-SLIDE_LIMIT_M])
        .numbers("upper", &[SLIDE_LIMIT_M])
        .numbers("effort", &[LIMIT_EFFORT])
        .numbers("velocity", &[LIMIT_SPEED])
}
