//! Single steps of an embedded pair: trial, error, dense output. Written once over [`Real`]: for one run, and for what many runs
//! on lanes do, written down.

use super::tableau::{ErrorEstimate, Tableau, TableauRow};
use crate::Real;

/// A system of first-order ordinary differential equations, dy/ds = f(y), and integrals of functions of y.
pub trait System<T = f64> {
    /// Writes f(y) to `slope`, and behind it the integrands.
    fn derivative(&mut self, state: &[T], slope: &mut [T]);

    /// The derivative at an end of a step, where the system may note more than its derivative. The integrals stand behind the
    /// unknowns of `state`.
    fn derivative_at_end(&mut self, state: &[T], slope: &mut [T]) {
        self.derivative(state, slope);
    }
}

/// The numbers of a step, which the caller keeps; each row has one number for each unknown and each integral.
#[derive(Debug)]
pub struct StepRows<'r, T> {
    /// State at the start of the step.
    pub start: &'r mut [T],
    /// State at the end of the step.
    pub end: &'r mut [T],
    /// Point of the next evaluation of the derivative.
    pub point: &'r mut [T],
    /// [`Stepper::rows`] rows: derivatives at the start and at the points of the step, at its end, at the further points of the
    /// dense output; then the dense output itself.
    pub stages: &'r mut [T],
}

/// The arithmetic of steps with an embedded pair. The caller decides about steps, events and the end.
///
/// Integrals are unknowns on which the system does not depend: they cost nothing but their sum over the stages, and take part
/// in the error only where they are given a tolerance.
#[derive(Debug, Clone, Copy)]
pub struct Stepper {
    tableau: &'static Tableau,
    /// Unknowns without integrals.
    dimension: usize,
    /// Unknowns with integrals: the length of a row.
    stride: usize,
}

impl Stepper {
    /// Steps of `dimension` unknowns and `integrals` integrals behind them.
    pub fn new(tableau: &'static Tableau, dimension: usize, integrals: usize) -> Self {
        Self { tableau, dimension, stride: dimension + integrals }
    }

    /// Rows of [`StepRows::stages`].
    pub fn rows(&self) -> usize {
        self.dense_row() + 3 + self.tableau.dense.len()
    }

    /// The row of the derivative at the end of the step.
    pub fn end_row(&self) -> usize {
        self.tableau.stages.len()
    }

    /// The first row of the dense output.
    fn dense_row(&self) -> usize {
        self.end_row() + 1 + self.tableau.dense_stages.len()
    }

    /// Tries a step: computes the state at its end and the derivative there, and gives the error estimate times `weights`, one over
    /// tolerances (one for each unknown, and for each integral or none), at most one where the step is good enough. Row 0 of the stages
    /// holds the derivative at the start.
    pub fn attempt<T: Real>(
        &self,
        rows: &mut StepRows<'_, T>,
        step: T,
        weights: &[T],
        system: &mut impl System<T>,
    ) -> T {
        for stage in 1..self.end_row() {
            self.derivative_at_point(rows, stage, self.tableau.stages[stage], step, system);
        }
        for i in 0..self.stride {
            rows.end[i] = step.mul_add(self.combine(rows.stages, self.tableau.weights, i), rows.start[i]);
        }
        let slope = &mut rows.stages[self.end_row() * self.stride..(self.end_row() + 1) * self.stride];
        system.derivative_at_end(rows.end, slope);
        let count = T::from_f64(weights.len() as f64);
        match self.tableau.error {
            ErrorEstimate::Single(row) => {
                let [sum, _] = self.squares(rows.stages, [row, row], weights);
                step.abs() * (sum / count).sqrt()
            }
            ErrorEstimate::Combined { fifth, third } => {
                let [fifth, third] = self.squares(rows.stages, [fifth, third], weights);
                let mixed = third.mul_add(T::from_f64(0.01), fifth) * count;
                // Both estimates zero: the smallest number keeps the quotient zero. One beyond all numbers would make it zero
                // as well, and is no error then.
                let error = step.abs() * fifth / mixed.sqrt().max(T::from_f64(f64::MIN_POSITIVE));
                T::select(mixed.less_than(T::from_f64(f64::INFINITY)), error, T::from_f64(f64::NAN))
            }
        }
    }

