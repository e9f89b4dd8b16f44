//! What is drawn, in frames of bodies and in mm, cut into parts that can be sorted by depth.

use serde::Serialize;

use crate::charts::plane_view::round_factor;
use crate::mechanism::shapes::MM_PER_M;
use crate::medium::script_data::round_to_digits;
use loosepin_result::spatial_picture::{PictureElement, PictureRole, PictureShape, PictureTrace, SpatialPicture};
use std::f64::consts::TAU;

/// Longest piece of a bar or rail, over the extent: pieces of two crossing bars are sorted right where they cross.
const PIECE: f64 = 0.045;
/// Pieces of a path, at most.
const TRACE_PIECES: usize = 60;
/// Points round each end of a cylinder.
pub(crate) const RIM_POINTS: usize = 20;
/// Joints are drawn as if they were nearer by these shares of the extent, so that the bars that end in them do not hide them, nor a block the
/// bearing or ball in it.
const BLOCK_LIFT: f64 = 0.03;
const BEARING_LIFT: f64 = 0.05;
const BALL_LIFT: f64 = 0.06;
/// The same for lines on a face.
const HATCH_LIFT: f64 = 0.004;
/// Radius of the dot on a path, over the extent.
const TIP: f64 = 0.007;
/// The largest zone is drawn about this large, over the extent.
const ZONE: f64 = 0.09;
/// Digits of coordinates in a page.
const DIGITS: usize = 7;

/// Which shape the points of a part are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum PartKind {
    /// A line through them.
    Line,
    /// A face with these corners.
    Face,
    /// A cylinder: the points round one end, then those round the other.
    Solid,
    /// Their hull.
    Hull,
    /// A ball about one point.
    Ball,
}

/// A part of the picture. Script data as it is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Part {
    pub kind: PartKind,
    /// Class of its style.
    pub class: String,
    /// The body with which it moves.
    pub body: usize,
    /// In the frame of the body, mm.
    pub points: Vec<[f64; 3]>,
    /// Of a ball, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub radius: Option<f64>,
    /// How much nearer it counts, mm.
    pub lift: f64,
    /// The body or joint that it shows.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub of: String,
}

/// All parts, and how many times zones are magnified where there are any.
pub(crate) fn parts(picture: &SpatialPicture) -> (Vec<Part>, Option<f64>) {
    let extent_mm = picture.extent_m * MM_PER_M;
    let magnification = magnification(picture);
    let of_elements = picture.elements.iter().flat_map(|element| of_element(element, extent_mm));
    let of_traces = picture.traces.iter().flat_map(|trace| of_trace(trace, magnification.unwrap_or(1.0), extent_mm));
    (of_elements.chain(of_traces).collect(), magnification)
}

/// A round factor by which the largest displacement of all zones can be seen; `None` without zones.
fn magnification(picture: &SpatialPicture) -> Option<f64> {
    let zones = picture.traces.iter().flat_map(|trace| &trace.zones);
    let points = zones.flat_map(|zone| &zone.boundary_m);
    let largest_m = points.map(|[x, y, z]| (x * x + y * y + z * z).sqrt()).fold(0.0, f64::max);
    (largest_m > 0.0).then(|| round_factor(ZONE * picture.extent_m / largest_m))
}

fn of_element(element: &PictureElement, extent_mm: f64) -> Vec<Part> {
    let role = element.role;
    let lift = match role {
        PictureRole::Bar | PictureRole::Plate | PictureRole::Guide | PictureRole::Axis | PictureRole::Foot => 0.0,
        PictureRole::Hatch => HATCH_LIFT,
        PictureRole::Block => BLOCK_LIFT,
        PictureRole::Bearing | PictureRole::Pin | PictureRole::Drive => BEARING_LIFT,
        PictureRole::Ball => BALL_LIFT,
    };
    let part = |kind: PartKind, points: Vec<[f64; 3]>, radius: Option<f64>| Part {
        kind,
        class: format!("{}{}", role.word(), if element.has_play { " with-play" } else { "" }),
        body: element.body,
        points: points.into_iter().map(rounded).collect(),
        radius: radius.map(round),
        lift: round(lift * extent_mm),
        of: element.of.clone(),
    };
    match &element.shape {
        PictureShape::Line { points_m } if matches!(role, PictureRole::Bar | PictureRole::Guide) => {
            let ends = points_m.windows(2).map(|ends| [in_mm(ends[0]), in_mm(ends[1])]);
            ends.flat_map(|ends| pieces(ends, PIECE * extent_mm))
                .map(|ends| part(PartKind::Line, ends.to_vec(), None))
                .collect()
        }
        PictureShape::Line { points_m } => {
            vec![part(PartKind::Line, points_m.iter().copied().map(in_mm).collect(), None)]
        }
        PictureShape::Face { corners_m } => {
            vec![part(PartKind::Face, corners_m.iter().copied().map(in_mm).collect(), None)]
        }
        PictureShape::Cylinder { ends_m, radius_m } => {
            vec![part(PartKind::Solid, rims(ends_m.map(in_mm), radius_m * MM_PER_M), None)]
        }
        PictureShape::Ball { centre_m, radius_m } => {
            vec![part(PartKind::Ball, vec![in_mm(*centre_m)], Some(radius_m * MM_PER_M))]
        }
    }
}

