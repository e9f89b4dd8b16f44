//! Radau IIA of three stages and order five, an implicit method for stiff equations of motion: L-stable, so that frequencies far above one
//! over the step die away instead of limiting it. Hairer and Wanner, "Solving Ordinary Differential Equations II", 2nd edition, section IV.8.
//!
//! Of the unknowns y = (q, v, z) with q̇ = v, v̇ = a(y) and constant ż the stages are found by simplified Newton iterations on q and v:
//!
//! ```text
//! Y_i = y + h Σ a_ij f(Y_j),   A⁻¹ = T diag(γ, [α -β; β α]) T⁻¹,   (μ - J) x = r  for μ = γ/h and (α + iβ)/h
//! J = [0 1; J_q J_v]:   (μ² - μ J_v - J_q) x_q = r_v + (μ - J_v) r_q,   x_v = μ x_q - r_q
//! ```
//!
//! J_q and J_v are differences in the middle of the step, taken anew where the iterations become slow: stiff directions turn with the bodies. The error
//! estimate is of order three, solved with the real factors.

use super::radau_tables::{ALPHA, BETA, ERROR, GAMMA, NODES, T, T_INVERSE, WEIGHTS};
use super::{StepRows, System};
use crate::solve::complex_lu::ComplexLu;
use crate::solve::dense::RealLu;

/// Newton iterations of a step.
const ITERATIONS: usize = 8;
/// What may be left of the stages, in units of the error allowed in a step.
const LEFT: f64 = 1e-2;
/// Convergence factor of the iterations above which the Jacobian is taken anew.
const SLOW: f64 = 0.1;
/// Shortening of the step where they do not converge.
const SHORTER: f64 = 0.4;
/// Growth of the next step up to which it stays as it is, so that the factors serve again.
const SAME: f64 = 1.3;
/// Iterations from which on the next step does not grow: another orientation of stiff directions slows them down, and a longer step more so.
const MANY: usize = 5;
/// Least error that counts, so that a step grows by no more than some hundred times.
const MIN_ERROR: f64 = 1e-12;
/// Change of a rate over which J_v is taken, over that of its coordinate, 1/s.
const RATE_OVER_PLACE: f64 = 1e3;
/// Distance of times, over the step, that is round-off.
const SAME_TIME: f64 = 1e-9;
/// Size of a first change below which it is round-off, over what may be left.
const NOTHING: f64 = 1e-3;
/// Convergence factor of iterations that do not converge.
const DIVERGES: f64 = 0.95;

/// Result of an attempted step.
#[derive(Debug, Clone, Copy)]
pub struct RadauAttempt {
    /// Error over tolerance, at most one where the step is good.
    pub error: f64,
    /// How much longer the next step may be.
    pub growth: f64,
    /// Evaluations of the system.
    pub evaluations: u64,
    /// Factorizations, each of the real and of the complex matrix.
    pub factorizations: u64,
}

/// Steps of the method.
#[derive(Debug, Clone)]
pub struct Radau {
    freedoms: usize,
    dimension: usize,
    stride: usize,
    /// Changes of q over which J_q is taken.
    differences: Vec<f64>,
    /// Whether J_v is taken.
    has_damping: bool,
    /// J_q and J_v, row by row.
    by_place: Vec<f64>,
    by_rate: Vec<f64>,
    /// Whether J belongs to a state near by, and whether to that of this step.
    is_known: bool,
    is_fresh: bool,
    /// The step for which the factors stand.
    factored: f64,
    real: RealLu,
    complex: ComplexLu,
    /// Y_i - y.
    changes: [Vec<f64>; 3],
    /// T⁻¹ of them, one row for each eigenvalue.
    transformed: [Vec<f64>; 3],
    /// f(Y_i).
    slopes: [Vec<f64>; 3],
    /// Time at the end of the last good attempt and its length, where `changes` still hold its stages.
    last: Option<(f64, f64)>,
    /// Iterations of the last good attempt.
    iterations: usize,
}

