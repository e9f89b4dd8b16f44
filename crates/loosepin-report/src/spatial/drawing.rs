//! The shapes of a picture in space.

use maud::{Markup, html};

use super::parts::PartKind;
use super::placed::{Placed, Surroundings};
use super::projection::Projection;

/// Places of coordinates: a hundred-thousandth of the picture.
pub(crate) fn places(size_mm: f64) -> usize {
    (5.0 - size_mm.log10().floor()).clamp(0.0, 12.0) as usize
}

/// Placed parts in their order, the farthest first. Lines have an edge in the colour of the ground, so that a nearer one parts a farther one where
/// they cross.
pub(crate) fn scene(placed: &[Placed<'_>], around: &Surroundings, projection: &Projection) -> Markup {
    let places = places(around.radius);
    html! {
        @for own in placed {
            @let level = around.level(own.depth, projection);
            @let class = format!("{} d{level}", own.part.class);
            @match own.part.kind {
                PartKind::Line => {
                    @let path = path(&own.points, false, places);
                    @if let Some(edge) = edge(&own.part.class) { path class=(edge) d=(path) {} }
                    path class=(class) d=(path) {}
                }
                PartKind::Face | PartKind::Hull => path class=(class) d=(path(&own.points, true, places)) {},
                PartKind::Solid => {
                    path class=(class) d=(path(&own.points, true, places)) {}
                    path class=(format!("{class} end")) d=(path(&own.rim, true, places)) {}
                }
                PartKind::Ball => {
                    @for [x, y] in &own.points {
                        circle class=(class) cx=(format!("{x:.places$}")) cy=(format!("{y:.places$}"))
                            r=(format!("{:.places$}", own.part.radius.unwrap_or_default())) {}
                    }
                }
            }
        }
    }
}

/// Class of the edge of a line, which parts those behind it. Axes, hatchings and paths have none: they hide nothing.
fn edge(class: &str) -> Option<&'static str> {
    match class.split(' ').next() {
        Some("axis" | "hatch" | "trace") => None,
        Some("bar") => Some("halo wide"),
        _ => Some("halo"),
    }
}

/// A path through points.
pub(crate) fn path(points: &[[f64; 2]], is_closed: bool, places: usize) -> String {
    let mut path = String::new();
    for (number, [x, y]) in points.iter().enumerate() {
        path.push_str(&format!("{}{x:.places$} {y:.places$}", if number == 0 { 'M' } else { 'L' }));
    }
    if is_closed {
        path.push('Z');
    }
    path
}
