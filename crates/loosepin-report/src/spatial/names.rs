//! Names of joints beside them.

use maud::{Markup, html};

use super::drawing::places;
use super::parts::round;
use super::placed::on_sheet;
use super::projection::Projection;
use super::signs::AXIS_LETTERS;
use crate::mechanism::shapes::{Frame, MM_PER_M};
use loosepin_result::spatial_picture::{PicturePose, PictureRole, SpatialPicture};
use serde::Serialize;
use std::f64::consts::TAU;

/// Distance of a name from the middle of its joint, in letters.
const AWAY_LETTERS: f64 = 1.7;
/// The same beside the arrow of a drive.
const AWAY_OF_DRIVE_LETTERS: f64 = 3.6;
/// Directions in which a name may stand.
const SIDES: usize = 8;
/// Positions that are looked at, at most.
const POSITIONS: usize = 24;
/// Joints that are closer than this share of the extent in all positions have one name.
const TOGETHER: f64 = 0.02;
/// How sharply a bar towards a name counts: exp(s cos) of the angle between both.
const SHARPNESS: f64 = 4.0;
/// The middle of the picture counts as such a share of a bar.
const MIDDLE_SHARE: f64 = 0.3;

/// The name of one joint, or of several at one place. Script data as it is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Name {
    pub text: String,
    pub body: usize,
    /// In the frame of the body, mm.
    pub at: [f64; 3],
    /// From the joint to the name on the sheet, in letters, y down.
    pub side: [f64; 2],
    pub anchor: &'static str,
    pub play: bool,
}

/// A joint on the sheet, over the turn.
struct Seen {
    text: String,
    body: usize,
    at_mm: [f64; 3],
    has_play: bool,
    is_driven: bool,
    places: Vec<[f64; 2]>,
}

