//! Enclosure of all positions that the play allows near a dead centre, where one box over all of them is too wide: in slices along the direction
//! in which the loops give way first.
//!
//! With w that direction and y the one in which the loop equations give way, J w = σ y, the bordered equations
//!
//! ```text
//! Φ(q, v) - κ y = 0,   w·(q - q₀) = a
//! ```
//!
//! have a solution (q, κ) for each a and v even where J is singular (W. Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria,
//! 2000, 3.3). The loops are closed where κ(a, v) = 0. Where dκ/da > 0 in every slice from a₁ to a₂ and κ(a₁, v) < 0 < κ(a₂, v) for all v,
//! each v has exactly one such a in them, and the loops are regular there: the ideal position moves to it on every way within the play.
//!
//! A deviation in a slice is bounded by its first derivatives over the slice, with κ = 0 as a condition that a multiplier takes in:
//!
//! ```text
//! y(a, v) - y(0, r) ≤ y_c - y₀ + μ κ_c + |y_a + μ κ_a| h + Σ |y_v + μ κ_v - y_r|
//! ```
//!
//! from the middle of the slice, h its half-width, r those numbers of v that move the position which deviations are counted from, y_r the
//! derivatives of that, and the sum over the balls of v.

use super::bordered::Bordered;
use super::enclosure::{
    Encloser, NotEnclosed, eliminate, inverse_of, krawczyk_image, preconditioned, residuals, slopes,
};
use loosepin_math::{Dual, Interval, Real};
use std::ops::Range;

/// Parts of the inputs where all of them at once come too near to a dead centre: what they do is then linear to a sixteenth.
const PARTS: usize = 4;
/// Slices that are tried before the proof is given up.
const MOST_SLICES: usize = 400;
/// The first slice, as a share of how far the numbers take the position to first order.
const FIRST_SHARE: f64 = 0.25;
/// The thinnest slice, in units of the first.
const THINNEST: f64 = 1e-4;
/// Slices thinner than this, in the same units, are as even as they get.
const THIN: f64 = 0.1;
/// Most of what dκ/da may differ by in a slice: the ends of a deviation are as good as this is near one.
const EVEN: f64 = 1.4;
/// By how much the next slice is thicker.
const THICKER: f64 = 1.5;
/// By how much slices overlap.
const OVERLAP: f64 = 1.0 + 1e-9;
/// Boxes that are tried for a slice.
const BOXES: usize = 6;
/// How much larger than what they must hold they are made.
const INFLATION: f64 = 1.15;
/// Newton steps to the middle of a slice; from the one before two or three are enough.
const NEWTON_STEPS: usize = 12;
/// Steps of the search for a multiplier; whatever it ends with gives a true end.
const STEPS: usize = 60;

/// All positions that the play allows, in slices.
pub(in super::super) struct Sliced {
    /// One for all inputs, or one for each part of them.
    parts: Vec<Part>,
    /// Values of the outputs in the ideal position.
    ideal: Vec<Interval>,
}

/// All positions for a part of the inputs, around the ideal position in its middle.
struct Part {
    slices: Vec<Slice>,
    /// Values of the outputs in that position.
    ideal: Vec<Interval>,
    /// Derivatives of each output by all numbers v over the positions without play, as long as dimensions and the input move alone.
    slopes_of_reference: Vec<Vec<Interval>>,
}

/// The solutions of the bordered equations with a in a slice.
struct Slice {
    half_width: f64,
    kappa: Linear,
    outputs: Vec<Linear>,
    /// The box of (q, κ) in which they are the only ones, and the slice.
    tried: Vec<Interval>,
    a: Interval,
}

/// Positions without play.
struct WithoutPlay {
    slices: Vec<Slice>,
    /// w.
    motion: Vec<f64>,
    /// Values of the outputs in the ideal position.
    ideal: Vec<Interval>,
}

/// A number that depends on a and v: its value at the middle of the slice with v = 0, and its derivatives over all of it.
struct Linear {
    middle: Interval,
    by_a: Interval,
    by_v: Vec<Interval>,
}

