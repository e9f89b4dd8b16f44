//! The restitution that a linear law delivers, for the test of each law.

use super::LinearLaw;
use crate::contact::{LinearContact, NormalContact, PlayState, restitution_of_damping_ratio};

const MASS_KG: f64 = 0.137;

/// Asserts that `law` delivers `expected`, to four digits, for a nominal restitution of 0.5, 0.7 and 0.9: by the
/// formula and by integrating a free impact.
pub(super) fn assert_delivers(law: &LinearLaw, expected: [f64; 3]) {
    /// Four digits are given.
    const TABLE_DIGIT: f64 = 0.6e-4;
    /// The integration of the impact, at 200,000 steps, of which the one with the cut loses an order.
    const INTEGRATION: f64 = 1e-8;
    for (nominal, expected) in [0.5, 0.7, 0.9].into_iter().zip(expected) {
        let damping_ratio = law.damping_ratio.expect("the law has a ratio")(nominal);
        let by_formula = restitution_of_damping_ratio(damping_ratio);
        assert!((by_formula - expected).abs() < TABLE_DIGIT, "{}: {nominal} delivers {by_formula}", law.name);
        let by_integration = restitution_of_an_integrated_impact(damping_ratio);
        assert!((by_integration - by_formula).abs() < INTEGRATION, "{by_integration} is not {by_formula}");
    }
}

/// Integrates m δ̈ = -F_N from δ = 0 until δ = 0 again by the classical Runge-Kutta method and gives the ratio of speeds.
fn restitution_of_an_integrated_impact(damping_ratio: f64) -> f64 {
    let contact = LinearContact { stiffness_n_m: 2.3e8, damping_n_s_m: 0.0, damping_ratio, has_ratio: true };
    let touch = PlayState { contact: 1.0, inverse_impact_speed_s_m: 1.0 / 0.83, effective_mass_kg: MASS_KG };
    let slope = |[depth, rate]: [f64; 2]| [rate, -contact.force(depth, rate, &touch).total_n / MASS_KG];
    let step_s = 20.0 * (MASS_KG / contact.stiffness_n_m).sqrt() / 200_000.0;
    let mut state = [0.0, 0.83];
    loop {
        let add = |a: [f64; 2], b: [f64; 2], h: f64| [a[0] + h * b[0], a[1] + h * b[1]];
        let k1 = slope(state);
        let k2 = slope(add(state, k1, step_s / 2.0));
        let k3 = slope(add(state, k2, step_s / 2.0));
        let k4 = slope(add(state, k3, step_s));
        let next = [0, 1].map(|i| state[i] + step_s / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        // The speed no longer changes once the force is cut.
        if next[0] <= 0.0 {
            return -next[1] / 0.83;
        }
        state = next;
    }
}
