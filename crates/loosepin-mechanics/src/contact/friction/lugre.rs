//! LuGre: Canudas de Wit, Olsson, Åström and Lischinsky 1995.

use super::keys::{COEFFICIENT, STATIC_COEFFICIENT, STRIBECK_SPEED, VISCOUS};
use super::law::{
    BristledForce, Friction, FrictionDescription, FrictionKey, FrictionPart, friction_key, friction_numbers,
};
use loosepin_math::{Real, exponential};
use loosepin_text::document::quantity;
use loosepin_text::units::{Dimension as D, Rule};

/// g(v) is at least this: bristles settle in a time g/(σ0 |v|), so that with no friction at all they would be infinitely fast.
const MIN_COEFFICIENT: f64 = 1e-4;

/// Friction with a memory (Canudas de Wit, Olsson, Åström and Lischinsky 1995): bristles of mean deflection z
/// between the surfaces, ż = v - σ0 |v| z/g(v), F_T = -F_N (σ0 z + σ1 ż + η v), g(v) = μ_c + (μ_s - μ_c) exp(-(v/v_s)²).
///
/// All coefficients are in units of μ, so that the force vanishes with F_N; z is zero where contact begins. The law that the
/// deflection settles to is Stribeck's. The bristles store energy, which the energy account counts as lost to friction when it
/// is put in.
///
/// **Where it is passive.** With V = ½ σ0 F_N z² for what the bristles store, friction takes up the power
///
/// -F_T v = V̇ + F_N (σ0² |v| z²/g + σ1 ż v + η v²) - ½ σ0 z² Ḟ_N
///
/// so that with a constant normal force and σ1 = 0 nothing is ever gained. Bristles that are bent under a small normal force and
/// relax under a large one give back more than they took: the last term. What slips makes up for it where bristles relax faster than
/// the force grows, Ḟ_N/F_N < 2 σ0 |v|/g: for a contact that lasts τ, where the bristles' way g/σ0 is well below |v| τ. With a
/// g in the tens and more that fails, and bristles are springs that a contact winds up. σ1 adds to the loss while bristles follow v,
/// but takes away from it while they are dragged back (ż v < 0), at most σ1 (g_max - g_min)/g_min of what η v² has. A run in which
/// friction gains energy is a failed run (`loosepin-simulate`, `balance.rs`).
#[derive(Debug, Clone, Copy)]
pub struct LuGreFriction<T> {
    /// Dynamic coefficient μ_c.
    pub coefficient: T,
    /// Static coefficient μ_s.
    pub static_coefficient: T,
    /// v_s, m/s.
    pub stribeck_speed_m_s: T,
    /// σ0, 1/m.
    pub bristle_stiffness_1_m: T,
    /// σ1, s/m.
    pub bristle_damping_s_m: T,
    /// Viscous term η, s/m.
    pub viscous_s_m: T,
}

friction_numbers!(LuGreFriction {
    coefficient,
    static_coefficient,
    stribeck_speed_m_s,
    bristle_stiffness_1_m,
    bristle_damping_s_m,
    viscous_s_m
});

friction_key!(
    /// lugre: increase of the coefficient per deflection of the bristles
    BRISTLE_STIFFNESS of Bristles:
        optional bristle_stiffness = quantity(D::INVERSE_LENGTH, Rule::Positive), "\"1e5 m^-1\""
);
friction_key!(
    /// lugre: increase of the coefficient per speed of the bristles
    BRISTLE_DAMPING of Bristles:
        optional bristle_damping =
            quantity(D::INVERSE_VELOCITY, Rule::NonNegative), "\"0.4 s/m\"", or "0 s/m" called "nothing"
);

impl LuGreFriction<f64> {
    /// How model files know it.
    pub const DESCRIPTION: FrictionDescription = FrictionDescription {
        name: "lugre",
        source: "Canudas de Wit, Olsson, Åström and Lischinsky 1995: ż = v - σ0 |v| z/g(v), μ = σ0 z + σ1 ż + η v, \
                 g(v) = μ_c + (μ_s - μ_c) exp(-(v/v_s)²)",
        numbers: &[COEFFICIENT, STATIC_COEFFICIENT, STRIBECK_SPEED, BRISTLE_STIFFNESS, BRISTLE_DAMPING, VISCOUS],
        below: None,
    };
}

impl<T: Real> LuGreFriction<T> {
    /// g(v), never below [`MIN_COEFFICIENT`].
    #[inline(always)]
    fn settled(&self, velocity_m_s: T) -> T {
        let share = velocity_m_s / self.stribeck_speed_m_s;
        let peak = (self.static_coefficient - self.coefficient) * exponential(-(share * share));
        (self.coefficient + peak).max(T::from_f64(MIN_COEFFICIENT))
    }
}

impl<T: Real> Friction<T> for LuGreFriction<T> {
    /// The force that the bristles settle to in steady sliding.
    #[inline(always)]
    fn force_n(&self, sliding_velocity_m_s: T, normal_force_n: T) -> T {
        let size = self.settled(sliding_velocity_m_s);
        let signed = T::select(sliding_velocity_m_s.less_than(T::zero()), -size, size);
        -(self.viscous_s_m.mul_add(sliding_velocity_m_s, signed) * normal_force_n)
    }

