//! Enclosure of all positions that the play allows, and first and second derivatives of the outputs over them, on intervals.
//!
//! Φ(q, v) = 0 are the loop equations over the free coordinates q and the numbers v of [`super::variables`]: play, dimensions, and last the
//! input of the cycle around its angle. With J = dΦ/dq over a box Q and the inverse Y of its middle, Krawczyk's operator
//!
//! ```text
//! K = q₀ - Y Φ(q₀, v) + (1 - Y J)(Q - q₀)
//! ```
//!
//! lies inside Q only if for every v there is exactly one q in Q that closes the loops (R. Krawczyk, Computing 4 (1969) 187). It is then the
//! assembly of the ideal position, since all of them hang together. The implicit function theorem gives
//!
//! ```text
//! T = dq/dv = -J⁻¹ dΦ/dv,   w = J⁻ᵀ dy/dq,   d²y/dv² = Tᵀ (d²y - Σ w_r d²Φ_r) T  with T over (q, v)
//! ```

use super::evaluate::Evaluator;
use super::variables::{Variables, balls_and_numbers};
use loosepin_math::{Dual, Interval, Outlined, Real, inverse, solve_in_order};
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{Position, Values};
use std::ops::Range;

/// Boxes that are tried before the proof is given up.
const BOXES: usize = 8;
/// How much larger than what they must hold they are made.
const INFLATION: f64 = 1.15;

/// First derivatives of the outputs at the ideal position, and second ones over all positions, both over the numbers v.
pub(in super::super) struct Enclosed {
    /// For each output.
    pub gradients: Vec<Vec<Interval>>,
    /// For each output, row by row.
    pub hessians: Vec<Vec<Interval>>,
    /// dy/dv over all positions, for each output.
    pub slopes: Vec<Vec<Interval>>,
}

/// The loops could not be shown to close in one way over all play.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct NotEnclosed {
    /// The least certain free coordinate; `None` where it was not determined.
    pub coordinate: Option<usize>,
}

/// The moving variables and their ranges.
pub(in super::super) struct Moving<'a> {
    pub mechanism: &'a Mechanism,
    pub values: &'a Values,
    pub variables: Variables,
    /// For each dimension that deviates: by how much every quantity changes at its limit.
    pub dimensions: Vec<Vec<f64>>,
    /// Change of each driven coordinate at the limit of the input, if it may move.
    pub driven_steps: Option<Vec<f64>>,
}

/// Evaluators over the numbers that the proof needs.
pub(in super::super) struct Encloser<'a> {
    pub(super) moving: Moving<'a>,
    pub(super) readings: Vec<Position>,
    pub(super) plain: Evaluator<'a, Dual<f64>>,
    pub(super) first: Evaluator<'a, Dual<Interval>>,
    second: Evaluator<'a, Outlined<Dual<Dual<Interval>>>>,
}

/// A box of which it is shown that it holds one position for each v.
pub(super) struct Closed {
    /// A smaller box that holds all of these positions.
    pub positions: Vec<Interval>,
    /// The box itself.
    tried: Vec<Interval>,
    /// Derivatives over it.
    slopes: Slopes<Interval>,
}

/// Derivatives of residuals and outputs over (q, v), row by row.
pub(super) struct Slopes<T> {
    pub of_residuals: Vec<T>,
    pub of_outputs: Vec<T>,
}

