//! Contact stiffness of a pin in a hole and of a corner on a plane, and the speed up to which the contact laws hold.

use super::line::LinePair;

/// h = (1 - ν²)/E, 1/Pa, without 1/π.
///
/// \[SC16\] breaks off after eq. (9), whose printed form has no π: a definition of h with 1/π would make K wrong by π.
pub fn compliance_1_pa(youngs_modulus_pa: f64, poisson_ratio: f64) -> f64 {
    (1.0 - poisson_ratio * poisson_ratio) / youngs_modulus_pa
}

/// K = 4/(3(h_i + h_j)) · √(R_i R_j/(R_i - R_j)), N/m^1.5 (\[SC16\] eq. (9)), with R_j = R_i - c.
///
/// `compliances_1_pa` are h_i (bearing) and h_j (journal); the bearing radius R_i is held and the journal radius follows the
/// clearance, both in m.
pub fn cylinder_stiffness_n_m1_5(compliances_1_pa: [f64; 2], bearing_radius_m: f64, radial_clearance_m: f64) -> f64 {
    let journal_radius_m = bearing_radius_m - radial_clearance_m;
    let curvature_m = bearing_radius_m * journal_radius_m / radial_clearance_m;
    4.0 / (3.0 * (compliances_1_pa[0] + compliances_1_pa[1])) * curvature_m.sqrt() // eq. (9)
}

/// K = 4/(3(h_i + h_j)) · √ρ, N/m^1.5: Hertz' sphere of radius ρ, m, on a plane, K = 4/3 E* √ρ with 1/E* = h_i + h_j.
///
/// Eq. (9) of \[SC16\] is of a pin in a hole and means nothing for a corner; this choice is ours.
pub fn sphere_stiffness_n_m1_5(compliances_1_pa: [f64; 2], radius_m: f64) -> f64 {
    4.0 / (3.0 * (compliances_1_pa[0] + compliances_1_pa[1])) * radius_m.sqrt()
}

/// The parts that touch, as far as the stiffness of a contact of materials depends on them.
#[derive(Debug, Clone, Copy)]
pub enum TouchingParts {
    /// A pin in a hole.
    Pin {
        /// Radius R_i of the bearing, m.
        bearing_radius_m: f64,
        /// Radial clearance c, m.
        clearance_m: f64,
        /// Length L of the bearing, m, where it has one.
        bearing_length_m: Option<f64>,
    },
    /// A corner or a pin on a plane.
    OnPlane {
        /// Its radius ρ, m; `None` if it is not defined, as for flanks of teeth.
        radius_m: Option<f64>,
    },
}

impl TouchingParts {
    /// K of a point contact, N/m^1.5, with the compliances h_i and h_j, 1/Pa; `None` if the radius is not defined.
    pub fn stiffness_n_m1_5(&self, compliances_1_pa: [f64; 2]) -> Option<f64> {
        match *self {
            Self::Pin { bearing_radius_m, clearance_m, .. } => {
                Some(cylinder_stiffness_n_m1_5(compliances_1_pa, bearing_radius_m, clearance_m))
            }
            // For R_i without bounds eq. (9) comes to the same.
            Self::OnPlane { radius_m } => radius_m.map(|radius_m| sphere_stiffness_n_m1_5(compliances_1_pa, radius_m)),
        }
    }

    /// The pair of cylinders with these compliances, 1/Pa; `None` of other parts and of a bearing without a length.
    pub fn line_pair(&self, compliances_1_pa: [f64; 2]) -> Option<LinePair> {
        let Self::Pin { bearing_radius_m, clearance_m, bearing_length_m: Some(length_m) } = *self else { return None };
        Some(LinePair { bearing_radius_m, clearance_m, length_m, compliances_1_pa })
    }
}

/// Impact speed up to which Lankarani and Nikravesh's law is meant to hold: 1e-5 √(E/ρ), m/s (about 0.05 for steel).
pub fn largest_valid_impact_speed_m_s(youngs_modulus_pa: f64, density_kg_m3: f64) -> f64 {
    1e-5 * (youngs_modulus_pa / density_kg_m3).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_steel_pin() {
        let h = compliance_1_pa(207e9, 0.3);
        let k = cylinder_stiffness_n_m1_5([h, h], 0.010, 0.0005);
        // Eq. (9) by hand, to seven digits.
        assert!((k / 6.610198e10 - 1.0).abs() < 1e-7, "{k}");
        // c from 0.5 to 0.1 mm: √(5 · 9.9/9.5) = 2.28 times as stiff.
        let tight = cylinder_stiffness_n_m1_5([h, h], 0.010, 0.0001);
        assert!((tight / k - 2.28).abs() < 0.005);
    }

    #[test]
    fn analytic_rounded_corner_of_steel_on_steel() {
        let h = compliance_1_pa(207e9, 0.3);
        // E* = E/(2(1 - ν²)) = 113.736 GPa; 4/3 E* √(5 mm).
        let k = sphere_stiffness_n_m1_5([h, h], 0.005);
        assert!((k / 1.072316e10 - 1.0).abs() < 1e-5, "{k}");
    }

    #[test]
    fn analytic_validity_limit_of_steel() {
        let speed_m_s = largest_valid_impact_speed_m_s(207e9, 7800.0);
        assert!((speed_m_s - 0.0515).abs() < 1e-4);
    }
}
