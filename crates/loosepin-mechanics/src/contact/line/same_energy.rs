//! Force by another law in an impact that was computed by a first one: where it has stored the same energy.

use crate::contact::NormalLaw;
use crate::contact::normal::NormalContact;
use crate::contact::restitution::bisect;

/// Penetrations are looked for up to this many times that of the first law where the other has no limit of its own.
const FURTHEST: f64 = 1e3;

/// F_el of `other` at the penetration δ' where it has stored what `law` has at `penetration_m`: ∫₀^δ' F'_el dδ = ∫₀^δ F_el dδ, N.
///
/// An impact without loss ends its approach where the energy ½ m v² is stored, whatever the law, so this is the peak force of the same
/// impact under the other law; the loss of a law changes both peaks alike, to first order. Not for forces that a load holds in balance:
/// those are the load's. `None` where the other law does not reach that energy before its limit.
pub fn force_of_same_energy_n(law: &NormalLaw<f64>, penetration_m: f64, other: &NormalLaw<f64>) -> Option<f64> {
    let energy_j = law.stored_energy_j(penetration_m);
    let deepest_m = other.limit_m().unwrap_or(FURTHEST * penetration_m);
    if !(energy_j > 0.0) || other.stored_energy_j(deepest_m) < energy_j {
        return None;
    }
    Some(other.elastic_n(bisect(0.0, deepest_m, |depth_m| other.stored_energy_j(depth_m) - energy_j)))
}

#[cfg(test)]
mod tests {
    use super::force_of_same_energy_n;
    use crate::contact::line::johnson::JOHNSON;
    use crate::contact::{LinePair, NormalContact, NormalLaw, PlayState, PointContact};

    /// A steel pin of 19.9 mm in a hole of 20 mm, 40 mm long.
    fn laws() -> [NormalLaw<f64>; 2] {
        let compliance_1_pa = (1.0 - 0.3 * 0.3) / 207e9;
        let compliances_1_pa = [compliance_1_pa; 2];
        let pair = LinePair { bearing_radius_m: 0.020, clearance_m: 1e-4, length_m: 0.040, compliances_1_pa };
        // K of eq. (9) by hand: 4/3 E* √(R_i R_j/c).
        let stiffness_n_m_n = 4.0 / 3.0 * pair.equivalent_modulus_pa() * (0.020_f64 * 0.0199 / 1e-4).sqrt();
        let point = NormalLaw::from(PointContact { stiffness_n_m_n, exponent: 1.5, damping_factor: 0.0 });
        [point, (JOHNSON.contact)(&pair, 0.0)]
    }

    /// The largest force of a mass that hits without loss, by small steps of the midpoint rule.
    fn peak_force_n(law: &NormalLaw<f64>, mass_kg: f64, speed_m_s: f64) -> f64 {
        let state = PlayState { contact: 1.0, inverse_impact_speed_s_m: 1.0 / speed_m_s, effective_mass_kg: f64::NAN };
        let force_n = |depth_m: f64| law.force(depth_m, 0.0, &state).total_n;
        let (mut depth_m, mut rate_m_s, mut peak_n) = (0.0, speed_m_s, 0.0_f64);
        let step_s = 2e-9;
        while rate_m_s > 0.0 {
            let middle_m = depth_m + 0.5 * step_s * rate_m_s;
            rate_m_s -= step_s * force_n(middle_m) / mass_kg;
            depth_m = middle_m + 0.5 * step_s * rate_m_s;
            peak_n = peak_n.max(force_n(depth_m));
        }
        peak_n
    }

    #[test]
    fn identity_an_impact_without_loss_has_the_force_of_the_same_energy() {
        /// Of the integration by steps of 2 ns in an impact of tens of microseconds.
        const INTEGRATION: f64 = 1e-4;
        let [point, line] = laws();
        let (mass_kg, speed_m_s) = (14.0, 0.13);
        let depth_m = (5.0 * mass_kg * speed_m_s * speed_m_s / (4.0 * point.elastic_n(1.0))).powf(0.4);
        let found_n = force_of_same_energy_n(&point, depth_m, &line).unwrap_or_else(|| panic!("beyond the limit"));
        let [of_point_n, of_line_n] = [&point, &line].map(|law| peak_force_n(law, mass_kg, speed_m_s));
        assert!((found_n / of_line_n - 1.0).abs() < INTEGRATION, "{found_n} {of_line_n}");
        // The laws differ by much more than that.
        assert!(of_line_n > 1.4 * of_point_n, "{of_line_n} {of_point_n}");
    }

    #[test]
    fn beyond_the_limit_of_the_other_law_there_is_no_force() {
        let [point, line] = laws();
        assert_eq!(force_of_same_energy_n(&point, 2e-3, &line), None);
        assert_eq!(force_of_same_energy_n(&point, 0.0, &line), None);
    }
}
