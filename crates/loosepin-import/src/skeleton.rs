//! The text of the model.

use crate::toml_text::quoted;
use std::f64::consts::PI;
use std::fmt::Write;

use super::links::{Link, Links};
use super::sketch::{Point, Sketch, distance};

/// Significant digits of the size of the drawing that coordinates keep.
const DIGITS: i32 = 12;
/// Places behind the point of angles in degrees.
const DEGREE_PLACES: usize = 9;

/// A link's frame: origin at its first circle, x axis towards the second one, or to the furthest vertex.
struct Frame {
    origin: Point,
    angle_rad: f64,
}

impl Frame {
    fn of(link: &Link, sketch: &Sketch) -> Self {
        let origin = sketch.circles[link.circles[0]].centre;
        let towards = match link.circles.get(1) {
            Some(&circle) => sketch.circles[circle].centre,
            None => link
                .vertices
                .iter()
                .copied()
                .max_by(|a, b| distance(origin, *a).total_cmp(&distance(origin, *b)))
                .unwrap_or(origin),
        };
        Self { origin, angle_rad: libm::atan2(towards[1] - origin[1], towards[0] - origin[0]) }
    }

    fn coordinates(&self, point: Point) -> Point {
        let (sine, cosine) = (libm::sin(self.angle_rad), libm::cos(self.angle_rad));
        let [x, y] = [point[0] - self.origin[0], point[1] - self.origin[1]];
        [cosine * x + sine * y, cosine * y - sine * x]
    }
}

/// Writes numbers of a drawing.
struct Numbers<'s> {
    unit: &'s str,
    places: usize,
}

impl Numbers<'_> {
    fn length(&self, value: f64) -> String {
        format!("\"{} {}\"", trimmed(value, self.places), self.unit)
    }

    fn point(&self, [x, y]: Point) -> String {
        format!("[{}, {}]", self.length(x), self.length(y))
    }
}

