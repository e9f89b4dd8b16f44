//! The mechanism drawn and moving: a still picture of the first pose, and the poses for the script that moves it.

use maud::{Markup, PreEscaped, html};
use serde::Serialize;

use crate::charts::chart::{PHASE, turns_before_rad};
use crate::charts::figure::Picture;
use crate::mechanism::bends::{Bend, bend_words, bends, bent, is_drawn_by_its_axis};
use crate::mechanism::labels::{Label, Sizes, frame_with, labels};
use crate::mechanism::shapes::{
    BLOCK_PINS, Frame, JOURNAL_PINS, MM_PER_M, PIN_SHARE, PinLayer, frame, ground, outline, pins,
};
use crate::mechanism::signs::{DriveSign, drive_sign, scale, scale_width_mm};
use crate::medium::script_data::{round_to_digits, script_json};
use crate::medium::styles::{COLOURS, MECHANISM_STYLE};
use loosepin_result::simulation::{Drawing, DriveSense, PoseTable};
use loosepin_text::units;

/// Name of the figure.
const NAME: &str = "mechanism";
/// Digits of the poses in a page: 0.1 µm in a metre, so that a magnified deviation is smooth.
const POSE_DIGITS: usize = 8;
/// Most poses in a page.
const MAX_POSES: usize = 361;
/// A clearance is magnified at first to about this share of the diagonal: the ring around the journal is then as high as a
/// slider's block, at most.
const VISIBLE_SHARE: f64 = (BLOCK_PINS[1] - JOURNAL_PINS) * PIN_SHARE;
/// Size of the letters, as a share of the diagonal: 12 pixels where the figure is 400 wide.
const FONT_SHARE: f64 = 0.027;
/// The still picture shows the pose at this fraction of the cycle (one over it): not a dead centre.
const FIRST_POSE: usize = 6;
/// Magnifications on offer.
const MAGNIFICATIONS: [f64; 10] = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0];

/// Poses of a mechanism over a turn, for the script that moves its picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Motion {
    /// Angle of the drive at each pose, degrees.
    angle_deg: Vec<Option<f64>>,
    magnification: f64,
    /// The pose that is shown first.
    start: usize,
    bodies: Vec<BodyMotion>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    bends: Vec<Bend>,
}

/// Ideal pose and actual minus ideal, in mm and degrees, one entry per pose.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct BodyMotion {
    x: Vec<Option<f64>>,
    y: Vec<Option<f64>>,
    a: Vec<Option<f64>>,
    dx: Vec<Option<f64>>,
    dy: Vec<Option<f64>>,
    da: Vec<Option<f64>>,
}

/// The picture of a mechanism, and how it moves.
struct Moving {
    picture: Picture,
    motion: Motion,
    has_play: bool,
    /// Which signs are drawn, for the caption: the arrow of a drive, the flag of an output.
    has_signs: [bool; 2],
}

/// Of `count` recorded poses a page has each one whose index is a multiple of this.
pub(crate) fn pose_step(count: usize) -> usize {
    count.div_ceil(MAX_POSES).max(1)
}

