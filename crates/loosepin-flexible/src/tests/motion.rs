//! Motion through time with the error control that the tests need.

use loosepin_math::integrate::{DOP853, StepRows, Stepper, System};

/// y(t) at each of `times_s`, increasing from above zero, for y' = f(t, y); relative and absolute tolerance of each unknown.
pub(super) fn at_times(
    slope: impl FnMut(f64, &[f64], &mut [f64]),
    start: &[f64],
    times_s: &[f64],
    relative: f64,
    absolute: &[f64],
) -> Vec<Vec<f64>> {
    struct Timed<F>(F);
    impl<F: FnMut(f64, &[f64], &mut [f64])> System for Timed<F> {
        fn derivative(&mut self, state: &[f64], slope: &mut [f64]) {
            let n = state.len() - 1;
            (self.0)(state[n], &state[..n], &mut slope[..n]);
            slope[n] = 1.0;
        }
    }
    let mut system = Timed(slope);
    let n = start.len() + 1;
    let stepper = Stepper::new(&DOP853, n, 0);
    let mut at = [start, &[0.0]].concat();
    let (mut end, mut point, mut stages) = (vec![0.0; n], vec![0.0; n], vec![0.0; stepper.rows() * n]);
    system.derivative(&at, &mut stages[..n]);
    let (mut step_s, mut found) = (1e-6, Vec::new());
    for &time_s in times_s {
        while at[n - 1] < time_s {
            let left_s = time_s - at[n - 1];
            let tried_s = if step_s < left_s { step_s.min(0.5 * left_s.max(step_s)) } else { left_s };
            let mut weights: Vec<f64> =
                at.iter().zip(absolute).map(|(y, absolute)| 1.0 / (absolute + relative * y.abs())).collect();
            weights.push(0.0);
            let mut rows = StepRows { start: &mut at, end: &mut end, point: &mut point, stages: &mut stages };
            let error = stepper.attempt(&mut rows, tried_s, &weights, &mut system);
            step_s = tried_s * stepper.growth(error).clamp(0.2, 6.0);
            if error <= 1.0 {
                at.clone_from(&end);
                if tried_s == left_s {
                    at[n - 1] = time_s;
                }
                let last = stepper.end_row() * n;
                stages.copy_within(last..last + n, 0);
            }
        }
        found.push(at[..n - 1].to_vec());
    }
    found
}

#[test]
fn analytic_a_pendulum_of_small_angle_swings_as_its_closed_form() {
    let found = at_times(
        |_, y, slope| (slope[0], slope[1]) = (y[1], -4.0 * y[0]),
        &[0.3, 1.1],
        &[0.7, 2.3],
        1e-12,
        &[1e-13; 2],
    );
    for (state, time_s) in found.iter().zip([0.7, 2.3_f64]) {
        let exact = 0.3 * (2.0 * time_s).cos() + 0.55 * (2.0 * time_s).sin();
        assert!((state[0] - exact).abs() < 1e-11);
    }
}
