//! Johnson 1985.

use super::law::LineLaw;
use super::logarithmic::logarithmic_law;
use crate::contact::point::DEFAULT_LAW;

/// Johnson 1985: δ = f h (ln(4c/(f h)) - 1), f = F/L; no inverse beyond δ = 0.5413 c.
pub(super) const JOHNSON: LineLaw = LineLaw {
    name: "johnson",
    source: "Johnson 1985: δ = f h (ln(4c/(f h)) - 1), f = F/L, h with 1/π; inverted up to δ = 0.5413 c",
    default_damping: DEFAULT_LAW,
    fitted_clearances_m: None,
    contact: |pair, damping_factor| {
        // ln(4c/s) - 1 = ln(4c/(e s))
        let scale_m = 4.0 * pair.clearance_m / std::f64::consts::E;
        logarithmic_law(pair, scale_m, damping_factor)
    },
};

#[cfg(test)]
mod tests {
    use super::JOHNSON;
    use crate::contact::line::esdu::ESDU_78035;
    use crate::contact::line::static_table::assert_static_forces;
    use crate::contact::{LinePair, NormalContact};

    /// Why this is the law of long pins where none is named. In plane strain the centre of a pin comes nearer to its surface by
    /// f (1 - ν²)/(π E) (2 ln(4R/a) - 1) (Johnson 1985, eq. (5.57)), and a hole's surface to a point at the depth d by
    /// f (1 - ν²)/(π E) (2 ln(2d/a) - ν/(1 - ν)) (eq. (5.56)), a² = 4 f R_i R_j/(c π E*). With d = 2R, the far side of an eye whose wall
    /// is as thick as the pin, that is this law but for a constant in the bracket; ESDU's supposes a housing that reaches eleven radii.
    #[test]
    fn analytic_the_law_of_a_pin_in_an_eye_in_plane_strain() {
        /// -1 in place of -(1 + ν/(1 - ν))/2 = -0.71 in a bracket of four to six: the tolerance of the comparison, and the gap to the other law.
        const SAME: f64 = 0.09;
        const OTHER: f64 = 0.15;
        let (modulus_pa, ratio) = (207e9, 0.3);
        let compliance_1_pa = (1.0 - ratio * ratio) / modulus_pa;
        let compliances_1_pa = [compliance_1_pa; 2];
        let pair = LinePair { bearing_radius_m: 0.020, clearance_m: 1e-4, length_m: 0.040, compliances_1_pa };
        for depth_m in [1e-6, 3e-6, 1e-5] {
            let gap = |law: &crate::contact::LineLaw| {
                let force_n_m = (law.contact)(&pair, 0.0).elastic_n(depth_m) / pair.length_m;
                let radii_m = [pair.bearing_radius_m, pair.journal_radius_m()];
                let half_width_m = (4.0 * force_n_m * radii_m[0] * radii_m[1]
                    / (pair.clearance_m * std::f64::consts::PI * pair.equivalent_modulus_pa()))
                .sqrt();
                let part = force_n_m * compliance_1_pa / std::f64::consts::PI;
                let of_pin_m = part * (2.0 * (4.0 * radii_m[1] / half_width_m).ln() - 1.0);
                let of_hole_m = part * (2.0 * (4.0 * radii_m[0] / half_width_m).ln() - ratio / (1.0 - ratio));
                (of_pin_m + of_hole_m) / depth_m - 1.0
            };
            let (own, other) = (gap(&JOHNSON), gap(&ESDU_78035));
            assert!(own.abs() < SAME, "{depth_m}: {own}");
            assert!(other.abs() > OTHER, "{depth_m}: {other}");
        }
    }

    #[test]
    fn analytic_static_forces() {
        assert_static_forces(&JOHNSON, [0.8146, 11.700, 87.153], |pair, force_n| {
            let s = force_n / pair.length_m * pair.h_1_pa();
            s * ((4.0 * pair.clearance_m / s).ln() - 1.0)
        });
    }
}