/// Boxes of (q, κ): one that holds the solutions, one in which they are the only ones.
struct Boxes {
    holds: Vec<Interval>,
    tried: Vec<Interval>,
    /// dF/d(q, κ, a, v) over the box that was tried, row by row, and the derivatives of the outputs by (q, v).
    matrix: Vec<Interval>,
    of_outputs: Vec<Interval>,
    inverse: Vec<f64>,
}

impl Sliced {
    /// A number that the sum of outputs in `weights`, times `sign`, nowhere exceeds as a deviation; numbers from `first_of_reference` on move
    /// what it is counted from as well.
    pub fn upper_end(
        &self,
        weights: &[(usize, f64)],
        sign: f64,
        balls: &[Range<usize>],
        first_of_reference: usize,
    ) -> f64 {
        let sum = |of: &dyn Fn(usize) -> Interval| {
            weights
                .iter()
                .fold(Interval::ZERO, |sum, (place, weight)| sum + Interval::from_f64(sign * weight) * of(*place))
        };
        let of_slice = |part: &Part, slice: &Slice| {
            let count = slice.kappa.by_v.len();
            let reference = |place: usize, v: usize| {
                if v >= first_of_reference { part.slopes_of_reference[place][v] } else { Interval::ZERO }
            };
            // Without a reference deviations are counted from the ideal position itself.
            let ideal = if first_of_reference < count { &part.ideal } else { &self.ideal };
            let own = Linear {
                middle: sum(&|place| slice.outputs[place].middle - ideal[place]),
                by_a: sum(&|place| slice.outputs[place].by_a),
                by_v: (0..count).map(|v| sum(&|place| slice.outputs[place].by_v[v] - reference(place, v))).collect(),
            };
            own.upper_end_where_closed(&slice.kappa, slice.half_width, balls)
        };
        let each = self.parts.iter().flat_map(|part| part.slices.iter().map(move |slice| of_slice(part, slice)));
        each.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The derivative of an output by the input, as long as the input moves alone.
    pub fn slope_by_input(&self, output: usize) -> Option<Interval> {
        self.parts.iter().filter_map(|part| part.slopes_of_reference[output].last().copied()).reduce(Interval::hull)
    }
}

impl Linear {
    /// Its largest value over a slice where `kappa` is zero, by the best multiplier that a search finds.
    fn upper_end_where_closed(&self, kappa: &Linear, half_width: f64, balls: &[Range<usize>]) -> f64 {
        let at = |multiplier: f64| {
            let times = Interval::from_f64(multiplier);
            let with = |own: Interval, kappa: Interval| own + times * kappa;
            let sum = Linear {
                middle: with(self.middle, kappa.middle),
                by_a: with(self.by_a, kappa.by_a),
                by_v: self.by_v.iter().zip(&kappa.by_v).map(|(own, kappa)| with(*own, *kappa)).collect(),
            };
            sum.upper_end(half_width, balls)
        };
        // Convex in the multiplier: around the one that takes a out, outwards until it grows, then thirds.
        let start = -self.by_a.middle() / kappa.by_a.middle();
        let mut reach = f64::max(start.abs(), 1.0);
        for _ in 0..STEPS {
            if at(start) <= f64::min(at(start - reach), at(start + reach)) {
                break;
            }
            reach *= 2.0;
        }
        let [mut low, mut high] = [start - reach, start + reach];
        for _ in 0..STEPS {
            let [first, second] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if at(first) <= at(second) { high = second } else { low = first }
        }
        f64::min(at(start), at(0.5 * (low + high)))
    }

