//! Front, side and top on one sheet, to one scale: the top above the front, the side to its right.

use maud::{Markup, html};

use super::drawing::scene;
use super::parts::{Part, parts};
use super::placed::{Surroundings, placed};
use super::projection::Projection;
use super::signs::{AXIS_LETTERS, sheet, triad};
use crate::charts::figure::Picture;
use crate::mechanism::shapes::Frame;
use crate::mechanism::signs::scale;
use loosepin_result::motion::MotionRecord;
use loosepin_result::spatial_picture::PicturePose;

/// Name of the figure.
const NAME: &str = "views";
/// Size of the letters, over the width of the sheet.
const FONT_SHARE: f64 = 0.0165;
/// Room around a view in letters: on its sides and above, with its name; and below, with its axes.
const SIDE_LETTERS: f64 = 1.5;
const ABOVE_LETTERS: f64 = 3.0;
const BELOW_LETTERS: f64 = AXIS_LETTERS + 2.4;

/// Room for the scale beside the top view, as a share of its width, at least.
const SCALE_SHARE: f64 = 0.4;

/// The least and the largest place of what is drawn, in all positions.
fn range(parts: &[Part], poses: &[Vec<PicturePose>], projection: &Projection, around: &Surroundings) -> [[f64; 2]; 2] {
    let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for own in poses.iter().flat_map(|poses| placed(parts, poses, projection, around)) {
        let radius = own.part.radius.unwrap_or(0.0);
        for point in &own.points {
            for k in 0..2 {
                range[k] = [range[k][0].min(point[k] - radius), range[k][1].max(point[k] + radius)];
            }
        }
    }
    range
}

/// The three views in the position `sample`; nothing where the record has no poses.
pub(crate) fn views_figure(record: &MotionRecord, sample: usize, at: &str) -> Markup {
    let own = &record.picture;
    let Some(poses) = own.poses.get(sample) else { return html! {} };
    let (parts, magnification) = parts(own);
    let around = Surroundings::of(&parts, &own.poses);
    // Views line up: each coordinate has its own range.
    let [across, up] = range(&parts, &own.poses, &Projection::FRONT, &around);
    let [deep, _] = range(&parts, &own.poses, &Projection::SIDE, &around);
    let [width, depth, height] = [across, deep, up].map(|[low, high]| high - low);
    // The sheet is wider than the views by four margins.
    // Above the side view stands the scale.
    let right = depth.max(SCALE_SHARE * width);
    let font_mm = FONT_SHARE * (width + right) / (1.0 - 4.0 * SIDE_LETTERS * FONT_SHARE);
    let (beside, above, below) = (SIDE_LETTERS * font_mm, ABOVE_LETTERS * font_mm, BELOW_LETTERS * font_mm);
    let [first, second] = [beside, width + 3.0 * beside];
    let [upper, lower] = [above, depth + 2.0 * above + below];
    let frame = Frame { left: 0.0, top: 0.0, width: width + right + 4.0 * beside, height: lower + height + below };
    // Ranges point down: that of the depth is up in the top view.
    let views = [
        ("top, x–y", Projection::TOP, [first - across[0], upper + deep[1]], [first, upper + depth]),
        ("front, x–z", Projection::FRONT, [first - across[0], lower - up[0]], [first, lower + height]),
        ("side, y–z", Projection::SIDE, [second - deep[0], lower - up[0]], [second, lower + height]),
    ];
    let drawn = html! {
        (sheet(&frame))
        @for (_, projection, [x, y], _) in &views {
            g transform=(format!("translate({x:.4} {y:.4})")) { (scene(&placed(&parts, poses, projection, &around), &around, projection)) }
        }
        g.signs style=(format!("font-size: {font_mm:.4}px")) {
            @for (words, projection, _, [left, bottom]) in &views {
                @let top = if *projection == Projection::TOP { upper } else { lower };
                text.view-name x=(format!("{left:.4}")) y=(format!("{:.4}", top - 0.8 * font_mm)) { (words) }
                g.triad { (triad(projection, [left + 0.4 * font_mm, bottom + below - 1.7 * font_mm], font_mm)) }
            }
            g transform=(format!("translate({:.4} {:.4})", second - 0.8 * font_mm, -below)) {
                (scale(&Frame { left: 0.0, top: 0.0, width: right + 2.0 * beside, height: lower - above + font_mm }, font_mm, None))
            }
        }
    };
    let alternative = format!("Front, side and top view of the mechanism {} at {at}, to one scale.", record.model);
    let view = [frame.left, frame.top, frame.width, frame.height];
    let picture = Picture { name: NAME.to_owned(), class: "space", view, below: 0.0, alternative, drawn };
    picture.figure(
        html! {
            strong { "Three views at " (at) "." } " Front, top above it and side to the right of it, to one scale."
            @if let Some(magnification) = magnification { " Zones of play are magnified " (magnification) " times." }
        },
        None,
    )
}
