//! The mechanism drawn and moving: a still picture of the first pose, and the poses for the script that moves it.

use maud::{Markup, html};
use serde::Serialize;

use super::script_data::{round_to_digits, script_json};
use crate::simulate::record::{Drawing, DrawnBody, DrawnJoint, DrawnJointKind, PoseTable};

/// Millimetres, in which the picture is drawn.
const MM_PER_M: f64 = 1e3;
/// Poses are sent with so many digits: 0.1 µm in a metre, so that a magnified deviation is smooth.
const POSE_DIGITS: usize = 8;
/// Most poses in a page.
const MOST_POSES: usize = 361;
/// Radius of a drawn pin, as a share of the picture's diagonal.
const PIN_SHARE: f64 = 0.011;
/// A clearance is magnified at first to about this share of the diagonal.
const VISIBLE_SHARE: f64 = 0.02;
/// Magnifications on offer.
const MAGNIFICATIONS: [f64; 10] = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0];

#[derive(Serialize)]
struct Motion {
    /// Angle of the drive at each pose, degrees.
    angle_deg: Vec<Option<f64>>,
    magnification: f64,
    bodies: Vec<BodyMotion>,
}

/// Ideal pose and actual minus ideal, in mm and degrees, one entry per pose.
#[derive(Serialize)]
struct BodyMotion {
    x: Vec<Option<f64>>,
    y: Vec<Option<f64>>,
    a: Vec<Option<f64>>,
    dx: Vec<Option<f64>>,
    dy: Vec<Option<f64>>,
    da: Vec<Option<f64>>,
}

