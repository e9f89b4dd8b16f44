//! The picture of a page, with the data by which its script turns it.

use maud::{Markup, html};
use serde::Serialize;

use super::drawing::scene;
use super::names::{Name, drawn_names, names};
use super::parts::{Part, parts, round};
use super::placed::{Surroundings, on_sheet, placed};
use super::projection::Projection;
use super::signs::{sheet, triad};
use crate::charts::figure::Picture;
use crate::mechanism::figure::pose_step;
use crate::mechanism::shapes::{Frame, MM_PER_M};
use crate::mechanism::signs::scale;
use crate::medium::script_data::script_json;
use loosepin_result::motion::MotionRecord;
use loosepin_result::spatial_picture::PicturePose;

/// Name of the figure.
const NAME: &str = "mechanism";
/// Size of the letters, as a share of the side of the picture: 13 pixels where it is 450 wide.
const FONT_SHARE: f64 = 0.029;
/// Room around what is drawn, over its radius, and below it for the scale, in letters.
const ROOM: f64 = 1.04;
const ABOVE_LETTERS: f64 = 1.5;
const BELOW_LETTERS: f64 = 3.5;
/// Azimuths, degrees apart, and elevations for which the picture has room.
const AZIMUTH_STEP_DEG: usize = 15;
const ELEVATIONS_DEG: [f64; 3] = [0.0, 20.0, 35.5];
/// Its height, at least and at most, over its width.
const HEIGHTS: [f64; 2] = [0.5, 0.95];
/// What the script needs.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Data<'p> {
    /// The input at each position: degrees where it is an angle, seconds where it is the time.
    inputs: Vec<f64>,
    is_angle: bool,
    /// Whether the inputs are one whole turn: then they are told from 0° to 360°.
    is_turn: bool,
    /// Position, azimuth and elevation that are shown first; degrees.
    start: usize,
    azimuth: f64,
    elevation: f64,
    /// Of the ball about all that is drawn, mm, and its outermost points.
    centre: [f64; 3],
    radius: f64,
    outer: Vec<[f64; 3]>,
    /// Half the sides of the room for what is drawn, mm.
    half: [f64; 2],
    font: f64,
    /// Where the axes stand, from the middle of the picture, mm.
    triad: [f64; 2],
    parts: &'p [Part],
    names: &'p [Name],
    /// For each position and body x, y, z, mm, and w, x, y, z of its quaternion.
    poses: Vec<Vec<[f64; 7]>>,
}

/// A picture ready to be shown.
struct Prepared {
    picture: Picture,
    magnification: Option<f64>,
    start: usize,
    /// Numbers of the positions that the page has.
    samples: Vec<usize>,
    parts: Vec<Part>,
    names: Vec<Name>,
    around: Surroundings,
    half: [f64; 2],
    font_mm: f64,
    triad: [f64; 2],
}

/// Half the width and the height of what is drawn, from all sides and from little above. Where a steep view is higher, the script makes it smaller.
fn half_sides(around: &Surroundings) -> [f64; 2] {
    let views = ELEVATIONS_DEG.into_iter().flat_map(|elevation_deg: f64| {
        (0..360).step_by(AZIMUTH_STEP_DEG).map(move |azimuth_deg| Projection {
            azimuth_rad: f64::from(azimuth_deg as u32).to_radians(),
            elevation_rad: elevation_deg.to_radians(),
        })
    });
    let sides = views.map(|view| around.half_sides(&view));
    let [width, height] = sides.fold([0.0; 2], |[width, height], [x, y]| [f64::max(width, x), f64::max(height, y)]);
    let width = if width > 0.0 { width } else { 1.0 };
    let first = around.half_sides(&Projection::ISOMETRIC)[1];
    [width, height.clamp(HEIGHTS[0] * width, HEIGHTS[1] * width).max(first)]
}