impl Moving<'_> {
    /// How many numbers v there are.
    pub fn count(&self) -> usize {
        self.variables.count() + self.dimensions.len() + usize::from(self.driven_steps.is_some())
    }

    /// Places of the numbers of each ball of v.
    pub fn balls(&self) -> Vec<Range<usize>> {
        let others = self.dimensions.len() + usize::from(self.driven_steps.is_some());
        balls_and_numbers(self.variables.balls.clone(), others)
    }

    pub(super) fn place<T: Real>(&self, evaluator: &mut Evaluator<'_, T>, q: &[T], driven: &[f64], v: &[T]) {
        let plays = self.variables.count();
        if !self.dimensions.is_empty() {
            let number = |id: usize| {
                let start = T::from_f64(self.values.0[id]);
                let ways = self.dimensions.iter().zip(&v[plays..]).filter(|(step, _)| step[id] != 0.0);
                ways.fold(start, |sum, (step, v)| sum + *v * T::from_f64(step[id]))
            };
            evaluator.set_numbers((0..self.values.0.len()).map(number));
        }
        let mut coordinates = q.to_vec();
        match &self.driven_steps {
            Some(steps) => {
                let input = v[v.len() - 1];
                let ways = driven.iter().zip(steps);
                coordinates.extend(ways.map(|(at, step)| T::from_f64(*at) + input * T::from_f64(*step)));
            }
            None => coordinates.extend(driven.iter().map(|at| T::from_f64(*at))),
        }
        evaluator.set(&coordinates, self.variables.displacements(v));
    }
}

impl<'a> Encloser<'a> {
    pub fn new(moving: Moving<'a>, readings: Vec<Position>) -> Self {
        let values = &moving.values.0;
        Self {
            readings,
            plain: Evaluator::new(moving.mechanism, values.iter().map(|v| Real::from_f64(*v)).collect()),
            first: Evaluator::new(moving.mechanism, values.iter().map(|v| Real::from_f64(*v)).collect()),
            second: Evaluator::new(moving.mechanism, values.iter().map(|v| Real::from_f64(*v)).collect()),
            moving,
        }
    }

    /// Takes other changes of the driven coordinates at the limit of the input, where it may move.
    pub fn take_steps(&mut self, steps: Option<&[f64]>) {
        self.moving.driven_steps = steps.map(<[f64]>::to_vec);
    }

    /// Derivatives of the outputs around the ideal position `coordinates`, free coordinates first, then driven ones.
    ///
    /// # Errors
    /// The loops were not shown to close in one way.
    pub fn in_one_box(&mut self, coordinates: &[f64]) -> Result<Enclosed, NotEnclosed> {
        let n = self.moving.mechanism.ideal.free;
        let nv = self.moving.count();
        let (q0, driven) = coordinates.split_at(n);
        let at_rest = slopes(&self.moving, &mut self.plain, &self.readings, q0, driven, &vec![0.0; nv]);
        let Some(inverse) = inverse_of(&at_rest.of_residuals, n, n + nv) else {
            return Err(NotEnclosed { coordinate: None });
        };
        let exact = self.exact(q0, driven, &inverse)?;
        let (_, gradients) = self.ways(&exact.slopes, &inverse).ok_or(NotEnclosed { coordinate: None })?;

        let everywhere = vec![Interval::around_zero(1.0); nv];
        let moved = (0..n).map(|row| {
            let columns = n..n + nv;
            let steps = columns.map(|column| {
                (0..n).map(|k| inverse[row * n + k] * at_rest.of_residuals[k * (n + nv) + column]).sum::<f64>().abs()
            });
            INFLATION * steps.sum::<f64>() + 1e-12 * (1.0 + q0[row].abs())
        });
        let moved: Vec<f64> = moved.collect();
        let Closed { positions: box_, tried, .. } = self.closed(q0, driven, &everywhere, moved, &inverse)?;
        // The one position without play that lies in the box is the ideal one.
        if let Some(coordinate) = (0..n).find(|k| !exact.positions[*k].is_inside(tried[*k])) {
            return Err(NotEnclosed { coordinate: Some(coordinate) });
        }
        // Once more, over the smaller box that is known by now.
        let at = slopes(&self.moving, &mut self.first, &self.readings, &box_, driven, &everywhere);
        let failed = || NotEnclosed { coordinate: Some(widest(&box_, q0)) };
        let (ways, slopes) = self.ways(&at, &inverse).ok_or_else(failed)?;
        let hessians = self.hessians(&box_, driven, &everywhere, &at, &ways, &inverse).ok_or_else(failed)?;
        Ok(Enclosed { gradients, hessians, slopes })
    }