    /// Its largest value over a slice.
    fn upper_end(&self, half_width: f64, balls: &[Range<usize>]) -> f64 {
        (self.middle + self.by_a.abs() * Interval::from_f64(half_width) + furthest(&self.by_v, balls)).high()
    }
}

/// How far the numbers v take something with these derivatives at most.
fn furthest(by_v: &[Interval], balls: &[Range<usize>]) -> Interval {
    // A sum of squares that may be zero has a least number below zero, by round-off: only the largest one counts.
    let length = |ball: &Range<usize>| {
        let squares = by_v[ball.clone()].iter().fold(Interval::ZERO, |sum, slope| sum + slope.squared());
        squares.high().sqrt().next_up()
    };
    balls.iter().fold(Interval::ZERO, |sum, ball| sum + Interval::from_f64(length(ball)))
}

impl Encloser<'_> {
    /// All positions around the ideal one in slices: for all inputs at once, or for parts of them.
    ///
    /// # Errors
    /// The loops were not shown to be regular for all v: the play, dimensions or the input reach a dead centre, or come too near.
    pub fn in_slices(&mut self, coordinates: &[f64]) -> Result<Sliced, NotEnclosed> {
        let (part, reference) = self.part(coordinates)?;
        match (part, self.moving.driven_steps.clone()) {
            (Ok(part), _) => Ok(Sliced { ideal: part.ideal.clone(), parts: vec![part] }),
            (Err(failed), None) => Err(failed),
            (Err(failed), Some(steps)) => {
                let parts = self.parts(coordinates, &steps, &reference);
                self.moving.driven_steps = Some(steps);
                Ok(Sliced { parts: parts.ok_or(failed)?, ideal: reference.ideal })
            }
        }
    }

    /// Positions for each of some equal parts of the inputs. `reference` holds those without play for all of them, which shows that the ideal
    /// positions in the middle of the parts hang together.
    fn parts(&mut self, coordinates: &[f64], steps: &[f64], reference: &WithoutPlay) -> Option<Vec<Part>> {
        let n = self.moving.mechanism.ideal.free;
        let share = 1.0 / PARTS as f64;
        let mut parts = Vec::with_capacity(PARTS);
        for part in 0..PARTS {
            let input = share * (2 * part + 1) as f64 - 1.0;
            let driven = coordinates[n..].iter().zip(steps).map(|(at, step)| at + input * step);
            let mut middle = coordinates[..n].to_vec();
            middle.extend(driven);
            self.moving.driven_steps = Some(steps.iter().map(|step| share * OVERLAP * step).collect());
            self.close(&mut middle)?;
            let (q0, driven) = middle.split_at(n);
            let nv = self.moving.count();
            let at_rest = slopes(&self.moving, &mut self.plain, &self.readings, q0, driven, &vec![0.0; nv]);
            let inverse = inverse_of(&at_rest.of_residuals, n, n + nv)?;
            let exact = self.exact(q0, driven, &inverse).ok()?.positions;
            let ways = exact.iter().zip(&coordinates[..n]).zip(&reference.motion);
            let a = ways.fold(Interval::ZERO, |sum, ((q, q0), motion)| {
                sum + Interval::from_f64(*motion) * (*q - Interval::from_f64(*q0))
            });
            let is_in = |slice: &Slice| {
                let kappa_is_in = Interval::ZERO.is_inside(slice.tried[n]) && a.is_inside(slice.a);
                kappa_is_in && exact.iter().zip(&slice.tried).all(|(at, tried)| at.is_inside(*tried))
            };
            if !reference.slices.iter().any(is_in) {
                return None;
            }
            parts.push(self.part(&middle).ok()?.0.ok()?);
        }
        Some(parts)
    }

    /// Newton's method for the loops without play.
    fn close(&mut self, coordinates: &mut [f64]) -> Option<()> {
        let (n, nv) = (self.moving.mechanism.ideal.free, self.moving.count());
        let nowhere = vec![0.0; nv];
        for _ in 0..NEWTON_STEPS {
            let (q, driven) = coordinates.split_at_mut(n);
            let open = residuals(&self.moving, &mut self.plain, q, driven, &nowhere);
            let plain = slopes(&self.moving, &mut self.plain, &[], q, driven, &nowhere);
            let inverse = inverse_of(&plain.of_residuals, n, n + nv)?;
            for (row, q) in q.iter_mut().enumerate() {
                *q -= (0..n).map(|k| inverse[row * n + k] * open[k]).sum::<f64>();
            }
        }
        coordinates.iter().all(|coordinate| coordinate.is_finite()).then_some(())
    }