    /// Computes what dense output of the current step needs, once a step.
    pub fn prepare_dense<T: Real>(&self, rows: &mut StepRows<'_, T>, step: T, system: &mut impl System<T>) {
        for (extra, row) in self.tableau.dense_stages.iter().enumerate() {
            self.derivative_at_point(rows, self.end_row() + 1 + extra, row, step, system);
        }
        let n = self.stride;
        let (stages, dense) = rows.stages.split_at_mut(self.dense_row() * n);
        for i in 0..n {
            let slopes = [stages[i], stages[self.end_row() * n + i]];
            for (term, value) in cubic_terms([rows.start[i], rows.end[i]], slopes, step).into_iter().enumerate() {
                dense[term * n + i] = value;
            }
            for (extra, row) in self.tableau.dense.iter().enumerate() {
                dense[(3 + extra) * n + i] = step * self.combine(stages, row, i);
            }
        }
    }

    /// The same for a step of another method: the polynomial of degree three with the slopes at both ends.
    pub fn prepare_cubic<T: Real>(&self, rows: &mut StepRows<'_, T>, step: T) {
        let n = self.stride;
        let (stages, dense) = rows.stages.split_at_mut(self.dense_row() * n);
        for i in 0..n {
            let slopes = [stages[i], stages[self.end_row() * n + i]];
            for (term, value) in cubic_terms([rows.start[i], rows.end[i]], slopes, step).into_iter().enumerate() {
                dense[term * n + i] = value;
            }
            for extra in 0..self.tableau.dense.len() {
                dense[(3 + extra) * n + i] = T::zero();
            }
        }
    }

    /// Unknown `i` at `share` in [0, 1] of the step over its value at the start, by Hairer's nested form of the dense output;
    /// `number` reads a number of [`StepRows::stages`].
    #[inline]
    pub fn dense_change<T: Real>(&self, i: usize, share: T, number: impl Fn(usize) -> T) -> T {
        let terms = 3 + self.tableau.dense.len();
        let mut sum = T::zero();
        for (k, term) in (0..terms).rev().enumerate() {
            sum += number((self.dense_row() + term) * self.stride + i);
            sum *= if (terms - 1 - k).is_multiple_of(2) { share } else { T::one() - share };
        }
        sum
    }

    /// 0.9 · error^(-1/order): how much longer the next step may be. The eighth root by square roots, which cost less.
    pub fn growth<T: Real>(&self, error: T) -> T {
        /// An error of zero lets the step grow as much as this one.
        const SMALLEST: f64 = 1e-300;
        let share = T::from_f64(0.9);
        match self.tableau.order {
            8 => share / error.sqrt().sqrt().sqrt(),
            order => share * error.max(T::from_f64(SMALLEST)).powf(-1.0 / f64::from(order)),
        }
    }

    /// Evaluations of the system that a tried step costs, the one at its end included.
    pub fn evaluations_per_attempt(&self) -> u64 {
        self.tableau.stages.len() as u64
    }

    /// Evaluations that the first look inside a step costs.
    pub fn evaluations_for_dense(&self) -> u64 {
        self.tableau.dense_stages.len() as u64
    }

    /// The derivative at start + h Σ row · stages, to the row `stage`.
    fn derivative_at_point<T: Real>(
        &self,
        rows: &mut StepRows<'_, T>,
        stage: usize,
        row: TableauRow,
        step: T,
        system: &mut impl System<T>,
    ) {
        for i in 0..self.dimension {
            rows.point[i] = step.mul_add(self.combine(rows.stages, row, i), rows.start[i]);
        }
        let slope = &mut rows.stages[stage * self.stride..(stage + 1) * self.stride];
        system.derivative(&rows.point[..self.dimension], slope);
    }

    /// Σ row · stages for the unknown `i`.
    #[inline(always)]
    fn combine<T: Real>(&self, stages: &[T], row: TableauRow, i: usize) -> T {
        let mut sum = T::zero();
        for &(stage, coefficient) in row {
            sum = stages[stage * self.stride + i].mul_add(T::from_f64(coefficient), sum);
        }
        sum
    }

    /// Σ (weight · row · stages)² over the unknowns, for two rows.
    fn squares<T: Real>(&self, stages: &[T], rows: [TableauRow; 2], weights: &[T]) -> [T; 2] {
        let mut sums = [T::zero(); 2];
        for (i, weight) in weights.iter().enumerate() {
            for (sum, row) in sums.iter_mut().zip(rows) {
                let ratio = self.combine(stages, row, i) * *weight;
                *sum = ratio.mul_add(ratio, *sum);
            }
        }
        sums
    }
}

