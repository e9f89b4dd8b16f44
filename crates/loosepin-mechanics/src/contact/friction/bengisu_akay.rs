//! Bengisu and Akay 1994.

use super::keys::{COEFFICIENT, STATIC_COEFFICIENT, TRANSITION_SPEED};
use super::law::{
    Friction, FrictionDescription, FrictionKey, FrictionPart, KinkSpeeds, friction_key, friction_numbers,
};
use loosepin_math::{Real, exponential};
use loosepin_text::document::quantity;
use loosepin_text::units::{Dimension as D, Rule};

/// A parabola up to the static coefficient, then an exponential down to the dynamic one (Bengisu and Akay 1994):
/// μ(v) = μ_s - (μ_s/v_a²)(v - v_a)² for v < v_a, μ_c + (μ_s - μ_c) exp(-ξ(v - v_a)) beyond.
#[derive(Debug, Clone, Copy)]
pub struct BengisuAkayFriction<T> {
    /// Dynamic coefficient μ_c.
    pub coefficient: T,
    /// Static coefficient μ_s.
    pub static_coefficient: T,
    /// v_a, m/s.
    pub transition_speed_m_s: T,
    /// ξ, s/m: how fast friction falls.
    pub decay_s_m: T,
}

friction_numbers!(BengisuAkayFriction { coefficient, static_coefficient, transition_speed_m_s, decay_s_m });

friction_key!(
    /// bengisu-akay: rate of the decrease of friction from its static to its dynamic value
    DECAY of Fall: optional decay = quantity(D::INVERSE_VELOCITY, Rule::NonNegative), "\"30 s/m\""
);

impl BengisuAkayFriction<f64> {
    /// How model files know it.
    pub const DESCRIPTION: FrictionDescription = FrictionDescription {
        name: "bengisu-akay",
        source: "Bengisu and Akay 1994: μ_s - (μ_s/v_a²)(v - v_a)² for v < v_a, μ_c + (μ_s - μ_c) exp(-ξ(v - v_a)) beyond",
        numbers: &[COEFFICIENT, STATIC_COEFFICIENT, TRANSITION_SPEED, DECAY],
        below: None,
    };
}

impl<T: Real> Friction<T> for BengisuAkayFriction<T> {
    #[inline(always)]
    fn force_n(&self, sliding_velocity_m_s: T, normal_force_n: T) -> T {
        let beyond = sliding_velocity_m_s.abs() - self.transition_speed_m_s;
        let share = beyond / self.transition_speed_m_s;
        let rising = self.static_coefficient * (T::one() - share * share);
        let decay = exponential(-(self.decay_s_m * beyond.max(T::zero())));
        let falling = (self.static_coefficient - self.coefficient).mul_add(decay, self.coefficient);
        let size = T::select(beyond.less_than(T::zero()), rising, falling) * normal_force_n;
        T::select(sliding_velocity_m_s.less_than(T::zero()), size, -size)
    }

    #[inline(always)]
    fn kink_speeds_m_s(&self) -> KinkSpeeds<T> {
        [Some(self.transition_speed_m_s), None]
    }
}

#[cfg(test)]
mod tests {
    use super::BengisuAkayFriction;
    use crate::contact::friction::coefficient::assert_coefficient;

    #[test]
    fn analytic_stick_and_slip() {
        let law = BengisuAkayFriction {
            coefficient: 0.11,
            static_coefficient: 0.17,
            transition_speed_m_s: 2e-3,
            decay_s_m: 31.0,
        };
        assert_coefficient(&law, |v| {
            if v < 2e-3 { 0.17 - 0.17 / 4e-6 * (v - 2e-3).powi(2) } else { 0.11 + 0.06 * (-31.0 * (v - 2e-3)).exp() }
        });
    }
}
