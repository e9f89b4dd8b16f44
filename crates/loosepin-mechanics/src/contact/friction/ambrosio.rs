//! Coulomb friction modified by Ambrósio.

use super::keys::COEFFICIENT;
use super::law::{
    Friction, FrictionDescription, FrictionKey, FrictionPart, KinkSpeeds, friction_key, friction_numbers,
};
use loosepin_math::Real;
use loosepin_text::document::quantity;
use loosepin_text::units::{Dimension as D, Rule};

/// Friction that grows linearly between two sliding speeds (Ambrósio 2003):
/// μ(v) = 0 for v <= v_a, μ (v - v_a)/(v_b - v_a) between, μ beyond v_b.
#[derive(Debug, Clone, Copy)]
pub struct AmbrosioFriction<T> {
    /// Coefficient μ.
    pub coefficient: T,
    /// v_a, m/s.
    pub lower_speed_m_s: T,
    /// v_b, m/s.
    pub upper_speed_m_s: T,
}

friction_numbers!(AmbrosioFriction { coefficient, lower_speed_m_s, upper_speed_m_s });

friction_key!(
    /// ambrosio: sliding speed up to which there is no friction
    LOWER_SPEED of Ramp: optional lower_speed = quantity(D::VELOCITY, Rule::NonNegative), "\"0.1 mm/s\"", or "0.1 mm/s"
);
friction_key!(
    /// ambrosio: sliding speed above which friction has its full value
    UPPER_SPEED of Ramp: optional upper_speed = quantity(D::VELOCITY, Rule::Positive), "\"1 mm/s\"", or "1 mm/s"
);

impl AmbrosioFriction<f64> {
    /// How model files know it.
    pub const DESCRIPTION: FrictionDescription = FrictionDescription {
        name: "ambrosio",
        source: "Coulomb friction modified by Ambrósio 2003: linear from zero at v_a to μ at v_b",
        numbers: &[COEFFICIENT, LOWER_SPEED, UPPER_SPEED],
        below: Some(["lower_speed", "upper_speed"]),
    };
}

impl<T: Real> Friction<T> for AmbrosioFriction<T> {
    #[inline(always)]
    fn force_n(&self, sliding_velocity_m_s: T, normal_force_n: T) -> T {
        let speed = sliding_velocity_m_s.abs();
        let ramp = (speed - self.lower_speed_m_s) / (self.upper_speed_m_s - self.lower_speed_m_s);
        let size = self.coefficient * ramp.max(T::zero()).min(T::one()) * normal_force_n;
        T::select(sliding_velocity_m_s.less_than(T::zero()), size, -size)
    }

    #[inline(always)]
    fn kink_speeds_m_s(&self) -> KinkSpeeds<T> {
        [Some(self.lower_speed_m_s), Some(self.upper_speed_m_s)]
    }
}

#[cfg(test)]
mod tests {
    use super::{AmbrosioFriction, Friction};

    #[test]
    fn analytic_stick_ramp_and_slip_in_both_directions() {
        let friction = AmbrosioFriction { coefficient: 0.13, lower_speed_m_s: 1e-4, upper_speed_m_s: 1e-3 };
        for (speed, share) in [(0.0, 0.0), (0.99e-4, 0.0), (5.5e-4, 0.5), (1.01e-3, 1.0), (3.7, 1.0)] {
            for sign in [-1.0, 1.0] {
                let force_n = friction.force_n(sign * speed, 1700.0);
                // Round-off on 221 N.
                assert!((force_n + sign * share * 0.13 * 1700.0).abs() < 1e-10, "{speed}: {force_n}");
                assert!(force_n * sign * speed <= 0.0, "friction never supplies power");
            }
        }
    }
}
