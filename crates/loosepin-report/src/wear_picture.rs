//! Size and surfaces of the pictures of wear around pin and hole.

use loosepin_result::simulation::WornSurface;

/// Half the side of the picture, radii of bearing and journal, and the greatest depth, in units of the picture.
pub(super) const HALF_SIDE: f64 = 1180.0;
const BEARING_RADIUS: f64 = 760.0;
const JOURNAL_RADIUS: f64 = 700.0;
pub(super) const GREATEST: f64 = 360.0;

/// Radius of a surface in the picture, and its style.
pub(super) fn shape(surface: WornSurface) -> (f64, &'static str) {
    match surface {
        WornSurface::Bearing => (BEARING_RADIUS, "worn bearing"),
        WornSurface::Journal => (JOURNAL_RADIUS, "worn journal"),
    }
}
