//! Axes and ground of a picture in space.

use maud::{Markup, html};

use super::drawing::{path, places};
use super::placed::on_sheet;
use super::projection::Projection;
use crate::mechanism::shapes::Frame;

/// Length of the axes in letters.
pub(crate) const AXIS_LETTERS: f64 = 2.6;

/// The axes x, y and z of the ground at a place of the sheet, the farthest first.
pub(crate) fn triad(projection: &Projection, [x, y]: [f64; 2], font_mm: f64) -> Markup {
    let mut axes: Vec<(&str, [f64; 2], f64)> = ["x", "y", "z"]
        .into_iter()
        .enumerate()
        .map(|(number, letter)| {
            let (tip, depth) = on_sheet(projection, std::array::from_fn(|k| f64::from(u8::from(k == number))));
            (letter, tip, depth)
        })
        .collect();
    axes.sort_by(|a, b| a.2.total_cmp(&b.2));
    let digits = places(font_mm) + 1;
    let length = AXIS_LETTERS * font_mm;
    html! {
        @for (letter, [right, down], _) in axes {
            // An axis along the line of sight has no letter.
            @if right.hypot(down) > 0.1 {
                path.(letter) d=(path(&[[x, y], [x + length * right, y + length * down]], false, digits)) {}
                text text-anchor="middle" x=(format!("{:.digits$}", x + 1.32 * length * right))
                    y=(format!("{:.digits$}", y + 1.32 * length * down + 0.35 * font_mm)) { (letter) }
            }
        }
    }
}

/// The ground of the picture.
pub(crate) fn sheet(frame: &Frame) -> Markup {
    let [left, top, width, height] = [frame.left, frame.top, frame.width, frame.height].map(|own| format!("{own:.4}"));
    html! { rect.sheet x=(left) y=(top) width=(width) height=(height) {} }
}