impl Radau {
    /// Workspace for `freedoms` coordinates q, `dimension` unknowns, and `integrals` of them.
    pub fn new(freedoms: usize, dimension: usize, integrals: usize, differences: Vec<f64>, has_damping: bool) -> Self {
        let stride = dimension + integrals;
        let rows = || std::array::from_fn(|_| vec![0.0; stride]);
        Self {
            freedoms,
            dimension,
            stride,
            differences,
            has_damping,
            by_place: vec![0.0; freedoms * freedoms],
            by_rate: vec![0.0; freedoms * freedoms],
            is_known: false,
            is_fresh: false,
            factored: 0.0,
            real: RealLu::new(freedoms),
            complex: ComplexLu::new(freedoms),
            changes: rows(),
            transformed: rows(),
            slopes: rows(),
            last: None,
            iterations: 0,
        }
    }

    /// Forgets what it knows of a state near by.
    pub fn restart(&mut self) {
        self.is_known = false;
        self.last = None;
    }

    /// Tries a step: the state at its end, and the slope there in the row `end_row` of the stages. Row 0 holds that at the start.
    pub fn attempt(
        &mut self,
        rows: &mut StepRows<'_, f64>,
        end_row: usize,
        step: f64,
        weights: &[f64],
        system: &mut impl System,
    ) -> RadauAttempt {
        let (mut evaluations, mut factorizations) = (0, 0);
        self.is_fresh = false;
        self.guess(rows, step);
        let guess = self.changes.clone();
        let converged = loop {
            self.changes.clone_from(&guess);
            if !self.is_known {
                self.take_jacobian(rows, system);
                evaluations += 1 + (self.freedoms * if self.has_damping { 2 } else { 1 }) as u64;
            }
            if self.factored != step {
                self.factor(step);
                factorizations += 1;
            }
            let found = self.iterate(rows, step, weights, system, &mut evaluations);
            if found || self.is_fresh {
                break found;
            }
            self.is_known = false;
        };
        if !converged {
            self.last = None;
            return RadauAttempt { error: 2.0, growth: SHORTER, evaluations, factorizations };
        }
        for i in 0..self.dimension {
            rows.end[i] = rows.start[i] + self.changes[2][i];
        }
        // The weights of the last stage are those of the step.
        let end = end_row * self.stride;
        for i in self.dimension..self.stride {
            let sum: f64 = WEIGHTS.iter().zip(&self.slopes).map(|(weight, slopes)| weight * slopes[i]).sum();
            rows.end[i] = rows.start[i] + step * sum;
        }
        system.derivative_at_end(rows.end, &mut rows.stages[end..end + self.stride]);
        evaluations += 1;
        let mut error = self.error(rows, None, step, weights);
        if error >= 1.0 {
            // The estimate again from a start that is off by it, so that stiff parts of the slope there do not count.
            let own = self.transformed[0].clone();
            for i in 0..self.dimension {
                rows.point[i] = rows.start[i] + if i < 2 * self.freedoms { own[i] } else { 0.0 };
            }
            let mut slope = vec![0.0; self.stride];
            system.derivative(&rows.point[..self.dimension], &mut slope);
            evaluations += 1;
            error = self.error(rows, Some(&slope), step, weights);
        }
        // Hairer's safety factor: less where the iterations were many.
        let safety = 0.9 * (2 * ITERATIONS + 1) as f64 / (2 * ITERATIONS + self.iterations) as f64;
        let mut growth = safety / error.max(MIN_ERROR).sqrt().sqrt();
        if self.iterations >= MANY {
            growth = growth.min(1.0);
        }
        if growth > 1.0 && growth < SAME {
            growth = 1.0;
        }
        self.last = Some((rows.start[2 * self.freedoms] + step, step));
        RadauAttempt { error, growth, evaluations, factorizations }
    }

    /// x of (μ - J) x = (0, r) with the real factors of the last step, r/(μ² + ω²) of q in a direction of frequency ω: where ω² is far above μ² it takes a difference r between two
    /// accelerations off, and there is next to nothing in the others.
    pub fn stiff_share(&self, difference: &[f64]) -> Vec<f64> {
        let mut right = vec![0.0; 2 * self.freedoms];
        right[self.freedoms..].copy_from_slice(difference);
        self.solve_real(&mut right, GAMMA / self.factored);
        right
    }