    /// All positions around the ideal one, and those without play.
    ///
    /// # Errors
    /// The ideal position is singular, or not even those without play are known to be regular.
    fn part(&mut self, coordinates: &[f64]) -> Result<(Result<Part, NotEnclosed>, WithoutPlay), NotEnclosed> {
        let n = self.moving.mechanism.ideal.free;
        let nv = self.moving.count();
        let (q0, driven) = coordinates.split_at(n);
        let at_rest = slopes(&self.moving, &mut self.plain, &self.readings, q0, driven, &vec![0.0; nv]);
        let nowhere = NotEnclosed { coordinate: None };
        let Some(bordered) = Bordered::new(&at_rest.of_residuals, q0, driven, nv) else { return Err(nowhere) };
        let failed = || NotEnclosed { coordinate: Some(bordered.weakest()) };
        // What dimensions and the input do without play.
        let plays = self.moving.variables.count();
        let without: Vec<Interval> =
            (0..nv).map(|v| if v < plays { Interval::ZERO } else { Interval::around_zero(1.0) }).collect();
        let everywhere = vec![Interval::around_zero(1.0); nv];
        // The ideal position itself is known to round-off; its loops are closed.
        let mut start = self.exact(q0, driven, &bordered.inverse)?.positions;
        start.push(Interval::ZERO);
        let reach = bordered.reach(&at_rest.of_residuals, nv);
        let slices = self.march(&bordered, &start, &without, reach).ok_or_else(failed)?;
        let ideal = self.values(coordinates, &start);
        let reference = WithoutPlay { slices, motion: bordered.motion.clone(), ideal: ideal.clone() };
        let Some(slices) = self.march(&bordered, &start, &everywhere, reach) else {
            return Ok((Err(failed()), reference));
        };
        let slopes_of_reference = (0..self.readings.len())
            .map(|output| {
                let over = |v: usize| {
                    let each = reference.slices.iter().map(|slice| {
                        let own = &slice.outputs[output];
                        own.by_v[v] - own.by_a * slice.kappa.by_v[v] / slice.kappa.by_a
                    });
                    each.reduce(Interval::hull).unwrap_or(Interval::WHOLE)
                };
                (0..nv).map(over).collect()
            })
            .collect();
        Ok((Ok(Part { slices, ideal, slopes_of_reference }), reference))
    }

    /// Slices from the ideal position to either side, until κ has one sign for all v.
    fn march(&mut self, bordered: &Bordered<'_>, start: &[Interval], v: &[Interval], reach: f64) -> Option<Vec<Slice>> {
        let balls = self.moving.balls();
        let mut slices = Vec::new();
        let mut tried = 0;
        for side in [1.0, -1.0] {
            let (mut a, mut width) = (0.0, FIRST_SHARE * reach);
            let mut x = [bordered.q0, &[0.0]].concat();
            let mut last: Option<Vec<Interval>> = None;
            loop {
                tried += 1;
                if tried > MOST_SLICES {
                    return None;
                }
                let middle = a + 0.5 * side * width;
                let centre = self.solved(bordered, &x, middle)?;
                let found = self.boxes(bordered, &centre, middle, 0.5 * width * OVERLAP, v);
                let found =
                    found.and_then(|boxes| Some((self.slice(bordered, &centre, middle, width, &boxes)?, boxes)));
                let is_thin = width < THIN * FIRST_SHARE * reach;
                let is_even = |by_a: Interval| by_a.low() > 0.0 && (is_thin || by_a.high() < EVEN * by_a.low());
                let Some((slice, boxes)) = found.filter(|(slice, _)| is_even(slice.kappa.by_a)) else {
                    width *= 0.5;
                    if width < THINNEST * FIRST_SHARE * reach {
                        return None;
                    }
                    continue;
                };
                // Where two slices meet they hold the same solutions: one of them, without play, lies in both.
                let between = if a == 0.0 { start.to_vec() } else { self.point(bordered, &x, a)?.holds };
                let is_in = |tried: &[Interval]| between.iter().zip(tried).all(|(at, tried)| at.is_inside(*tried));
                if !is_in(&boxes.tried) || !last.as_deref().is_none_or(is_in) {
                    return None;
                }
                a += side * width;
                let by_v: Vec<Interval> = slice.kappa.by_v.iter().zip(v).map(|(slope, v)| *slope * v.abs()).collect();
                let by_play = furthest(&by_v, &balls);
                let way = slice.kappa.by_a * Interval::from_f64(0.5 * width * side);
                let end = slice.kappa.middle + way;
                let is_end = if side > 0.0 { (end - by_play).low() > 0.0 } else { (end + by_play).high() < 0.0 };
                slices.push(slice);
                if is_end {
                    break;
                }
                x = self.solved(bordered, &centre, a)?;
                last = Some(boxes.tried);
                width = f64::min(THICKER * width, FIRST_SHARE * reach);
            }
        }
        Some(slices)
    }