/// The mechanism in its first pose, or nothing where the record holds no poses. Gaps are magnified where the poses with play are
/// known beside the ideal ones, or where that is asked for.
fn moving(drawing: &Drawing, drive: &str, is_gap_shown: bool) -> Option<Moving> {
    if drawing.bodies.is_empty() || !is_complete(&drawing.poses, drawing.bodies.len()) {
        return None;
    }
    let has_ideal = is_complete(&drawing.ideal_poses, drawing.bodies.len())
        && drawing.ideal_poses.drive_angle_rad.len() == drawing.poses.drive_angle_rad.len();
    let reference = if has_ideal { &drawing.ideal_poses } else { &drawing.poses };
    let frame = frame(drawing, reference);
    let largest_clearance_mm =
        drawing.joints.iter().map(|joint| joint.radial_clearance_m * MM_PER_M).fold(0.0, f64::max);
    let is_magnified = has_ideal || is_gap_shown;
    let magnification = if is_magnified { first_magnification(frame.diagonal(), largest_clearance_mm) } else { 1.0 };
    let motion = motion(drawing, reference, has_ideal, magnification);
    let alternative = format!(
        "Drawing of the mechanism with {} and {}, moving through one {}.",
        if drawing.bodies.len() == 1 { "1 body".to_owned() } else { format!("{} bodies", drawing.bodies.len()) },
        units::counted(drawing.joints.len(), "joint"),
        if drive == PHASE { drive.to_owned() } else { format!("turn of {drive}") }
    );
    let has_play = is_magnified && largest_clearance_mm > 0.0;
    let sizes = Sizes { pin: PIN_SHARE * frame.diagonal(), font_mm: FONT_SHARE * frame.diagonal() };
    let labels = labels(drawing, reference, &frame, sizes);
    // A magnified deviation takes labels along: there must be room for that, too.
    let points = |label: &Label| {
        let places = (0..motion.angle_deg.len()).flat_map(|pose| [0.0, magnification].map(|factor| (pose, factor)));
        places.map(|(pose, factor)| carried(&motion, label.body, pose, factor, label.at_mm)).collect()
    };
    let view = with_scale(frame_with(&labels, points, &frame, sizes), sizes.font_mm);
    let drawn = html! {
        (shapes(drawing, reference, &motion, &frame, magnification, has_ideal))
        g.signs style=(format!("font-size: {:.4}px", sizes.font_mm)) {
            g transform="scale(1 -1)" {
                @for label in &labels { (riding(&motion, label.body, label.at_mm, magnification, label.drawn(sizes))) }
            }
            (scale(&view, sizes.font_mm, has_play.then_some(magnification)))
        }
    };
    let view = [view.left, view.top, view.width, view.height];
    let picture = Picture { name: NAME.to_owned(), class: "mechanism", view, below: 0.0, alternative, drawn };
    let has_signs = [has_arrow(drawing, reference, sizes.pin), labels.iter().any(Label::is_output)];
    Some(Moving { picture, motion, has_play, has_signs })
}

/// A drawing of a mechanism for a page that moves it by itself.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MovingDrawing {
    /// The first pose, as an SVG document that takes its style from the page. Groups with `data-body` move with a body, those with
    /// `data-rides` with a point of one.
    pub svg: String,
    /// Poses of the bodies.
    pub motion: Motion,
}

/// The mechanism with its gaps magnified, or nothing where the record holds no poses.
pub fn moving_drawing(drawing: &Drawing, drive: &str) -> Option<MovingDrawing> {
    let Moving { picture, motion, .. } = moving(drawing, drive, true)?;
    Some(MovingDrawing { svg: picture.document(&[]), motion })
}

/// Angle of the drive in the pose that [`mechanism_figure`] shows first, degrees; `None` where the record holds no poses.
pub(crate) fn start_deg(drawing: &Drawing) -> Option<f64> {
    let Moving { motion, .. } = moving(drawing, "", false)?;
    motion.angle_deg[motion.start]
}

