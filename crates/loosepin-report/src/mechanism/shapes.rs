//! The shapes of a drawn mechanism: bars, plates, blocks, guides, supports, pins and bearings.

use maud::{Markup, html};

use loosepin_result::simulation::{Drawing, DrawnBody, DrawnJoint, DrawnPin, PointReference, PoseTable};
use std::f64::consts::TAU;

/// Millimetres, in which the picture is drawn.
pub(crate) const MM_PER_M: f64 = 1e3;
/// Radius of a drawn pin, as a share of the picture's diagonal.
pub(crate) const PIN_SHARE: f64 = 0.011;
/// Radius of a drawn journal, in pins.
pub(crate) const JOURNAL_PINS: f64 = 1.3;
/// Half the length and half the height of a slider's block, in pins.
pub(crate) const BLOCK_PINS: [f64; 2] = [4.2, 2.8];
/// A rail lies so far from the middle of its guide, in pins.
pub(crate) const RAIL_PINS: f64 = 3.0;
/// Half the width and the height of a support, and half its base line, in pins.
const SUPPORT_PINS: [f64; 3] = [2.2, 3.4, 3.2];

/// Distance between the lines of a hatching and how far they reach, in pins.
const HATCH_PINS: [f64; 2] = [1.3, 1.1];
/// A rail along a circle is drawn in straight pieces of this turn, rad.
const ROUND_PIECE_RAD: f64 = 0.1;
/// Depth of a hatching, in pins.
pub(crate) const HATCH_DEPTH_PINS: f64 = HATCH_PINS[1];

