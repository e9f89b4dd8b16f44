//! Linear contact laws: a spring and a damper side by side.

use super::normal::{NormalContact, NormalForce};
use super::restitution::bisect;
use super::state::PlayState;
use super::{anagnostopoulos, exact_linear_restitution, kelvin_voigt};
use loosepin_math::Real;
use std::fmt::Debug;

/// A linear contact law `F_N = K δ + D δ̇`, cut at zero (method, section 2.1): it tells where D comes from.
pub trait LinearLaw: Debug + Sync {
    /// The name used in model files, in kebab case.
    fn name(&self) -> &'static str;
    /// Author, year and the equation of D, as shown in help and reports.
    fn source(&self) -> &'static str;
    /// The damping ratio ξ of `D = 2ξ √(K m_eff)` for a nominal restitution in (0, 1], m_eff the mass that the contact meets
    /// along its normal where it begins. None where D itself is given.
    fn damping_ratio(&self, restitution: f64) -> Option<f64>;
    /// Whether D itself is given.
    fn has_given_damping(&self) -> bool {
        self.damping_ratio(0.5).is_none()
    }
}

/// Every linear law.
pub static LINEAR_LAWS: &[&dyn LinearLaw] =
    &[&kelvin_voigt::KelvinVoigt, &anagnostopoulos::Anagnostopoulos, &exact_linear_restitution::ExactLinearRestitution];

/// `F_N = K δ + (D + 2ξ √(K m_eff)) δ̇`, cut at zero: D given, or ξ.
///
/// The force jumps where contact begins, to the damper's. Where the spring cannot hold the damper's pull any longer, the force
/// is zero until the contact ends at δ = 0.
#[derive(Debug, Clone, Copy)]
pub struct LinearContact<T> {
    /// Stiffness K, N/m.
    pub stiffness_n_m: T,
    /// Damping coefficient D where it is given, else zero, N s/m.
    pub damping_n_s_m: T,
    /// Damping ratio ξ where D follows from it, else zero.
    pub damping_ratio: T,
    /// Whether D follows from ξ.
    pub has_ratio: bool,
}

impl<T: Real> LinearContact<T> {
    /// The same numbers in every lane.
    pub fn broadcast(from: &LinearContact<f64>) -> Self {
        Self {
            stiffness_n_m: T::from_f64(from.stiffness_n_m),
            damping_n_s_m: T::from_f64(from.damping_n_s_m),
            damping_ratio: T::from_f64(from.damping_ratio),
            has_ratio: from.has_ratio,
        }
    }

    #[inline(always)]
    fn damping_n_s_m(&self, state: &PlayState<T>) -> T {
        if self.has_ratio {
            let critical_n_s_m = T::from_f64(2.0) * (self.stiffness_n_m * state.effective_mass_kg).sqrt();
            self.damping_ratio * critical_n_s_m
        } else {
            self.damping_n_s_m
        }
    }
}

impl<T: Real> NormalContact<T> for LinearContact<T> {
    #[inline(always)]
    fn elastic_n(&self, penetration_m: T) -> T {
        self.stiffness_n_m * penetration_m.max(T::zero())
    }

    /// The loss is D δ̇.
    #[inline(always)]
    fn damping_factor(&self) -> T {
        T::zero()
    }

    #[inline(always)]
    fn force(&self, penetration_m: T, rate_m_s: T, state: &PlayState<T>) -> NormalForce<T> {
        let elastic_n = self.stiffness_n_m * penetration_m;
        // Not the sign of δ but the state of the contact tells whether there is a damper: where contact begins, δ is zero.
        let total_n = self.damping_n_s_m(state).mul_add(rate_m_s, elastic_n) * state.contact;
        NormalForce { total_n: total_n.max(T::zero()), elastic_n: elastic_n * state.contact }
    }

    /// K δ²/2.
    #[inline(always)]
    fn stored_energy_j(&self, penetration_m: T) -> T {
        T::from_f64(0.5) * self.stiffness_n_m * penetration_m * penetration_m
    }

    #[inline(always)]
    fn largest_force_n(&self, penetration_m: T, rate_m_s: T, state: &PlayState<T>) -> T {
        self.damping_n_s_m(state).mul_add(rate_m_s.max(T::zero()), self.elastic_n(penetration_m))
    }

    #[inline(always)]
    fn needs_effective_mass(&self) -> bool {
        self.has_ratio
    }

    fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        visit(&mut self.stiffness_n_m);
        visit(&mut self.damping_n_s_m);
        visit(&mut self.damping_ratio);
    }
}

/// The restitution ε that a free impact delivers with the damping ratio ξ, the force cut at zero:
/// `-ln ε = 2ξ acos(ξ)/√(1 - ξ²)`, beyond critical damping `2ξ acosh(ξ)/√(ξ² - 1)`.
///
/// The same as (ξ/s)(π - atan2(2ξs, 1 - 2ξ²)) with s = √(1 - ξ²) (method, section 2.1), which is the phase at which the force
/// reaches zero; from there on the speed stays.
pub fn restitution_of_damping_ratio(damping_ratio: f64) -> f64 {
    libm::exp(-logarithmic_loss(damping_ratio))
}

