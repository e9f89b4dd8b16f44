//! The restitution that a point-contact law delivers, for the test of each law.

use super::PointLaw;
use crate::contact::free_impact::free_impact_penetration_m;
use crate::contact::{NormalContact, PlayState, PointContact, delivered_restitution};

/// Asserts that `law` delivers `expected`, to four digits, for a nominal restitution of 0.5, 0.7 and 0.9: by the identity and by
/// integrating a free impact. Also that the law is found by its name.
pub(super) fn assert_delivers(law: &PointLaw, expected: [f64; 3]) {
    /// Four digits are given.
    const TABLE_DIGIT: f64 = 0.6e-4;
    /// The integration of the impact below, at 20,000 steps.
    const INTEGRATION: f64 = 1e-6;
    for (nominal, expected) in [0.5, 0.7, 0.9].into_iter().zip(expected) {
        let damping_factor = (law.damping_factor)(nominal);
        let by_identity = delivered_restitution(damping_factor);
        assert!((by_identity - expected).abs() < TABLE_DIGIT, "{}: {nominal} delivers {by_identity}", law.name);
        let by_integration = restitution_of_an_integrated_impact(damping_factor);
        assert!(
            (by_integration - by_identity).abs() < INTEGRATION,
            "{}: {by_integration} is not {by_identity}",
            law.name
        );
    }
}

/// Integrates m δ̈ = -F_N from δ = 0 until δ = 0 again by the classical Runge-Kutta method in the variable
/// u = √δ (the force is smooth in it) and gives the ratio of the speeds.
fn restitution_of_an_integrated_impact(damping_factor: f64) -> f64 {
    let (mass_kg, impact_speed_m_s) = (0.137, 0.83);
    let contact = PointContact { stiffness_n_m_n: 5.3e10, exponent: 1.5, damping_factor };
    let state =
        PlayState { contact: 1.0, inverse_impact_speed_s_m: 1.0 / impact_speed_m_s, effective_mass_kg: f64::NAN };
    let slope = |[u, rate]: [f64; 2]| {
        let force = contact.force(u * u, rate, &state);
        [0.5 * rate, -u * force.total_n / mass_kg]
    };
    let longest = free_impact_penetration_m(5.3e10, 1.5, damping_factor, mass_kg, impact_speed_m_s).sqrt();
    let step = 12.0 * longest / impact_speed_m_s / 20_000.0;
    let mut state = [0.0, impact_speed_m_s];
    loop {
        let add = |a: [f64; 2], b: [f64; 2], h: f64| [a[0] + h * b[0], a[1] + h * b[1]];
        let k1 = slope(state);
        let k2 = slope(add(state, k1, step / 2.0));
        let k3 = slope(add(state, k2, step / 2.0));
        let k4 = slope(add(state, k3, step));
        let next = [0, 1].map(|i| state[i] + step / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        if next[0] <= 0.0 {
            let share = state[0] / (state[0] - next[0]);
            return -(state[1] + share * (next[1] - state[1])) / impact_speed_m_s;
        }
        state = next;
    }
}
