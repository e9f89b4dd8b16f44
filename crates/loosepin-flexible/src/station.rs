//! The shapes at one place along a beam.

/// Values of an axial shape by its index and s: ψ and dψ/ds.
pub type AxialFunction<'f> = &'f dyn Fn(usize, f64) -> [f64; 2];
/// Values of a lateral shape by its index and s: φ/L, φ' and dφ'/ds.
pub type LateralFunction<'f> = &'f dyn Fn(usize, f64) -> [f64; 3];

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

/// `count` >= 2 shares of the length, evenly from root to tip.
pub fn even_shares(count: usize) -> Vec<f64> {
    (0..count).map(|place| place as f64 / (count - 1) as f64).collect()
}

impl Station {
    /// The shapes at `share`, from their number and their functions. H is integrated by a rule on 0 to `share`: places with their weights.
    pub(crate) fn at(
        share: f64,
        (axial_count, axial): (usize, AxialFunction<'_>),
        (lateral_count, lateral): (usize, LateralFunction<'_>),
        rule: impl Iterator<Item = [f64; 2]>,
    ) -> Self {
        let mut shortening = vec![0.0; lateral_count * lateral_count];
        for [s, weight] in rule {
            let slopes: Vec<f64> = (0..lateral_count).map(|i| lateral(i, s)[1]).collect();
            for (place, entry) in shortening.iter_mut().enumerate() {
                *entry += weight * slopes[place / lateral_count] * slopes[place % lateral_count];
            }
        }
        let values: Vec<[f64; 3]> = (0..lateral_count).map(|i| lateral(i, share)).collect();
        Self {
            share,
            axial: (0..axial_count).map(|k| axial(k, share)[0]).collect(),
            lateral: values.iter().map(|values| values[0]).collect(),
            slopes: values.iter().map(|values| values[1]).collect(),
            shortening,
        }
    }

    /// A place without shapes.
    pub(crate) fn bare(share: f64) -> Self {
        Self { share, axial: Vec::new(), lateral: Vec::new(), slopes: Vec::new(), shortening: Vec::new() }
    }

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