/// The damping ratio ξ with which a free impact delivers exactly `restitution` in (0, 1].
pub fn damping_ratio_that_delivers(restitution: f64) -> f64 {
    let loss = -libm::log(restitution);
    // The loss is at least 2 ln ξ, so that ξ is at most ε^(-1/2).
    bisect(0.0, 1.0 / restitution.sqrt(), |damping_ratio| logarithmic_loss(damping_ratio) - loss)
}

/// -ln ε.
fn logarithmic_loss(damping_ratio: f64) -> f64 {
    let square = (1.0 - damping_ratio) * (1.0 + damping_ratio);
    let side = square.abs().sqrt();
    let share = if side == 0.0 {
        1.0
    } else if square > 0.0 {
        libm::atan2(side, damping_ratio) / side
    } else {
        libm::log1p(damping_ratio - 1.0 + side) / side
    };
    2.0 * damping_ratio * share
}

/// Asserts that `law` delivers `expected` for a nominal restitution of 0.5, 0.7 and 0.9 (method, section 2.1), by the formula and
/// by integrating a free impact.
#[cfg(test)]
pub(crate) fn assert_delivers(law: &dyn LinearLaw, expected: [f64; 3]) {
    /// The table has four digits.
    const TABLE_DIGIT: f64 = 0.6e-4;
    /// The integration of the impact, at 200,000 steps, of which the one with the cut loses an order.
    const INTEGRATION: f64 = 1e-8;
    for (nominal, expected) in [0.5, 0.7, 0.9].into_iter().zip(expected) {
        let damping_ratio = law.damping_ratio(nominal).expect("the law has a ratio");
        let by_formula = restitution_of_damping_ratio(damping_ratio);
        assert!((by_formula - expected).abs() < TABLE_DIGIT, "{}: {nominal} delivers {by_formula}", law.name());
        let by_integration = tests::restitution_of_an_integrated_impact(damping_ratio);
        assert!((by_integration - by_formula).abs() < INTEGRATION, "{by_integration} is not {by_formula}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MASS_KG: f64 = 0.137;
    const TOUCH: PlayState<f64> =
        PlayState { contact: 1.0, inverse_impact_speed_s_m: 1.0 / 0.83, effective_mass_kg: MASS_KG };

    fn contact(damping_ratio: f64) -> LinearContact<f64> {
        LinearContact { stiffness_n_m: 2.3e8, damping_n_s_m: 0.0, damping_ratio, has_ratio: true }
    }

    /// Integrates m δ̈ = -F_N from δ = 0 until δ = 0 again by the classical Runge-Kutta method and gives the ratio of speeds.
    pub(super) fn restitution_of_an_integrated_impact(damping_ratio: f64) -> f64 {
        let contact = contact(damping_ratio);
        let slope = |[depth, rate]: [f64; 2]| [rate, -contact.force(depth, rate, &TOUCH).total_n / MASS_KG];
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

    #[test]
    fn analytic_force_in_flight_at_the_onset_and_while_it_is_cut() {
        let contact =
            LinearContact { stiffness_n_m: 2.3e8, damping_n_s_m: 900.0, damping_ratio: 0.0, has_ratio: false };
        let flight = contact.force(0.0, 0.7, &PlayState::flight());
        assert_eq!((flight.total_n, flight.elastic_n), (0.0, 0.0));
        assert_eq!(contact.force(0.0, 0.7, &TOUCH).total_n, 900.0 * 0.7);
        let force = contact.force(3e-6, 0.7, &TOUCH);
        // Round-off on 1320 N.
        assert!((force.total_n - (2.3e8 * 3e-6 + 630.0)).abs() < 1e-9);
        assert!((force.elastic_n - 690.0).abs() < 1e-9);
        assert_eq!(contact.force(3e-6, -0.9, &TOUCH).total_n, 0.0);
    }

    #[test]
    fn identity_of_the_ratio_and_its_restitution() {
        for restitution in [1e-6, 0.03, 0.134, 0.136, 0.5, 0.77, 0.999, 1.0] {
            let damping_ratio = damping_ratio_that_delivers(restitution);
            let delivered = restitution_of_damping_ratio(damping_ratio);
            // Bisection to the last place of ξ, and round-off near critical damping.
            assert!((delivered / restitution - 1.0).abs() < 1e-12, "{restitution}: {damping_ratio} {delivered}");
        }
        // The form of the method, below critical damping.
        for ratio in [0.1, 0.4, 0.9] {
            let s = f64::sqrt(1.0 - ratio * ratio);
            let other = ratio / s * (std::f64::consts::PI - f64::atan2(2.0 * ratio * s, 1.0 - 2.0 * ratio * ratio));
            assert!((restitution_of_damping_ratio(ratio) - (-other).exp()).abs() < 1e-14);
        }
    }

    #[test]
    fn identity_the_elastic_force_is_the_slope_of_the_stored_energy() {
        let (depth_m, step_m, contact) = (2.3e-5, 1e-9, contact(0.2));
        let slope_n =
            (contact.stored_energy_j(depth_m + step_m) - contact.stored_energy_j(depth_m - step_m)) / (2.0 * step_m);
        // Round-off of the energies over the step.
        assert!((slope_n / contact.force(depth_m, 0.0, &TOUCH).elastic_n - 1.0).abs() < 1e-9);
    }
}