    /// The ideal position itself, known to round-off; `inverse` is that of the derivatives of the loop equations there.
    pub(super) fn exact(&mut self, q0: &[f64], driven: &[f64], inverse: &[f64]) -> Result<Closed, NotEnclosed> {
        let nowhere = vec![Interval::ZERO; self.moving.count()];
        let round_off: Vec<f64> = q0.iter().map(|q| 1e-13 * (1.0 + q.abs())).collect();
        self.closed(q0, driven, &nowhere, round_off, inverse)
    }

    /// A box around `q0` that holds the one position for each v in `v`, and the derivatives over it.
    fn closed(
        &mut self,
        q0: &[f64],
        driven: &[f64],
        v: &[Interval],
        mut radii: Vec<f64>,
        inverse: &[f64],
    ) -> Result<Closed, NotEnclosed> {
        let (n, nv) = (q0.len(), v.len());
        let first_radii = radii.clone();
        let centre: Vec<Interval> = q0.iter().map(|q| Interval::from_f64(*q)).collect();
        let nowhere = vec![Interval::ZERO; nv];
        let residuals = residuals(&self.moving, &mut self.first, &centre, driven, &nowhere);
        let mut worst = 0;
        for _ in 0..BOXES {
            let away: Vec<Interval> = radii.iter().map(|radius| Interval::around_zero(*radius)).collect();
            let box_: Vec<Interval> = centre.iter().zip(&away).map(|(q, away)| *q + *away).collect();
            let at = slopes(&self.moving, &mut self.first, &self.readings, &box_, driven, v);
            let found = krawczyk_image(inverse, &at.of_residuals, n, &residuals, v, &away);
            let growth = |row: usize| found[row].magnitude() / first_radii[row];
            worst = (0..n).max_by(|a, b| growth(*a).total_cmp(&growth(*b))).unwrap_or(0);
            if found.iter().zip(&away).all(|(found, away)| found.is_inside(*away)) {
                let positions = centre.iter().zip(&found).map(|(q, away)| *q + *away).collect();
                return Ok(Closed { positions, tried: box_, slopes: at });
            }
            // A coordinate that the play does not move at all grows from nothing: only what has no end is given up before its time.
            if !found.iter().all(|found| found.is_finite()) {
                break;
            }
            for (radius, found) in radii.iter_mut().zip(&found) {
                *radius = radius.max(INFLATION * found.magnitude());
            }
        }
        Err(NotEnclosed { coordinate: Some(worst) })
    }

    /// T, (q, v) by v, and dy/dv for each output.
    fn ways(&self, at: &Slopes<Interval>, inverse: &[f64]) -> Option<(Vec<Interval>, Vec<Vec<Interval>>)> {
        let (n, nv) = (self.moving.mechanism.ideal.free, self.moving.count());
        let nz = n + nv;
        let matrix = preconditioned(inverse, &at.of_residuals, n, nz, 0..n);
        let right: Vec<Interval> =
            preconditioned(inverse, &at.of_residuals, n, nz, n..nz).into_iter().map(|entry| -entry).collect();
        let mut ways = eliminate(matrix, n, right, nv)?;
        for row in 0..nv {
            ways.extend((0..nv).map(|column| Interval::from_f64(f64::from(u8::from(row == column)))));
        }
        let slopes = (0..self.readings.len())
            .map(|output| {
                let own = &at.of_outputs[output * nz..(output + 1) * nz];
                (0..nv).map(|v| (0..nz).fold(Interval::ZERO, |sum, z| sum + own[z] * ways[z * nv + v])).collect()
            })
            .collect();
        Some((ways, slopes))
    }

