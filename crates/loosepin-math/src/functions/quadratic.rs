//! Upper ends of quadratic functions over balls.

use crate::functions::interval::Interval;
use crate::real::Real;
use crate::solve::dense::{factor_definite, solve_definite};
use std::ops::Range;

/// Steps of the search for good multipliers; whatever it ends with gives a true upper end.
const STEPS: usize = 60;
/// Distance of |s| of every ball from one at which the iteration ends.
const SETTLED: f64 = 1e-7;

/// A quadratic function g·s + s·H s/2 of which the numbers are known to lie in intervals; s lies in a ball of radius one for each of `balls`.
pub struct QuadraticOverBalls<'a> {
    /// The numbers of each ball.
    pub balls: &'a [Range<usize>],
    /// g.
    pub gradient: &'a [Interval],
    /// H, symmetric, row by row.
    pub hessian: &'a [Interval],
}

impl QuadraticOverBalls<'_> {
    /// A number that the function nowhere exceeds; infinite where none is found.
    ///
    /// By weak duality: with multipliers λ, one for each ball, and M = Λ - H positive definite,
    ///
    /// ```text
    /// g·s + s·H s/2 ≤ Σ λ/2 + g·s - s·M s/2 ≤ Σ λ/2 + g·t - t·M t/2 + |g - M t|·(1 + |t|)
    /// ```
    ///
    /// for every s in the balls and any t; the last term vanishes for t = M⁻¹ g. H is the middle of its intervals, and what they
    /// differ from it by at most, D, adds the half of Σ |D_kl| over all pairs of balls (Frobenius norms). All of it is computed on
    /// intervals, and M is shown to be positive definite by its pivots.
    pub fn upper_end(&self) -> f64 {
        let n = self.gradient.len();
        let is_finite = self.gradient.iter().chain(self.hessian).all(|entry| entry.is_finite());
        if !is_finite {
            return f64::INFINITY;
        }
        let gradient: Vec<f64> = self.gradient.iter().map(|entry| entry.middle()).collect();
        let hessian: Vec<f64> = self.hessian.iter().map(|entry| entry.middle()).collect();
        if gradient.iter().chain(&hessian).all(|middle| *middle == 0.0) {
            // No multiplier makes Λ positive definite and adds nothing; what is left is round-off, or nothing at all.
            return self.largest_terms();
        }
        let multipliers = self.multipliers(&gradient, &hessian);
        let Some(factors) = self.shifted(&multipliers, &hessian) else { return f64::INFINITY };
        let mut point = gradient.clone();
        solve_definite(&factors, n, &mut point);
        // From here on everything is rigorous.
        let lambda = |k: usize| Interval::from_f64(multipliers[self.ball_of(k)]);
        let shifted: Vec<Interval> = (0..n * n)
            .map(|at| {
                let entry = -Interval::from_f64(hessian[at]);
                if at / n == at % n { entry + lambda(at / n) } else { entry }
            })
            .collect();
        if !factor_definite(&mut shifted.clone(), n, |pivot| pivot.low() > 0.0) {
            return f64::INFINITY;
        }
        let t: Vec<Interval> = point.iter().map(|value| Interval::from_f64(*value)).collect();
        let half = Interval::from_f64(0.5);
        let mut bound = multipliers.iter().fold(Interval::ZERO, |sum, value| sum + half * Interval::from_f64(*value));
        for row in 0..n {
            let product = (0..n).fold(Interval::ZERO, |sum, column| sum + shifted[row * n + column] * t[column]);
            let rest = self.gradient[row] - product;
            bound += self.gradient[row] * t[row] - half * t[row] * product
                + rest.abs() * (Interval::from_f64(1.0) + t[row].abs());
        }
        for first in self.balls {
            for second in self.balls {
                let squares = first.clone().flat_map(|row| second.clone().map(move |column| row * n + column)).fold(
                    Interval::ZERO,
                    |sum, at| {
                        let away = self.hessian[at] - Interval::from_f64(hessian[at]);
                        sum + away.squared()
                    },
                );
                bound += half * Interval::from_f64(squares.high()).sqrt();
            }
        }
        bound.high()
    }

    /// Σ |g_k| + Σ |H_kl|/2: every number lies between -1 and 1.
    fn largest_terms(&self) -> f64 {
        let sum = |entries: &[Interval]| entries.iter().fold(Interval::ZERO, |sum, entry| sum + entry.abs());
        (sum(self.gradient) + Interval::from_f64(0.5) * sum(self.hessian)).high()
    }

    fn ball_of(&self, place: usize) -> usize {
        self.balls.iter().position(|ball| ball.contains(&place)).unwrap_or(0)
    }

    /// Multipliers that make the upper end nearly as small as it can be: at the best |s| = 1 in each ball for s = M⁻¹ g, or λ = 0.
    fn multipliers(&self, gradient: &[f64], hessian: &[f64]) -> Vec<f64> {
        let n = gradient.len();
        let length = |ball: &Range<usize>, of: &[f64]| ball.clone().map(|k| of[k] * of[k]).sum::<f64>().sqrt();
        // By Gershgorin's circles M is positive definite with these.
        let mut multipliers: Vec<f64> = self
            .balls
            .iter()
            .map(|ball| {
                let rows = ball.clone().map(|row| hessian[row * n..(row + 1) * n].iter().map(|h| h.abs()).sum::<f64>());
                length(ball, gradient) + rows.fold(0.0, f64::max) * (1.0 + 1e-9)
            })
            .collect();
        let largest = multipliers.iter().copied().fold(0.0, f64::max);
        multipliers.iter_mut().for_each(|value| *value = value.max(1e-12 * largest));
        let mut best = (f64::INFINITY, multipliers.clone());
        for _ in 0..STEPS {
            let Some(factors) = self.shifted(&multipliers, hessian) else {
                // Not positive definite: half of the way back.
                let ways = multipliers.iter_mut().zip(&best.1);
                ways.for_each(|(value, safe)| *value = (*value * safe).sqrt().max(0.5 * (*value + safe)));
                continue;
            };
            let mut s = gradient.to_vec();
            solve_definite(&factors, n, &mut s);
            let value =
                0.5 * multipliers.iter().sum::<f64>() + 0.5 * s.iter().zip(gradient).map(|(s, g)| s * g).sum::<f64>();
            if value < best.0 {
                best = (value, multipliers.clone());
            }
            let lengths: Vec<f64> = self.balls.iter().map(|ball| length(ball, &s)).collect();
            if lengths.iter().all(|length| (length - 1.0).abs() < SETTLED) {
                break;
            }
            for (value, length) in multipliers.iter_mut().zip(lengths) {
                *value *= length.clamp(0.3, 3.0);
            }
        }
        // A little more than at the edge of being positive definite.
        best.1.iter().map(|value| value * (1.0 + 1e-12) + 1e-15 * largest).collect()
    }

    /// The factors of Λ - H; `None` if that is not positive definite.
    fn shifted(&self, multipliers: &[f64], hessian: &[f64]) -> Option<Vec<f64>> {
        let n = self.gradient.len();
        let mut matrix: Vec<f64> = hessian.iter().map(|entry| -entry).collect();
        for (ball, value) in self.balls.iter().zip(multipliers) {
            for k in ball.clone() {
                matrix[k * n + k] += value;
            }
        }
        factor_definite(&mut matrix, n, |pivot| pivot > 0.0).then_some(matrix)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(values: &[f64]) -> Vec<Interval> {
        values.iter().map(|value| Interval::from_f64(*value)).collect()
    }

    #[test]
    fn analytic_linear_function_over_two_balls() {
        // |(3, 4)| + |-2|.
        let (gradient, hessian) = (exact(&[3.0, 4.0, -2.0]), exact(&[0.0; 9]));
        let balls = [0..2, 2..3];
        let bound = QuadraticOverBalls { balls: &balls, gradient: &gradient, hessian: &hessian }.upper_end();
        assert!((7.0..7.0 + 1e-6).contains(&bound), "{bound}");
    }

    #[test]
    fn analytic_quadratic_function_over_one_ball() {
        // x + x² over |(x, y)| ≤ 1 is 2 at (1, 0); x - y² as well as x is 1 there.
        for (second, due) in [([2.0, 0.0, 0.0, 0.0], 2.0), ([0.0, 0.0, 0.0, -2.0], 1.0)] {
            let (gradient, hessian) = (exact(&[1.0, 0.0]), exact(&second));
            let bound =
                QuadraticOverBalls { balls: std::slice::from_ref(&(0..2)), gradient: &gradient, hessian: &hessian }
                    .upper_end();
            assert!((due..due + 1e-6).contains(&bound), "{bound} {due}");
        }
    }

    #[test]
    fn analytic_function_that_is_zero() {
        let balls = [0..2, 2..3];
        let [gradient, hessian] = [exact(&[0.0; 3]), exact(&[0.0; 9])];
        assert_eq!(QuadraticOverBalls { balls: &balls, gradient: &gradient, hessian: &hessian }.upper_end(), 0.0);
        // Around zero by round-off: 3 times 1e-16, and half of 9 times 1e-16.
        let about = |count: usize| vec![Interval::around_zero(1e-16); count];
        let bound = QuadraticOverBalls { balls: &balls, gradient: &about(3), hessian: &about(9) }.upper_end();
        assert!((7.5e-16..7.6e-16).contains(&bound), "{bound}");
    }

    #[test]
    fn identity_no_value_in_the_balls_lies_above_the_upper_end() {
        let spread = |index: usize| 2.0 * ((index as f64 + 1.0) * 0.618_033_988_749_895).fract() - 1.0;
        let balls = [0..2, 2..3, 3..5];
        let mut closest = f64::INFINITY;
        for case in 0..40 {
            let scale = 10f64.powi(-(case as i32 % 4));
            let gradient: Vec<f64> = (0..5).map(|k| spread(case * 31 + k)).collect();
            let mut hessian = [0.0; 25];
            for i in 0..5 {
                for j in 0..=i {
                    let value = scale * spread(1000 + case * 37 + i * 5 + j);
                    (hessian[i * 5 + j], hessian[j * 5 + i]) = (value, value);
                }
            }
            let wide: Vec<Interval> = hessian.iter().map(|value| Interval::new(value - 1e-3, value + 1e-3)).collect();
            let bound = QuadraticOverBalls { balls: &balls, gradient: &exact(&gradient), hessian: &wide }.upper_end();
            let mut largest = f64::NEG_INFINITY;
            for sample in 0..20_000 {
                let turn = |salt: f64| std::f64::consts::TAU * ((sample as f64 + 1.0) * salt).fract();
                let (a, b) = (turn(0.618_033_988_749_895), turn(0.754_877_666_246_693));
                let s = [a.cos(), a.sin(), if sample % 2 == 0 { 1.0 } else { -1.0 }, b.cos(), b.sin()];
                let mut value = 0.0;
                for i in 0..5 {
                    value += gradient[i] * s[i];
                    for j in 0..5 {
                        value += 0.5 * s[i] * s[j] * hessian[i * 5 + j];
                    }
                }
                largest = f64::max(largest, value);
            }
            assert!(largest <= bound, "{case}: {largest} {bound}");
            closest = closest.min(bound - largest);
        }
        // What the intervals of H may add: half of 25 times 1e-3, and what 20,000 samples miss.
        assert!(closest < 0.015, "{closest}");
    }
}
