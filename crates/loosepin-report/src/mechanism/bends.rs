//! Flexible bodies in the drawing of a mechanism: their bent axes, magnified.

use crate::charts::plane_view::round_factor;
use crate::mechanism::shapes::MM_PER_M;
use crate::medium::script_data::round_to_digits;
use loosepin_result::simulation::{Drawing, DrawnBeam};
use loosepin_text::units::{Dimension, format_value, listed};
use serde::Serialize;

/// The largest deflection is drawn as at most this share of the length of the beam.
const MAX_SHARE: f64 = 0.1;
/// Digits of what is sent: the picture shows three.
const DIGITS: usize = 5;

/// Digits of the largest deflection in words.
const SHOWN_DIGITS: usize = 3;

/// The bent axis of a flexible body over the poses, for the script that moves it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Bend {
    /// The body in whose frame it is drawn.
    pub(crate) body: usize,
    /// Places along the straight axis, mm.
    places: Vec<[f64; 2]>,
    /// Direction to the left of the way from root to tip.
    normal: [f64; 2],
    /// Deflection of each shape at each place, mm for each rad.
    shapes: Vec<Vec<Option<f64>>>,
    /// Coordinate of each shape at each pose, rad.
    turns: Vec<Vec<Option<f64>>>,
    /// Magnification of deflections.
    factor: f64,
    /// x and y of places along the axis at each pose, mm, in place of shapes.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    track: Vec<[Vec<Option<f64>>; 2]>,
}

impl Bend {
    /// The axis at a pose, as an SVG path.
    pub(crate) fn path(&self, pose: usize) -> String {
        let mut path = String::new();
        for (place, lists) in self.track.iter().enumerate() {
            let [x, y] = lists.each_ref().map(|list| list.get(pose).copied().flatten().unwrap_or(0.0));
            let letter = if place == 0 { 'M' } else { 'L' };
            path.push_str(&format!("{letter}{x:.3} {y:.3}"));
        }
        for (place, [x, y]) in self.places.iter().enumerate() {
            let number = |list: &[Option<f64>], index: usize| list.get(index).copied().flatten().unwrap_or(0.0);
            let terms = self.shapes.iter().zip(&self.turns);
            let deflection: f64 = terms.map(|(shape, turns)| number(shape, place) * number(turns, pose)).sum();
            let drawn = self.factor * deflection;
            let letter = if place == 0 { 'M' } else { 'L' };
            path.push_str(&format!("{letter}{:.3} {:.3}", x + drawn * self.normal[0], y + drawn * self.normal[1]));
        }
        path
    }
}

/// The flexible bodies whose coordinates are known at all `poses` poses.
pub(crate) fn bent(drawing: &Drawing, poses: usize) -> impl Iterator<Item = &DrawnBeam> {
    let is_known = move |beam: &&DrawnBeam| {
        has_axis(beam, poses)
            || !beam.turns_rad.is_empty()
                && beam.turns_rad.len() == beam.deflections_m.len()
                && beam.turns_rad.iter().all(|turns| turns.len() == poses && poses > 0)
    };
    drawing.beams.iter().filter(is_known)
}

/// Whether the axis of a body in absolute nodal coordinates is known at all `poses` poses.
fn has_axis(beam: &DrawnBeam, poses: usize) -> bool {
    let lists = || beam.axis_x_m.iter().chain(&beam.axis_y_m);
    beam.axis_x_m.len() == beam.axis_y_m.len()
        && beam.axis_x_m.len() > 1
        && lists().all(|list| list.len() == poses && poses > 0)
}

/// Whether a body is drawn by its bent axis alone: it may bend far off a straight bar.
pub(crate) fn is_drawn_by_its_axis(drawing: &Drawing, body: usize) -> bool {
    let poses = drawing.poses.drive_angle_rad.len();
    drawing.beams.iter().any(|beam| beam.body == body && has_axis(beam, poses))
}

/// The bent axes at every `step`th of `poses` poses.
pub(crate) fn bends(drawing: &Drawing, poses: usize, step: usize) -> Vec<Bend> {
    bent(drawing, poses).filter_map(|beam| bend(drawing, beam, step)).collect()
}