#[derive(Clone, Copy)]
struct Frame {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl Frame {
    fn diagonal(&self) -> f64 {
        self.width.hypot(self.height)
    }
}

/// The figure, or nothing where the record holds no poses.
pub(super) fn mechanism_figure(drawing: &Drawing, drive: &str, id: &str) -> Markup {
    if drawing.bodies.is_empty() || !is_complete(&drawing.poses, drawing.bodies.len()) {
        return html! {};
    }
    let has_ideal = is_complete(&drawing.ideal_poses, drawing.bodies.len())
        && drawing.ideal_poses.drive_angle_rad.len() == drawing.poses.drive_angle_rad.len();
    let reference = if has_ideal { &drawing.ideal_poses } else { &drawing.poses };
    let frame = frame(drawing, reference);
    let largest_clearance_mm =
        drawing.joints.iter().map(|joint| joint.radial_clearance_m * MM_PER_M).fold(0.0, f64::max);
    let magnification = if has_ideal { first_magnification(frame.diagonal(), largest_clearance_mm) } else { 1.0 };
    let motion = motion(drawing, reference, has_ideal, magnification);
    let pin = PIN_SHARE * frame.diagonal();
    let alternative = format!(
        "Drawing of the mechanism with {} bodies and {} joints, moving through one turn of {drive}.",
        drawing.bodies.len(),
        drawing.joints.len()
    );
    html! {
        figure.mechanism id=(id) data-mechanism=(id) {
            svg viewBox=(format!("{:.3} {:.3} {:.3} {:.3}", frame.left, frame.top, frame.width, frame.height))
                role="img" aria-label=(alternative) preserveAspectRatio="xMidYMid meet" {
                g transform="scale(1 -1)" {
                    (ground(drawing, &frame, pin))
                    @if has_ideal {
                        g.ghost aria-hidden="true" {
                            @for (index, body) in drawing.bodies.iter().enumerate() {
                                @if !body.is_ground {
                                    g data-ghost=(index) transform=(transform(&motion.bodies[index], 0.0)) {
                                        (outline(drawing, index, reference, pin))
                                    }
                                }
                            }
                        }
                    }
                    @for (index, body) in drawing.bodies.iter().enumerate() {
                        @if !body.is_ground {
                            g.body data-body=(index) transform=(transform(&motion.bodies[index], magnification)) {
                                title { (body.name) }
                                (outline(drawing, index, reference, pin))
                            }
                        }
                    }
                    // Above all shapes, bearings below journals, so that no body hides a joint of another.
                    @for layer in [PinLayer::Bearings, PinLayer::Journals] {
                        @for (index, body) in drawing.bodies.iter().enumerate() {
                            @if !body.is_ground {
                                g data-body=(index) transform=(transform(&motion.bodies[index], magnification)) {
                                    (pins(drawing, index, pin, magnification, layer))
                                }
                            }
                        }
                    }
                }
            }
            div.controls {
                button.play type="button" aria-pressed="false" { "Play" }
                label {
                    span { (drive) " at " output.angle { (format!("{:.0}°", motion.angle_deg[0].unwrap_or(0.0))) } }
                    input.pose type="range" min="0" max=(motion.angle_deg.len().saturating_sub(1)) value="0"
                        step="1" aria-label=(format!("Angle of {drive}"));
                }
                @if has_ideal && largest_clearance_mm > 0.0 {
                    label {
                        span { "Deviation drawn" }
                        select.magnification {
                            @for choice in MAGNIFICATIONS.iter().filter(|choice| **choice <= 5.0 * magnification) {
                                option value=(choice) selected[*choice == magnification] {
                                    @if *choice == 1.0 { "true to scale" } @else { "× " (choice) }
                                }
                            }
                        }
                    }
                }
            }
            figcaption {
                @if has_ideal && largest_clearance_mm > 0.0 {
                    "The mechanism over one turn. Solid: with play, its departure from the ideal position magnified as \
                     chosen above. Dashed: the ideal mechanism. The orange rings are bearings with play; the gap between \
                     ring and pin is the clearance, magnified alike."
                } @else {
                    "The mechanism over one turn."
                }
            }
            script type="application/json" data-for=(id) { (script_json(&motion)) }
        }
    }
}

fn is_complete(poses: &PoseTable, bodies: usize) -> bool {
    let count = poses.drive_angle_rad.len();
    count > 0
        && [&poses.x_m, &poses.y_m, &poses.angle_rad]
            .into_iter()
            .all(|table| table.len() == bodies && table.iter().all(|column| column.len() == count))
}

fn first_magnification(diagonal_mm: f64, clearance_mm: f64) -> f64 {
    let wanted = if clearance_mm > 0.0 { VISIBLE_SHARE * diagonal_mm / clearance_mm } else { 1.0 };
    MAGNIFICATIONS.iter().copied().rfind(|choice| *choice <= wanted).unwrap_or(1.0)
}

fn motion(drawing: &Drawing, reference: &PoseTable, has_ideal: bool, magnification: f64) -> Motion {
    let count = reference.drive_angle_rad.len();
    let step = count.div_ceil(MOST_POSES).max(1);
    let pick = |value: &dyn Fn(usize) -> f64| -> Vec<Option<f64>> {
        (0..count).step_by(step).map(|pose| round_to_digits(value(pose), POSE_DIGITS)).collect()
    };
    let bodies = (0..drawing.bodies.len())
        .map(|body| {
            let actual = &drawing.poses;
            let turn = |pose: usize| {
                let difference = actual.angle_rad[body][pose] - reference.angle_rad[body][pose];
                difference.sin().atan2(difference.cos()).to_degrees()
            };
            BodyMotion {
                x: pick(&|pose| reference.x_m[body][pose] * MM_PER_M),
                y: pick(&|pose| reference.y_m[body][pose] * MM_PER_M),
                a: pick(&|pose| reference.angle_rad[body][pose].to_degrees()),
                dx: if has_ideal {
                    pick(&|pose| (actual.x_m[body][pose] - reference.x_m[body][pose]) * MM_PER_M)
                } else {
                    Vec::new()
                },
                dy: if has_ideal {
                    pick(&|pose| (actual.y_m[body][pose] - reference.y_m[body][pose]) * MM_PER_M)
                } else {
                    Vec::new()
                },
                da: if has_ideal { pick(&turn) } else { Vec::new() },
            }
        })
        .collect();
    Motion { angle_deg: pick(&|pose| reference.drive_angle_rad[pose].to_degrees()), magnification, bodies }
}

fn transform(body: &BodyMotion, magnification: f64) -> String {
    let first = |list: &[Option<f64>]| list.first().copied().flatten().unwrap_or(0.0);
    format!(
        "translate({:.4} {:.4}) rotate({:.5})",
        first(&body.x) + magnification * first(&body.dx),
        first(&body.y) + magnification * first(&body.dy),
        first(&body.a) + magnification * first(&body.da)
    )
}

/// The picture's frame around all points in all poses, with room for pins and a magnified deviation. y points down
/// here, as in SVG.
fn frame(drawing: &Drawing, poses: &PoseTable) -> Frame {
    let (mut left, mut right, mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::NEG_INFINITY);
    for (index, body) in drawing.bodies.iter().enumerate() {
        for pose in 0..poses.drive_angle_rad.len() {
            for point in 0..body.points.len() {
                let (x_mm, y_mm) = place_mm(body, index, point, poses, pose);
                left = left.min(x_mm);
                right = right.max(x_mm);
                low = low.min(y_mm);
                high = high.max(y_mm);
            }
        }
    }
    if !(left.is_finite() && low.is_finite()) {
        return Frame { left: 0.0, top: 0.0, width: 1.0, height: 1.0 };
    }
    let margin = 0.09 * (right - left).hypot(high - low).max(1e-6);
    Frame {
        left: left - margin,
        top: -(high + margin),
        width: right - left + 2.0 * margin,
        height: high - low + 2.0 * margin,
    }
}

fn place_mm(body: &DrawnBody, index: usize, point: usize, poses: &PoseTable, pose: usize) -> (f64, f64) {
    let (sine, cosine) = poses.angle_rad[index][pose].sin_cos();
    let point = &body.points[point];
    (
        (poses.x_m[index][pose] + cosine * point.x_m - sine * point.y_m) * MM_PER_M,
        (poses.y_m[index][pose] + sine * point.x_m + cosine * point.y_m) * MM_PER_M,
    )
}

/// Supports under fixed pins, and guides.
fn ground(drawing: &Drawing, frame: &Frame, pin: f64) -> Markup {
    let is_ground = |body: usize| drawing.bodies.get(body).is_some_and(|body| body.is_ground);
    html! {
        g.ground {
            @for joint in &drawing.joints {
                @if is_ground(joint.first.body) {
                    @if let Some(point) = drawing.bodies[joint.first.body].points.get(joint.first.point) {
                        @let (x, y) = (point.x_m * MM_PER_M, point.y_m * MM_PER_M);
                        @if joint.kind == DrawnJointKind::Prismatic {
                            (guide(drawing, joint, frame, pin, (x, y)))
                        } @else {
                            path.support d=(format!(
                                "M {:.3} {:.3} l {:.3} {:.3} h {:.3} Z",
                                x, y, -2.2 * pin, -3.4 * pin, 4.4 * pin
                            )) {}
                            line.base x1=(format!("{:.3}", x - 3.2 * pin)) x2=(format!("{:.3}", x + 3.2 * pin))
                                y1=(format!("{:.3}", y - 3.4 * pin)) y2=(format!("{:.3}", y - 3.4 * pin)) {}
                        }
                    }
                }
            }
        }
    }
}

/// Two rails along the way of the slider.
fn guide(drawing: &Drawing, joint: &DrawnJoint, frame: &Frame, pin: f64, origin_mm: (f64, f64)) -> Markup {
    let (sine, cosine) = joint.guide_angle_rad.sin_cos();
    let slider = joint.second;
    let Some(body) = drawing.bodies.get(slider.body).filter(|body| slider.point < body.points.len()) else {
        return html! {};
    };
    let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
    for pose in 0..drawing.poses.drive_angle_rad.len() {
        let (x, y) = place_mm(body, slider.body, slider.point, &drawing.poses, pose);
        let along = (x - origin_mm.0) * cosine + (y - origin_mm.1) * sine;
        from = from.min(along);
        to = to.max(along);
    }
    let (from, to) = (from - 0.06 * frame.diagonal(), to + 0.06 * frame.diagonal());
    let rail = |side: f64| {
        let (x, y) = (origin_mm.0 - side * sine, origin_mm.1 + side * cosine);
        (x + from * cosine, y + from * sine, x + to * cosine, y + to * sine)
    };
    html! {
        @for side in [-2.6 * pin, 2.6 * pin] {
            @let (x1, y1, x2, y2) = rail(side);
            line.guide x1=(format!("{x1:.3}")) y1=(format!("{y1:.3}")) x2=(format!("{x2:.3}")) y2=(format!("{y2:.3}")) {}
        }
    }
}

/// The shape of one body in its own frame: a bar, a plate, or a block where it slides.
fn outline(drawing: &Drawing, index: usize, poses: &PoseTable, pin: f64) -> Markup {
    let body = &drawing.bodies[index];
    let points: Vec<(f64, f64)> =
        body.points.iter().map(|point| (point.x_m * MM_PER_M, point.y_m * MM_PER_M)).collect();
    let block = drawing
        .joints
        .iter()
        .find(|joint| joint.kind == DrawnJointKind::Prismatic && joint.second.body == index)
        .and_then(|joint| Some((points.get(joint.second.point)?, joint)));
    html! {
        @if let Some(((x, y), joint)) = block {
            @let own = poses.angle_rad[index].first().copied().unwrap_or(0.0);
            @let guide = poses.angle_rad.get(joint.first.body).and_then(|angles| angles.first()).copied().unwrap_or(0.0);
            rect.block x=(format!("{:.3}", x - 4.0 * pin)) y=(format!("{:.3}", y - 2.4 * pin))
                width=(format!("{:.3}", 8.0 * pin)) height=(format!("{:.3}", 4.8 * pin)) rx=(format!("{:.3}", 0.6 * pin))
                transform=(format!("rotate({:.4} {x:.3} {y:.3})", (guide + joint.guide_angle_rad - own).to_degrees())) {}
        }
        @if points.len() >= 2 {
            @let hull = convex_hull(&points);
            path class=(if hull.len() > 2 { "plate" } else { "bar" }) d=(path_through(&hull)) {}
        }
    }
}

fn path_through(points: &[(f64, f64)]) -> String {
    let mut path = String::new();
    for (index, (x, y)) in points.iter().enumerate() {
        path.push_str(&format!("{} {x:.3} {y:.3} ", if index == 0 { 'M' } else { 'L' }));
    }
    if points.len() > 2 {
        path.push('Z');
    }
    path
}

/// Corners of the convex hull, anticlockwise (Andrew's monotone chain).
fn convex_hull(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let turn = |o: (f64, f64), a: (f64, f64), b: (f64, f64)| (a.0 - o.0) * (b.1 - o.1) - (a.1 - o.1) * (b.0 - o.0);
    let half = |ordered: &mut dyn Iterator<Item = (f64, f64)>| {
        let mut chain: Vec<(f64, f64)> = Vec::new();
        for point in ordered {
            while chain.len() >= 2 && turn(chain[chain.len() - 2], chain[chain.len() - 1], point) <= 0.0 {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut sorted.iter().copied());
    hull.extend(half(&mut sorted.iter().rev().copied()));
    hull
}

/// What is drawn of the joints in which order.
#[derive(Clone, Copy, PartialEq, Eq)]
enum PinLayer {
    Bearings,
    Journals,
}

/// Bearings, or pins and journals, that belong to one body.
fn pins(drawing: &Drawing, index: usize, pin: f64, magnification: f64, layer: PinLayer) -> Markup {
    let at = |point: usize| {
        drawing.bodies[index].points.get(point).map(|point| (point.x_m * MM_PER_M, point.y_m * MM_PER_M))
    };
    html! {
        @for joint in &drawing.joints {
            @if joint.kind == DrawnJointKind::RevoluteWithClearance {
                @if layer == PinLayer::Bearings && joint.first.body == index {
                    @if let Some((x, y)) = at(joint.first.point) {
                        @let clearance_mm = joint.radial_clearance_m * MM_PER_M;
                        circle.bearing cx=(format!("{x:.3}")) cy=(format!("{y:.3}"))
                            r=(format!("{:.4}", 1.3 * pin + magnification * clearance_mm))
                            data-pin=(format!("{:.4}", 1.3 * pin)) data-clearance=(format!("{clearance_mm:.6}")) {
                            title { "bearing of " (joint.name) }
                        }
                    }
                }
                @if layer == PinLayer::Journals && joint.second.body == index {
                    @if let Some((x, y)) = at(joint.second.point) {
                        circle.journal cx=(format!("{x:.3}")) cy=(format!("{y:.3}")) r=(format!("{:.4}", 1.3 * pin)) {
                            title { "journal of " (joint.name) }
                        }
                    }
                }
            } @else if layer == PinLayer::Journals
                && joint.kind == DrawnJointKind::Revolute
                && joint.second.body == index
            {
                @if let Some((x, y)) = at(joint.second.point) {
                    circle.pin cx=(format!("{x:.3}")) cy=(format!("{y:.3}")) r=(format!("{pin:.4}")) {
                        title { (joint.name) }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_hull_of_a_square_with_a_point_inside() {
        let hull = convex_hull(&[(0.0, 0.0), (2.0, 0.1), (1.0, 1.0), (2.1, 2.0), (-0.1, 1.9)]);
        assert_eq!(hull, vec![(-0.1, 1.9), (0.0, 0.0), (2.0, 0.1), (2.1, 2.0)]);
    }

    #[test]
    fn analytic_magnification_is_a_round_number_that_shows_the_clearance() {
        assert_eq!(first_magnification(250.0, 0.5), 10.0);
        assert_eq!(first_magnification(250.0, 0.0), 1.0);
        assert_eq!(first_magnification(1.0, 10.0), 1.0);
    }
}
