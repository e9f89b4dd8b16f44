//! Coulomb friction modified by Ambrósio.

use crate::math::Real;

/// Friction that grows linearly between two sliding speeds (Ambrósio 2003; method, section 2.3):
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

impl<T: Real> AmbrosioFriction<T> {
    /// Speeds at which the force has a kink, m/s, in both directions of sliding: a step of an integrator should not straddle
    /// one.
    #[inline(always)]
    pub fn kink_speeds_m_s(&self) -> [T; 2] {
        [self.lower_speed_m_s, self.upper_speed_m_s]
    }

    /// F_T = -μ(|v_T|) F_N sign(v_T), N, along the tangent along which the sliding velocity v_T, m/s, is measured.
    #[inline(always)]
    pub fn force_n(&self, sliding_velocity_m_s: T, normal_force_n: T) -> T {
        let speed = sliding_velocity_m_s.abs();
        let ramp = (speed - self.lower_speed_m_s) / (self.upper_speed_m_s - self.lower_speed_m_s);
        let size = self.coefficient * ramp.max(T::zero()).min(T::one()) * normal_force_n;
        T::select(sliding_velocity_m_s.less_than(T::zero()), size, -size)
    }
}

#[cfg(test)]
mod tests {
    use super::AmbrosioFriction;

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
