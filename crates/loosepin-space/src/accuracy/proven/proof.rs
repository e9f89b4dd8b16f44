//! Y, T and w, and the ends that come of them.

use super::forms::{Ways, add_times};
use crate::accuracy::play_set::PlaySet;
use crate::enclosure::enclosed_output::EnclosedOutput;
use crate::enclosure::jet::{Jet, pair};
use crate::enclosure::position_box::{BoxCentre, PlacedJet, PositionBox};
use crate::output::SpatialOutput;
use loosepin_math::{Interval, QuadraticOverBalls, Real, RealLu, SingularValues};

/// Parts into which the way along v is divided.
const SHARES: usize = 3;
/// Largest step at which a proof is tried, lengths over L and rad.
pub(super) const MAX_STEP: f64 = 0.7;

/// A position with what is computed there.
pub(super) struct Proof<'a> {
    pub centre: &'a BoxCentre<'a>,
    pub output: &'a SpatialOutput,
    idle: Vec<Vec<f64>>,
    pub ways: Ways,
    /// Y, row by row.
    pub inverse: Vec<Interval>,
    /// w.
    weights: Vec<Interval>,
    /// The rows, then the output, at the ideal position, with second derivatives.
    pub at_rest: Vec<PlacedJet>,
}

/// Second derivatives along the way T v.
pub(super) struct Straight {
    /// H̃ of each row, lower triangles; empty where linear.
    pub hessians: Vec<Vec<Interval>>,
}

impl<'a> Proof<'a> {
    /// `None` if J is singular, or there are more rows than unknowns.
    pub(super) fn new(centre: &'a BoxCentre<'a>, set: &PlaySet, output: &'a SpatialOutput) -> Option<Self> {
        let (n, nv) = (centre.loops.unknowns(), set.variables());
        let numbers = vec![Interval::ZERO; n + nv];
        let at = PositionBox { centre, numbers: &numbers, is_second_order: true, direction: None };
        let mut at_rest = at.rows();
        let idle = idle_motions(&at_rest, n)?;
        at_rest.extend(idle.iter().map(|motion| linear(motion)));
        if at_rest.len() != n {
            return None;
        }
        let mut lu = RealLu::new(n);
        for (row, form) in at_rest.iter().enumerate() {
            for (place, slope) in form.places.iter().zip(&form.jet.slopes).filter(|(place, _)| **place < n) {
                lu.matrix[row * n + place] = slope.middle();
            }
        }
        lu.factor();
        let mut inverse = vec![0.0; n * n];
        for column in 0..n {
            let mut unit = vec![0.0; n];
            unit[column] = 1.0;
            lu.solve(&mut unit);
            unit.iter().enumerate().for_each(|(row, entry)| inverse[row * n + column] = *entry);
        }
        if !inverse.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let mut unknowns = vec![0.0; n * nv];
        for (row, form) in at_rest.iter().enumerate() {
            for (place, slope) in form.places.iter().zip(&form.jet.slopes).filter(|(place, _)| **place >= n) {
                for k in 0..n {
                    unknowns[k * nv + place - n] -= inverse[k * n + row] * slope.middle();
                }
            }
        }
        let own: PlacedJet = output.enclosed(&at);
        let mut weights = vec![0.0; n];
        for (place, slope) in own.places.iter().zip(&own.jet.slopes).filter(|(place, _)| **place < n) {
            let row = &inverse[place * n..(place + 1) * n];
            weights.iter_mut().zip(row).for_each(|(sum, entry)| *sum += slope.middle() * entry);
        }
        at_rest.push(own);
        let [inverse, unknowns, weights] =
            [inverse, unknowns, weights].map(|own| own.into_iter().map(Interval::from_f64).collect::<Vec<_>>());
        let ways = Ways { n, nv, balls: set.blocks().iter().map(|block| block.range()).collect(), unknowns };
        Some(Self { centre, output, idle, ways, inverse, weights, at_rest })
    }

    /// Largest |T v| of each unknown.
    pub(super) fn steps(&self) -> Vec<f64> {
        let rows = 0..self.ways.n;
        rows.map(|row| self.ways.reach(&self.ways.unknowns[row * self.ways.nv..(row + 1) * self.ways.nv])).collect()
    }

    /// Numbers with |q| <= radii, and a share of the play.
    pub(super) fn numbers(&self, radii: impl Iterator<Item = f64>, share: f64) -> Vec<Interval> {
        let play = core::iter::repeat_n(Interval::around_zero(share), self.ways.nv);
        radii.map(Interval::around_zero).chain(play).collect()
    }