    /// κ and the outputs over a slice.
    fn slice(
        &mut self,
        bordered: &Bordered<'_>,
        centre: &[f64],
        middle: f64,
        width: f64,
        boxes: &Boxes,
    ) -> Option<Slice> {
        let (n, nv) = (bordered.q0.len(), self.moving.count());
        let (m, columns) = (n + 1, n + 2 + nv);
        let matrix = preconditioned(&boxes.inverse, &boxes.matrix, m, columns, 0..m);
        let right = preconditioned(&boxes.inverse, &boxes.matrix, m, columns, m..columns);
        let ways = eliminate(matrix, m, right.into_iter().map(|entry| -entry).collect(), 1 + nv)?;
        let way = |row: usize, u: usize| ways[row * (1 + nv) + u];
        let point = self.point(bordered, centre, middle)?.holds;
        let values = self.values(&[bordered.q0, bordered.driven].concat(), &point);
        let nz = n + nv;
        let outputs = (0..self.readings.len()).map(|output| {
            let own = &boxes.of_outputs[output * nz..(output + 1) * nz];
            let by = |u: usize, direct: Interval| (0..n).fold(direct, |sum, k| sum + own[k] * way(k, u));
            Linear {
                middle: values[output],
                by_a: by(0, Interval::ZERO),
                by_v: (0..nv).map(|v| by(1 + v, own[n + v])).collect(),
            }
        });
        let outputs = outputs.collect();
        let kappa = Linear { middle: point[n], by_a: way(n, 0), by_v: (0..nv).map(|v| way(n, 1 + v)).collect() };
        Some(Slice {
            half_width: 0.5 * width * OVERLAP,
            kappa,
            outputs,
            tried: boxes.tried.clone(),
            a: Interval::from_f64(middle) + Interval::around_zero(0.5 * width * OVERLAP),
        })
    }

    /// The outputs at positions `x` without play, at the driven coordinates of `coordinates`.
    fn values(&mut self, coordinates: &[f64], x: &[Interval]) -> Vec<Interval> {
        let constant = |number: &Interval| Dual::constant(*number);
        let n = self.moving.mechanism.ideal.free;
        let q: Vec<_> = x[..n].iter().map(constant).collect();
        let v = vec![constant(&Interval::ZERO); self.moving.count()];
        self.moving.place(&mut self.first, &q, &coordinates[n..], &v);
        self.readings.iter().map(|reading| self.first.value(*reading).value).collect()
    }

    /// The solution at one a without play, known to round-off.
    fn point(&mut self, bordered: &Bordered<'_>, x: &[f64], a: f64) -> Option<Boxes> {
        let nowhere = vec![Interval::ZERO; self.moving.count()];
        self.boxes(bordered, x, a, 0.0, &nowhere)
    }