/// The figure, or nothing where the record holds no poses.
pub(crate) fn mechanism_figure(drawing: &Drawing, drive: &str) -> Markup {
    let Some(Moving { picture, motion, has_play, has_signs }) = moving(drawing, drive, false) else { return html! {} };
    let magnification = motion.magnification;
    let cycle = if drive == PHASE { "cycle" } else { "turn" };
    html! {
        figure.mechanism id=(NAME) data-mechanism=(NAME) data-figure=(NAME) {
            (picture.svg())
            div.controls {
                button.play type="button" aria-pressed="false" { "Animate" }
                label {
                    span { (if drive == PHASE { "phase of the cycle:" } else { drive }) @if drive != PHASE { " at" } " " output.angle { (format!("{:.0}°", motion.angle_deg[motion.start].unwrap_or(0.0))) } }
                    input.pose type="range" min="0" max=(motion.angle_deg.len().saturating_sub(1)) value=(motion.start)
                        step="1" aria-label=(if drive == PHASE { "Phase of the cycle".to_owned() } else { format!("Angle of {drive}") });
                }
                @if has_play {
                    label {
                        span { "Magnification" }
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
                @if has_play {
                    "The mechanism over one " (cycle) ". Solid: with play, deviation magnified as chosen above. Dashed: ideal. Orange rings: \
                     bearings with play; the gap to the pin is the clearance, with the same magnification."
                } @else {
                    "The mechanism over one " (cycle) "."
                }
                @for beam in bent(drawing, drawing.poses.drive_angle_rad.len()) {
                    @if let Some(bend) = motion.bends.iter().find(|bend| bend.body == beam.body) { (bend_words(drawing, beam, bend)) }
                }
                @if has_signs[0] { " Arrow: drive." }
                @if has_signs[1] { " Flag: output." }
            }
            script type="application/json" data-for=(NAME) { (script_json(&motion)) }
        }
    }
}

/// Whether any drive has an arrow: one that rests has none, nor one of a joint without a sign.
fn has_arrow(drawing: &Drawing, poses: &PoseTable, pin: f64) -> bool {
    let moving = drawing.drives.iter().filter(|drive| drive.sense != DriveSense::Still);
    moving.filter_map(|drive| drive_sign(drawing, drive, poses, pin)).next().is_some()
}

/// The mechanism in the pose that is shown first, with the dashed ideal one where there is one.
fn shapes(
    drawing: &Drawing,
    reference: &PoseTable,
    motion: &Motion,
    frame: &Frame,
    magnification: f64,
    has_ideal: bool,
) -> Markup {
    let pin = PIN_SHARE * frame.diagonal();
    html! {
        g transform="scale(1 -1)" {
            (ground(drawing, reference, frame, pin))
            @if has_ideal {
                g.ghost aria-hidden="true" {
                    @for (index, body) in drawing.bodies.iter().enumerate() {
                        @if !body.is_ground {
                            g data-ghost=(index) transform=(transform(motion, index, 0.0)) {
                                (outline(drawing, index, reference, frame, pin))
                            }
                        }
                    }
                }
            }
            @for (index, body) in drawing.bodies.iter().enumerate() {
                @if !body.is_ground {
                    g.body data-body=(index) transform=(transform(motion, index, magnification)) {
                        title { (body.name) }
                        @if !is_drawn_by_its_axis(drawing, index) { (outline(drawing, index, reference, frame, pin)) }
                    }
                }
            }
            @for (index, bend) in motion.bends.iter().enumerate() {
                g data-body=(bend.body) transform=(transform(motion, bend.body, magnification)) {
                    path.bend data-bend=(index) d=(bend.path(motion.start)) {}
                }
            }
            @for sign in drawing.drives.iter().filter_map(|drive| drive_sign(drawing, drive, reference, pin)) {
                @match &sign {
                    DriveSign::Curved { body, at_mm, .. } => (riding(motion, *body, *at_mm, magnification, sign.arrow(pin))),
                    DriveSign::Straight { body, at_mm: (x, y), .. } => g data-body=(body) transform=(transform(motion, *body, magnification)) {
                        g transform=(format!("translate({x:.4} {y:.4})")) { (sign.arrow(pin)) }
                    },
                }
            }
            // Above all shapes, bearings below journals, so that no body hides a joint of another.
            @for layer in [PinLayer::Bearings, PinLayer::Journals] {
                @for index in 0..drawing.bodies.len() {
                    g data-body=(index) transform=(transform(motion, index, magnification)) {
                        (pins(drawing, index, pin, magnification, layer))
                    }
                }
            }
        }
    }
}

/// What moves with a point of a body but stays upright; the script moves it.
fn riding(motion: &Motion, body: usize, at_mm: (f64, f64), magnification: f64, drawn: Markup) -> Markup {
    let (x, y) = carried(motion, body, motion.start, magnification, at_mm);
    html! {
        g data-rides=(body) data-x=(format!("{:.4}", at_mm.0)) data-y=(format!("{:.4}", at_mm.1))
            transform=(format!("translate({x:.4} {y:.4})")) { (drawn) }
    }
}

/// Position of a point of a body at a pose, mm, its deviation magnified.
fn carried(motion: &Motion, body: usize, pose: usize, magnification: f64, (x, y): (f64, f64)) -> (f64, f64) {
    let [body_x, body_y, angle_deg] = placed(motion, body, pose, magnification);
    let (sine, cosine) = angle_deg.to_radians().sin_cos();
    (body_x + cosine * x - sine * y, body_y + sine * x + cosine * y)
}

/// The frame with room for the scale below.
fn with_scale(frame: Frame, font_mm: f64) -> Frame {
    let missing = (scale_width_mm(frame.width, font_mm) - frame.width).max(0.0);
    Frame {
        left: frame.left - 0.5 * missing,
        top: frame.top,
        width: frame.width + missing,
        height: frame.height + 1.8 * font_mm,
    }
}

/// Width of a picture that stands alone, pixels, and the largest height.
const PICTURE_PX: [f64; 2] = [520.0, 420.0];

/// The mechanism in one pose as an SVG file of its own, that needs no network and follows the colours of the reader's
/// system; empty if the record holds no poses.
pub fn mechanism_picture(drawing: &Drawing, name: &str) -> String {
    if drawing.bodies.is_empty() || !is_complete(&drawing.poses, drawing.bodies.len()) {
        return String::new();
    }
    let frame = frame(drawing, &drawing.poses);
    let motion = motion(drawing, &drawing.poses, false, 1.0);
    let scale = (PICTURE_PX[0] / frame.width).min(PICTURE_PX[1] / frame.height);
    let picture = html! {
        svg.mechanism xmlns="http://www.w3.org/2000/svg" role="img" aria-label=(name)
            width=(format!("{:.0}", scale * frame.width)) height=(format!("{:.0}", scale * frame.height))
            viewBox=(view_box(&frame)) {
            title { (name) }
            style { (PreEscaped(COLOURS)) (PreEscaped(MECHANISM_STYLE)) }
            rect x=(format!("{:.3}", frame.left)) y=(format!("{:.3}", frame.top)) width="100%" height="100%"
                style="fill: var(--raised)" {}
            (shapes(drawing, &drawing.poses, &motion, &frame, 1.0, false))
        }
    };
    format!("{}\n", picture.into_string())
}

fn view_box(frame: &Frame) -> String {
    format!("{:.3} {:.3} {:.3} {:.3}", frame.left, frame.top, frame.width, frame.height)
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
    let step = pose_step(count);
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
    let before_rad = turns_before_rad(&reference.drive_angle_rad);
    let angle_deg = pick(&|pose| (reference.drive_angle_rad[pose] - before_rad).to_degrees());
    let start = angle_deg.len() / FIRST_POSE;
    Motion { angle_deg, magnification, start, bodies, bends: bends(drawing, count, step) }
}

/// x, y in mm and angle in degrees of a body at a pose.
fn placed(motion: &Motion, index: usize, pose: usize, magnification: f64) -> [f64; 3] {
    let body = &motion.bodies[index];
    let at = |list: &[Option<f64>]| list.get(pose).copied().flatten().unwrap_or(0.0);
    [(&body.x, &body.dx), (&body.y, &body.dy), (&body.a, &body.da)]
        .map(|(ideal, change)| at(ideal) + magnification * at(change))
}

fn transform(motion: &Motion, index: usize, magnification: f64) -> String {
    let [x, y, angle_deg] = placed(motion, index, motion.start, magnification);
    format!("translate({x:.4} {y:.4}) rotate({angle_deg:.5})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_magnification_is_a_round_number_that_shows_the_clearance() {
        assert_eq!(first_magnification(250.0, 0.5), 5.0);
        assert_eq!(first_magnification(250.0, 0.0), 1.0);
        assert_eq!(first_magnification(1.0, 10.0), 1.0);
        for diagonal_mm in [1.0, 130.0, 3700.0] {
            let pin = PIN_SHARE * diagonal_mm;
            let ring_mm = JOURNAL_PINS * pin + first_magnification(diagonal_mm, 1e-3) * 1e-3;
            assert!(ring_mm <= BLOCK_PINS[1] * pin, "the ring is higher than the block");
        }
    }
}