    /// J at the second stage as it is guessed.
    fn take_jacobian(&mut self, rows: &mut StepRows<'_, f64>, system: &mut impl System) {
        let n = self.freedoms;
        let mut slope = vec![0.0; self.stride];
        let middle: Vec<f64> = (0..self.dimension).map(|i| rows.start[i] + self.changes[1][i]).collect();
        let mut own = vec![0.0; self.stride];
        system.derivative(&middle, &mut own);
        for column in 0..n {
            rows.point[..self.dimension].copy_from_slice(&middle);
            rows.point[column] += self.differences[column];
            let difference = rows.point[column] - middle[column];
            system.derivative(&rows.point[..self.dimension], &mut slope);
            for row in 0..n {
                self.by_place[row * n + column] = (slope[n + row] - own[n + row]) / difference;
            }
        }
        for column in 0..n {
            if !self.has_damping {
                break;
            }
            rows.point[..self.dimension].copy_from_slice(&middle);
            rows.point[n + column] += RATE_OVER_PLACE * self.differences[column];
            let difference = rows.point[n + column] - middle[n + column];
            system.derivative(&rows.point[..self.dimension], &mut slope);
            for row in 0..n {
                self.by_rate[row * n + column] = (slope[n + row] - own[n + row]) / difference;
            }
        }
        (self.is_known, self.is_fresh, self.factored) = (true, true, 0.0);
    }

    /// The factors for a step.
    fn factor(&mut self, step: f64) {
        let n = self.freedoms;
        let (gamma, alpha, beta) = (GAMMA / step, ALPHA / step, BETA / step);
        for row in 0..n {
            for column in 0..n {
                let k = row * n + column;
                let one = if row == column { 1.0 } else { 0.0 };
                let (by_place, by_rate) = (self.by_place[k], self.by_rate[k]);
                self.real.matrix[k] = gamma * gamma * one - gamma * by_rate - by_place;
                self.complex.real[k] = (alpha * alpha - beta * beta) * one - alpha * by_rate - by_place;
                self.complex.imaginary[k] = 2.0 * alpha * beta * one - beta * by_rate;
            }
        }
        self.real.factor();
        self.complex.factor();
        self.factored = step;
    }

    /// Finds the stages; false where the iterations do not converge.
    fn iterate(
        &mut self,
        rows: &mut StepRows<'_, f64>,
        step: f64,
        weights: &[f64],
        system: &mut impl System,
        evaluations: &mut u64,
    ) -> bool {
        let (n, dimension) = (self.freedoms, self.dimension);
        for i in 0..2 * n {
            for k in 0..3 {
                self.transformed[k][i] = (0..3).map(|j| T_INVERSE[k][j] * self.changes[j][i]).sum();
            }
        }
        let mut last = 0.0;
        for iteration in 0..ITERATIONS {
            for k in 0..3 {
                for i in 0..dimension {
                    rows.point[i] = rows.start[i] + self.changes[k][i];
                }
                system.derivative(&rows.point[..dimension], &mut self.slopes[k]);
            }
            *evaluations += 3;
            let mut right = [const { Vec::new() }; 3];
            for (k, right) in right.iter_mut().enumerate() {
                *right = (0..2 * n).map(|i| (0..3).map(|j| T_INVERSE[k][j] * self.slopes[j][i]).sum::<f64>()).collect();
            }
            let w = &self.transformed;
            for i in 0..2 * n {
                right[0][i] -= GAMMA / step * w[0][i];
                right[1][i] -= (ALPHA * w[1][i] - BETA * w[2][i]) / step;
                right[2][i] -= (BETA * w[1][i] + ALPHA * w[2][i]) / step;
            }
            self.solve_real(&mut right[0], GAMMA / step);
            let [_, second, third] = &mut right;
            self.solve_complex(second, third, [ALPHA / step, BETA / step]);
            let mut sum = 0.0;
            for i in 0..2 * n {
                for k in 0..3 {
                    self.transformed[k][i] += right[k][i];
                }
                for k in 0..3 {
                    let change: f64 = (0..3).map(|j| T[k][j] * right[j][i]).sum();
                    self.changes[k][i] += change;
                    sum += (change * weights[i]).powi(2);
                }
            }
            let size = (sum / (6 * n) as f64).sqrt();
            if !size.is_finite() {
                return false;
            }
            if iteration > 0 {
                let factor: f64 = size / last;
                if factor >= DIVERGES {
                    return false;
                }
                if factor / (1.0 - factor) * size <= LEFT {
                    if factor > SLOW {
                        self.is_known = false;
                    }
                    self.iterations = iteration + 1;
                    return true;
                }
                let at_the_end = (iteration + 1..ITERATIONS).fold(size, |size, _| size * factor);
                if at_the_end / (1.0 - factor) > LEFT {
                    return false;
                }
            } else if size <= NOTHING * LEFT {
                self.iterations = 1;
                return true;
            }
            last = size;
        }
        false
    }

