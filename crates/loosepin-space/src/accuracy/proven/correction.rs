//! How far positions are from T v.

use super::forms::add_times;
use super::proof::{MAX_STEP, Proof, Straight};
use crate::enclosure::jet::pair;
use crate::enclosure::position_box::PlacedJet;
use loosepin_math::{Interval, Real};

/// Boxes that are tried before the proof is given up.
const MAX_BOXES: usize = 10;
/// How much larger than what they must hold they are made.
const INFLATION: f64 = 1.1;

/// Positions q = T v + z.
pub(super) struct Correction {
    /// |z| of each unknown is at most this.
    pub radii: Vec<f64>,
    over: Curved,
}

/// Rows and output over the box of all positions.
struct Curved {
    forms: Vec<PlacedJet>,
    /// C W of each.
    halves: Vec<Vec<Vec<Interval>>>,
    /// |C| Z of each, for each number that it depends on.
    bent: Vec<Vec<f64>>,
}

impl Proof<'_> {
    /// Shows that all positions lie near T v; `None` if that fails.
    pub(super) fn correction(&self, straight: &Straight) -> Option<Correction> {
        let n = self.ways.n;
        let steps = self.steps();
        let base: Vec<f64> = (0..n).map(|k| self.straight_residual(k, straight)).collect();
        let at_rest: Vec<Vec<f64>> = (0..n).map(|k| self.inverse_error(k)).collect();
        let mut tried: Vec<f64> = base.iter().map(|own| INFLATION * own + f64::MIN_POSITIVE).collect();
        for _ in 0..MAX_BOXES {
            if !tried.iter().zip(&steps).all(|(z, step)| z + step < MAX_STEP) {
                return None;
            }
            let over = self.curved(&steps, &tried);
            let radii: Vec<f64> = (0..n)
                .map(|k| {
                    let factors = &self.inverse[k * n..(k + 1) * n];
                    let bent = self.turned_by(&over, factors, &at_rest[k], &tried);
                    (Interval::from_f64(base[k]) + Interval::from_f64(bent)).high()
                })
                .collect();
            if radii.iter().zip(&tried).all(|(found, tried)| found < tried) {
                return Some(Correction { radii, over });
            }
            for (tried, found) in tried.iter_mut().zip(&radii) {
                *tried = tried.max(INFLATION * found + f64::MIN_POSITIVE);
            }
        }
        None
    }

    /// A number that |Y F(T v, v)| does not exceed, for one row of Y.
    fn straight_residual(&self, k: usize, straight: &Straight) -> f64 {
        let factors = &self.inverse[k * self.ways.n..(k + 1) * self.ways.n];
        let (mut value, mut gradient) = (Interval::ZERO, vec![Interval::ZERO; self.ways.nv]);
        for (factor, form) in factors.iter().zip(&self.at_rest) {
            value += *factor * form.jet.value;
            add_times(&mut gradient, *factor, &self.ways.gradient(form));
        }
        let curved = self.ways.quadratic_reach(&self.combined_hessian(straight, factors));
        let [value, linear, curved] = [value.magnitude(), self.ways.reach(&gradient), curved].map(Interval::from_f64);
        (value + linear + curved).high()
    }

    /// |1 - Y J| at the ideal position, for one row of Y: round-off.
    fn inverse_error(&self, k: usize) -> Vec<f64> {
        let n = self.ways.n;
        let mut error = vec![Interval::ZERO; n];
        error[k] = Interval::from_f64(1.0);
        for (row, form) in self.at_rest.iter().take(n).enumerate() {
            for (place, slope) in form.places.iter().zip(&form.jet.slopes).filter(|(place, _)| **place < n) {
                error[*place] -= self.inverse[k * n + row] * *slope;
            }
        }
        error.into_iter().map(Interval::magnitude).collect()
    }

    fn curved(&self, steps: &[f64], tried: &[f64]) -> Curved {
        let forms = self.over(steps.iter().zip(tried).map(|(step, z)| (step + z).next_up()), 1.0);
        let halves = forms.iter().map(|form| self.ways.half(form)).collect();
        let bent = forms.iter().map(|form| {
            let curve = |i: usize, j: usize| form.jet.curves.get(pair(i, j)).map_or(0.0, |curve| curve.magnitude());
            let row = |i: usize| {
                let places = form.places.iter().enumerate().filter(|(_, place)| **place < self.ways.n);
                let terms =
                    places.map(|(j, place)| Interval::from_f64(curve(i, j)) * Interval::from_f64(tried[*place]));
                terms.fold(Interval::ZERO, |sum, term| sum + term).high()
            };
            (0..form.places.len()).map(row).collect()
        });
        Curved { bent: bent.collect(), halves, forms }
    }

    /// A number that the change of a combination of rows (and output) by any |z| <= radii does not exceed, anywhere in the box: what its derivatives
    /// by the unknowns are at the ideal position, and by how much they turn with v and with z.
    fn turned_by(&self, over: &Curved, factors: &[Interval], at_rest: &[f64], radii: &[f64]) -> f64 {
        let (n, nv) = (self.ways.n, self.ways.nv);
        let mut along = vec![Interval::ZERO; n * nv];
        let mut bent: Vec<Interval> = at_rest.iter().map(|slope| Interval::from_f64(*slope)).collect();
        for (number, factor) in factors.iter().enumerate().filter(|(_, factor)| **factor != Interval::ZERO) {
            let places = over.forms[number].places.iter().zip(&over.halves[number]).zip(&over.bent[number]);
            for ((place, half), own) in places.filter(|((place, _), _)| **place < n) {
                add_times(&mut along[place * nv..(place + 1) * nv], *factor, half);
                bent[*place] += Interval::from_f64(factor.magnitude()) * Interval::from_f64(*own);
            }
        }
        // First all z, then v: in a ball the sum of the magnitudes is shorter than the sum of the lengths.
        let mut gradient = vec![Interval::ZERO; nv];
        let mut sum = Interval::ZERO;
        for k in 0..n {
            let radius = Interval::from_f64(radii[k]);
            sum += bent[k] * radius;
            let own = &along[k * nv..(k + 1) * nv];
            gradient.iter_mut().zip(own).for_each(|(sum, slope)| *sum += slope.abs() * radius);
        }
        (sum + Interval::from_f64(self.ways.reach(&gradient))).high()
    }

    /// A number that L(T v + z, v) - L(T v, v) does not exceed.
    pub(super) fn rest(&self, correction: &Correction, factors: &[Interval]) -> f64 {
        let mut at_rest = vec![Interval::ZERO; self.ways.n];
        for (factor, form) in factors.iter().zip(&self.at_rest) {
            for (place, slope) in form.places.iter().zip(&form.jet.slopes).filter(|(place, _)| **place < self.ways.n) {
                at_rest[*place] += *factor * *slope;
            }
        }
        let at_rest: Vec<f64> = at_rest.into_iter().map(Interval::magnitude).collect();
        self.turned_by(&correction.over, factors, &at_rest, &correction.radii)
    }
}
