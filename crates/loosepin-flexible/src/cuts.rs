//! Cuts along a beam: what lies beyond each of them is summed up from the points of the mass.

use super::basis::Basis;
use super::legendre::legendre;
use super::shapes::Shapes;
use super::station::Station;

/// Places at which internal forces are summed up, and the integrals from each of them to the tip.
#[derive(Debug, Clone, PartialEq)]
pub struct Cuts {
    /// The shapes at the cuts.
    pub stations: Vec<Station>,
    /// The shapes at the points of the mass: Gauss points of [`Shapes::points`].
    pub points: Vec<Station>,
    /// Row by row for each cut, `∫_(s_k)^1 ℓ_g ds` with the polynomial `ℓ_g` that is one at the Gauss point g and zero at the others of its span: the sum
    /// over a row times the values of a function at the points is its integral from the cut to the tip.
    beyond: Vec<f64>,
}

impl Cuts {
    /// Cuts of a beam at `shares` of its length, ascending.
    pub fn new(basis: &Basis, shares: &[f64]) -> Self {
        let shapes = Shapes::of(basis, &[]);
        let spans = basis.spans();
        // The Legendre polynomials of the span of each point there.
        let mut first = 0;
        let at_points: Vec<(usize, Vec<f64>)> = spans
            .iter()
            .enumerate()
            .flat_map(|(index, span)| {
                let places = &shapes.points[first..first + span.points];
                first += span.points;
                places.iter().map(move |point| (index, legendre(span.local(point.station.share), span.points)))
            })
            .collect();
        let mut beyond = Vec::with_capacity(shares.len() * shapes.points.len());
        for share in shares {
            let at_cut: Vec<(f64, Vec<f64>)> = spans
                .iter()
                .map(|span| {
                    let z = span.local(*share).clamp(-1.0, 1.0);
                    (z, legendre(z, span.points + 1))
                })
                .collect();
            for (point, (span, values)) in shapes.points.iter().zip(&at_points) {
                // ℓ_g = w_g Σ (2j + 1) P_j(z_g) P_j, and (2j + 1) ∫_z^1 P_j = P_(j-1)(z) - P_(j+1)(z).
                let (z, of_cut) = &at_cut[*span];
                let order = spans[*span].points;
                let further = (1..order).map(|j| 0.5 * values[j] * (of_cut[j - 1] - of_cut[j + 1]));
                beyond.push(point.weight * (0.5 * (1.0 - z) + further.sum::<f64>()));
            }
        }
        Self {
            stations: basis.stations(shares),
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

#[cfg(test)]
mod tests {
    use super::Cuts;
    use crate::{Basis, Frame};

    #[test]
    fn analytic_integrals_from_a_cut_to_the_tip() {
        for (axial, lateral, count, inside) in
            [(0, 1, 5, &[][..]), (2, 2, 9, &[]), (8, 8, 65, &[]), (2, 2, 65, &[0.3, 0.77])]
        {
            let basis = Basis::new(Frame::Secant, [axial, lateral], inside);
            let shares: Vec<f64> = (0..count).map(|cut| f64::from(cut) / f64::from(count - 1)).collect();
            let cuts = Cuts::new(&basis, &shares);
            assert_eq!(cuts.stations.len(), shares.len());
            let least = basis.spans().iter().map(|span| span.points).min().unwrap_or(0);
            for (index, cut) in cuts.stations.iter().enumerate() {
                for degree in 0..=least as i32 - 1 {
                    let terms = cuts.beyond(index).iter().zip(&cuts.points);
                    let found: f64 = terms.map(|(weight, point)| weight * point.share.powi(degree)).sum();
                    let due = (1.0 - cut.share.powi(degree + 1)) / f64::from(degree + 1);
                    assert!((found - due).abs() < 1e-14, "s^{degree} from {}: {found} for {due}", cut.share);
                }
            }
        }
    }
}
