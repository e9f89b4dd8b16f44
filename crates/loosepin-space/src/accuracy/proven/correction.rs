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
    /// Z: half the box in which they were sought.
    tried: Vec<f64>,
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
                    let slopes = self.slopes(&over, factors);
                    let terms = (0..n).map(|l| {
                        let slope = Interval::from_f64(at_rest[k][l]) + Interval::from_f64(slopes[l]);
                        slope * Interval::from_f64(tried[l])
                    });
                    terms.fold(Interval::from_f64(base[k]), |sum, term| sum + term).high()
                })
                .collect();
            if radii.iter().zip(&tried).all(|(found, tried)| found < tried) {
                return Some(Correction { radii, tried, over });
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

    /// By how much the derivatives of a combination of rows (and output) by each unknown differ from those at the ideal position, at most.
    fn slopes(&self, over: &Curved, factors: &[Interval]) -> Vec<f64> {
        let (n, nv) = (self.ways.n, self.ways.nv);
        let mut along = vec![Interval::ZERO; n * nv];
        let mut bent = vec![Interval::ZERO; n];
        for (number, factor) in factors.iter().enumerate().filter(|(_, factor)| **factor != Interval::ZERO) {
            let places = over.forms[number].places.iter().zip(&over.halves[number]).zip(&over.bent[number]);
            for ((place, half), own) in places.filter(|((place, _), _)| **place < n) {
                add_times(&mut along[place * nv..(place + 1) * nv], *factor, half);
                bent[*place] += Interval::from_f64(factor.magnitude()) * Interval::from_f64(*own);
            }
        }
        let each = along.chunks(nv.max(1)).map(|own| self.ways.reach(own)).chain(core::iter::repeat(0.0));
        each.zip(bent).map(|(along, bent)| (Interval::from_f64(along) + bent).high()).collect()
    }

    /// A number that L(T v + z, v) - L(T v, v) does not exceed.
    pub(super) fn rest(&self, correction: &Correction, factors: &[Interval]) -> f64 {
        let n = self.ways.n;
        let mut at_rest = vec![Interval::ZERO; n];
        for (factor, form) in factors.iter().zip(&self.at_rest) {
            for (place, slope) in form.places.iter().zip(&form.jet.slopes).filter(|(place, _)| **place < n) {
                at_rest[*place] += *factor * *slope;
            }
        }
        let slopes = self.slopes(&correction.over, factors);
        let terms = (0..n).map(|k| {
            let slope = Interval::from_f64(at_rest[k].magnitude()) + Interval::from_f64(slopes[k]);
            slope * Interval::from_f64(correction.radii[k])
        });
        debug_assert_eq!(correction.tried.len(), n);
        terms.fold(Interval::ZERO, |sum, term| sum + term).high()
    }
}
