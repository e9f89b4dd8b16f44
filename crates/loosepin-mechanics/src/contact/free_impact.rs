//! The free impact of a point contact, for tests of restitution.

use super::restitution::log_remainder;
use super::{NormalContact, PlayState, PointContact};

/// Largest penetration of a free impact, m.
///
/// `K δmax^(n+1)/(n+1) = m v0² (1/χ - ln(1 + χ)/χ²)`; with χ = 0 the right side is m v0²/2.
pub(super) fn free_impact_penetration_m(
    stiffness_n_m_n: f64,
    exponent: f64,
    damping_factor: f64,
    effective_mass_kg: f64,
    impact_speed_m_s: f64,
) -> f64 {
    let share = -log_remainder(damping_factor);
    let energy_j = effective_mass_kg * impact_speed_m_s * impact_speed_m_s * share;
    libm::pow((exponent + 1.0) * energy_j / stiffness_n_m_n, 1.0 / (exponent + 1.0))
}

#[test]
fn analytic_hertz_impact() {
    // δmax = (5 m v0²/(4K))^(2/5) with m = 0.14 kg, v0 = 1 m/s, K = 6.610198e10 N/m^1.5.
    let penetration_m = free_impact_penetration_m(6.610198e10, 1.5, 0.0, 0.14, 1.0);
    assert!((penetration_m - 2.33953e-5).abs() < 1e-10);
    let contact = PointContact { stiffness_n_m_n: 6.610198e10, exponent: 1.5, damping_factor: 0.0 };
    assert!((contact.force(penetration_m, 0.0, &PlayState::flight()).total_n - 7480.12).abs() < 0.01);
}