    /// First guess of the stages: the extrapolated last step, or the rates.
    fn guess(&mut self, rows: &StepRows<'_, f64>, step: f64) {
        let n = self.freedoms;
        let time = rows.start[2 * n];
        match self.last {
            Some((end, length)) if (end - time).abs() <= SAME_TIME * length => {
                let ratio = step / length;
                for i in 0..2 * n {
                    let [first, second, whole] = [0, 1, 2].map(|k| self.changes[k][i]);
                    // The polynomial through the start and the stages of the last step.
                    let [of_first, of_second] = [(first, NODES[0]), (second, NODES[1])]
                        .map(|(change, c)| (change - c * whole) / (c * (1.0 - c)));
                    let bend = (of_second - of_first) / (NODES[1] - NODES[0]);
                    let level = of_first - NODES[0] * bend;
                    for k in 0..3 {
                        let share = 1.0 + NODES[k] * ratio;
                        self.changes[k][i] = share * whole + share * (1.0 - share) * bend.mul_add(share, level) - whole;
                    }
                }
            }
            _ => {
                for k in 0..3 {
                    for i in 0..n {
                        self.changes[k][i] = NODES[k] * step * rows.start[n + i];
                        self.changes[k][n + i] = 0.0;
                    }
                }
            }
        }
        // The stages are overwritten: they serve once.
        self.last = None;
        for k in 0..3 {
            for i in 2 * n..self.dimension {
                self.changes[k][i] = NODES[k] * step * rows.stages[i];
            }
        }
    }

    /// The error estimate, which stays in the first of the transformed rows; `slope`: that at the start, where it is another.
    fn error(&mut self, rows: &StepRows<'_, f64>, slope: Option<&[f64]>, step: f64, weights: &[f64]) -> f64 {
        let n = self.freedoms;
        let slope = slope.unwrap_or(&rows.stages[..self.stride]);
        let mut right: Vec<f64> =
            (0..2 * n).map(|i| slope[i] + (0..3).map(|k| ERROR[k] * self.changes[k][i]).sum::<f64>() / step).collect();
        self.solve_real(&mut right, GAMMA / step);
        let sum: f64 = right.iter().zip(weights).map(|(error, weight)| (error * weight).powi(2)).sum();
        self.transformed[0][..2 * n].copy_from_slice(&right);
        (sum / (2 * n) as f64).sqrt()
    }

    /// (μ - J) x = r in place.
    fn solve_real(&self, right: &mut [f64], mu: f64) {
        let n = self.freedoms;
        let (places, rates) = right.split_at_mut(n);
        let mut unknown: Vec<f64> = (0..n).map(|i| rates[i] + mu * places[i]).collect();
        if self.has_damping {
            for (i, unknown) in unknown.iter_mut().enumerate() {
                *unknown -= (0..n).map(|j| self.by_rate[i * n + j] * places[j]).sum::<f64>();
            }
        }
        self.real.solve(&mut unknown);
        for i in 0..n {
            rates[i] = mu * unknown[i] - places[i];
            places[i] = unknown[i];
        }
    }

