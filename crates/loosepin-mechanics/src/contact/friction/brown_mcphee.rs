//! Brown and McPhee 2016.

use super::keys::{COEFFICIENT, STATIC_COEFFICIENT, TRANSITION_SPEED, VISCOUS};
use super::law::{Friction, FrictionDescription, friction_numbers};
use loosepin_math::{Real, hyperbolic_tangent};

/// A smooth Stribeck curve (Brown and McPhee 2016):
/// μ(v) = μ_d tanh(4v/v_t) + (μ_s - μ_d) (v/v_t)/(¼(v/v_t)² + ¾)² + η v. It peaks at v_t.
///
/// Their viscous force grows with the normal force up to a transition force; ours is proportional to it, in units of μ.
#[derive(Debug, Clone, Copy)]
pub struct BrownMcPheeFriction<T> {
    /// Dynamic coefficient μ_d.
    pub coefficient: T,
    /// Static coefficient μ_s.
    pub static_coefficient: T,
    /// v_t, m/s.
    pub transition_speed_m_s: T,
    /// Viscous term η, in units of μ, s/m.
    pub viscous_s_m: T,
}

friction_numbers!(BrownMcPheeFriction { coefficient, static_coefficient, transition_speed_m_s, viscous_s_m });

impl BrownMcPheeFriction<f64> {
    /// How model files know it.
    pub const DESCRIPTION: FrictionDescription = FrictionDescription {
        name: "brown-mcphee",
        source: "Brown and McPhee 2016: μ_d tanh(4v/v_t) + (μ_s - μ_d) (v/v_t)/(¼(v/v_t)² + ¾)² + η v",
        numbers: &[COEFFICIENT, STATIC_COEFFICIENT, TRANSITION_SPEED, VISCOUS],
        below: None,
    };
}

impl<T: Real> Friction<T> for BrownMcPheeFriction<T> {
    #[inline(always)]
    fn force_n(&self, sliding_velocity_m_s: T, normal_force_n: T) -> T {
        let share = sliding_velocity_m_s / self.transition_speed_m_s;
        let width = (share * share).mul_add(T::from_f64(0.25), T::from_f64(0.75));
        let peak = (self.static_coefficient - self.coefficient) * share / (width * width);
        let dynamic = self.coefficient * hyperbolic_tangent(share * T::from_f64(4.0));
        -((dynamic + peak + self.viscous_s_m * sliding_velocity_m_s) * normal_force_n)
    }
}

#[cfg(test)]
mod tests {
    use super::BrownMcPheeFriction;
    use crate::contact::friction::coefficient::assert_coefficient;

    #[test]
    fn analytic_stick_and_slip() {
        let law = BrownMcPheeFriction {
            coefficient: 0.11,
            static_coefficient: 0.17,
            transition_speed_m_s: 2e-3,
            viscous_s_m: 0.03,
        };
        assert_coefficient(&law, |v| {
            let share: f64 = v / 2e-3;
            0.11 * (4.0 * share).tanh() + 0.06 * share / (share * share / 4.0 + 0.75).powi(2) + 0.03 * v
        });
    }
}
