//! The friction force of a contact, whatever its law.

use super::ambrosio::AmbrosioFriction;
use super::bengisu_akay::BengisuAkayFriction;
use super::brown_mcphee::BrownMcPheeFriction;
use super::lugre::LuGreFriction;
use super::stribeck::StribeckFriction;
use super::threlfall::ThrelfallFriction;
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
pub trait Friction<T: Real>: Sized {
    /// The law with its numbers in the order of its description.
    fn from_numbers(numbers: &[T]) -> Self;

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

    /// Shows every number of the law, in the order of its description.
    fn visit(&mut self, visit: &mut impl FnMut(&mut T));
}

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
    /// What it takes from the model file.
    pub numbers: &'static [FrictionNumber],
    /// Two of its keys: the value of the first must be below that of the second.
    pub below: Option<[&'static str; 2]>,
}

impl<T> FrictionLaw<T> {
    /// Whether there is any friction.
    #[inline(always)]
    pub fn acts(&self) -> bool {
        !matches!(self, Self::None)
    }
}

impl FrictionLaw<f64> {
    /// Distance from a kink within which a step counts as ending on it, m/s: a share of the narrowest piece.
    pub fn kink_tolerance_m_s(&self) -> f64 {
        let (mut before_m_s, mut narrowest_m_s) = (0.0, f64::INFINITY);
        for speed_m_s in self.kink_speeds_m_s().into_iter().flatten() {
            narrowest_m_s = f64::min(narrowest_m_s, speed_m_s - before_m_s);
            before_m_s = speed_m_s;
        }
        1e-3 * narrowest_m_s
    }
}

/// The enum of all laws, what it hands on to them, and the table of their descriptions.
macro_rules! friction_laws {
    ($($variant:ident($friction:ident)),* $(,)?) => {
        /// The friction law of a contact with its numbers. Which one it is belongs to the mechanism and is the same in all
        /// lanes.
        #[derive(Debug, Clone, Copy)]
        pub enum FrictionLaw<T> {
            /// No friction.
            None,
            $(#[doc = concat!("The numbers of `", stringify!($friction), "`.")] $variant($friction<T>)),*
        }

        /// Every friction law.
        pub static FRICTION_LAWS: &[FrictionDescription] = &[$($friction::<f64>::DESCRIPTION),*];

        impl FrictionDescription {
            /// The law with its numbers in the order of [`FrictionDescription::numbers`].
            pub fn law(&self, numbers: &[f64]) -> FrictionLaw<f64> {
                $(if self.name == $friction::<f64>::DESCRIPTION.name {
                    return FrictionLaw::$variant($friction::from_numbers(numbers));
                })*
                FrictionLaw::None
            }
        }

        impl<T: Real> FrictionLaw<T> {
            /// The same numbers in every lane.
            pub fn broadcast(from: &FrictionLaw<f64>) -> Self {
                let mut numbers = Vec::new();
                from.clone().visit(&mut |number| numbers.push(T::from_f64(*number)));
                match from {
                    FrictionLaw::None => Self::None,
                    $(FrictionLaw::$variant(_) => Self::$variant($friction::from_numbers(&numbers))),*
                }
            }

            /// F_T, N (see [`Friction::force_n`]).
            #[inline(always)]
            pub fn force_n(&self, sliding_velocity_m_s: T, normal_force_n: T) -> T {
                match self {
                    Self::None => T::zero(),
                    $(Self::$variant(friction) => friction.force_n(sliding_velocity_m_s, normal_force_n)),*
                }
            }

            /// Speeds at which the slope of μ jumps, m/s (see [`Friction::kink_speeds_m_s`]).
            #[inline(always)]
            pub fn kink_speeds_m_s(&self) -> KinkSpeeds<T> {
                match self {
                    Self::None => [None, None],
                    $(Self::$variant(friction) => friction.kink_speeds_m_s()),*
                }
            }

            /// Whether the law has a memory (see [`Friction::has_bristle`]).
            #[inline(always)]
            pub fn has_bristle(&self) -> bool {
                match self {
                    Self::None => false,
                    $(Self::$variant(friction) => friction.has_bristle()),*
                }
            }

            /// F_T and ż (see [`Friction::force_with_bristle`]).
            #[inline(always)]
            pub fn force_with_bristle(&self, sliding_m_s: T, normal_force_n: T, deflection_m: T) -> BristledForce<T> {
                match self {
                    Self::None => BristledForce { force_n: T::zero(), rate_m_s: T::zero() },
                    $(Self::$variant(friction) => {
                        friction.force_with_bristle(sliding_m_s, normal_force_n, deflection_m)
                    })*
                }
            }

            /// The largest deflection in steady sliding, m (see [`Friction::largest_deflection_m`]).
            #[inline(always)]
            pub fn largest_deflection_m(&self) -> T {
                match self {
                    Self::None => T::zero(),
                    $(Self::$variant(friction) => friction.largest_deflection_m()),*
                }
            }

            /// Shows every number of the law.
            pub fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
                match self {
                    Self::None => {}
                    $(Self::$variant(friction) => friction.visit(visit)),*
                }
            }
        }
    };
}

friction_laws! {
    Ambrosio(AmbrosioFriction),
    Threlfall(ThrelfallFriction),
    Stribeck(StribeckFriction),
    BrownMcPhee(BrownMcPheeFriction),
    BengisuAkay(BengisuAkayFriction),
    LuGre(LuGreFriction),
}

/// The friction law called `name` in model files.
pub fn friction_law(name: &str) -> Option<&'static FrictionDescription> {
    FRICTION_LAWS.iter().find(|law| law.name == name)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_a_law_is_found_by_name_takes_its_numbers_and_shows_them_in_order() {
        for description in FRICTION_LAWS {
            let numbers: Vec<f64> = (1..=description.numbers.len()).map(|k| 0.01 * k as f64).collect();
            let mut law = FrictionLaw::<f64>::broadcast(&description.law(&numbers));
            let mut shown = Vec::new();
            law.visit(&mut |number| shown.push(*number));
            assert_eq!(shown, numbers, "{}", description.name);
            assert!(law.acts());
            assert_eq!(friction_law(description.name).map(|found| found.source), Some(description.source));
            let keys = description.numbers.iter().map(|number| number.key);
            assert!(description.below.into_iter().flatten().all(|key| keys.clone().any(|known| known == key)));
        }
        assert!(!FrictionLaw::<f64>::None.acts());
        assert_eq!(FrictionLaw::<f64>::None.force_n(0.7, 1700.0), 0.0);
    }
}