    /// d²y/dv² over a box, for each output.
    fn hessians(
        &mut self,
        box_: &[Interval],
        driven: &[f64],
        v: &[Interval],
        at: &Slopes<Interval>,
        ways: &[Interval],
        inverse: &[f64],
    ) -> Option<Vec<Vec<Interval>>> {
        let (n, nv, outputs) = (box_.len(), v.len(), self.readings.len());
        let nz = n + nv;
        // w for each output: (Y J)ᵀ u = dy/dq, w = Yᵀ u.
        let matrix = preconditioned(inverse, &at.of_residuals, n, nz, 0..n);
        let transposed: Vec<Interval> = (0..n * n).map(|k| matrix[(k % n) * n + k / n]).collect();
        let right: Vec<Interval> = (0..n * outputs).map(|k| at.of_outputs[(k % outputs) * nz + k / outputs]).collect();
        let solved = eliminate(transposed, n, right, outputs)?;
        let weight = |output: usize, row: usize| {
            (0..n).fold(Interval::ZERO, |sum, k| {
                sum + Interval::from_f64(inverse[k * n + row]) * solved[k * outputs + output]
            })
        };
        let weights: Vec<Vec<Interval>> =
            (0..outputs).map(|output| (0..n).map(|row| weight(output, row)).collect()).collect();
        // The second derivatives of y - Σ w Φ over (q, v).
        let mut second = vec![vec![Interval::ZERO; nz * nz]; outputs];
        let whole: Vec<Interval> = box_.iter().chain(v).copied().collect();
        for i in 0..nz {
            for j in i..nz {
                let number = |k: usize| {
                    Outlined(Dual {
                        value: Dual { value: whole[k], derivative: Interval::from_f64(f64::from(u8::from(k == i))) },
                        derivative: Dual::constant(Interval::from_f64(f64::from(u8::from(k == j)))),
                    })
                };
                let [q, v]: [Vec<_>; 2] = [(0..n).map(number).collect(), (n..nz).map(number).collect()];
                self.moving.place(&mut self.second, &q, driven, &v);
                let residuals: Vec<Interval> =
                    self.second.residuals().map(|residual| residual.0.derivative.derivative).collect();
                for (output, reading) in self.readings.iter().enumerate() {
                    let own = self.second.value(*reading).0.derivative.derivative;
                    let ways = weights[output].iter().zip(&residuals);
                    let entry = ways.fold(own, |sum, (weight, residual)| sum - *weight * *residual);
                    (second[output][i * nz + j], second[output][j * nz + i]) = (entry, entry);
                }
            }
        }
        let of_output = |second: &Vec<Interval>| {
            let mut half = vec![Interval::ZERO; nz * nv];
            for z in 0..nz {
                for v in 0..nv {
                    half[z * nv + v] =
                        (0..nz).fold(Interval::ZERO, |sum, k| sum + second[z * nz + k] * ways[k * nv + v]);
                }
            }
            let mut hessian = vec![Interval::ZERO; nv * nv];
            for a in 0..nv {
                for b in a..nv {
                    let entry = (0..nz).fold(Interval::ZERO, |sum, z| sum + ways[z * nv + a] * half[z * nv + b]);
                    (hessian[a * nv + b], hessian[b * nv + a]) = (entry, entry);
                }
            }
            hessian
        };
        Some(second.iter().map(of_output).collect())
    }
}

/// How far from its middle Krawczyk's operator takes a box of `n` unknowns with the half-widths `away`, where parameters lie in `parameters`
/// around the middle: - Y F - Y dF/du u + (1 - Y dF/dx) away. `matrix` holds dF/dx and dF/du, row by row.
pub(super) fn krawczyk_image(
    inverse: &[f64],
    matrix: &[Interval],
    n: usize,
    residuals: &[Interval],
    parameters: &[Interval],
    away: &[Interval],
) -> Vec<Interval> {
    let columns = n + parameters.len();
    let times = |row: usize, column: usize| {
        (0..n).fold(Interval::ZERO, |sum, k| {
            sum + Interval::from_f64(inverse[row * n + k]) * matrix[k * columns + column]
        })
    };
    let image = |row: usize| {
        let mut sum =
            (0..n).fold(Interval::ZERO, |sum, k| sum - Interval::from_f64(inverse[row * n + k]) * residuals[k]);
        for (k, parameter) in parameters.iter().enumerate() {
            sum -= times(row, n + k) * *parameter;
        }
        for column in 0..n {
            let unit = Interval::from_f64(f64::from(u8::from(row == column)));
            sum += (unit - times(row, column)) * away[column];
        }
        sum
    };
    (0..n).map(image).collect()
}

