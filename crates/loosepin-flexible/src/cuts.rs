//! Cuts along a beam: what lies beyond each of them is summed up from the points of the mass.

use super::basis::{Basis, Span};
use super::legendre::legendre;
use super::shapes::Shapes;
use super::station::Station;
use loosepin_math::legendre_rule;

/// Points of the mass in an element in absolute nodal coordinates: couples of its inertia are of the sixth degree.
const POINTS_OF_ELEMENT: usize = 4;

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
        let points = Shapes::of(basis, &[]).points.into_iter().map(|point| (point.station, point.weight)).collect();
        Self::of_spans(&basis.spans(), basis.stations(shares), points)
    }

    /// Cuts of a beam of `elements` elements in absolute nodal coordinates at `shares` of its length, ascending. The stations have no
    /// shapes.
    pub fn of_elements(elements: usize, shares: &[f64]) -> Self {
        let length = 1.0 / elements as f64;
        let span = |element: usize| Span {
            start: element as f64 * length,
            end: (element + 1) as f64 * length,
            points: POINTS_OF_ELEMENT,
        };
        let spans: Vec<Span> = (0..elements).map(span).collect();
        let rule = legendre_rule(POINTS_OF_ELEMENT);
        let of_span = |span: &Span| {
            let start = span.start;
            let place =
                move |(t, weight): &(f64, f64)| (Station::bare(start + 0.5 * (1.0 + t) * length), weight * length);
            rule.iter().map(place).collect::<Vec<_>>()
        };
        let points = spans.iter().flat_map(of_span).collect();
        Self::of_spans(&spans, shares.iter().map(|share| Station::bare(*share)).collect(), points)
    }

    /// Cuts at `stations`, with points of Gauss on the spans and their weights.
    fn of_spans(spans: &[Span], stations: Vec<Station>, points: Vec<(Station, f64)>) -> Self {
        // The Legendre polynomials of the span of each point there.
        let mut first = 0;
        let at_points: Vec<(usize, Vec<f64>)> = spans
            .iter()
            .enumerate()
            .flat_map(|(index, span)| {
                let places = &points[first..first + span.points];
                first += span.points;
                places.iter().map(move |(point, _)| (index, legendre(span.local(point.share), span.points)))
            })
            .collect();
        let mut beyond = Vec::with_capacity(stations.len() * points.len());
        for station in &stations {
            let at_cut: Vec<(f64, Vec<f64>)> = spans
                .iter()
                .map(|span| {
                    let z = span.local(station.share).clamp(-1.0, 1.0);
                    (z, legendre(z, span.points + 1))
                })
                .collect();
            for ((_, weight), (span, values)) in points.iter().zip(&at_points) {
                // ℓ_g = w_g Σ (2j + 1) P_j(z_g) P_j, and (2j + 1) ∫_z^1 P_j = P_(j-1)(z) - P_(j+1)(z).
                let (z, of_cut) = &at_cut[*span];
                let order = spans[*span].points;
                let further = (1..order).map(|j| 0.5 * values[j] * (of_cut[j - 1] - of_cut[j + 1]));
                beyond.push(weight * (0.5 * (1.0 - z) + further.sum::<f64>()));
            }
        }
        Self { stations, points: points.into_iter().map(|(station, _)| station).collect(), beyond }
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

    /// Powers below the number of points of a span are integrated exactly from each cut to the tip.
    fn demand(cuts: &Cuts, least: usize) {
        for (index, cut) in cuts.stations.iter().enumerate() {
            for degree in 0..=least as i32 - 1 {
                let terms = cuts.beyond(index).iter().zip(&cuts.points);
                let found: f64 = terms.map(|(weight, point)| weight * point.share.powi(degree)).sum();
                let due = (1.0 - cut.share.powi(degree + 1)) / f64::from(degree + 1);
                assert!((found - due).abs() < 1e-14, "s^{degree} from {}: {found} for {due}", cut.share);
            }
        }
    }

    fn even(count: i32) -> Vec<f64> {
        (0..count).map(|cut| f64::from(cut) / f64::from(count - 1)).collect()
    }

    #[test]
    fn analytic_integrals_from_a_cut_to_the_tip() {
        for (axial, lateral, count, inside) in
            [(0, 1, 5, &[][..]), (2, 2, 9, &[]), (8, 8, 65, &[]), (2, 2, 65, &[0.3, 0.77])]
        {
            let basis = Basis::new(Frame::Secant, [axial, lateral], inside);
            let cuts = Cuts::new(&basis, &even(count));
            assert_eq!(cuts.stations.len(), count as usize);
            demand(&cuts, basis.spans().iter().map(|span| span.points).min().unwrap_or(0));
        }
    }

    #[test]
    fn analytic_integrals_over_elements_from_a_cut_to_the_tip() {
        for elements in [1, 3, 16] {
            let cuts = Cuts::of_elements(elements, &even(65));
            assert_eq!((cuts.stations.len(), cuts.points.len()), (65, 4 * elements));
            demand(&cuts, 4);
        }
    }
}