fn bend(drawing: &Drawing, beam: &DrawnBeam, step: usize) -> Option<Bend> {
    if !beam.axis_x_m.is_empty() {
        let sent = |list: &Vec<f64>| -> Vec<Option<f64>> {
            list.iter().step_by(step).map(|value| round_to_digits(value * MM_PER_M, DIGITS)).collect()
        };
        let track = beam.axis_x_m.iter().zip(&beam.axis_y_m).map(|(x, y)| [sent(x), sent(y)]).collect();
        let (places, shapes, turns) = (Vec::new(), Vec::new(), Vec::new());
        return Some(Bend { body: beam.body, places, normal: [0.0; 2], shapes, turns, factor: 1.0, track });
    }
    let points = &drawing.bodies.get(beam.body)?.points;
    let [root, tip] = beam.ends.map(|end| points.get(end).map(|point| [point.x_m * MM_PER_M, point.y_m * MM_PER_M]));
    let (root, tip) = (root?, tip?);
    let (dx, dy) = (tip[0] - root[0], tip[1] - root[1]);
    let length = dx.hypot(dy);
    let count = beam.deflections_m.first()?.len();
    let share = |place: usize| place as f64 / (count - 1) as f64;
    let rounded = |list: &Vec<f64>, factor: f64, step: usize| {
        list.iter().step_by(step).map(|value| round_to_digits(value * factor, DIGITS)).collect()
    };
    let largest_mm = largest_deflection_m(beam) * MM_PER_M;
    Some(Bend {
        body: beam.body,
        places: (0..count).map(|place| [root[0] + share(place) * dx, root[1] + share(place) * dy]).collect(),
        normal: [-dy / length, dx / length],
        shapes: beam.deflections_m.iter().map(|shape| rounded(shape, MM_PER_M, 1)).collect(),
        turns: beam.turns_rad.iter().map(|turns| rounded(turns, 1.0, step)).collect(),
        factor: magnification(MAX_SHARE * length / largest_mm),
        track: Vec::new(),
    })
}

/// Largest deflection over all places and poses, m.
fn largest_deflection_m(beam: &DrawnBeam) -> f64 {
    let (places, poses) = (beam.deflections_m.first().map_or(0, Vec::len), beam.turns_rad.first().map_or(0, Vec::len));
    let at = |place: usize, pose: usize| -> f64 {
        beam.deflections_m.iter().zip(&beam.turns_rad).map(|(shape, turns)| shape[place] * turns[pose]).sum()
    };
    let all = (0..places).flat_map(|place| (0..poses).map(move |pose| (place, pose)));
    all.fold(0.0, |largest: f64, (place, pose)| largest.max(at(place, pose).abs()))
}

/// A round number, at most `wanted`; 1 where that is less or without bound.
fn magnification(wanted: f64) -> f64 {
    if (1.0..1e9).contains(&wanted) { round_factor(wanted) } else { 1.0 }
}

