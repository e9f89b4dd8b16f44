//! Threlfall 1978.

use super::keys::{COEFFICIENT, TRANSITION_SPEED};
use super::law::{Friction, FrictionDescription, KinkSpeeds, friction_numbers};
use loosepin_math::{Real, exponential};

/// Friction that grows steeply and evens out (Threlfall 1978): μ(v) = μ (1 - exp(-3v/v_r)) up to v_r, and from there on constant, 0.95 μ.
#[derive(Debug, Clone, Copy)]
pub struct ThrelfallFriction<T> {
    /// Coefficient μ.
    pub coefficient: T,
    /// v_r, m/s.
    pub transition_speed_m_s: T,
}

friction_numbers!(ThrelfallFriction { coefficient, transition_speed_m_s });

impl ThrelfallFriction<f64> {
    /// How model files know it.
    pub const DESCRIPTION: FrictionDescription = FrictionDescription {
        name: "threlfall",
        source: "Threlfall 1978: μ (1 - exp(-3v/v_r)) up to v_r, constant and continuous beyond",
        numbers: &[COEFFICIENT, TRANSITION_SPEED],
        below: None,
    };
}

impl<T: Real> Friction<T> for ThrelfallFriction<T> {
    #[inline(always)]
    fn force_n(&self, sliding_velocity_m_s: T, normal_force_n: T) -> T {
        let share = (sliding_velocity_m_s.abs() / self.transition_speed_m_s).min(T::one());
        let size = self.coefficient * (T::one() - exponential(share * T::from_f64(-3.0))) * normal_force_n;
        T::select(sliding_velocity_m_s.less_than(T::zero()), size, -size)
    }

    #[inline(always)]
    fn kink_speeds_m_s(&self) -> KinkSpeeds<T> {
        [Some(self.transition_speed_m_s), None]
    }
}

#[cfg(test)]
mod tests {
    use super::ThrelfallFriction;
    use crate::contact::friction::coefficient::assert_coefficient;

    #[test]
    fn analytic_stick_and_slip() {
        let law = ThrelfallFriction { coefficient: 0.13, transition_speed_m_s: 2e-3 };
        assert_coefficient(&law, |v| 0.13 * (1.0 - (-3.0 * (v / 2e-3_f64).min(1.0)).exp()));
    }
}
