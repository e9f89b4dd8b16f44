//! A spring and a damper side by side: the normal force of the linear laws.

use super::contact::{NormalContact, NormalForce, PlayState};
use crate::contact::restitution::bisect;
use loosepin_math::{Real, numbers};

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

numbers!(struct LinearContact { stiffness_n_m, damping_n_s_m, damping_ratio; has_ratio });

impl<T: Real> LinearContact<T> {
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
    fn stiffness(&self) -> Option<(T, f64)> {
        Some((self.stiffness_n_m, 1.0))
    }

    #[inline(always)]
    fn largest_force_n(&self, penetration_m: T, rate_m_s: T, state: &PlayState<T>) -> T {
        self.damping_n_s_m(state).mul_add(rate_m_s.max(T::zero()), self.elastic_n(penetration_m))
    }

    #[inline(always)]
    fn needs_effective_mass(&self) -> bool {
        self.has_ratio
    }
}

/// The restitution ε that a free impact delivers with the damping ratio ξ, the force cut at zero:
/// `-ln ε = 2ξ acos(ξ)/√(1 - ξ²)`, beyond critical damping `2ξ acosh(ξ)/√(ξ² - 1)`.
///
/// Equal to (ξ/s)(π - atan2(2ξs, 1 - 2ξ²)) with s = √(1 - ξ²), which is the phase at which the force
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

#[cfg(test)]
mod tests {
    use super::*;

    const MASS_KG: f64 = 0.137;
    const TOUCH: PlayState<f64> =
        PlayState { contact: 1.0, inverse_impact_speed_s_m: 1.0 / 0.83, effective_mass_kg: MASS_KG };

    fn contact(damping_ratio: f64) -> LinearContact<f64> {
        LinearContact { stiffness_n_m: 2.3e8, damping_n_s_m: 0.0, damping_ratio, has_ratio: true }
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
        // The other form, below critical damping.
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
