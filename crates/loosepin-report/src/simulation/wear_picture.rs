//! Pictures of wear around pin and hole: of the bearing outwards, of the journal inwards.

use crate::charts::figure::Picture;
use loosepin_result::simulation::WornSurface;
use maud::{Markup, html};

/// Half the side of the picture, radii of bearing and journal, and the greatest depth, in units of the picture.
const HALF_SIDE: f64 = 1180.0;
const BEARING_RADIUS: f64 = 760.0;
const JOURNAL_RADIUS: f64 = 700.0;
const GREATEST: f64 = 360.0;

/// Radius of a surface in the picture, and its style.
pub(super) fn shape(surface: WornSurface) -> (f64, &'static str) {
    match surface {
        WornSurface::Bearing => (BEARING_RADIUS, "worn bearing"),
        WornSurface::Journal => (JOURNAL_RADIUS, "worn journal"),
    }
}

/// Depths are drawn so that the greatest one has its length in the picture.
pub(super) struct DepthScale {
    per_m: f64,
}

impl DepthScale {
    pub fn new(greatest_m: f64) -> Self {
        Self { per_m: if greatest_m > 0.0 { GREATEST / greatest_m } else { 0.0 } }
    }

    /// Radius of a surface in the picture where it is worn so deep.
    pub fn worn_radius(&self, surface: WornSurface, depth_m: f64) -> f64 {
        let sign = if surface == WornSurface::Bearing { 1.0 } else { -1.0 };
        shape(surface).0 + sign * depth_m * self.per_m
    }
}

/// The figure of a joint with its axes around `surfaces`, y upwards; `csv` holds its depths.
pub(super) fn depth_figure(
    name: String,
    (alternative, caption): (String, Markup),
    surfaces: &Markup,
    csv: &str,
) -> Markup {
    let drawn = html! {
        g transform="scale(1 -1)" {
            line.axis x1="-1120" x2="1120" y1="0" y2="0" {}
            line.axis y1="-1120" y2="1120" x1="0" x2="0" {}
            (surfaces)
        }
    };
    let view = [-HALF_SIDE, -HALF_SIDE, 2.0 * HALF_SIDE, 2.0 * HALF_SIDE];
    Picture { name, class: "polar", view, below: 0.0, alternative, drawn }.figure(caption, Some(csv))
}
