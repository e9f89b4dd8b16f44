//! Sizes and materials of a line contact of a cylinder in a cylinder.

/// A pin in a hole as line-contact laws see it.
#[derive(Debug, Clone, Copy)]
pub struct LinePair {
    /// Radius R_i of the bearing, m.
    pub bearing_radius_m: f64,
    /// Radial clearance c, m.
    pub clearance_m: f64,
    /// Length L of the bearing, m.
    pub length_m: f64,
    /// Compliances (1 - ν²)/E of bearing and journal, 1/Pa.
    pub compliances_1_pa: [f64; 2],
}

impl LinePair {
    /// Radius R_j = R_i - c of the journal, m.
    pub fn journal_radius_m(&self) -> f64 {
        self.bearing_radius_m - self.clearance_m
    }
    /// h = ((1 - ν_i²)/E_i + (1 - ν_j²)/E_j)/π, 1/Pa: with 1/π, as the line-contact laws have it.
    pub fn h_1_pa(&self) -> f64 {
        (self.compliances_1_pa[0] + self.compliances_1_pa[1]) / std::f64::consts::PI
    }
    /// E* = 1/(π h), Pa.
    pub fn equivalent_modulus_pa(&self) -> f64 {
        1.0 / (self.compliances_1_pa[0] + self.compliances_1_pa[1])
    }
}
