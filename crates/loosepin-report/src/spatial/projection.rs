//! Orthographic views.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// sin of the elevation of an isometric view, 1/√3.
const ISOMETRIC_ELEVATION_RAD: f64 = 0.615_479_708_670_387_3;

/// A view by two angles: from the front, along y, turned about z by the azimuth φ and then raised by the elevation ε.
///
/// ```text
/// right  = (cos φ, sin φ, 0)
/// up     = (-sin φ sin ε, cos φ sin ε, cos ε)
/// toward = (sin φ cos ε, -cos φ cos ε, sin ε)      right × up = toward, the direction to the reader
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Projection {
    pub azimuth_rad: f64,
    pub elevation_rad: f64,
}

impl Projection {
    /// x to the right, z up.
    pub const FRONT: Self = Self { azimuth_rad: 0.0, elevation_rad: 0.0 };
    /// y to the right, z up, from the side of positive x.
    pub const SIDE: Self = Self { azimuth_rad: FRAC_PI_2, elevation_rad: 0.0 };
    /// x to the right, y up.
    pub const TOP: Self = Self { azimuth_rad: 0.0, elevation_rad: FRAC_PI_2 };
    /// All three axes foreshortened alike: towards (1, -1, 1).
    pub const ISOMETRIC: Self = Self { azimuth_rad: FRAC_PI_4, elevation_rad: ISOMETRIC_ELEVATION_RAD };

    /// The directions right, up and toward the reader.
    pub fn axes(&self) -> [[f64; 3]; 3] {
        let (sine, cosine) = sin_cos(self.azimuth_rad);
        let (rise, level) = sin_cos(self.elevation_rad);
        [[cosine, sine, 0.0], [-sine * rise, cosine * rise, level], [sine * level, -cosine * level, rise]]
    }

    /// A point as (right, up, depth); what has more depth is nearer to the reader.
    pub fn project(&self, point: [f64; 3]) -> [f64; 3] {
        self.axes().map(|axis| axis.iter().zip(point).map(|(a, b)| a * b).sum())
    }
}

/// Exact at right angles, so that standard views have no round-off.
fn sin_cos(angle_rad: f64) -> (f64, f64) {
    if angle_rad == FRAC_PI_2 { (1.0, 0.0) } else { (libm::sin(angle_rad), libm::cos(angle_rad)) }
}

#[cfg(test)]
mod tests {
    use super::Projection;

    #[test]
    fn analytic_standard_views_show_two_coordinates() {
        let point = [0.3, -0.7, 1.1];
        assert_eq!(Projection::FRONT.project(point), [0.3, 1.1, 0.7]);
        assert_eq!(Projection::SIDE.project(point), [-0.7, 1.1, 0.3]);
        assert_eq!(Projection::TOP.project(point), [0.3, -0.7, 1.1]);
    }

    #[test]
    fn analytic_the_isometric_view_foreshortens_all_axes_alike() {
        // √(2/3); their products are those of the identity less n nᵀ, n = (1, -1, 1)/√3.
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let flat = axes.map(|axis| Projection::ISOMETRIC.project(axis));
        for [x, y, _] in flat {
            assert!((x.hypot(y) - (2.0_f64 / 3.0).sqrt()).abs() < 1e-15, "{x} {y}");
        }
        for (a, b, due) in [(0, 1, 1.0 / 3.0), (1, 2, 1.0 / 3.0), (2, 0, -1.0 / 3.0)] {
            let product = flat[a][0] * flat[b][0] + flat[a][1] * flat[b][1];
            assert!((product - due).abs() < 1e-15, "{product} {due}");
        }
        let [right, up, toward] = Projection { azimuth_rad: 0.8, elevation_rad: -0.3 }.axes();
        let cross = [
            right[1] * up[2] - right[2] * up[1],
            right[2] * up[0] - right[0] * up[2],
            right[0] * up[1] - right[1] * up[0],
        ];
        assert!(cross.iter().zip(toward).all(|(a, b)| (a - b).abs() < 1e-15));
    }
}
