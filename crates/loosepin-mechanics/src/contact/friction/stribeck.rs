//! Stribeck's curve.

use super::keys::{COEFFICIENT, STATIC_COEFFICIENT, STRIBECK_SPEED, TRANSITION_SPEED, VISCOUS};
use super::law::{Friction, FrictionDescription, friction_numbers};
use loosepin_math::{Real, exponential, hyperbolic_tangent};

/// Friction that falls from its static to its dynamic value (Stribeck 1902, as Bo and Pavelescu 1982 write it):
/// μ(v) = (μ_c + (μ_s - μ_c) exp(-(v/v_s)²)) tanh(4v/v_t) + η v.
///
/// The hyperbolic tangent stands for the sign of v: the curve itself does not begin at zero. It is full, 0.9993, at v_t.
#[derive(Debug, Clone, Copy)]
pub struct StribeckFriction<T> {
    /// Dynamic coefficient μ_c.
    pub coefficient: T,
    /// Static coefficient μ_s.
    pub static_coefficient: T,
    /// v_s, m/s.
    pub stribeck_speed_m_s: T,
    /// v_t, m/s.
    pub transition_speed_m_s: T,
    /// Viscous term η, in units of μ, s/m.
    pub viscous_s_m: T,
}

friction_numbers!(StribeckFriction {
    coefficient,
    static_coefficient,
    stribeck_speed_m_s,
    transition_speed_m_s,
    viscous_s_m
});

impl StribeckFriction<f64> {
    /// How model files know it.
    pub const DESCRIPTION: FrictionDescription = FrictionDescription {
        name: "stribeck",
        source: "Stribeck 1902, Bo and Pavelescu 1982: (μ_c + (μ_s - μ_c) exp(-(v/v_s)²)) tanh(4v/v_t) + η v",
        numbers: &[COEFFICIENT, STATIC_COEFFICIENT, STRIBECK_SPEED, TRANSITION_SPEED, VISCOUS],
        below: None,
    };
}

impl<T: Real> Friction<T> for StribeckFriction<T> {
    #[inline(always)]
    fn force_n(&self, sliding_velocity_m_s: T, normal_force_n: T) -> T {
        let v = sliding_velocity_m_s;
        let share = v / self.stribeck_speed_m_s;
        let peak = (self.static_coefficient - self.coefficient) * exponential(-(share * share));
        let sign = hyperbolic_tangent(T::from_f64(4.0) * v / self.transition_speed_m_s);
        -(((self.coefficient + peak) * sign + self.viscous_s_m * v) * normal_force_n)
    }
}

#[cfg(test)]
mod tests {
    use super::StribeckFriction;
    use crate::contact::friction::coefficient::assert_coefficient;

    #[test]
    fn analytic_stick_and_slip() {
        let law = StribeckFriction {
            coefficient: 0.11,
            static_coefficient: 0.17,
            stribeck_speed_m_s: 8e-3,
            transition_speed_m_s: 2e-3,
            viscous_s_m: 0.03,
        };
        assert_coefficient(&law, |v| (0.11 + 0.06 * (-(v / 8e-3).powi(2)).exp()) * (4.0 * v / 2e-3).tanh() + 0.03 * v);
    }
}
