//! Friction laws: one a file, a struct over [`Real`] with its numbers, its `DESCRIPTION` and [`Friction`], and one line in the list
//! below.

mod ambrosio;
mod bengisu_akay;
mod brown_mcphee;
#[cfg(test)]
mod coefficient;
mod keys;
mod law;
mod lugre;
mod stribeck;
mod threlfall;

pub use ambrosio::AmbrosioFriction;
pub use bengisu_akay::BengisuAkayFriction;
pub use brown_mcphee::BrownMcPheeFriction;
pub use law::{BristledForce, Friction, FrictionDescription, FrictionKey, FrictionPart, KinkSpeeds};
pub use lugre::LuGreFriction;
pub use stribeck::StribeckFriction;
pub use threlfall::ThrelfallFriction;

use loosepin_math::{Real, numbers};
use loosepin_text::document::Key;

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
        pub static FRICTION_LAWS: &[FrictionDescription] = LAWS;

        const LAWS: &[FrictionDescription] = &[$($friction::<f64>::DESCRIPTION),*];

        impl FrictionDescription {
            /// The law with its numbers in the order of [`FrictionDescription::numbers`].
            pub fn law(&self, numbers: &[f64]) -> FrictionLaw<f64> {
                $(if self.name == $friction::<f64>::DESCRIPTION.name {
                    return FrictionLaw::$variant($friction::from_numbers(numbers));
                })*
                FrictionLaw::None
            }
        }

        numbers!(enum FrictionLaw { None, $($variant(friction)),* });

        impl<T: Real> FrictionLaw<T> {
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

/// The keys of the numbers of all laws, each once.
pub const FRICTION_KEYS: &[Key] = &keys::keys::<{ keys::count(LAWS) }>(LAWS);

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_math::Numbers;

    #[test]
    fn a_key_is_listed_once_and_means_the_same_in_all_laws() {
        let numbers = || FRICTION_LAWS.iter().flat_map(|law| law.numbers);
        for key in FRICTION_KEYS {
            assert_eq!(FRICTION_KEYS.iter().filter(|other| other.name == key.name).count(), 1, "{}", key.name);
            let mut same = numbers().filter(|number| number.name() == key.name);
            assert!(same.all(|number| format!("{:?}", number.key) == format!("{key:?}")), "{}", key.name);
        }
        assert!(numbers().all(|number| FRICTION_KEYS.iter().any(|key| key.name == number.name())));
    }

    #[test]
    fn identity_a_law_takes_its_numbers_and_shows_them_in_order() {
        for description in FRICTION_LAWS {
            let numbers: Vec<f64> = (1..=description.numbers.len()).map(|k| 0.01 * k as f64).collect();
            let mut law = FrictionLaw::<f64>::broadcast(&description.law(&numbers));
            let mut shown = Vec::new();
            law.visit(&mut |number| shown.push(*number));
            assert_eq!(shown, numbers, "{}", description.name);
            assert!(law.acts());
            let keys = description.numbers.iter().map(|number| number.name());
            assert!(description.below.into_iter().flatten().all(|key| keys.clone().any(|known| known == key)));
        }
        assert!(!FrictionLaw::<f64>::None.acts());
        assert_eq!(FrictionLaw::<f64>::None.force_n(0.7, 1700.0), 0.0);
    }
}