fn trimmed(value: f64, places: usize) -> String {
    let text = format!("{value:.places$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn degrees(angle_rad: f64) -> String {
    format!("\"{} deg\"", trimmed(angle_rad * 180.0 / PI, DEGREE_PLACES))
}

/// A point of the ground or of a link at a circle.
fn point_name(circle: usize) -> String {
    format!("p{}", circle + 1)
}

fn link_name(link: usize) -> String {
    format!("link{}", link + 1)
}

/// Name, bearing and journal of every joint; the circle, the link of the bearing (none for the ground) and of the journal.
fn joints(links: &Links) -> Vec<(String, usize, Option<usize>, usize)> {
    let mut joints = Vec::new();
    for (circle, meeting) in links.meetings.iter().enumerate().filter(|(_, meeting)| meeting.is_joint()) {
        let (bearing, journals) =
            if meeting.on_ground { (None, &meeting.links[..]) } else { (Some(meeting.links[0]), &meeting.links[1..]) };
        for (index, &journal) in journals.iter().enumerate() {
            let name =
                if index == 0 { format!("joint{}", circle + 1) } else { format!("joint{}_{}", circle + 1, index + 1) };
            joints.push((name, circle, bearing, journal));
        }
    }
    joints
}

/// The text of `model.toml`.
pub(super) fn model(name: &str, sketch: &Sketch, links: &Links) -> String {
    let size = sketch
        .shapes
        .iter()
        .flat_map(|shape| &shape.vertices)
        .fold(0.0_f64, |size, point| size.max(point[0].abs()).max(point[1].abs()));
    let magnitude: i32 = format!("{size:e}").split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0);
    let numbers = Numbers { unit: &sketch.unit, places: (DIGITS - 1 - magnitude).clamp(0, 15) as usize };
    let frames: Vec<Frame> = links.links.iter().map(|link| Frame::of(link, sketch)).collect();
    let joints = joints(links);
    let mut text = format!(
        "# Read from a drawing: lines are links, circles are joints. Every \"?\" is a number that a drawing does not contain; fill it in.\n\
         # `loosepin check model.toml` lists the remaining ones.\n\
         name = {}\n\
         gravity = \"?\"                                       # along -y; \"0 m/s^2\" for none\n\n",
        quoted(name)
    );
    let ground: Vec<String> = links
        .meetings
        .iter()
        .enumerate()
        .filter(|(_, meeting)| meeting.on_ground)
        .map(|(circle, _)| format!("{} = {}", point_name(circle), numbers.point(sketch.circles[circle].centre)))
        .collect();
    let _ = writeln!(text, "[body.ground]\npoints = {{ {} }}\n", ground.join(", "));
    for (index, (link, frame)) in links.links.iter().zip(&frames).enumerate() {
        let points: Vec<String> = link
            .circles
            .iter()
            .map(|&circle| {
                let at = frame.coordinates(sketch.circles[circle].centre);
                format!("{} = {}", point_name(circle), numbers.point(at))
            })
            .collect();
        let _ = writeln!(
            text,
            "[body.{}]\n\
             mass = \"?\"\n\
             inertia = \"?\"                                       # about the centre of mass\n\
             centre_of_mass = [\"?\", \"?\"]\n\
             points = {{ {} }}\n",
            link_name(index),
            points.join(", ")
        );
    }
    for (name, circle, bearing, journal) in &joints {
        let body = bearing.map_or("ground".to_owned(), link_name);
        let point = point_name(*circle);
        let _ = writeln!(
            text,
            "[joint.{name}]\n\
             kind = \"revolute\"\n\
             bearing = \"{body}.{point}\"                             # the hole\n\
             journal = \"{}.{point}\"                             # the pin\n\
             bearing_radius = {}                         # as drawn\n\
             radial_clearance = \"0 {}\"                           # play needs a [contact.NAME] and contact = \"NAME\"\n",
            link_name(*journal),
            numbers.length(sketch.circles[*circle].radius),
            sketch.unit
        );
    }
    let driven = joints.iter().find(|(_, _, bearing, _)| bearing.is_none());
    if let Some((name, _, _, journal)) = driven {
        let _ = writeln!(
            text,
            "[drive.input]\n\
             joint = \"{name}\"                                  # the first joint of the ground; another one if it is not driven\n\
             speed = \"?\"\n\
             start_angle = {}                             # as drawn\n",
            degrees(frames[*journal].angle_rad)
        );
    }
    let guesses: Vec<String> = frames
        .iter()
        .enumerate()
        .map(|(index, frame)| format!("{} = {}", link_name(index), degrees(frame.angle_rad)))
        .collect();
    let _ = writeln!(
        text,
        "[assembly]                                            # as drawn\nguess = {{ {} }}\n",
        guesses.join(", ")
    );
    let _ =
        writeln!(text, "[cycle]\ndrive = \"input\"\ntransient_turns = 0\nrecorded_turns = 1\nsamples_per_turn = 360\n");
    for (circle, meeting) in links.meetings.iter().enumerate().filter(|(_, meeting)| !meeting.is_joint()) {
        let point = point_name(circle);
        let _ = writeln!(text, "[output.{point}]\npath_of = \"{}.{point}\"\n", link_name(meeting.links[0]));
    }
    let last = joints.iter().rev().find(|(_, _, bearing, _)| bearing.is_none()).or(joints.last());
    if let Some((_, _, _, journal)) = last {
        let link = link_name(*journal);
        let _ = writeln!(text, "[output.{link}]\nangle_of = \"{link}\"");
    }
    text
}

/// Findings in words.
pub(super) fn notes(sketch: &Sketch, links: &Links) -> Vec<String> {
    let counted = |count: usize, one: &str, many: &str| format!("{count} {}", if count == 1 { one } else { many });
    let joints = joints(links).len();
    let points = links.meetings.iter().filter(|meeting| !meeting.is_joint()).count();
    let mut notes = vec![format!(
        "{}, {}, {} on links; lengths in {}",
        counted(links.links.len(), "link", "links"),
        counted(joints, "joint", "joints"),
        counted(points, "point", "points"),
        sketch.unit
    )];
    if sketch.ignored > 0 {
        notes.push(format!(
            "{} neither line nor polyline nor circle, and ignored",
            counted(sketch.ignored, "thing is", "things are")
        ));
    }
    notes
}
