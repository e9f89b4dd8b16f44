//! Third derivatives along W.

use super::forms::{Ways, add_times, length};
use super::proof::Proof;
use crate::enclosure::enclosed_output::EnclosedOutput;
use crate::enclosure::jet::{Jet, pair};
use crate::enclosure::position_box::{PlacedJet, PositionBox};
use loosepin_math::{Dual, Interval, Real};

/// A cubic form: for each number v_c the lower triangle of a matrix.
struct Cubic(Vec<Vec<Interval>>);

impl Cubic {
    /// Adds what a function of some numbers has: `curves` are derivatives of its second derivatives by the number at `direction`.
    fn add(&mut self, ways: &Ways, direction: usize, curves: PlacedJet) {
        let hessian = ways.hessian(&curves);
        match direction.checked_sub(ways.n) {
            Some(own) => add_times(&mut self.0[own], Interval::from_f64(1.0), &hessian),
            None => {
                let own = &ways.unknowns[direction * ways.nv..(direction + 1) * ways.nv];
                own.iter().zip(&mut self.0).for_each(|(way, sum)| add_times(sum, *way, &hessian));
            }
        }
    }

    /// A number that a sixth of it does not exceed over the balls: Frobenius norms of all triples of balls.
    fn reach(&self, ways: &Ways) -> f64 {
        let mut sum = Interval::ZERO;
        for third in &ways.balls {
            for (number, first) in ways.balls.iter().enumerate() {
                for second in &ways.balls[..=number] {
                    let pairs = first.clone().flat_map(|a| second.clone().map(move |b| pair(a, b)));
                    let entries = pairs.flat_map(|place| third.clone().map(move |c| self.0[c][place]));
                    let weight = if first == second { 1.0 } else { 2.0 };
                    sum += Interval::from_f64(weight) * Interval::from_f64(length(entries));
                }
            }
        }
        (sum / Interval::from_f64(6.0)).high()
    }
}

impl Proof<'_> {
    /// A number that the remainder of L(T v, v) behind the second degree does not exceed: a sixth of its third derivatives, anywhere between
    /// the ideal position and T v.
    pub(super) fn cubic_reach(&self, factors: &[Interval]) -> f64 {
        let ways = &self.ways;
        let numbers = self.numbers(self.steps().into_iter(), 1.0);
        let mut sum = Cubic(vec![vec![Interval::ZERO; pair(ways.nv, 0)]; ways.nv]);
        let at = |direction| PositionBox {
            centre: self.centre,
            numbers: &numbers,
            is_second_order: true,
            direction: Some(direction),
        };
        let one = Interval::from_f64(1.0);
        let mut add = |of: &dyn Fn(usize) -> Vec<(Interval, PlacedJet<Dual<Interval>>)>| {
            let mut direction = 0;
            loop {
                let forms = of(direction);
                let places = forms.first().map_or(Vec::new(), |(_, form)| form.places.clone());
                let Some(place) = places.get(direction) else { return };
                let mut curves = vec![Interval::ZERO; pair(places.len(), 0)];
                for (factor, form) in &forms {
                    let entries: Vec<Interval> = form.jet.curves.iter().map(|curve| curve.derivative).collect();
                    add_times(&mut curves, *factor, &entries);
                }
                let (place, jet) = (*place, Jet { value: Interval::ZERO, slopes: Vec::new(), curves });
                sum.add(ways, place, PlacedJet { places, jet });
                direction += 1;
            }
        };
        for joint in 0..self.centre.loops.mechanism.joints().len() {
            add(&|direction| {
                let rows = at(direction).rows_of(joint).into_iter();
                rows.map(|(number, form)| (factors.get(number).copied().unwrap_or(one), form)).collect()
            });
        }
        add(&|direction| vec![(one, self.output.enclosed(&at(direction)))]);
        sum.reach(ways)
    }
}