    /// A box around `x`, the solution at `a`, that holds the one solution for each a within `half` of it and each v in `v`.
    fn boxes(&mut self, bordered: &Bordered<'_>, x: &[f64], a: f64, half: f64, v: &[Interval]) -> Option<Boxes> {
        let (n, nv) = (bordered.q0.len(), v.len());
        let (m, columns) = (n + 1, n + 2 + nv);
        let plain = slopes(&self.moving, &mut self.plain, &[], &x[..n], bordered.driven, &vec![0.0; nv]);
        let at_rest = bordered.matrix(&plain.of_residuals, nv);
        let inverse = inverse_of(&at_rest, m, columns)?;
        let centre: Vec<Interval> = x.iter().map(|x| Interval::from_f64(*x)).collect();
        let open = {
            let nowhere = vec![Interval::ZERO; nv];
            let open = residuals(&self.moving, &mut self.first, &centre[..n], bordered.driven, &nowhere);
            bordered.residuals(open, &centre, a)
        };
        let parameters: Vec<Interval> = std::iter::once(Interval::around_zero(half)).chain(v.iter().copied()).collect();
        let mut radii: Vec<f64> = (0..m)
            .map(|row| {
                let step = |(column, parameter): (usize, &Interval)| {
                    let way: f64 = (0..m).map(|k| inverse[row * m + k] * at_rest[k * columns + column]).sum();
                    way.abs() * parameter.magnitude()
                };
                INFLATION * (m..columns).zip(&parameters).map(step).sum::<f64>() + 1e-13 * (1.0 + x[row].abs())
            })
            .collect();
        for _ in 0..BOXES {
            let away: Vec<Interval> = radii.iter().map(|radius| Interval::around_zero(*radius)).collect();
            let tried: Vec<Interval> = centre.iter().zip(&away).map(|(x, away)| *x + *away).collect();
            let over = slopes(&self.moving, &mut self.first, &self.readings, &tried[..n], bordered.driven, v);
            let matrix = bordered.matrix(&over.of_residuals, nv);
            let found = krawczyk_image(&inverse, &matrix, m, &open, &parameters, &away);
            if found.iter().zip(&away).all(|(found, away)| found.is_inside(*away)) {
                let holds = centre.iter().zip(&found).map(|(x, found)| *x + *found).collect();
                return Some(Boxes { holds, tried, matrix, of_outputs: over.of_outputs, inverse });
            }
            if !found.iter().all(|found| found.is_finite()) {
                return None;
            }
            for (radius, found) in radii.iter_mut().zip(&found) {
                *radius = radius.max(INFLATION * found.magnitude());
            }
        }
        None
    }

    /// Newton's method for the bordered equations at `a` without play.
    fn solved(&mut self, bordered: &Bordered<'_>, x: &[f64], a: f64) -> Option<Vec<f64>> {
        const SETTLED: f64 = 1e-15;
        let (n, nv) = (bordered.q0.len(), self.moving.count());
        let (m, columns) = (n + 1, n + 2 + nv);
        let nowhere = vec![0.0; nv];
        let mut x = x.to_vec();
        for _ in 0..NEWTON_STEPS {
            let open = residuals(&self.moving, &mut self.plain, &x[..n], bordered.driven, &nowhere);
            let open = bordered.residuals(open, &x, a);
            let plain = slopes(&self.moving, &mut self.plain, &[], &x[..n], bordered.driven, &nowhere);
            let inverse = inverse_of(&bordered.matrix(&plain.of_residuals, nv), m, columns)?;
            let step = |row: usize| (0..m).map(|k| inverse[row * m + k] * open[k]).sum::<f64>();
            let steps: Vec<f64> = (0..m).map(step).collect();
            x.iter_mut().zip(&steps).for_each(|(x, step)| *x -= step);
            if steps.iter().zip(&x).all(|(step, x)| step.abs() <= SETTLED * (1.0 + x.abs())) {
                break;
            }
        }
        x.iter().all(|x| x.is_finite()).then_some(x)
    }
}