/// Names of all joints, each on the side on which the fewest bars are over the turn, in this view; in the position `sample` none covers another
/// joint or name, nor the axes that stand at a place of the sheet, and all are inside its frame, where that can be.
pub(crate) fn names(
    picture: &SpatialPicture,
    sample: usize,
    projection: &Projection,
    (sheet, axes): (&Frame, [f64; 2]),
    font_mm: f64,
) -> Vec<Name> {
    let step = picture.poses.len().div_ceil(POSITIONS).max(1);
    let poses: Vec<&Vec<PicturePose>> = picture.poses.iter().step_by(step).collect();
    let places = |body: usize, at_mm: [f64; 3]| -> Vec<[f64; 2]> {
        poses.iter().map(|poses| on_sheet(projection, in_ground(poses, body, at_mm)).0).collect()
    };
    let arrows = || picture.elements.iter().filter(|element| element.role == PictureRole::Drive);
    let is_driven = |joint: &str| arrows().any(|arrow| arrow.of == joint);
    let together_mm = TOGETHER * picture.extent_m * MM_PER_M;
    let mut seen: Vec<Seen> = Vec::new();
    for joint in &picture.joints {
        let at_mm = joint.sign_at_m.map(|own| own * MM_PER_M);
        let own = places(joint.sign_body, at_mm);
        let is_at = |other: &&mut Seen| other.places.iter().zip(&own).all(|(a, b)| distance(*a, *b) < together_mm);
        if let Some(other) = seen.iter_mut().find(is_at) {
            other.text = format!("{}, {}", other.text, joint.name);
            other.has_play |= joint.has_play;
            other.is_driven |= is_driven(&joint.name);
        } else {
            let (text, has_play) = (joint.name.clone(), joint.has_play);
            let is_driven = is_driven(&text);
            seen.push(Seen { text, body: joint.sign_body, at_mm, has_play, is_driven, places: own });
        }
    }
    // Ends of bars, to which others come: those of all joints on moving bodies.
    let ends = picture.joints.iter().flat_map(|joint| joint.ends.iter().map(|end| (end.body, end.at_m)));
    let ends: Vec<(usize, Vec<[f64; 2]>)> = ends
        .filter(|(body, _)| *body != 0)
        .map(|(body, at_m)| (body, places(body, at_m.map(|own| own * MM_PER_M))))
        .collect();
    let middle = mean(seen.iter().flat_map(|own| &own.places));
    let poses_first = picture.poses.get(sample);
    let first = |own: &Seen| poses_first.map(|poses| on_sheet(projection, in_ground(poses, own.body, own.at_mm)).0);
    let joints: Vec<[f64; 2]> = seen.iter().filter_map(first).collect();
    let mut taken = vec![Box2 { middle: axes, half: [1.5 * AXIS_LETTERS * font_mm; 2] }];
    seen.iter()
        .map(|own| {
            // Bodies of which a point is here.
            let is_here =
                |other: &[[f64; 2]]| other.iter().zip(&own.places).all(|(a, b)| distance(*a, *b) < together_mm);
            let bodies: Vec<usize> = ends.iter().filter(|(_, other)| is_here(other)).map(|(body, _)| *body).collect();
            let bars = ends.iter().filter(|(body, other)| bodies.contains(body) && !is_here(other));
            let bars: Vec<&Vec<[f64; 2]>> = bars.map(|(_, other)| other).collect();
            let crowd = |side: [f64; 2]| {
                let of = |(sample, from): (usize, &[f64; 2])| {
                    let bars = bars.iter().filter_map(|bar| bar.get(sample));
                    bars.map(|to| crowding(*from, *to, side)).sum::<f64>()
                        + MIDDLE_SHARE * crowding(*from, middle, side)
                };
                own.places.iter().enumerate().map(of).sum::<f64>()
            };
            let away = if own.is_driven { AWAY_OF_DRIVE_LETTERS } else { AWAY_LETTERS };
            let box_at = |side: [f64; 2]| first(own).map(|at| Box2::of(at, side, away, &own.text, font_mm));
            let covered = |side: [f64; 2]| {
                let own_box = box_at(side);
                let of_joints =
                    joints.iter().filter(|joint| own_box.is_some_and(|own| own.has(**joint, JOINT_LETTERS * font_mm)));
                let is_outside = own_box.is_some_and(|own| !own.is_in(sheet));
                usize::from(is_outside)
                    + of_joints.count()
                    + taken.iter().filter(|other| own_box.is_some_and(|own| own.meets(other))).count()
            };
            let side = (0..SIDES)
                .map(direction)
                .min_by(|a, b| covered(*a).cmp(&covered(*b)).then(crowd(*a).total_cmp(&crowd(*b))))
                .unwrap_or([0.0, -1.0]);
            taken.extend(box_at(side));
            Name {
                text: own.text.clone(),
                body: own.body,
                at: own.at_mm.map(round),
                side: [away * side[0], away * side[1] + 0.35].map(round),
                anchor: anchor(side),
                play: own.has_play,
            }
        })
        .collect()
}

/// Width of a letter, half the height of a line, and the radius of a joint's sign, in letters.
const LETTER_WIDTH: f64 = 0.56;
const HALF_LINE: f64 = 0.55;
const JOINT_LETTERS: f64 = 0.7;

/// Which end of a name on this side is next to its joint.
fn anchor(side: [f64; 2]) -> &'static str {
    match side[0] {
        across if across > 0.4 => "start",
        across if across < -0.4 => "end",
        _ => "middle",
    }
}

/// The room of a name: its middle, and half its sides.
#[derive(Debug, Clone, Copy)]
struct Box2 {
    middle: [f64; 2],
    half: [f64; 2],
}

impl Box2 {
    fn of(at: [f64; 2], side: [f64; 2], away: f64, text: &str, font_mm: f64) -> Self {
        let half = [0.5 * LETTER_WIDTH * text.chars().count() as f64 * font_mm, HALF_LINE * font_mm];
        let beside = match anchor(side) {
            "start" => half[0],
            "end" => -half[0],
            _ => 0.0,
        };
        Self { middle: [at[0] + away * side[0] * font_mm + beside, at[1] + away * side[1] * font_mm], half }
    }

