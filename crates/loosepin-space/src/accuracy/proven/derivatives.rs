//! Derivatives of an output by the play, over boxes of positions.

use crate::accuracy::proven::linear::{product, solve_near_identity};
use crate::accuracy::proven::loop_box::LoopBox;
use crate::enclosure::enclosed_output::{EnclosedOutput, PlacedJet};
use crate::enclosure::jet::{Jet, NUMBERS, PAIRS, pair};
use crate::enclosure::position_box::PositionBox;
use crate::output::SpatialOutput;
use loosepin_math::Interval;

/// First derivatives over a box.
pub(super) struct FirstDerivatives<const C: usize> {
    /// The output.
    pub value: Interval,
    /// dy/dv.
    pub by_play: Vec<Interval>,
    /// dq/dv, row by row.
    ways: Vec<Interval>,
    output: PlacedJet<C>,
    rows: Vec<(usize, Jet<C>)>,
    /// J and K side by side, and Y J.
    slopes: Vec<Interval>,
    near_identity: Vec<Interval>,
}

impl LoopBox<'_> {
    /// Over a box of positions and a share of the play; `None` if J may be singular.
    pub(super) fn derivatives<const C: usize>(
        &self,
        output: &SpatialOutput,
        positions: &[Interval],
        share: f64,
    ) -> Option<FirstDerivatives<C>> {
        let (n, nv) = (self.n, self.nv);
        let rows = self.rows::<C>(positions, share);
        let slopes = self.slopes(&rows);
        let near_identity = product(&self.inverse, &slopes, n, n + nv, 0..n);
        let right = product(&self.inverse, &slopes, n, n + nv, n..n + nv).into_iter().map(|entry| -entry).collect();
        let ways = solve_near_identity(near_identity.clone(), n, right, nv)?;
        let output: PlacedJet<C> = output.enclosed(&PositionBox { centre: self.centre, numbers: positions });
        let mut by_play = vec![Interval::ZERO; nv];
        for (place, slope) in self.places(output.bodies, (0, 0)).into_iter().zip(output.jet.slopes) {
            if let Some(place) = place {
                by_play.iter_mut().zip(&ways[place * nv..]).for_each(|(sum, way)| *sum += slope * *way);
            }
        }
        Some(FirstDerivatives { value: output.jet.value, by_play, ways, output, rows, slopes, near_identity })
    }

    /// d²y/dv² over a box of positions and a share of the play, row by row.
    pub(super) fn curvature(
        &self,
        output: &SpatialOutput,
        positions: &[Interval],
        share: f64,
    ) -> Option<Vec<Interval>> {
        let nv = self.nv;
        let first = self.derivatives::<PAIRS>(output, positions, share)?;
        let weights = self.weights(&first)?;
        let mut hessian = vec![Interval::ZERO; nv * nv];
        self.add(&mut hessian, &first.ways, &self.places(first.output.bodies, (0, 0)), &first.output.jet.curves);
        // The rows of a joint stand one after the other, and are by the same numbers.
        let joint_of = |row: usize| self.centre.loops.rows[row].joint;
        for own in first.rows.chunk_by(|a, b| joint_of(a.0) == joint_of(b.0)) {
            let mut curves = [Interval::ZERO; PAIRS];
            for (row, jet) in own {
                curves.iter_mut().zip(&jet.curves).for_each(|(sum, curve)| *sum -= weights[*row] * *curve);
            }
            if let Some((row, _)) = own.first() {
                self.add(&mut hessian, &first.ways, &self.places_of_row(*row), &curves);
            }
        }
        for a in 0..nv {
            for b in 0..a {
                hessian[b * nv + a] = hessian[a * nv + b];
            }
        }
        Some(hessian)
    }

    /// w = J⁻ᵀ dy/dq.
    fn weights(&self, first: &FirstDerivatives<PAIRS>) -> Option<Vec<Interval>> {
        let n = self.n;
        let mut gradient = vec![Interval::ZERO; n];
        for (place, slope) in self.places(first.output.bodies, (0, 0)).into_iter().zip(first.output.jet.slopes) {
            if let Some(place) = place {
                gradient[place] = slope;
            }
        }
        // (Y J)ᵀ u = dy/dq, w = Yᵀ u.
        let transposed = (0..n * n).map(|at| first.near_identity[(at % n) * n + at / n]).collect();
        let solved = solve_near_identity(transposed, n, gradient, 1)?;
        let weight = |row: usize| (0..n).fold(Interval::ZERO, |sum, k| sum + self.inverse[k * n + row] * solved[k]);
        Some((0..n).map(weight).collect())
    }

    /// Adds (T, 1)ᵀ C (T, 1), C by the numbers at these places.
    fn add(
        &self,
        hessian: &mut [Interval],
        ways: &[Interval],
        places: &[Option<usize>; NUMBERS],
        curves: &[Interval; PAIRS],
    ) {
        let (n, nv) = (self.n, self.nv);
        let one = Interval::new(1.0, 1.0);
        let moving: Vec<(usize, usize)> =
            places.iter().enumerate().filter_map(|(k, place)| place.map(|place| (k, place))).collect();
        let way = |place: usize, v: usize| match place.checked_sub(n) {
            None => ways[place * nv + v],
            Some(own) if own == v => one,
            Some(_) => Interval::ZERO,
        };
        for &(i, place_i) in &moving {
            let half: Vec<Interval> = (0..nv)
                .map(|v| {
                    moving.iter().fold(Interval::ZERO, |sum, &(j, place_j)| sum + curves[pair(i, j)] * way(place_j, v))
                })
                .collect();
            for a in 0..nv {
                let own = way(place_i, a);
                if own != Interval::ZERO {
                    for b in 0..=a {
                        hessian[a * nv + b] += own * half[b];
                    }
                }
            }
        }
    }
}
