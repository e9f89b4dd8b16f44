//! Single steps of an embedded pair: trial, error, acceptance, dense output.

use super::tableau::{ErrorEstimate, Row, Tableau};

/// A system of first-order ordinary differential equations, dy/dt = f(t, y).
pub trait System {
    /// Writes f(t, y) to `slope`.
    fn derivative(&mut self, time_s: f64, state: &[f64], slope: &mut [f64]);
}

/// Unknowns that are combined at once: the compiler makes vector instructions of a group.
const GROUP: usize = 4;

/// One step at a time with an embedded pair. The caller decides about steps, events and the end.
#[derive(Debug, Clone)]
pub struct Stepper {
    tableau: &'static Tableau,
    dimension: usize,
    /// Distance between two stages: the dimension rounded up to whole groups.
    stride: usize,
    /// Time at the start of the step, s.
    time_s: f64,
    /// State at the start of the step.
    start: Vec<f64>,
    /// State at the end of the step.
    end: Vec<f64>,
    /// Length of the step at hand, s.
    step_s: f64,
    /// Derivatives of all stages, one after the other: the step's, the one at the end, those of the dense output.
    stages: Vec<f64>,
    trial: Vec<f64>,
    dense: Vec<f64>,
    /// Whether `dense` belongs to the step at hand.
    is_dense: bool,
    evaluations: u64,
}

impl Stepper {
    /// Room for `dimension` unknowns.
    pub fn new(tableau: &'static Tableau, dimension: usize) -> Self {
        let stages = tableau.stages.len() + 1 + tableau.dense_stages.len();
        let stride = dimension.next_multiple_of(GROUP);
        Self {
            tableau,
            dimension,
            stride,
            time_s: 0.0,
            start: vec![0.0; stride],
            end: vec![0.0; stride],
            step_s: 0.0,
            stages: vec![0.0; stages * stride],
            trial: vec![0.0; stride],
            dense: vec![0.0; (3 + tableau.dense.len()) * dimension],
            is_dense: false,
            evaluations: 0,
        }
    }

    /// Starts, or starts again, at `state`: evaluates the derivative there.
    pub fn restart(&mut self, system: &mut impl System, time_s: f64, state: &[f64]) {
        self.time_s = time_s;
        let n = self.dimension;
        self.start[..n].copy_from_slice(state);
        system.derivative(time_s, &self.start[..n], &mut self.stages[..n]);
        self.evaluations += 1;
        self.step_s = 0.0;
        self.is_dense = false;
    }

    /// Tries a step of `step_s`: computes the state at its end and gives the error estimate over `tolerances` (one for
    /// each unknown), at most one where the step is good enough.
    pub fn attempt(&mut self, system: &mut impl System, step_s: f64, tolerances: &[f64]) -> f64 {
        let n = self.dimension;
        self.step_s = step_s;
        self.is_dense = false;
        for stage in 1..self.tableau.stages.len() {
            self.set_trial(self.tableau.stages[stage]);
            let slope = &mut self.stages[stage * self.stride..stage * self.stride + n];
            system.derivative(self.time_s + self.tableau.nodes[stage] * step_s, &self.trial[..n], slope);
        }
        self.evaluations += self.tableau.stages.len() as u64 - 1;
        self.set_trial(self.tableau.weights);
        std::mem::swap(&mut self.end, &mut self.trial);
        match self.tableau.error {
            ErrorEstimate::Single(row) => {
                self.finish(system);
                step_s.abs() * self.norm(row, tolerances)
            }
            ErrorEstimate::Combined { fifth, third } => {
                let (fifth, third) = (self.norm(fifth, tolerances), self.norm(third, tolerances));
                if fifth == 0.0 && third == 0.0 {
                    return 0.0;
                }
                step_s.abs() * fifth * fifth / (fifth * fifth + 0.01 * third * third).sqrt()
            }
        }
    }