    fn is_in(&self, sheet: &Frame) -> bool {
        let [x, y] = self.middle;
        let [width, height] = self.half;
        x - width > sheet.left
            && x + width < sheet.left + sheet.width
            && y - height > sheet.top
            && y + height < sheet.top + sheet.height
    }

    fn has(&self, point: [f64; 2], radius: f64) -> bool {
        (0..2).all(|k| (point[k] - self.middle[k]).abs() < self.half[k] + radius)
    }

    fn meets(&self, other: &Self) -> bool {
        (0..2).all(|k| (other.middle[k] - self.middle[k]).abs() < self.half[k] + other.half[k])
    }
}

fn direction(number: usize) -> [f64; 2] {
    let angle = TAU * number as f64 / SIDES as f64;
    [libm::cos(angle), libm::sin(angle)]
}

/// How much what goes from one place to another is in the way of a name on this side.
fn crowding(from: [f64; 2], to: [f64; 2], side: [f64; 2]) -> f64 {
    let length = distance(from, to);
    if length == 0.0 {
        return 0.0;
    }
    libm::exp(SHARPNESS * ((to[0] - from[0]) * side[0] + (to[1] - from[1]) * side[1]) / length)
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn mean<'a>(points: impl Iterator<Item = &'a [f64; 2]>) -> [f64; 2] {
    let (sum, count) = points.fold(([0.0; 2], 0.0), |([x, y], count), own| ([x + own[0], y + own[1]], count + 1.0));
    sum.map(|own| own / f64::max(count, 1.0))
}

fn in_ground(poses: &[PicturePose], body: usize, at_mm: [f64; 3]) -> [f64; 3] {
    let pose = poses.get(body).copied().unwrap_or(PicturePose::GROUND);
    PicturePose { at_m: pose.at_m.map(|own| own * MM_PER_M), ..pose }.point_m(at_mm)
}

/// Width of a letter of a name that must stay inside, and the room between it and the edge of the sheet, in letters. `scripts/space.ts` has them too.
const WIDEST_LETTER: f64 = 0.62;
const EDGE_LETTERS: f64 = 0.4;

/// The place of a text that would be cut by the edge of the sheet, moved so far that it is not.
fn inside([x, y]: [f64; 2], name: &Name, sheet: &Frame, font_mm: f64) -> [f64; 2] {
    let edge = EDGE_LETTERS * font_mm;
    let width = WIDEST_LETTER * name.text.chars().count() as f64 * font_mm;
    let before = match name.anchor {
        "start" => 0.0,
        "end" => width,
        _ => 0.5 * width,
    };
    let [least, most] = [sheet.left + edge + before, sheet.left + sheet.width - edge - width + before];
    let [top, bottom] = [sheet.top + edge + font_mm, sheet.top + sheet.height - edge - 0.3 * font_mm];
    [x.min(most).max(least), y.min(bottom).max(top)]
}

/// Names beside their joints, inside the sheet. `scripts/space-scene.ts` and `scripts/space.ts` do the same.
pub(crate) fn drawn_names(
    names: &[Name],
    poses: &[PicturePose],
    projection: &Projection,
    (sheet, font_mm): (&Frame, f64),
) -> Markup {
    let digits = places(font_mm) + 1;
    html! {
        @for name in names {
            @let [x, y] = on_sheet(projection, in_ground(poses, name.body, name.at)).0;
            @let [x, y] = inside([x + name.side[0] * font_mm, y + name.side[1] * font_mm], name, sheet, font_mm);
            text class=[name.play.then_some("with-play")] text-anchor=(name.anchor)
                x=(format!("{x:.digits$}")) y=(format!("{y:.digits$}")) { (name.text) }
        }
    }
}