fn prepared(record: &MotionRecord, wanted: usize) -> Option<Prepared> {
    let own = &record.picture;
    let poses: &[PicturePose] = &own.poses.get(wanted)?.iter().map(rounded_pose).collect::<Vec<PicturePose>>();
    let step = pose_step(own.poses.len());
    let mut samples: Vec<usize> = (0..own.poses.len()).step_by(step).chain([wanted, own.poses.len() - 1]).collect();
    samples.sort_unstable();
    samples.dedup();
    let start = samples.iter().position(|sample| *sample == wanted)?;
    let (parts, magnification) = parts(own);
    let around = Surroundings::of(&parts, &own.poses);
    let projection = Projection::ISOMETRIC;
    let half = half_sides(&around).map(|own| ROOM * own);
    let font_mm = FONT_SHARE * 2.0 * half[0];
    let ([x, y], _) = on_sheet(&projection, around.centre);
    let frame = Frame {
        left: x - half[0],
        top: y - half[1] - ABOVE_LETTERS * font_mm,
        width: 2.0 * half[0],
        height: 2.0 * half[1] + (ABOVE_LETTERS + BELOW_LETTERS) * font_mm,
    };
    // The lower left corner, above the scale.
    let triad_at = [-half[0] + 4.4 * font_mm, half[1] + (BELOW_LETTERS - 5.0) * font_mm];
    let names = names(own, wanted, &projection, (&frame, [x + triad_at[0], y + triad_at[1]]), font_mm);
    let drawn = html! {
        (sheet(&frame))
        g.scene { (scene(&placed(&parts, poses, &projection, &around), &around, &projection)) }
        g.signs style=(format!("font-size: {font_mm:.4}px")) {
            g.names { (drawn_names(&names, poses, &projection, (&frame, font_mm))) }
            g.triad { (triad(&projection, [x + triad_at[0], y + triad_at[1]], font_mm)) }
            (scale(&frame, font_mm, magnification))
        }
    };
    let bodies = own.bodies.len().saturating_sub(1);
    let alternative = format!(
        "Isometric drawing of the mechanism {} with {} and {}.",
        record.model,
        if bodies == 1 { "1 body".to_owned() } else { format!("{bodies} bodies") },
        loosepin_text::units::counted(own.joints.len(), "joint")
    );
    let view = [frame.left, frame.top, frame.width, frame.height];
    let picture = Picture { name: NAME.to_owned(), class: "space", view, below: 0.0, alternative, drawn };
    Some(Prepared { picture, magnification, start, samples, parts, names, around, half, font_mm, triad: triad_at })
}

/// A pose with the digits of the data, so that the script begins with the same picture.
fn rounded_pose(pose: &PicturePose) -> PicturePose {
    let [x, y, z, w, a, b, c] = pose_data(pose);
    PicturePose { at_m: [x, y, z].map(|own| own / MM_PER_M), turn: [w, a, b, c] }
}

fn pose_data(pose: &PicturePose) -> [f64; 7] {
    let [x, y, z] = pose.at_m.map(|own| round(own * MM_PER_M));
    let [w, a, b, c] = pose.turn.map(round);
    [x, y, z, w, a, b, c]
}

/// A drawing of a mechanism in space for a page that turns and moves it by itself.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpaceDrawing {
    /// The first view, as an SVG document that takes its style from the page.
    pub svg: String,
    /// What `scripts/space-scene.ts` draws it from, as JSON.
    pub scene: String,
}

/// The drawing, at first in the position `sample`; `None` where the record has none.
pub(crate) fn space_drawing(record: &MotionRecord, sample: usize) -> Option<SpaceDrawing> {
    let prepared = prepared(record, sample)?;
    let scene = serde_json::to_string(&data(record, &prepared)).ok()?;
    Some(SpaceDrawing { svg: prepared.picture.document(&[]), scene })
}