/// The part of the plane that the picture shows, mm; y points down, as in SVG.
#[derive(Clone, Copy)]
pub(crate) struct Frame {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

impl Frame {
    pub fn diagonal(&self) -> f64 {
        self.width.hypot(self.height)
    }
}

/// The picture's frame around all points in all poses, with room for pins and a magnified deviation. y points down
/// here, as in SVG.
pub(crate) fn frame(drawing: &Drawing, poses: &PoseTable) -> Frame {
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
    let point = &body.points[point];
    transformed_mm(poses, index, pose, (point.x_m * MM_PER_M, point.y_m * MM_PER_M))
}

/// Position of a point of a body at a pose, mm.
pub(crate) fn transformed_mm(poses: &PoseTable, body: usize, pose: usize, (x, y): (f64, f64)) -> (f64, f64) {
    let (sine, cosine) = poses.angle_rad[body][pose].sin_cos();
    (poses.x_m[body][pose] * MM_PER_M + cosine * x - sine * y, poses.y_m[body][pose] * MM_PER_M + sine * x + cosine * y)
}

/// Lines at 45° along the line `from` to `to`, on its right-hand side.
pub(crate) fn hatching(from: (f64, f64), to: (f64, f64), pin: f64) -> Markup {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx.hypot(dy);
    let count = (length / (HATCH_PINS[0] * pin)).floor();
    if !(1.0..1e3).contains(&count) {
        return html! {};
    }
    let (ux, uy) = (dx / length, dy / length);
    let reach = HATCH_PINS[1] * pin;
    let mut path = String::new();
    for line in 0..count as usize {
        let along = (line as f64 + 0.9) * length / count;
        path.push_str(&format!(
            "M{:.3} {:.3}l{:.3} {:.3}",
            from.0 + along * ux,
            from.1 + along * uy,
            reach * (uy - ux),
            -reach * (ux + uy)
        ));
    }
    html! { path.hatch d=(path) {} }
}

/// Fixed pins.
pub(crate) fn support_points(drawing: &Drawing) -> impl Iterator<Item = (f64, f64)> {
    let ends = drawing.joints.iter().filter(|joint| !has_rails(joint)).flat_map(|joint| [joint.first, joint.second]);
    ends.filter(|end| is_on_ground(drawing, *end)).filter_map(|end| point_mm(drawing, end))
}

fn is_on_ground(drawing: &Drawing, end: PointReference) -> bool {
    drawing.bodies.get(end.body).is_some_and(|body| body.is_ground)
}

/// Supports under fixed pins, and fixed guides, hatched.
pub(crate) fn ground(drawing: &Drawing, poses: &PoseTable, frame: &Frame, pin: f64) -> Markup {
    let [half_width, height, half_base] = SUPPORT_PINS.map(|pins| pins * pin);
    html! {
        g.ground {
            @for joint in drawing.joints.iter().filter(|joint| has_rails(joint) && is_on_ground(drawing, joint.first)) {
                (guide(drawing, joint, poses, frame, pin))
                // The second rail runs the other way, so that the right-hand side of both is outside.
                @for [from, to] in fixed_rails(drawing, joint, poses, frame, RAIL_PINS * pin) { (hatching(from, to, pin)) }
            }
            @for (x, y) in support_points(drawing) {
                path.support d=(format!("M {x:.3} {y:.3} l {:.3} {:.3} h {:.3} Z", -half_width, -height, 2.0 * half_width)) {}
                line.base x1=(format!("{:.3}", x - half_base)) x2=(format!("{:.3}", x + half_base))
                    y1=(format!("{:.3}", y - height)) y2=(format!("{:.3}", y - height)) {}
                (hatching((x - half_base, y - height), (x + half_base, y - height), pin))
            }
        }
    }
}

/// A point in the frame of its body; `None` if the record names one that is not there.
pub(crate) fn point_mm(drawing: &Drawing, end: PointReference) -> Option<(f64, f64)> {
    let point = drawing.bodies.get(end.body)?.points.get(end.point)?;
    Some((point.x_m * MM_PER_M, point.y_m * MM_PER_M))
}

/// Whether a joint has a line or a circle along which it slides.
pub(crate) fn has_rails(joint: &DrawnJoint) -> bool {
    joint.kind.has_faces()
}

/// Position of the second point of a joint from the first in all poses, mm, in the frame of the first one's body; `None` if the record
/// names no such point.
fn gaps_mm(drawing: &Drawing, joint: &DrawnJoint, poses: &PoseTable) -> Option<Vec<(f64, f64)>> {
    let origin_mm = point_mm(drawing, joint.first)?;
    point_mm(drawing, joint.second)?;
    let carrier = joint.first.body;
    let slider = &drawing.bodies[joint.second.body];
    let gap_mm = |pose: usize| {
        let (x, y) = place_mm(slider, joint.second.body, joint.second.point, poses, pose);
        let (x, y) = (x - poses.x_m[carrier][pose] * MM_PER_M, y - poses.y_m[carrier][pose] * MM_PER_M);
        let (turn_sine, turn_cosine) = poses.angle_rad[carrier][pose].sin_cos();
        let (x, y) = (turn_cosine * x + turn_sine * y, turn_cosine * y - turn_sine * x);
        (x - origin_mm.0, y - origin_mm.1)
    };
    Some((0..poses.drive_angle_rad.len()).map(gap_mm).collect())
}

/// How far a slider moves along its guide, mm from the guide's point, in all poses; `None` if the record names no such point.
pub(crate) fn slider_travel_mm(drawing: &Drawing, joint: &DrawnJoint, poses: &PoseTable) -> Option<(f64, f64)> {
    gaps_mm(drawing, joint, poses).map(|gaps_mm| way_of(joint, &gaps_mm))
}

/// The least and the largest part of `gaps_mm` along the guide.
fn way_of(joint: &DrawnJoint, gaps_mm: &[(f64, f64)]) -> (f64, f64) {
    let (sine, cosine) = joint.guide_angle_rad.sin_cos();
    let along = gaps_mm.iter().map(|(x, y)| x * cosine + y * sine);
    along.fold((f64::INFINITY, f64::NEG_INFINITY), |(from, to), along| (from.min(along), to.max(along)))
}

/// Both rails of a circular slot: the outer one anticlockwise in short pieces, the inner one back; all round where the pin comes so far.
fn round_rails(gaps_mm: &[(f64, f64)], (x, y): (f64, f64), margin: f64, side: f64) -> Vec<[(f64, f64); 2]> {
    let Some(start) = gaps_mm.first() else { return Vec::new() };
    let radius = start.0.hypot(start.1);
    if !(radius > 0.0) {
        return Vec::new();
    }
    let first = start.1.atan2(start.0);
    let (mut angle, mut from, mut to) = (first, first, first);
    for (x, y) in gaps_mm {
        // The shorter way from pose to pose.
        let step = y.atan2(*x) - angle;
        angle += step - TAU * (step / TAU).round();
        (from, to) = (from.min(angle), to.max(angle));
    }
    let (from, to) = (from - margin / radius, to + margin / radius);
    let turn = (to - from).min(TAU);
    let pieces = (turn / ROUND_PIECE_RAD).ceil();
    let at = |piece: f64, side: f64| {
        let (sine, cosine) = (from + turn * piece / pieces).sin_cos();
        (x + (radius + side) * cosine, y + (radius + side) * sine)
    };
    let count = 0..pieces as usize;
    let outer = count.clone().map(|piece| [at(piece as f64, side), at((piece + 1) as f64, side)]);
    let inner = count.rev().map(|piece| [at((piece + 1) as f64, -side), at(piece as f64, -side)]);
    outer.chain(inner).collect()
}

/// Both rails of a guide or slot, `side` from its middle, in the frame of the body that carries it: from end to end along it, and back.
fn rails(drawing: &Drawing, joint: &DrawnJoint, poses: &PoseTable, frame: &Frame, side: f64) -> Vec<[(f64, f64); 2]> {
    let margin = 0.06 * frame.diagonal();
    let (Some(gaps_mm), Some((x, y))) = (gaps_mm(drawing, joint, poses), point_mm(drawing, joint.first)) else {
        return Vec::new();
    };
    if joint.kind.has_circle() {
        return round_rails(&gaps_mm, (x, y), margin, side);
    }
    let (from, to) = way_of(joint, &gaps_mm);
    let (sine, cosine) = joint.guide_angle_rad.sin_cos();
    let (from, to) = (from - margin, to + margin);
    let at = |along: f64, side: f64| (x + along * cosine - side * sine, y + along * sine + side * cosine);
    vec![[at(from, -side), at(to, -side)], [at(to, side), at(from, side)]]
}

/// The rails of a guide on the ground, at their position; empty for other guides.
pub(crate) fn fixed_rails(
    drawing: &Drawing,
    joint: &DrawnJoint,
    poses: &PoseTable,
    frame: &Frame,
    side: f64,
) -> Vec<[(f64, f64); 2]> {
    if is_on_ground(drawing, joint.first) { rails(drawing, joint, poses, frame, side) } else { Vec::new() }
}

/// Two rails along the way of the slider, in the frame of the body that carries the guide.
fn guide(drawing: &Drawing, joint: &DrawnJoint, poses: &PoseTable, frame: &Frame, pin: f64) -> Markup {
    html! {
        @for [(x1, y1), (x2, y2)] in rails(drawing, joint, poses, frame, RAIL_PINS * pin) {
            line.guide x1=(format!("{x1:.3}")) y1=(format!("{y1:.3}")) x2=(format!("{x2:.3}")) y2=(format!("{y2:.3}")) {}
        }
    }
}

/// The shape of one body in its own frame: a bar, a plate, or a block where it slides.
pub(crate) fn outline(drawing: &Drawing, index: usize, poses: &PoseTable, frame: &Frame, pin: f64) -> Markup {
    let body = &drawing.bodies[index];
    let points = points_mm(body);
    let block = drawing
        .joints
        .iter()
        .find(|joint| joint.kind.has_block() && joint.second.body == index)
        .and_then(|joint| Some((points.get(joint.second.point)?, joint)));
    html! {
        @if let Some(((x, y), joint)) = block {
            @let own = poses.angle_rad[index].first().copied().unwrap_or(0.0);
            @let guide = poses.angle_rad.get(joint.first.body).and_then(|angles| angles.first()).copied().unwrap_or(0.0);
            @let [half_length, half_height] = BLOCK_PINS.map(|pins| pins * pin);
            rect.block x=(format!("{:.3}", x - half_length)) y=(format!("{:.3}", y - half_height))
                width=(format!("{:.3}", 2.0 * half_length)) height=(format!("{:.3}", 2.0 * half_height)) rx=(format!("{:.3}", 0.6 * pin))
                transform=(format!("rotate({:.4} {x:.3} {y:.3})", (guide + joint.guide_angle_rad - own).to_degrees())) {}
        }
        @for joint in drawing.joints.iter().filter(|joint| {
            has_rails(joint) && joint.first.body == index
        }) {
            (guide(drawing, joint, poses, frame, pin))
        }
        @if points.len() >= 2 {
            @let hull = convex_hull(&points);
            path class=(if hull.len() > 2 { "plate" } else { "bar" }) d=(path_through(&hull)) {}
        }
    }
}

fn points_mm(body: &DrawnBody) -> Vec<(f64, f64)> {
    body.points.iter().map(|point| (point.x_m * MM_PER_M, point.y_m * MM_PER_M)).collect()
}

/// Corners of the drawn shape of a body with several points.
pub(crate) fn hull_mm(body: &DrawnBody) -> Vec<(f64, f64)> {
    convex_hull(&points_mm(body))
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
pub(crate) fn convex_hull(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
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

/// Layers of the joints, in the order of drawing.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum PinLayer {
    Bearings,
    Journals,
}

/// Bearings, or pins and journals, that belong to one body.
pub(crate) fn pins(drawing: &Drawing, index: usize, pin: f64, magnification: f64, layer: PinLayer) -> Markup {
    let at = |point: usize| point_mm(drawing, PointReference { body: index, point });
    html! {
        @for joint in &drawing.joints {
            @if joint.kind.pin() == Some(DrawnPin::InBearing) {
                @if layer == PinLayer::Bearings && joint.first.body == index {
                    @if let Some((x, y)) = at(joint.first.point) {
                        @let clearance_mm = joint.radial_clearance_m * MM_PER_M;
                        circle.bearing cx=(format!("{x:.3}")) cy=(format!("{y:.3}"))
                            r=(format!("{:.4}", JOURNAL_PINS * pin + magnification * clearance_mm))
                            data-pin=(format!("{:.4}", JOURNAL_PINS * pin)) data-clearance=(format!("{clearance_mm:.6}")) {
                            title { "bearing of " (joint.name) }
                        }
                    }
                }
                @if layer == PinLayer::Journals && joint.second.body == index {
                    @if let Some((x, y)) = at(joint.second.point) {
                        circle.journal cx=(format!("{x:.3}")) cy=(format!("{y:.3}")) r=(format!("{:.4}", JOURNAL_PINS * pin)) {
                            title { "journal of " (joint.name) }
                        }
                    }
                }
            } @else if layer == PinLayer::Journals
                && joint.kind.pin() == Some(DrawnPin::Solid)
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
    fn analytic_rails_of_a_circular_slot_lie_on_both_sides_of_its_arc() {
        /// Round-off of places of 60 mm.
        const ROUND_OFF_MM: f64 = 1e-12;
        // From 170° over the half turn, where the arc tangent jumps, to 230° and back to 200°.
        let at = |degrees: f64| (50.0 * degrees.to_radians().cos(), 50.0 * degrees.to_radians().sin());
        let rails = round_rails(&[170.0, 190.0, 230.0, 200.0].map(at), (3.0, -4.0), 5.0, 2.0);
        let (outer, inner) = rails.split_at(rails.len() / 2);
        assert_eq!((outer.len(), inner.len()), (13, 13), "1.25 rad in pieces of at most 0.1");
        for (rail, radius) in [(outer, 52.0), (inner, 48.0)] {
            for (x, y) in rail.iter().flatten() {
                assert!(((x - 3.0).hypot(y + 4.0) - radius).abs() < ROUND_OFF_MM, "{x} {y}");
            }
            assert!(rail.windows(2).all(|pair| pair[0][1] == pair[1][0]), "they hang together");
        }
        // 5 mm on an arc of 50 mm is 0.1 rad.
        let (x, y) = outer[0][0];
        assert!(((y + 4.0).atan2(x - 3.0) - (170f64.to_radians() - 0.1)).abs() < ROUND_OFF_MM);
        let all_round = round_rails(&[0.0, 120.0, 240.0, 360.0].map(at), (0.0, 0.0), 5.0, 2.0);
        let ends = [all_round[0][0], all_round[all_round.len() / 2 - 1][1]];
        assert!((ends[0].0 - ends[1].0).hypot(ends[0].1 - ends[1].1) < ROUND_OFF_MM, "{ends:?}");
        assert!(round_rails(&[(0.0, 0.0)], (0.0, 0.0), 5.0, 2.0).is_empty());
    }

    #[test]
    fn analytic_hatching_lies_on_the_right_at_45_degrees() {
        // Along +x the right-hand side is below: each line goes left and down by the same length.
        let markup = hatching((0.0, 0.0), (13.0, 0.0), 1.0).into_string();
        assert_eq!(markup.matches("l-1.100 -1.100").count(), 10, "{markup}");
        // Along +y it is on the right.
        let markup = hatching((0.0, 0.0), (0.0, 13.0), 1.0).into_string();
        assert_eq!(markup.matches("l1.100 -1.100").count(), 10, "{markup}");
        assert!(hatching((0.0, 0.0), (0.0, 0.0), 1.0).into_string().is_empty());
    }
}