    #[inline(always)]
    fn has_bristle(&self) -> bool {
        true
    }

    #[inline(always)]
    fn force_with_bristle(&self, sliding_velocity_m_s: T, normal_force_n: T, deflection_m: T) -> BristledForce<T> {
        let v = sliding_velocity_m_s;
        let spring = self.bristle_stiffness_1_m * deflection_m;
        let rate_m_s = v - v.abs() * spring / self.settled(v);
        let coefficient = self.viscous_s_m.mul_add(v, self.bristle_damping_s_m.mul_add(rate_m_s, spring));
        BristledForce { force_n: -(coefficient * normal_force_n), rate_m_s }
    }

    /// (μ_c or μ_s)/σ0, the larger.
    #[inline(always)]
    fn largest_deflection_m(&self) -> T {
        let largest = self.coefficient.max(self.static_coefficient).max(T::from_f64(MIN_COEFFICIENT));
        largest / self.bristle_stiffness_1_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAW: LuGreFriction<f64> = LuGreFriction {
        coefficient: 0.11,
        static_coefficient: 0.17,
        stribeck_speed_m_s: 8e-3,
        bristle_stiffness_1_m: 1.3e5,
        bristle_damping_s_m: 0.4,
        viscous_s_m: 0.03,
    };
    const NORMAL_N: f64 = 1700.0;

    #[test]
    fn analytic_a_stuck_contact_is_a_spring_and_a_damper() {
        // Small motions: |v| z is of second order.
        let force = LAW.force_with_bristle(1e-9, NORMAL_N, 2e-9);
        let expected_n = -NORMAL_N * (1.3e5 * 2e-9 + (0.4 + 0.03) * 1e-9);
        assert!((force.force_n / expected_n - 1.0).abs() < 1e-5);
        assert!((force.rate_m_s - 1e-9).abs() < 2e-12);
        assert_eq!(LAW.force_with_bristle(0.0, NORMAL_N, 0.0).force_n, 0.0);
        assert_eq!(LAW.force_with_bristle(0.7, 0.0, 1e-6).force_n, 0.0);
    }

    /// Bent by z under N1 and back under N2, so fast that nothing slips: σ0 z²/2 (N2 - N1) is given, whatever the steps.
    #[test]
    fn analytic_bristles_that_relax_under_a_larger_force_give_more_than_they_took() {
        let law = LuGreFriction {
            coefficient: 1e7,
            static_coefficient: 1e7,
            bristle_damping_s_m: 0.0,
            viscous_s_m: 0.0,
            ..LAW
        };
        let [small_n, large_n] = [300.0, NORMAL_N];
        let (speed_m_s, steps, step_s) = (0.1, 1000, 1e-7);
        let (mut deflection_m, mut taken_j) = (0.0, 0.0);
        for (normal_n, velocity_m_s) in [(small_n, speed_m_s), (large_n, -speed_m_s)] {
            for _ in 0..steps {
                // The force is linear in z: the rule of the midpoint is exact.
                let middle_m = deflection_m + 0.5 * step_s * velocity_m_s;
                let force = law.force_with_bristle(velocity_m_s, normal_n, middle_m);
                taken_j -= force.force_n * velocity_m_s * step_s;
                deflection_m += step_s * force.rate_m_s;
            }
        }
        let largest_m = speed_m_s * step_s * f64::from(steps);
        let given_j = 0.5 * 1.3e5 * largest_m * largest_m * (large_n - small_n);
        // σ0 z/g, what slips of it, is 1e-7.
        assert!((taken_j + given_j).abs() < 1e-6 * given_j, "{taken_j} {given_j}");
    }

    #[test]
    fn analytic_steady_sliding_settles_to_the_curve_of_stribeck() {
        for velocity_m_s in [-2.0, -7e-3, 1e-4, 3e-3, 0.4_f64] {
            // Until the bristles no longer move: their time is g/(σ0 |v|).
            let step_s = 1e-2 * 0.1 / (1.3e5 * velocity_m_s.abs());
            let mut deflection_m = 0.0;
            for _ in 0..8_000 {
                let rate_m_s = LAW.force_with_bristle(velocity_m_s, NORMAL_N, deflection_m).rate_m_s;
                deflection_m += step_s * rate_m_s;
            }
            let force_n = LAW.force_with_bristle(velocity_m_s, NORMAL_N, deflection_m).force_n;
            let size = 0.11 + 0.06 * (-(velocity_m_s / 8e-3).powi(2)).exp();
            let expected_n = -NORMAL_N * (size * velocity_m_s.signum() + 0.03 * velocity_m_s);
            // e^-80/1.7 of the start is left, and round-off.
            assert!((force_n / expected_n - 1.0).abs() < 1e-12, "{velocity_m_s}: {force_n} {expected_n}");
            assert!((LAW.force_n(velocity_m_s, NORMAL_N) / expected_n - 1.0).abs() < 1e-14);
            assert!(force_n * velocity_m_s <= 0.0, "settled friction never supplies power");
            assert!(deflection_m.abs() <= LAW.largest_deflection_m());
        }
    }
}
