//! Single steps of an embedded pair: trial, error, acceptance, dense output; on one run or on lanes.

use super::tableau::{ErrorEstimate, Row, Tableau};
use crate::{Lanes, Real};

/// A system of first-order ordinary differential equations, dy/ds = f(s, y), and integrals of functions of s and y.
pub trait System<T = f64> {
    /// Writes f(s, y) to `slope`, and behind it the integrands.
    fn derivative(&mut self, place: T, state: &[T], slope: &mut [T]);

    /// The same at an end of a step, where the system may note more than its derivative.
    #[inline(always)]
    fn derivative_at_end(&mut self, place: T, state: &[T], slope: &mut [T]) {
        self.derivative(place, state, slope);
    }
}

/// One step at a time with an embedded pair, each lane with a step of its own. The caller decides about steps, events and
/// the end.
///
/// Integrals are unknowns on which the system does not depend: they cost nothing but their sum over the stages, and take part
/// in the error only where they are given a tolerance.
#[derive(Debug, Clone)]
pub struct Stepper<T = f64> {
    tableau: &'static Tableau,
    /// Unknowns without integrals.
    dimension: usize,
    /// Unknowns with integrals: the distance between two stages.
    stride: usize,
    /// s at the start of the step.
    place: T,
    /// State at the start of the step.
    start: Vec<T>,
    /// State at the end of the step.
    end: Vec<T>,
    /// Length of the step at hand.
    step: T,
    /// Derivatives of all stages, one after the other: the step's, the one at the end, those of the dense output.
    stages: Vec<T>,
    trial: Vec<T>,
    dense: Vec<T>,
    /// Whether `dense` belongs to the step at hand.
    is_dense: bool,
    evaluations: u64,
}

impl<T: Real> Stepper<T> {
    /// Room for `dimension` unknowns.
    pub fn new(tableau: &'static Tableau, dimension: usize) -> Self {
        Self::with_integrals(tableau, dimension, 0)
    }

    /// Room for `dimension` unknowns and `integrals` integrals behind them.
    pub fn with_integrals(tableau: &'static Tableau, dimension: usize, integrals: usize) -> Self {
        let stages = tableau.stages.len() + 1 + tableau.dense_stages.len();
        let stride = dimension + integrals;
        Self {
            tableau,
            dimension,
            stride,
            place: T::zero(),
            start: vec![T::zero(); stride],
            end: vec![T::zero(); stride],
            step: T::zero(),
            stages: vec![T::zero(); stages * stride],
            trial: vec![T::zero(); stride],
            dense: vec![T::zero(); (3 + tableau.dense.len()) * stride],
            is_dense: false,
            evaluations: 0,
        }
    }

    /// Starts, or starts again, at `state`: evaluates the derivative there.
    pub fn restart(&mut self, system: &mut impl System<T>, place: T, state: &[T]) {
        self.place = place;
        self.start.copy_from_slice(state);
        system.derivative(place, &self.start[..self.dimension], &mut self.stages[..self.stride]);
        self.evaluations += 1;
        self.step = T::zero();
        self.is_dense = false;
    }

    /// Evaluates the derivative at the start of the step again in the lanes of `mask`: after the caller has changed the
    /// state or the system there.
    #[inline(always)]
    pub fn restart_where(&mut self, system: &mut impl System<T>, mask: T::Mask) {
        system.derivative_at_end(self.place, &self.start[..self.dimension], &mut self.trial);
        self.evaluations += 1;
        for (slope, fresh) in self.stages[..self.stride].iter_mut().zip(&self.trial) {
            *slope = T::select(mask, *fresh, *slope);
        }
        self.is_dense = false;
    }

    /// Tries a step: computes the state at its end and gives the error estimate over `tolerances` (one for each unknown, and
    /// for each integral or none), at most one where the step is good enough.
    #[inline(always)]
    pub fn attempt(&mut self, system: &mut impl System<T>, step: T, tolerances: &[T]) -> T {
        self.step = step;
        self.is_dense = false;
        for stage in 1..self.tableau.stages.len() {
            self.set_trial(self.tableau.stages[stage], self.dimension);
            let slope = &mut self.stages[stage * self.stride..(stage + 1) * self.stride];
            let place = step.mul_add(T::from_f64(self.tableau.nodes[stage]), self.place);
            system.derivative(place, &self.trial[..self.dimension], slope);
        }
        self.evaluations += self.tableau.stages.len() as u64 - 1;
        self.set_trial(self.tableau.weights, self.stride);
        std::mem::swap(&mut self.end, &mut self.trial);
        match self.tableau.error {
            ErrorEstimate::Single(row) => {
                self.finish(system);
                let [sum, _] = self.squares([row, row], tolerances);
                step.abs() * (sum / T::from_f64(tolerances.len() as f64)).sqrt()
            }
            ErrorEstimate::Combined { fifth, third } => {
                let [fifth, third] = self.squares([fifth, third], tolerances);
                let mixed = third.mul_add(T::from_f64(0.01), fifth) * T::from_f64(tolerances.len() as f64);
                // Both estimates zero: the smallest number keeps the quotient zero. One beyond all numbers would make it zero
                // as well: infinity times zero is not a number, and neither is the error then.
                step.abs() * fifth / mixed.sqrt().max(T::from_f64(f64::MIN_POSITIVE)) + mixed * T::zero()
            }
        }
    }

