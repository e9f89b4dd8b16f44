//! Cuts along a beam: what lies beyond each of them is summed up from the points of the mass.

use super::functions::Frame;
use super::shapes::{Shapes, Station, stations};

/// Places at which internal forces are summed up, evenly from root to tip, and the integrals from each of them to the tip.
#[derive(Debug, Clone, PartialEq)]
pub struct Cuts {
    /// The shapes at the cuts.
    pub stations: Vec<Station>,
    /// The shapes at the points of the mass: Gauss points of [`Shapes::points`].
    pub points: Vec<Station>,
    /// Row by row for each cut, `∫_(s_k)^1 ℓ_g ds` with the polynomial `ℓ_g` that is one at the Gauss point g and zero at the others: the sum
    /// over a row times the values of a function at the points is its integral from the cut to the tip.
    beyond: Vec<f64>,
}

impl Cuts {
    /// `count` >= 2 cuts of a beam with the shapes of a frame.
    pub fn new(frame: Frame, axial_count: usize, lateral_count: usize, count: usize) -> Self {
        let shapes = Shapes::new(frame, axial_count, lateral_count);
        let shares: Vec<f64> = (0..count).map(|cut| cut as f64 / (count - 1) as f64).collect();
        let order = shapes.points.len();
        let at_points: Vec<Vec<f64>> =
            shapes.points.iter().map(|point| legendre(2.0 * point.station.share - 1.0, order)).collect();
        let mut beyond = Vec::with_capacity(count * order);
        for share in &shares {
            let z = 2.0 * share - 1.0;
            let at_cut = legendre(z, order + 1);
            for (point, values) in shapes.points.iter().zip(&at_points) {
                // ℓ_g = w_g Σ (2j + 1) P_j(z_g) P_j, and (2j + 1) ∫_z^1 P_j = P_(j-1)(z) - P_(j+1)(z).
                let further = (1..order).map(|j| 0.5 * values[j] * (at_cut[j - 1] - at_cut[j + 1]));
                beyond.push(point.weight * (0.5 * (1.0 - z) + further.sum::<f64>()));
            }
        }
        Self {
            stations: stations(frame, axial_count, lateral_count, &shares),
            points: shapes.points.into_iter().map(|point| point.station).collect(),
            beyond,
        }
    }

    /// The weights of the points of the mass in the integral from a cut to the tip.
    pub fn beyond(&self, cut: usize) -> &[f64] {
        let order = self.points.len();
        &self.beyond[cut * order..(cut + 1) * order]
    }
}

/// Legendre's polynomials P_0 to P_n at z.
fn legendre(z: f64, n: usize) -> Vec<f64> {
    let mut values = vec![1.0, z];
    for degree in 2..=n {
        let k = degree as f64;
        values.push(((2.0 * k - 1.0) * z * values[degree - 1] - (k - 1.0) * values[degree - 2]) / k);
    }
    values
}

#[cfg(test)]
mod tests {
    use super::Cuts;
    use crate::functions::Frame;

    #[test]
    fn analytic_integrals_from_a_cut_to_the_tip() {
        for (axial, lateral, count) in [(0, 1, 5), (2, 2, 9), (8, 8, 65)] {
            let cuts = Cuts::new(Frame::Secant, axial, lateral, count);
            assert_eq!(cuts.stations.len(), count);
            for (index, cut) in cuts.stations.iter().enumerate() {
                for degree in 0..=cuts.points.len() as i32 - 1 {
                    let terms = cuts.beyond(index).iter().zip(&cuts.points);
                    let found: f64 = terms.map(|(weight, point)| weight * point.share.powi(degree)).sum();
                    let due = (1.0 - cut.share.powi(degree + 1)) / f64::from(degree + 1);
                    assert!((found - due).abs() < 1e-14, "s^{degree} from {}: {found} for {due}", cut.share);
                }
            }
        }
    }
}