fn data<'p>(record: &MotionRecord, prepared: &'p Prepared) -> Data<'p> {
    let is_angle = record.time_s.is_empty();
    let shown = |sample: &usize| {
        let time_s = record.time_s.get(*sample).copied();
        let angle_deg = record.drive_angle_rad.get(*sample).map(|angle_rad| angle_rad.to_degrees());
        round(time_s.or(angle_deg).unwrap_or_default())
    };
    let poses = prepared.samples.iter().filter_map(|sample| record.picture.poses.get(*sample));
    let view = Projection::ISOMETRIC;
    Data {
        inputs: prepared.samples.iter().map(shown).collect(),
        is_angle,
        is_turn: is_angle && record.is_whole_turn(),
        start: prepared.start,
        azimuth: view.azimuth_rad.to_degrees(),
        elevation: view.elevation_rad.to_degrees(),
        centre: prepared.around.centre,
        radius: prepared.around.radius,
        outer: prepared.around.outer.iter().map(|point| point.map(round)).collect(),
        half: prepared.half.map(round),
        font: round(prepared.font_mm),
        triad: prepared.triad.map(round),
        parts: &prepared.parts,
        names: &prepared.names,
        poses: poses.map(|poses| poses.iter().map(pose_data).collect()).collect(),
    }
}

/// The picture with its controls, at first in the position `sample`; empty if the record has none.
pub(crate) fn spatial_figure(record: &MotionRecord, sample: usize) -> Markup {
    let Some(prepared) = prepared(record, sample) else { return html! {} };
    let data = data(record, &prepared);
    let is_angle = data.is_angle;
    let at = data.inputs.get(prepared.start).copied().unwrap_or_default();
    let at = if is_angle {
        format!("{:.0}°", if data.is_turn { at.rem_euclid(360.0) } else { at })
    } else {
        format!("{at:.4}\u{a0}s")
    };
    html! {
        figure.space id=(NAME) data-space=(NAME) data-figure=(NAME) {
            (prepared.picture.svg())
            div.controls {
                button.play type="button" aria-pressed="false" { "Animate" }
                label {
                    span { (record.drive) " at " output.angle { (at) } }
                    input.pose type="range" min="0" max=(data.inputs.len().saturating_sub(1)) value=(data.start) step="1"
                        aria-label=(if is_angle { format!("Angle of {}", record.drive) } else { "Time".to_owned() });
                }
                div.views role="group" aria-label="View" {
                    @for (word, view) in VIEWS {
                        button type="button" data-azimuth=(view.azimuth_rad.to_degrees()) data-elevation=(view.elevation_rad.to_degrees())
                            aria-pressed=(if view == Projection::ISOMETRIC { "true" } else { "false" }) { (word) }
                    }
                }
            }
            figcaption { (caption(record, prepared.magnification)) }
            script type="application/json" data-for=(NAME) { (script_json(&data)) }
        }
    }
}

/// Views on offer.
const VIEWS: [(&str, Projection); 4] = [
    ("Isometric", Projection::ISOMETRIC),
    ("Front", Projection::FRONT),
    ("Side", Projection::SIDE),
    ("Top", Projection::TOP),
];

fn caption(record: &MotionRecord, magnification: Option<f64>) -> Markup {
    let traces = &record.picture.traces;
    let points: Vec<&str> = traces.iter().map(|trace| trace.point.as_str()).collect();
    html! {
        "The mechanism over one " (if record.time_s.is_empty() { "turn" } else { "cycle" }) ". Drag the picture, or use arrow keys, to turn it."
        @if record.picture.joints.iter().any(|joint| joint.has_play) { " Orange: joints with play." }
        @if !points.is_empty() { " Green: " (if points.len() == 1 { "path" } else { "paths" }) " of " (points.join(", ")) "." }
        @if let Some(magnification) = magnification {
            " Orange zones: where play takes the point to first order, magnified " (magnification) " times; the outlined one is at the largest worst case."
        }
        @if record.picture.elements.iter().any(|element| element.role.word() == "drive") { " Arrow: drive." }
    }
}
