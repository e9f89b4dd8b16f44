//! MJCF: bodies with the frames and the names of the model, as they stand at time zero; `ref` of a joint is its coordinate there.

use super::closed_model::Export;
use super::element::Element;
use super::link::Mass;
use super::problem::ExportProblem;
use crate::robot::Names;
use loosepin_space::{Frame, Joint, JointCoordinate, Marker, Quaternion, TreeJoint, Vec3};
use loosepin_text::units::quoted;

/// Mass and inertia that MuJoCo is to give to bodies without: it takes no moving body without any.
const BOUND_MASS_KG: f64 = 1e-6;
const BOUND_INERTIA_KG_M2: f64 = 1e-9;

/// The root element; what it does not say is added to the notes.
pub(super) fn robot(export: &Export<'_>, notes: &mut Vec<String>) -> Result<Element, ExportProblem> {
    let mut compiler = Element::new("compiler").text("angle", "radian").text("autolimits", "true");
    let bodies = export.mechanism.bodies();
    let without = (1..bodies.len()).filter(|body| Mass::of(export, *body).is_none());
    let without: Vec<&String> = without.map(|body| &bodies[body].name).collect();
    if !without.is_empty() {
        compiler = compiler.numbers("boundmass", &[BOUND_MASS_KG]).numbers("boundinertia", &[BOUND_INERTIA_KG_M2]);
        notes.push(format!(
            "no mass and inertia of {}: boundmass and boundinertia give small ones, since MuJoCo needs some",
            quoted(&without)
        ));
    }
    let mut root = Element::new("mujoco").text("model", &export.model.name).with(compiler);
    if let Some(gravity) = export.model.gravity_m_s2 {
        root = root.with(Element::new("option").numbers("gravity", &gravity.map(|id| export.values[id])));
    } else {
        notes.push("the model has no gravity: that of MuJoCo acts, 9.81 m/s² against z".to_owned());
    }
    // The ground is the world, and its name is taken.
    let mut names = Names::without(&["world"]);
    let names: Vec<String> = bodies
        .iter()
        .enumerate()
        .map(|(number, body)| if number == 0 { "world".to_owned() } else { names.claim(&body.name) })
        .collect();
    let mut world = Element::new("worldbody").with_all(sites(export, 0));
    for own in export.tree.joints.iter().filter(|own| own.parent == 0) {
        world = world.with(body(export, own, &names)?);
    }
    root = root.with(world);
    let mut equality = Element::new("equality");
    for number in &export.tree.closing {
        equality = equality.with_all(closing(export, &export.mechanism.joints()[*number], &names)?);
    }
    if !equality.is_empty() {
        root = root.with(equality);
    }
    let motors = export.model.drives.iter().map(|drive| {
        let joint = &export.model.joints[drive.joint];
        // The second coordinate of a joint of two.
        let is_slide = joint.kind.word() == "cylindrical" && drive.coordinate == JointCoordinate::Slide;
        let name = if is_slide { export.second(&joint.name, "slide") } else { joint.name.clone() };
        Element::new("motor").text("name", &drive.name).text("joint", &name)
    });
    let actuator = Element::new("actuator").with_all(motors);
    if !actuator.is_empty() {
        root = root.with(actuator);
    }
    Ok(root)
}

fn body(export: &Export<'_>, own: &TreeJoint, names: &[String]) -> Result<Element, ExportProblem> {
    let at = at_start(export, own);
    let mut element = Element::new("body").text("name", &names[own.child]).numbers("pos", &at.origin_m.to_array());
    let turn = Quaternion::from_rotation(&at.axes);
    let Vec3 { x, y, z } = turn.vector;
    if turn.vector.length() > ROUND_OFF {
        element = element.numbers("quat", &[turn.w, x, y, z]);
    }
    if let Some(mass) = Mass::of(export, own.child) {
        let inertial = Element::new("inertial")
            .numbers("pos", &mass.centre_m.to_array())
            .numbers("mass", &[mass.mass_kg])
            .numbers("fullinertia", &mass.inertia_kg_m2);
        element = element.with(inertial);
    }
    element = element.with_all(joints(export, own, &at)?).with_all(sites(export, own.child));
    for inner in export.tree.joints.iter().filter(|inner| inner.parent == own.child) {
        element = element.with(body(export, inner, names)?);
    }
    Ok(element)
}

/// The frame of a body in that of its parent at time zero: by the markers and coordinates of its joint where they say it, which has fewer digits
/// than what was found by closing.
fn at_start(export: &Export<'_>, own: &TreeJoint) -> Frame {
    let joint = &export.mechanism.joints()[own.joint];
    if !["revolute", "prismatic", "rigid", "cylindrical"].contains(&joint.kind.word()) {
        return export.frames[own.parent].inverse().compose(&export.frames[own.child]);
    }
    let (angle_rad, slide_m) = coordinates(export, joint);
    let axis = Vec3::Z * angle_rad;
    let moved = Frame { origin_m: Vec3::Z * slide_m, axes: Quaternion::from_rotation_vector(axis).rotation() };
    let [bearing, journal] = [&joint.bearing, &joint.journal].map(Frame::from);
    let at = bearing.compose(&moved).compose(&journal.inverse());
    if own.is_reversed { at.inverse() } else { at }
}

