//! Second derivatives along W, and bounds of linear and quadratic functions over the balls of the play.

use crate::enclosure::jet::pair;
use crate::enclosure::position_box::PlacedJet;
use core::ops::Range;
use loosepin_math::{Interval, Real};

/// W = (T, 1), and the balls of v.
pub(super) struct Ways {
    /// Unknowns, and variables of play.
    pub n: usize,
    pub nv: usize,
    pub balls: Vec<Range<usize>>,
    /// T, row by row.
    pub unknowns: Vec<Interval>,
}

impl Ways {
    /// What the row of W of a number adds to a sum.
    fn add(&self, sum: &mut [Interval], place: usize, factor: Interval) {
        if place >= self.n {
            sum[place - self.n] += factor;
            return;
        }
        for (sum, way) in sum.iter_mut().zip(&self.unknowns[place * self.nv..(place + 1) * self.nv]) {
            *sum += factor * *way;
        }
    }

    /// Derivatives by v.
    pub(super) fn gradient(&self, form: &PlacedJet) -> Vec<Interval> {
        let mut gradient = vec![Interval::ZERO; self.nv];
        for (place, slope) in form.places.iter().zip(&form.jet.slopes) {
            self.add(&mut gradient, *place, *slope);
        }
        gradient
    }

    /// C W, C the second derivatives: for each number that it depends on; none where it is linear.
    pub(super) fn half(&self, form: &PlacedJet) -> Vec<Vec<Interval>> {
        if form.jet.curves.is_empty() {
            return Vec::new();
        }
        let each = 0..form.places.len();
        each.clone()
            .map(|i| {
                let mut sum = vec![Interval::ZERO; self.nv];
                for j in each.clone() {
                    let curve = form.jet.curves[pair(i, j)];
                    if curve != Interval::ZERO {
                        self.add(&mut sum, form.places[j], curve);
                    }
                }
                sum
            })
            .collect()
    }

    /// Wᵀ C W, the lower triangle row by row; empty where it is linear.
    pub(super) fn hessian(&self, form: &PlacedJet) -> Vec<Interval> {
        let half = self.half(form);
        let mut hessian = if half.is_empty() { Vec::new() } else { vec![Interval::ZERO; pair(self.nv, 0)] };
        for (place, half) in form.places.iter().zip(&half) {
            let mut add = |a: usize, way: Interval| {
                if way != Interval::ZERO {
                    let row = &mut hessian[pair(a, 0)..=pair(a, a)];
                    row.iter_mut().zip(half).for_each(|(sum, half)| *sum += way * *half);
                }
            };
            match place.checked_sub(self.n) {
                Some(own) => add(own, Interval::from_f64(1.0)),
                None => (0..self.nv).for_each(|a| add(a, self.unknowns[place * self.nv + a])),
            }
        }
        hessian
    }

    /// A number that |g·v| does not exceed.
    pub(super) fn reach(&self, gradient: &[Interval]) -> f64 {
        let balls = self.balls.iter().map(|ball| length(ball.clone().map(|k| gradient[k])));
        balls.fold(Interval::ZERO, |sum, own| sum + Interval::from_f64(own)).high()
    }

    /// A number that |v·H v/2| does not exceed: Frobenius norms of all pairs of balls.
    pub(super) fn quadratic_reach(&self, hessian: &[Interval]) -> f64 {
        let mut sum = Interval::ZERO;
        for (number, first) in self.balls.iter().enumerate() {
            for second in &self.balls[..=number] {
                let entries = first.clone().flat_map(|a| second.clone().map(move |b| hessian[pair(a, b)]));
                let weight = if first == second { 0.5 } else { 1.0 };
                sum += Interval::from_f64(weight) * Interval::from_f64(length(entries));
            }
        }
        sum.high()
    }
}

/// Length of a vector, rounded up.
pub(super) fn length(entries: impl Iterator<Item = Interval>) -> f64 {
    let squares = entries.fold(Interval::ZERO, |sum, entry| sum + Interval::from_f64(entry.squared().high()));
    Interval::from_f64(squares.high()).sqrt().high()
}

/// Σ factor_k a_k.
pub(super) fn add_times(sum: &mut [Interval], factor: Interval, entries: &[Interval]) {
    if factor != Interval::ZERO {
        sum.iter_mut().zip(entries).for_each(|(sum, entry)| *sum += factor * *entry);
    }
}
