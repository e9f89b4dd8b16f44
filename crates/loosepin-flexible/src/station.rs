//! The shapes at one place along a beam.

/// Numbers that are round-off of a zero at an end of the beam or at a point.
const ROUND_OFF: f64 = 1e-12;

/// The shapes at one place along the beam, s = x/L.
#[derive(Debug, Clone, PartialEq)]
pub struct Station {
    /// s.
    pub share: f64,
    /// ψ of the axial shapes.
    pub axial: Vec<f64>,
    /// φ/L of the lateral shapes.
    pub lateral: Vec<f64>,
    /// φ' = dφ/dx of the lateral shapes.
    pub slopes: Vec<f64>,
    /// H/L of (F1), ∫₀ˢ φ_i' φ_j' ds, row by row.
    pub shortening: Vec<f64>,
}

impl Station {
    /// The same with zeros and ones where they are off by round-off.
    pub(crate) fn cleaned(mut self) -> Self {
        for values in [&mut self.axial, &mut self.lateral, &mut self.slopes, &mut self.shortening] {
            for value in values.iter_mut() {
                if (*value - value.round()).abs() < ROUND_OFF {
                    *value = value.round() + 0.0;
                }
            }
        }
        self
    }
}