/// The joints of a body, in whose frame they are written.
fn joints(export: &Export<'_>, own: &TreeJoint, at: &Frame) -> Result<Vec<Element>, ExportProblem> {
    let joint = &export.mechanism.joints()[own.joint];
    let [parent, child] = own.markers(joint);
    let axis = child.axes.z * own.sign();
    let point = child.point_m;
    let (angle_rad, slide_m) = coordinates(export, joint);
    let one = |name: String, kind: &str, axis: Vec3, reference: f64| {
        let element = Element::new("joint").text("name", &name).text("type", kind);
        let element = element.numbers("pos", &point.to_array()).numbers("axis", &axis.to_array());
        if reference == 0.0 { element } else { element.numbers("ref", &[reference]) }
    };
    let name = || joint.name.clone();
    let second = |what: &str| export.second(&joint.name, what);
    let kind = joint.kind.word();
    Ok(match kind {
        "revolute" => vec![one(name(), "hinge", axis, angle_rad)],
        "prismatic" => vec![one(name(), "slide", axis, slide_m)],
        "rigid" => Vec::new(),
        "spherical" => {
            vec![Element::new("joint").text("name", &joint.name).text("type", "ball").numbers("pos", &point.to_array())]
        }
        "cylindrical" => vec![one(second("slide"), "slide", axis, slide_m), one(name(), "hinge", axis, angle_rad)],
        "universal" => {
            let pin = at.axes.apply_transposed(parent.axes.z);
            vec![one(name(), "hinge", pin, 0.0), one(second("cross"), "hinge", child.axes.z, 0.0)]
        }
        "planar" => vec![
            one(second("x"), "slide", child.axes.x, 0.0),
            one(second("y"), "slide", child.axes.y, 0.0),
            one(name(), "hinge", axis, 0.0),
        ],
        _ => return Err(ExportProblem::Kind { joint: name(), kind, format: "MJCF", other: false }),
    })
}

/// Angle from x of the bearing to x of the journal about z, and place of the journal along z, at time zero.
fn coordinates(export: &Export<'_>, joint: &Joint) -> (f64, f64) {
    let frame = |marker: &Marker| export.frames[marker.body].compose(&Frame::from(marker));
    let (bearing, journal) = (frame(&joint.bearing), frame(&joint.journal));
    let angle = libm::atan2(bearing.axes.y.dot(journal.axes.x), bearing.axes.x.dot(journal.axes.x));
    let slide = bearing.axes.z.dot(journal.origin_m - bearing.origin_m);
    let without_round_off = |value: f64| if value.abs() < ROUND_OFF { 0.0 } else { value };
    (without_round_off(angle), without_round_off(slide))
}

/// Round-off of closing, rad and m.
const ROUND_OFF: f64 = 1e-14;

/// Points that outputs read.
fn sites(export: &Export<'_>, body: usize) -> Vec<Element> {
    let own = export.output_points().into_iter().filter(|point| point.body == body);
    own.map(|point| {
        let name = export.model.point_name(point).replace('.', "_");
        Element::new("site").text("name", &name).numbers("pos", &export.model.position(point, export.values).to_array())
    })
    .collect()
}

/// A joint that closes a loop: a ball is one point, a pin two points of its axis.
fn closing(export: &Export<'_>, joint: &Joint, names: &[String]) -> Result<Vec<Element>, ExportProblem> {
    // The first body must not be the world.
    let (first, second) = match joint.bearing.body {
        0 => (&joint.journal, &joint.bearing),
        _ => (&joint.bearing, &joint.journal),
    };
    let of = |tag: &'static str, name: String| {
        Element::new(tag).text("name", &name).text("body1", &names[first.body]).text("body2", &names[second.body])
    };
    let connect = |name: String, at_m: Vec3| of("connect", name).numbers("anchor", &at_m.to_array());
    let kind = joint.kind.word();
    Ok(match kind {
        "spherical" => vec![connect(joint.name.clone(), first.point_m)],
        "revolute" => {
            let other = first.point_m + first.axes.z * export.mechanism.characteristic_length_m();
            vec![connect(joint.name.clone(), first.point_m), connect(export.second(&joint.name, "axis"), other)]
        }
        "rigid" => vec![of("weld", joint.name.clone())],
        _ => return Err(ExportProblem::LoopKind { joint: joint.name.clone(), kind }),
    })
}