/// The path with its zones, and a dot where the point is.
fn of_trace(trace: &PictureTrace, magnification: f64, extent_mm: f64) -> Vec<Part> {
    let part = |kind: PartKind, class: &str, body: usize, points: Vec<[f64; 3]>| Part {
        kind,
        class: class.to_owned(),
        body,
        points: points.into_iter().map(rounded).collect(),
        radius: None,
        lift: 0.0,
        of: trace.point.clone(),
    };
    let mut parts = Vec::new();
    for (number, zone) in trace.zones.iter().enumerate() {
        let Some(at_m) = trace.at_m.get(zone.sample) else { continue };
        let displaced = |own: &[f64; 3]| in_mm(std::array::from_fn(|k| at_m[k] + magnification * own[k]));
        let class = if trace.worst_zone == Some(number) { "zone worst" } else { "zone" };
        parts.push(part(PartKind::Hull, class, 0, zone.boundary_m.iter().map(displaced).collect()));
    }
    let last = trace.at_m.len().saturating_sub(1);
    let step = last.div_ceil(TRACE_PIECES).max(1);
    for first in (0..last).step_by(step) {
        let points = &trace.at_m[first..=(first + step).min(last)];
        parts.push(part(PartKind::Line, "trace", 0, points.iter().copied().map(in_mm).collect()));
    }
    let tip = part(PartKind::Ball, "tip", trace.body, vec![in_mm(trace.point_m)]);
    parts.push(Part { radius: Some(round(TIP * extent_mm)), lift: round(1.1 * BALL_LIFT * extent_mm), ..tip });
    parts
}

/// A line in equal pieces of at most this length.
fn pieces([from, to]: [[f64; 3]; 2], longest: f64) -> Vec<[[f64; 3]; 2]> {
    let length = from.iter().zip(to).map(|(a, b)| (b - a) * (b - a)).sum::<f64>().sqrt();
    let count = (length / longest).ceil().clamp(1.0, 1e3) as usize;
    let at = |piece: usize| std::array::from_fn(|k| from[k] + (to[k] - from[k]) * piece as f64 / count as f64);
    (0..count).map(|piece| [at(piece), at(piece + 1)]).collect()
}

/// Points round both ends of a cylinder.
fn rims([from, to]: [[f64; 3]; 2], radius: f64) -> Vec<[f64; 3]> {
    let axis: [f64; 3] = std::array::from_fn(|k| to[k] - from[k]);
    // Across the axis: its product with the coordinate axis that it is least along.
    let least = (0..3).min_by(|a, b| axis[*a].abs().total_cmp(&axis[*b].abs())).unwrap_or(0);
    let first = unit(cross(axis, std::array::from_fn(|k| f64::from(u8::from(k == least)))));
    let second = unit(cross(axis, first));
    let round = |end: [f64; 3]| {
        (0..RIM_POINTS).map(move |point| {
            let angle = TAU * point as f64 / RIM_POINTS as f64;
            let (sine, cosine) = (radius * libm::sin(angle), radius * libm::cos(angle));
            std::array::from_fn(|k| end[k] + cosine * first[k] + sine * second[k])
        })
    };
    round(from).chain(round(to)).collect()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = vector.iter().map(|own| own * own).sum::<f64>().sqrt();
    if length > 0.0 { vector.map(|own| own / length) } else { vector }
}

fn in_mm(point_m: [f64; 3]) -> [f64; 3] {
    point_m.map(|own| own * MM_PER_M)
}

fn rounded(point: [f64; 3]) -> [f64; 3] {
    point.map(round)
}

pub(super) fn round(value: f64) -> f64 {
    round_to_digits(value, DIGITS).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::{RIM_POINTS, pieces, rims};

    #[test]
    fn analytic_a_bar_is_cut_into_equal_pieces() {
        let found = pieces([[1.0, 2.0, 3.0], [1.0, 2.0, 13.0]], 4.0);
        assert_eq!(found.len(), 3);
        assert_eq!((found[0][0], found[2][1]), ([1.0, 2.0, 3.0], [1.0, 2.0, 13.0]));
        assert!(found.windows(2).all(|pair| pair[0][1] == pair[1][0]));
    }

    #[test]
    fn analytic_rims_lie_round_their_ends_across_the_axis() {
        let (from, to) = ([0.3, -0.2, 0.7], [1.3, 1.8, -1.3]);
        let points = rims([from, to], 0.25);
        assert_eq!(points.len(), 2 * RIM_POINTS);
        for (number, point) in points.iter().enumerate() {
            let end = if number < RIM_POINTS { from } else { to };
            let off: [f64; 3] = std::array::from_fn(|k| point[k] - end[k]);
            let length = off.iter().map(|own| own * own).sum::<f64>().sqrt();
            let along: f64 = (0..3).map(|k| off[k] * (to[k] - from[k])).sum();
            assert!((length - 0.25).abs() < 1e-15 && along.abs() < 1e-15, "{off:?}");
        }
    }
}