    /// The same for complex μ and r.
    fn solve_complex(&self, real: &mut [f64], imaginary: &mut [f64], [mu, nu]: [f64; 2]) {
        let n = self.freedoms;
        let (places, rates) = real.split_at_mut(n);
        let (places_i, rates_i) = imaginary.split_at_mut(n);
        let mut unknown: Vec<f64> = (0..n).map(|k| rates[k] + mu * places[k] - nu * places_i[k]).collect();
        let mut unknown_i: Vec<f64> = (0..n).map(|k| rates_i[k] + mu * places_i[k] + nu * places[k]).collect();
        if self.has_damping {
            for i in 0..n {
                let row = &self.by_rate[i * n..(i + 1) * n];
                unknown[i] -= row.iter().zip(&*places).map(|(slope, place)| slope * place).sum::<f64>();
                unknown_i[i] -= row.iter().zip(&*places_i).map(|(slope, place)| slope * place).sum::<f64>();
            }
        }
        self.complex.solve(&mut unknown, &mut unknown_i);
        for k in 0..n {
            rates[k] = mu * unknown[k] - nu * unknown_i[k] - places[k];
            rates_i[k] = mu * unknown_i[k] + nu * unknown[k] - places_i[k];
            places[k] = unknown[k];
            places_i[k] = unknown_i[k];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// q̈ = -ω² q - 2ζω q̇, or that of a pendulum, with the time as third unknown and ∫ q dt.
    struct Oscillator {
        omega: f64,
        damping_ratio: f64,
        is_pendulum: bool,
    }

    impl System for Oscillator {
        fn derivative(&mut self, state: &[f64], slope: &mut [f64]) {
            let place = if self.is_pendulum { state[0].sin() } else { state[0] };
            slope[0] = state[1];
            slope[1] = -self.omega * self.omega * place - 2.0 * self.damping_ratio * self.omega * state[1];
            slope[2] = 1.0;
            slope[3] = state[0];
        }
    }

    /// The state after `steps` steps from q = 0.3, q̇ = -0.2, and the error that was estimated in the first.
    fn run(system: &mut Oscillator, steps: usize, step: f64) -> ([f64; 4], f64) {
        let mut radau = Radau::new(1, 3, 1, vec![1e-7], system.damping_ratio > 0.0);
        let (mut start, mut end, mut point, mut stages) = ([0.3, -0.2, 0.0, 0.0], [0.0; 4], [0.0; 4], [0.0; 8]);
        let mut first = f64::NAN;
        for _ in 0..steps {
            let mut slope = [0.0; 4];
            system.derivative(&start, &mut slope);
            stages[..4].copy_from_slice(&slope);
            let mut rows = StepRows { start: &mut start, end: &mut end, point: &mut point, stages: &mut stages };
            let found = radau.attempt(&mut rows, 1, step, &[1e11; 3], system);
            if first.is_nan() {
                first = found.error * 1e-11;
            }
            start = end;
        }
        (start, first)
    }

    /// w = q̇ - z̄ q with ẇ = z w is multiplied by R(zh) = (1 + 2x/5 + x²/20)/(1 - 3x/5 + 3x²/20 - x³/60), x = zh.
    #[test]
    fn analytic_a_step_of_a_linear_oscillator() {
        for (omega, damping_ratio) in [(0.3, 0.0), (5.0, 0.1), (40.0, 0.0), (1e3, 0.5)] {
            let mut system = Oscillator { omega, damping_ratio, is_pendulum: false };
            let ([q, v, time, _], _) = run(&mut system, 1, 1.0);
            let z = [-damping_ratio * omega, omega * (1.0 - damping_ratio * damping_ratio).sqrt()];
            let times = |a: [f64; 2], b: [f64; 2]| [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
            let [square, cube] = [times(z, z), times(times(z, z), z)];
            let above = [1.0 + 0.4 * z[0] + 0.05 * square[0], 0.4 * z[1] + 0.05 * square[1]];
            let below =
                [1.0 - 0.6 * z[0] + 0.15 * square[0] - cube[0] / 60.0, -0.6 * z[1] + 0.15 * square[1] - cube[1] / 60.0];
            let of = |q: f64, v: f64| [v - z[0] * q, z[1] * q];
            let (left, right) = (times(below, of(q, v)), times(above, of(0.3, -0.2)));
            let size = right[0].hypot(right[1]);
            for k in 0..2 {
                assert!((left[k] - right[k]).abs() < 1e-9 * size, "{omega}: {left:?} for {right:?}");
            }
            assert_eq!(time, 1.0);
        }
    }

    /// Order five of a pendulum and of the integral, order four of the first error estimate (h times that of its slope).
    #[test]
    fn analytic_order_of_a_pendulum() {
        let mut system = Oscillator { omega: 2.0, damping_ratio: 0.0, is_pendulum: true };
        let (exact, _) = run(&mut system, 1280, 1.0 / 640.0);
        let [coarse, fine] = [20, 40].map(|steps| {
            let (found, error) = run(&mut system, steps, 2.0 / steps as f64);
            ([0, 1, 3].map(|k| (found[k] - exact[k]).abs()), error)
        });
        for k in 0..3 {
            let order = (coarse.0[k] / fine.0[k]).log2();
            assert!((order - 5.0).abs() < 0.4, "{k}: {order}");
        }
        let order = (coarse.1 / fine.1).log2();
        assert!((order - 4.0).abs() < 0.3, "{order}");
    }
}