/// Terms of the cubic through the ends of a step, with the slopes there, in Hairer's nested form.
#[inline]
fn cubic_terms<T: Real>([start, end]: [T; 2], slopes: [T; 2], step: T) -> [T; 3] {
    let difference = end - start;
    let [first, second] = slopes.map(|slope| step * slope);
    [difference, first - difference, difference + difference - (second + first)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::{DOP853, DORMAND_PRINCE_5, TSITOURAS_5};

    /// x'' = -4 x with x(0) = 0.3, x'(0) = 1.1.
    struct Oscillator;

    impl System for Oscillator {
        fn derivative(&mut self, state: &[f64], slope: &mut [f64]) {
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
        let mut run = Run::new(tableau, &[0.3, 1.1], &mut Oscillator);
        let step_s = 2.3 / f64::from(steps);
        let mut inside = 0.0;
        for step in 0..steps {
            run.attempt(step_s, &[1e9; 2], &mut Oscillator);
            run.stepper.prepare_dense(&mut run.numbers.rows(), step_s, &mut Oscillator);
            let found = run.numbers.start[0] + run.stepper.dense_change(0, 0.37, |place| run.numbers.stages[place]);
            inside = (found - exact((f64::from(step) + 0.37) * step_s)).abs();
            run.accept();
        }
        ((run.numbers.start[0] - exact(2.3)).hypot(run.numbers.start[1] - rate(2.3)), inside)
    }

    /// The numbers of a step.
    struct Numbers {
        start: Vec<f64>,
        end: Vec<f64>,
        point: Vec<f64>,
        stages: Vec<f64>,
    }

    impl Numbers {
        fn rows(&mut self) -> StepRows<'_, f64> {
            StepRows { start: &mut self.start, end: &mut self.end, point: &mut self.point, stages: &mut self.stages }
        }
    }

    struct Run {
        stepper: Stepper,
        numbers: Numbers,
    }

    impl Run {
        fn new(tableau: &'static Tableau, start: &[f64], system: &mut impl System) -> Self {
            let n = start.len();
            let stepper = Stepper::new(tableau, n, 0);
            let mut stages = vec![0.0; stepper.rows() * n];
            system.derivative(start, &mut stages[..n]);
            let numbers = Numbers { start: start.to_vec(), end: vec![0.0; n], point: vec![0.0; n], stages };
            Self { stepper, numbers }
        }

        fn attempt(&mut self, step: f64, weights: &[f64], system: &mut impl System) -> f64 {
            self.stepper.attempt(&mut self.numbers.rows(), step, weights, system)
        }

        fn accept(&mut self) {
            let n = self.numbers.start.len();
            self.numbers.start.clone_from(&self.numbers.end);
            let end = self.stepper.end_row() * n;
            self.numbers.stages.copy_within(end..end + n, 0);
        }
    }

    /// x' = 0 but for one stage of 1e140 to 1e160: one of the two estimates overflows before the other.
    #[test]
    fn identity_an_estimate_beyond_all_numbers_is_never_a_good_step() {
        struct Spike {
            stage: usize,
            spiked: usize,
            height: f64,
        }
        impl System for Spike {
            fn derivative(&mut self, _state: &[f64], slope: &mut [f64]) {
                slope[0] = if self.stage == self.spiked { self.height } else { 0.0 };
                self.stage += 1;
            }
        }
        for spiked in 0..12 {
            for power in 0..400 {
                let mut spike = Spike { stage: 0, spiked, height: 10f64.powf(140.0 + 0.05 * f64::from(power)) };
                let mut run = Run::new(&DOP853, &[0.0], &mut spike);
                let error = run.attempt(1e-3, &[1e9], &mut spike);
                // The estimates look at the first stage and at those from the sixth on.
                assert_eq!(
                    error <= 1.0,
                    (1..5).contains(&spiked),
                    "stage {spiked} at {:e}: error {error:e}",
                    spike.height
                );
            }
        }
    }

    #[test]
    fn identity_orders_of_step_and_dense_output() {
        // Halving the step divides the error by 2^order; a quarter of an order is left for higher terms.
        let cases = [(&DORMAND_PRINCE_5, 16, 5.0, 4.0), (&TSITOURAS_5, 16, 5.0, 4.0), (&DOP853, 4, 8.0, 7.0)];
        for (tableau, steps, order, dense_order) in cases {
            let (coarse, coarse_inside) = errors(tableau, steps);
            let (fine, fine_inside) = errors(tableau, 2 * steps);
            let found = (coarse / fine).log2();
            let found_inside = (coarse_inside / fine_inside).log2();
            assert!(found > order - 0.25, "{}: order {found}", tableau.name);
            assert!(found_inside > dense_order - 0.25, "{}: dense order {found_inside}", tableau.name);
        }
    }
}