/// Residuals at a place.
pub(super) fn residuals<T: Real>(
    moving: &Moving<'_>,
    evaluator: &mut Evaluator<'_, Dual<T>>,
    q: &[T],
    driven: &[f64],
    v: &[T],
) -> Vec<T> {
    let [q, v] = [q, v].map(|numbers| numbers.iter().map(|number| Dual::constant(*number)).collect::<Vec<_>>());
    moving.place(evaluator, &q, driven, &v);
    evaluator.residuals().map(|residual| residual.value).collect()
}

/// Residuals and outputs with their first derivatives.
pub(super) fn slopes<T: Real>(
    moving: &Moving<'_>,
    evaluator: &mut Evaluator<'_, Dual<T>>,
    readings: &[Position],
    q: &[T],
    driven: &[f64],
    v: &[T],
) -> Slopes<T> {
    let (n, nz) = (q.len(), q.len() + v.len());
    let mut found = Slopes { of_residuals: vec![T::zero(); n * nz], of_outputs: vec![T::zero(); readings.len() * nz] };
    for z in 0..nz {
        let number =
            |place: usize, value: &T| Dual { value: *value, derivative: if place == z { T::one() } else { T::zero() } };
        let along_q: Vec<_> = q.iter().enumerate().map(|(k, value)| number(k, value)).collect();
        let along_v: Vec<_> = v.iter().enumerate().map(|(k, value)| number(n + k, value)).collect();
        moving.place(evaluator, &along_q, driven, &along_v);
        for (row, residual) in evaluator.residuals().enumerate() {
            found.of_residuals[row * nz + z] = residual.derivative;
        }
        for (output, reading) in readings.iter().enumerate() {
            found.of_outputs[output * nz + z] = evaluator.value(*reading).derivative;
        }
    }
    found
}

/// Y times some columns of a matrix with `n` rows.
pub(super) fn preconditioned(
    inverse: &[f64],
    matrix: &[Interval],
    n: usize,
    columns: usize,
    of: Range<usize>,
) -> Vec<Interval> {
    let mut product = Vec::with_capacity(n * of.len());
    for row in 0..n {
        for column in of.clone() {
            let terms = (0..n).map(|k| Interval::from_f64(inverse[row * n + k]) * matrix[k * columns + column]);
            product.push(terms.fold(Interval::ZERO, |sum, term| sum + term));
        }
    }
    product
}

/// Solves a system near the identity with `m` right-hand sides, row by row; `None` if a pivot may be zero.
pub(super) fn eliminate(
    mut matrix: Vec<Interval>,
    n: usize,
    mut right: Vec<Interval>,
    m: usize,
) -> Option<Vec<Interval>> {
    solve_in_order(&mut matrix, n, &mut right, m, |pivot| pivot.low() > 0.0).then_some(right)
}

/// The inverse of the first `n` columns of a matrix with `n` rows; `None` if they are singular.
pub(super) fn inverse_of(matrix: &[f64], n: usize, columns: usize) -> Option<Vec<f64>> {
    inverse((0..n * n).map(|at| matrix[at / n * columns + at % n]).collect(), n)
}

/// The coordinate that is known least.
fn widest(box_: &[Interval], q0: &[f64]) -> usize {
    let away = |k: &usize| (box_[*k] - Interval::from_f64(q0[*k])).magnitude();
    (0..q0.len()).max_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(0)
}
