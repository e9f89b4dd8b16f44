//! The interface of a friction law.

use loosepin_math::Real;

/// Sliding speeds at which a friction law has a kink, m/s: a step of an integrator should not straddle one.
pub type KinkSpeeds<T> = [Option<T>; 2];

/// A friction force and the rate of the deflection that goes with it.
#[derive(Debug, Clone, Copy)]
pub struct BristledForce<T> {
    /// F_T, N.
    pub force_n: T,
    /// ż, m/s.
    pub rate_m_s: T,
}

/// The numbers of a friction law and its equation: what the equations of motion evaluate.
pub trait Friction<T: Real> {
    /// F_T = -μ(|v_T|) F_N sign(v_T), N, along the tangent along which the sliding velocity v_T, m/s, is measured.
    fn force_n(&self, sliding_velocity_m_s: T, normal_force_n: T) -> T;

    /// Speeds at which the slope of μ jumps, in both directions of sliding, in rising order.
    #[inline(always)]
    fn kink_speeds_m_s(&self) -> KinkSpeeds<T> {
        [None, None]
    }

    /// Whether the law has a memory: the mean deflection z of bristles between the surfaces.
    #[inline(always)]
    fn has_bristle(&self) -> bool {
        false
    }

    /// The force at a deflection z, m, of the bristles, and ż. Without bristles z has no meaning.
    #[inline(always)]
    fn force_with_bristle(&self, sliding_velocity_m_s: T, normal_force_n: T, _deflection_m: T) -> BristledForce<T> {
        BristledForce { force_n: self.force_n(sliding_velocity_m_s, normal_force_n), rate_m_s: T::zero() }
    }

    /// The largest deflection of the bristles in steady sliding, m: what the tolerance of z is a share of.
    #[inline(always)]
    fn largest_deflection_m(&self) -> T {
        T::zero()
    }
}

/// What a friction law is made from, and how its numbers are shown: both in the order of its description.
macro_rules! friction_numbers {
    ($friction:ident { $($number:ident),* }) => {
        loosepin_math::numbers!(struct $friction { $($number),* });

        impl $friction<f64> {
            /// The law with its numbers in the order of its description.
            pub(super) fn from_numbers(numbers: &[f64]) -> Self {
                let &[$($number),*] = numbers else { unreachable!("a law takes the numbers of its description") };
                Self { $($number),* }
            }
        }
    };
}
pub(super) use friction_numbers;

/// A number that a friction law takes from the model file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionNumber {
    /// Its key.
    pub key: &'static str,
    /// Its value, SI, where the file has none; absent where the file must have one.
    pub default_si: Option<f64>,
}

/// A friction law as model files, help and reports know it.
#[derive(Debug, Clone, Copy)]
pub struct FrictionDescription {
    /// The name used in model files, in kebab case.
    pub name: &'static str,
    /// Author, year and equation.
    pub source: &'static str,
    /// Its numbers in the model file.
    pub numbers: &'static [FrictionNumber],
    /// Two of its keys: the value of the first must be below that of the second.
    pub below: Option<[&'static str; 2]>,
}

/// Asserts the force of `law` against μ(v), v >= 0, from rest to fast sliding and in both directions; that friction never supplies
/// power; and that the force jumps nowhere and its slope only where the law says so.
#[cfg(test)]
pub(super) fn assert_coefficient<F: Friction<f64>>(law: &F, coefficient: impl Fn(f64) -> f64) {
    const NORMAL_N: f64 = 1700.0;
    let kinks: Vec<f64> = law.kink_speeds_m_s().into_iter().flatten().collect();
    let mut speed_m_s = 1e-9;
    while speed_m_s < 20.0 {
        let expected_n = coefficient(speed_m_s) * NORMAL_N;
        for sign in [-1.0, 1.0] {
            let force_n = law.force_n(sign * speed_m_s, NORMAL_N);
            // Round-off on a few hundred newtons.
            assert!((force_n + sign * expected_n).abs() < 1e-10, "{speed_m_s}: {force_n} {expected_n}");
            assert!(force_n * sign * speed_m_s <= 0.0, "friction never supplies power");
        }
        // Slopes on both sides of the place, over a share of it; they differ by that share where there is no kink.
        let step_m_s = 1e-6 * speed_m_s;
        let slope = |from: f64, to: f64| (law.force_n(to, NORMAL_N) - law.force_n(from, NORMAL_N)) / (to - from);
        let (left, right) = (slope(speed_m_s - step_m_s, speed_m_s), slope(speed_m_s, speed_m_s + step_m_s));
        let is_kink = kinks.iter().any(|kink| (speed_m_s - kink).abs() < 2.0 * step_m_s);
        let steepest = NORMAL_N * 10.0 / speed_m_s.max(1e-4);
        assert!(is_kink || (left - right).abs() < 1e-4 * steepest, "{speed_m_s}: slopes {left} and {right}");
        speed_m_s *= 1.01;
    }
    // At rest there is no force, and it does not jump there.
    assert_eq!(law.force_n(0.0, NORMAL_N), 0.0);
    assert!((law.force_n(1e-12, NORMAL_N) - law.force_n(-1e-12, NORMAL_N)).abs() < 1e-4);
    for kink in kinks {
        let (below, above) = (law.force_n(kink * (1.0 - 1e-9), NORMAL_N), law.force_n(kink * (1.0 + 1e-9), NORMAL_N));
        assert!((below - above).abs() < 1e-5, "the force is continuous at {kink}");
    }
}