    /// Evaluates the derivative at the end of the step, once its error is good. Needed before events, dense output and
    /// [`Self::accept`].
    pub fn finish(&mut self, system: &mut impl System) {
        let n = self.dimension;
        let last = self.tableau.stages.len() * self.stride;
        system.derivative(self.time_s + self.step_s, &self.end[..n], &mut self.stages[last..last + n]);
        self.evaluations += 1;
    }

    /// Whether [`Self::attempt`] has done the work of [`Self::finish`] already.
    pub fn finishes_by_itself(&self) -> bool {
        matches!(self.tableau.error, ErrorEstimate::Single(_))
    }

    /// Makes the end of the step the start of the next one.
    pub fn accept(&mut self) {
        let last = self.tableau.stages.len() * self.stride;
        self.time_s += self.step_s;
        std::mem::swap(&mut self.start, &mut self.end);
        self.stages.copy_within(last..last + self.stride, 0);
        self.is_dense = false;
    }

    /// The state at `share` in [0, 1] of the finished step, by dense output.
    pub fn interpolate(&mut self, system: &mut impl System, share: f64, state: &mut [f64]) {
        if !self.is_dense {
            self.prepare_dense(system);
        }
        let n = self.dimension;
        let terms = 3 + self.tableau.dense.len();
        for i in 0..n {
            let mut sum = 0.0;
            for (k, term) in (0..terms).rev().enumerate() {
                sum += self.dense[term * n + i];
                sum *= if (terms - 1 - k).is_multiple_of(2) { share } else { 1.0 - share };
            }
            state[i] = self.start[i] + sum;
        }
    }

    fn prepare_dense(&mut self, system: &mut impl System) {
        let n = self.dimension;
        let last = self.tableau.stages.len();
        for (extra, row) in self.tableau.dense_stages.iter().enumerate() {
            let stage = last + 1 + extra;
            self.set_trial(row);
            let time_s = self.time_s + self.tableau.dense_nodes[extra] * self.step_s;
            let slope = &mut self.stages[stage * self.stride..stage * self.stride + n];
            system.derivative(time_s, &self.trial[..n], slope);
        }
        self.evaluations += self.tableau.dense_stages.len() as u64;
        for i in 0..n {
            let difference = self.end[i] - self.start[i];
            let first = self.step_s * self.stages[i];
            let second = self.step_s * self.stages[last * self.stride + i];
            self.dense[i] = difference;
            self.dense[n + i] = first - difference;
            self.dense[2 * n + i] = 2.0 * difference - (second + first);
            for (extra, row) in self.tableau.dense.iter().enumerate() {
                self.dense[(3 + extra) * n + i] = self.step_s * self.combine(row, i);
            }
        }
        self.is_dense = true;
    }

    /// trial = start + h Σ row · stages.
    fn set_trial(&mut self, row: Row) {
        let groups = self.trial.chunks_exact_mut(GROUP).zip(self.start.chunks_exact(GROUP));
        for (group, (trial, start)) in groups.enumerate() {
            let mut sum = [0.0; GROUP];
            for &(stage, coefficient) in row {
                let first = stage * self.stride + group * GROUP;
                for (sum, slope) in sum.iter_mut().zip(&self.stages[first..first + GROUP]) {
                    *sum += coefficient * slope;
                }
            }
            for k in 0..GROUP {
                trial[k] = start[k] + self.step_s * sum[k];
            }
        }
    }

    #[inline]
    fn combine(&self, row: Row, i: usize) -> f64 {
        let mut sum = 0.0;
        for &(stage, coefficient) in row {
            sum += coefficient * self.stages[stage * self.stride + i];
        }
        sum
    }

    /// Root mean square of row · stages over the tolerances.
    fn norm(&self, row: Row, tolerances: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (i, tolerance) in tolerances.iter().enumerate() {
            let ratio = self.combine(row, i) / tolerance;
            sum += ratio * ratio;
        }
        (sum / self.dimension as f64).sqrt()
    }