    /// Evaluates the derivative at the end of the step, once its error is good. Needed before events, dense output and
    /// [`Self::accept`].
    #[inline(always)]
    pub fn finish(&mut self, system: &mut impl System<T>) {
        let last = self.tableau.stages.len() * self.stride;
        let slope = &mut self.stages[last..last + self.stride];
        system.derivative_at_end(self.place + self.step, &self.end[..self.dimension], slope);
        self.evaluations += 1;
    }

    /// Whether [`Self::attempt`] has done the work of [`Self::finish`] already.
    pub fn finishes_by_itself(&self) -> bool {
        matches!(self.tableau.error, ErrorEstimate::Single(_))
    }

    /// Makes the end of the step the start of the next one.
    pub fn accept(&mut self) {
        let last = self.tableau.stages.len() * self.stride;
        self.place += self.step;
        std::mem::swap(&mut self.start, &mut self.end);
        self.stages.copy_within(last..last + self.stride, 0);
        self.is_dense = false;
    }

    /// Makes the end of the step the start of the next one in the lanes of `mask`. The place, which no lane shares with
    /// another, is left to the caller's own unknowns.
    #[inline(always)]
    pub fn accept_where(&mut self, mask: T::Mask) {
        let last = self.tableau.stages.len() * self.stride;
        for i in 0..self.stride {
            self.start[i] = T::select(mask, self.end[i], self.start[i]);
            self.stages[i] = T::select(mask, self.stages[last + i], self.stages[i]);
        }
        self.is_dense = false;
    }

    /// The state at `share` in [0, 1] of the finished step, by dense output.
    pub fn interpolate(&mut self, system: &mut impl System<T>, share: T, state: &mut [T]) {
        self.prepare_dense(system);
        for (i, value) in state.iter_mut().enumerate() {
            *value = self.start[i] + self.dense_sum(i, share, |term| *term);
        }
    }

    /// The dense output of unknown `i` over its start value: Hairer's nested form, read through `number`.
    #[inline]
    fn dense_sum<N: Real>(&self, i: usize, share: N, number: impl Fn(&T) -> N) -> N {
        let terms = 3 + self.tableau.dense.len();
        let mut sum = N::zero();
        for (k, term) in (0..terms).rev().enumerate() {
            sum += number(&self.dense[term * self.stride + i]);
            sum *= if (terms - 1 - k).is_multiple_of(2) { share } else { N::one() - share };
        }
        sum
    }

    /// Computes what dense output of the step at hand needs, once a step.
    pub fn prepare_dense(&mut self, system: &mut impl System<T>) {
        if self.is_dense {
            return;
        }
        let last = self.tableau.stages.len();
        for (extra, row) in self.tableau.dense_stages.iter().enumerate() {
            let stage = last + 1 + extra;
            self.set_trial(row, self.dimension);
            let place = self.step.mul_add(T::from_f64(self.tableau.dense_nodes[extra]), self.place);
            let slope = &mut self.stages[stage * self.stride..(stage + 1) * self.stride];
            system.derivative(place, &self.trial[..self.dimension], slope);
        }
        self.evaluations += self.tableau.dense_stages.len() as u64;
        let n = self.stride;
        for i in 0..n {
            let difference = self.end[i] - self.start[i];
            let first = self.step * self.stages[i];
            let second = self.step * self.stages[last * n + i];
            self.dense[i] = difference;
            self.dense[n + i] = first - difference;
            self.dense[2 * n + i] = difference + difference - (second + first);
            for (extra, row) in self.tableau.dense.iter().enumerate() {
                self.dense[(3 + extra) * n + i] = self.step * self.combine(row, i);
            }
        }
        self.is_dense = true;
    }