/// The scale of the deflection, how large it is, and the frequencies, in words.
pub(crate) fn bend_words(drawing: &Drawing, beam: &DrawnBeam, bend: &Bend) -> String {
    if !beam.axis_x_m.is_empty() {
        return format!(" Green line: axis of the {}, true to scale.", drawing.bodies[beam.body].name);
    }
    let hz = |list: &[f64]| {
        let each: Vec<String> = list.iter().map(|hz| format!("{hz:.0}\u{a0}Hz")).collect();
        listed(&each, "and")
    };
    let axial = if beam.axial_hz.is_empty() { String::new() } else { format!(", axial {}", hz(&beam.axial_hz)) };
    let scale = if bend.factor == 1.0 { "true to scale".to_owned() } else { format!("× {}", bend.factor) };
    format!(
        " Green line: axis of the {} as it bends, deflection {scale}, at most {}; frequencies with its frame held: lateral {}{axial}.",
        drawing.bodies[beam.body].name,
        format_value(round_to_digits(largest_deflection_m(beam), SHOWN_DIGITS).unwrap_or(f64::NAN), Dimension::LENGTH)
            .replace(' ', "\u{a0}"),
        hz(&beam.lateral_hz),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_result::simulation::{DrawnBody, DrawnPoint, PoseTable};

    fn drawing(turns_rad: Vec<f64>) -> Drawing {
        let point = |name: &str, x_m: f64, y_m: f64| DrawnPoint { name: name.to_owned(), x_m, y_m };
        // From (0, 0.1) down to (0, -0.2): left of it is +x.
        let points = vec![point("tip", 0.0, -0.2), point("root", 0.0, 0.1)];
        Drawing {
            bodies: vec![DrawnBody { name: "rod".to_owned(), is_ground: false, points }],
            joints: Vec::new(),
            drives: Vec::new(),
            output_points: Vec::new(),
            poses: PoseTable::default(),
            ideal_poses: PoseTable::default(),
            beams: vec![DrawnBeam {
                body: 0,
                ends: [1, 0],
                deflections_m: vec![vec![0.0, 0.05, 0.0]],
                turns_rad: vec![turns_rad],
                axis_x_m: Vec::new(),
                axis_y_m: Vec::new(),
                lateral_hz: vec![172.4],
                axial_hz: vec![4953.4],
            }],
        }
    }

    #[test]
    fn analytic_a_bent_axis_is_magnified_by_a_round_number() {
        let drawing = drawing(vec![0.0, 0.002, -0.004]);
        let bends = bends(&drawing, 3, 1);
        // 0.2 mm at most; a tenth of 300 mm is 150 times as much.
        assert_eq!(bends[0].factor, 100.0);
        assert_eq!(bends[0].path(1), "M0.000 100.000L10.000 -50.000L0.000 -200.000");
        assert_eq!(bends[0].path(2), "M0.000 100.000L-20.000 -50.000L0.000 -200.000");
        assert_eq!(
            bend_words(&drawing, &drawing.beams[0], &bends[0]),
            " Green line: axis of the rod as it bends, deflection × 100, at most 0.2\u{a0}mm; frequencies with its frame held: \
             lateral 172\u{a0}Hz, axial 4953\u{a0}Hz."
        );
        assert!(super::bends(&drawing, 2, 1).is_empty(), "poses and coordinates do not fit");
    }

    #[test]
    fn analytic_magnifications() {
        assert_eq!([0.3, 1.0, 4.9, 51.0, 999.0, f64::INFINITY].map(magnification), [1.0, 1.0, 2.0, 50.0, 500.0, 1.0]);
    }

    #[test]
    fn a_body_in_absolute_nodal_coordinates_is_drawn_by_its_axis_alone() {
        let mut drawing = drawing(vec![0.0; 2]);
        assert!(!is_drawn_by_its_axis(&drawing, 0));
        let beam = &mut drawing.beams[0];
        (beam.deflections_m, beam.turns_rad) = (Vec::new(), Vec::new());
        (beam.axis_x_m, beam.axis_y_m) = (vec![vec![0.0; 2], vec![0.1, 0.2]], vec![vec![0.1; 2], vec![0.05, -0.07]]);
        drawing.poses.drive_angle_rad = vec![0.0; 2];
        assert!(is_drawn_by_its_axis(&drawing, 0) && !is_drawn_by_its_axis(&drawing, 1));
        let bends = bends(&drawing, 2, 1);
        assert_eq!(
            [0, 1].map(|pose| bends[0].path(pose)),
            ["M0.000 100.000L100.000 50.000".to_owned(), "M0.000 100.000L200.000 -70.000".to_owned()]
        );
        assert_eq!(bend_words(&drawing, &drawing.beams[0], &bends[0]), " Green line: axis of the rod, true to scale.");
        // A pose without its axis: nothing is drawn of it.
        drawing.beams[0].axis_y_m[1].pop();
        assert!(!is_drawn_by_its_axis(&drawing, 0) && super::bends(&drawing, 2, 1).is_empty());
    }
}