    /// The rows, then the output, with second derivatives, over |q| <= radii and a share of the play.
    pub(super) fn over(&self, radii: impl Iterator<Item = f64>, share: f64) -> Vec<PlacedJet> {
        let numbers = self.numbers(radii, share);
        let at = PositionBox { centre: self.centre, numbers: &numbers, is_second_order: true, direction: None };
        let mut forms = at.rows();
        forms.extend(self.idle.iter().map(|motion| linear(motion)));
        forms.push(self.output.enclosed(&at));
        forms
    }

    /// Coefficients of L: those of the rows, then of the output.
    pub(super) fn combination(&self) -> Vec<Interval> {
        self.weights.iter().map(|weight| -*weight).chain([Interval::from_f64(1.0)]).collect()
    }

    /// A combination of lower triangles.
    pub(super) fn combined_hessian(&self, straight: &Straight, factors: &[Interval]) -> Vec<Interval> {
        let mut sum = vec![Interval::ZERO; pair(self.ways.nv, 0)];
        for (factor, own) in factors.iter().zip(&straight.hessians) {
            add_times(&mut sum, *factor, own);
        }
        sum
    }

    fn straight(&self) -> Straight {
        let steps = self.steps();
        let mut hessians: Vec<Vec<Interval>> = vec![Vec::new(); self.ways.n];
        let all = Interval::from_f64((SHARES * SHARES) as f64);
        for part in 1..=SHARES {
            let share = part as f64 / SHARES as f64;
            let weight = Interval::from_f64((2 * (SHARES - part) + 1) as f64) / all;
            // Rounded up: a little more of the way does no harm.
            let forms = self.over(steps.iter().map(|step| (step * share).next_up()), share.next_up());
            for (sum, form) in hessians.iter_mut().zip(&forms) {
                let hessian = self.ways.hessian(form);
                sum.resize(hessian.len(), Interval::ZERO);
                add_times(sum, weight, &hessian);
            }
        }
        Straight { hessians }
    }

    /// The largest and the smallest deviation; `None` if nothing is proven.
    pub(super) fn ends(&self) -> Option<[f64; 2]> {
        if !self.steps().iter().all(|step| *step < MAX_STEP) {
            return None;
        }
        let straight = self.straight();
        let correction = self.correction(&straight)?;
        let (factors, nv) = (self.combination(), self.ways.nv);
        let (mut value, mut gradient) = (Interval::ZERO, vec![Interval::ZERO; nv]);
        let mut triangle = vec![Interval::ZERO; pair(nv, 0)];
        for (factor, form) in factors.iter().zip(&self.at_rest) {
            value += *factor * form.jet.value;
            add_times(&mut gradient, *factor, &self.ways.gradient(form));
            add_times(&mut triangle, *factor, &self.ways.hessian(form));
        }
        let cubic = Interval::around_zero(self.cubic_reach(&factors));
        let rest = Interval::around_zero(self.rest(&correction, &factors)) + cubic;
        let end = |sign: f64| {
            let sign = Interval::from_f64(sign);
            let gradient: Vec<Interval> = gradient.iter().map(|own| sign * *own).collect();
            let hessian: Vec<Interval> = (0..nv * nv).map(|at| sign * triangle[pair(at / nv, at % nv)]).collect();
            let above =
                QuadraticOverBalls { balls: &self.ways.balls, gradient: &gradient, hessian: &hessian }.upper_end();
            (sign * value + Interval::from_f64(above) + rest).high()
        };
        Some([end(1.0), -end(-1.0)])
    }
}

/// Motions that no row resists; `None` if there are more rows than they and the unknowns are.
fn idle_motions(rows: &[PlacedJet], n: usize) -> Option<Vec<Vec<f64>>> {
    if rows.len() >= n {
        return (rows.len() == n).then(Vec::new);
    }
    let mut matrix = vec![0.0; rows.len() * n];
    for (row, form) in rows.iter().enumerate() {
        for (place, slope) in form.places.iter().zip(&form.jet.slopes).filter(|(place, _)| **place < n) {
            matrix[row * n + place] = slope.middle();
        }
    }
    Some(SingularValues::new(&matrix, rows.len(), n).right_null_space(rows.len()))
}

/// The row that holds an idle motion.
fn linear(motion: &[f64]) -> PlacedJet {
    let slopes = motion.iter().map(|entry| Interval::from_f64(*entry)).collect();
    PlacedJet { places: (0..motion.len()).collect(), jet: Jet { value: Interval::ZERO, slopes, curves: Vec::new() } }
}