    /// trial = start + h Σ row · stages, for the first `count` unknowns: four at a time, so that their sums overlap.
    #[inline(always)]
    fn set_trial(&mut self, row: Row, count: usize) {
        let mut i = 0;
        while i + 4 <= count {
            self.set_group::<4>(row, i);
            i += 4;
        }
        if i + 2 <= count {
            self.set_group::<2>(row, i);
            i += 2;
        }
        if i < count {
            self.set_group::<1>(row, i);
        }
    }

    #[inline(always)]
    fn set_group<const GROUP: usize>(&mut self, row: Row, first: usize) {
        let mut sums = [T::zero(); GROUP];
        for &(stage, coefficient) in row {
            let coefficient = T::from_f64(coefficient);
            let place = stage * self.stride + first;
            for (sum, slope) in sums.iter_mut().zip(&self.stages[place..place + GROUP]) {
                *sum = slope.mul_add(coefficient, *sum);
            }
        }
        for k in 0..GROUP {
            self.trial[first + k] = self.step.mul_add(sums[k], self.start[first + k]);
        }
    }

    #[inline(always)]
    fn combine(&self, row: Row, i: usize) -> T {
        let mut sum = T::zero();
        for &(stage, coefficient) in row {
            sum = self.stages[stage * self.stride + i].mul_add(T::from_f64(coefficient), sum);
        }
        sum
    }

    /// Σ (row · stages over tolerance)² over the unknowns, for two rows.
    #[inline(always)]
    fn squares(&self, rows: [Row; 2], tolerances: &[T]) -> [T; 2] {
        let mut sums = [T::zero(); 2];
        for (i, tolerance) in tolerances.iter().enumerate() {
            let scale = T::one() / *tolerance;
            for (sum, row) in sums.iter_mut().zip(rows) {
                let ratio = self.combine(row, i) * scale;
                *sum = ratio.mul_add(ratio, *sum);
            }
        }
        sums
    }

    /// s at the start of the step: the time, s, where that is what one integrates over.
    pub fn time_s(&self) -> T {
        self.place
    }
    /// Length of the step at hand.
    pub fn step(&self) -> T {
        self.step
    }
    /// State at the start of the step.
    pub fn start(&self) -> &[T] {
        &self.start
    }
    /// State at the start of the step, to be changed before [`Self::restart_where`].
    pub fn start_mut(&mut self) -> &mut [T] {
        &mut self.start
    }
    /// State at the end of the step.
    pub fn end(&self) -> &[T] {
        &self.end
    }
    /// Derivative at the start of the step.
    pub fn start_slope(&self) -> &[T] {
        &self.stages[..self.stride]
    }
    /// Derivative at the end of the finished step.
    pub fn end_slope(&self) -> &[T] {
        let last = self.tableau.stages.len() * self.stride;
        &self.stages[last..last + self.stride]
    }
    /// Evaluations of the system so far.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }
    /// Evaluations that a tried step costs, the one at its end included.
    pub fn evaluations_per_attempt(&self) -> u64 {
        self.tableau.stages.len() as u64
    }
    /// Evaluations that the first look inside a step costs.
    pub fn evaluations_for_dense(&self) -> u64 {
        self.tableau.dense_stages.len() as u64
    }
}

impl<T: Lanes> Stepper<T> {
    /// The state of one lane at `share` in [0, 1] of the finished step. Needs [`Self::prepare_dense`].
    pub fn interpolate_lane(&self, lane: usize, share: f64, state: &mut [f64]) {
        for (i, value) in state.iter_mut().enumerate() {
            *value = self.start[i].lane(lane) + self.dense_sum(i, share, |term| term.lane(lane));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::{DOP853, DORMAND_PRINCE_5, TSITOURAS_5};

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

    /// x' = 0 but for one stage of 1e140 to 1e160: one of the two estimates overflows before the other.
    #[test]
    fn identity_an_estimate_beyond_all_numbers_is_never_a_good_step() {
        struct Spike {
            stage: usize,
            spiked: usize,
            height: f64,
        }
        impl System for Spike {
            fn derivative(&mut self, _time_s: f64, _state: &[f64], slope: &mut [f64]) {
                slope[0] = if self.stage == self.spiked { self.height } else { 0.0 };
                self.stage += 1;
            }
        }
        for spiked in 0..12 {
            for power in 0..400 {
                let mut spike = Spike { stage: 0, spiked, height: 10f64.powf(140.0 + 0.05 * f64::from(power)) };
                let mut stepper = Stepper::new(&DOP853, 1);
                stepper.restart(&mut spike, 0.0, &[0.0]);
                let error = stepper.attempt(&mut spike, 1e-3, &[1e-9]);
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