    /// Time at the start of the step, s.
    pub fn time_s(&self) -> f64 {
        self.time_s
    }
    /// Length of the step at hand, s.
    pub fn step_s(&self) -> f64 {
        self.step_s
    }
    /// State at the start of the step.
    pub fn start(&self) -> &[f64] {
        &self.start[..self.dimension]
    }
    /// State at the end of the step.
    pub fn end(&self) -> &[f64] {
        &self.end[..self.dimension]
    }
    /// Derivative at the start of the step.
    pub fn start_slope(&self) -> &[f64] {
        &self.stages[..self.dimension]
    }
    /// Derivative at the end of the finished step.
    pub fn end_slope(&self) -> &[f64] {
        let last = self.tableau.stages.len() * self.stride;
        &self.stages[last..last + self.dimension]
    }
    /// Evaluations of the system so far.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }
    /// Order of the method.
    pub fn order(&self) -> u32 {
        self.tableau.order
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::{DOP853, DORMAND_PRINCE_5};

    /// x'' = -4 x with x(0) = 0.3, x'(0) = 1.1.
    struct Oscillator;

    impl System for Oscillator {
        fn derivative(&mut self, _time_s: f64, state: &[f64], slope: &mut [f64]) {
            slope[0] = state[1];
            slope[1] = -4.0 * state[0];
        }
    }

    fn exact(time_s: f64) -> f64 {
        0.3 * (2.0 * time_s).cos() + 0.55 * (2.0 * time_s).sin()
    }

    fn rate(time_s: f64) -> f64 {
        -0.6 * (2.0 * time_s).sin() + 1.1 * (2.0 * time_s).cos()
    }

    /// Errors at t = 2.3 s, at the end of the steps and in the middle of the last one, after `steps` equal steps.
    fn errors(tableau: &'static Tableau, steps: u32) -> (f64, f64) {
        let mut stepper = Stepper::new(tableau, 2);
        stepper.restart(&mut Oscillator, 0.0, &[0.3, 1.1]);
        let step_s = 2.3 / f64::from(steps);
        let mut inside = 0.0;
        for _ in 0..steps {
            stepper.attempt(&mut Oscillator, step_s, &[1e-9; 2]);
            stepper.finish(&mut Oscillator);
            let mut state = [0.0; 2];
            stepper.interpolate(&mut Oscillator, 0.37, &mut state);
            inside = (state[0] - exact(stepper.time_s() + 0.37 * step_s)).abs();
            stepper.accept();
        }
        ((stepper.start()[0] - exact(2.3)).hypot(stepper.start()[1] - rate(2.3)), inside)
    }

    #[test]
    fn identity_orders_of_step_and_dense_output() {
        // Halving the step divides the error by 2^order; a quarter of an order is left for higher terms.
        for (tableau, steps, order, dense_order) in [(&DORMAND_PRINCE_5, 16, 5.0, 4.0), (&DOP853, 4, 8.0, 7.0)] {
            let (coarse, coarse_inside) = errors(tableau, steps);
            let (fine, fine_inside) = errors(tableau, 2 * steps);
            let found = (coarse / fine).log2();
            let found_inside = (coarse_inside / fine_inside).log2();
            assert!(found > order - 0.25, "{}: order {found}", tableau.name);
            assert!(found_inside > dense_order - 0.25, "{}: dense order {found_inside}", tableau.name);
        }
    }

    #[test]
    fn identity_rows_sum_to_their_nodes() {
        for tableau in [&DORMAND_PRINCE_5, &DOP853] {
            for (row, node) in tableau.stages.iter().zip(tableau.nodes) {
                let sum: f64 = row.iter().map(|(_, a)| a).sum();
                assert!((sum - node).abs() < 1e-14, "{}", tableau.name);
            }
            let sum: f64 = tableau.weights.iter().map(|(_, b)| b).sum();
            assert!((sum - 1.0).abs() < 1e-14);
        }
    }
}
