//! The interface of a friction law.

use loosepin_math::Real;
use loosepin_text::document::Key;

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

/// A number that friction laws take from the model file: its key, and the part of friction that it belongs to.
#[derive(Debug, Clone, Copy)]
pub struct FrictionKey {
    /// The part.
    pub of: FrictionPart,
    /// The key. Laws that have a key in common have the same one.
    pub key: Key,
    /// Its value where the file has none; `None` where the file must have one.
    pub usual: Option<&'static str>,
}

impl FrictionKey {
    /// The word of its key.
    pub const fn name(&self) -> &'static str {
        self.key.name
    }
}

/// Declares a [`FrictionKey`], written as a key of a [`record!`](loosepin_text::record) behind its part.
macro_rules! friction_key {
    (
        $(#[doc = $doc:literal])+
        $visibility:vis $name:ident of $part:ident:
        $need:ident $key:ident = $kind:expr, $example:literal $(, or $usual:literal $(called $called:literal)?)?
    ) => {
        $(#[doc = $doc])+
        $visibility const $name: FrictionKey = FrictionKey {
            of: FrictionPart::$part,
            key: loosepin_text::record!(
                @key $need (), stringify!($key), [$($doc),+], $kind, $example $(, $usual $(called $called)?)?
            )[0],
            usual: [$(Some($usual),)? None][0],
        };
    };
}
pub(super) use friction_key;

/// The parts of friction, from rest to fast sliding: keys are listed in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrictionPart {
    /// How large it is.
    Sliding,
    /// Where it begins and is full.
    Ramp,
    /// How large it is at the onset of sliding.
    Onset,
    /// Where it has risen from nothing.
    Rise,
    /// How it falls from its static to its dynamic value.
    Fall,
    /// Bristles between the surfaces.
    Bristles,
    /// What grows with the speed.
    Viscous,
}

impl FrictionPart {
    /// The last one.
    pub(super) const LAST: Self = Self::Viscous;
}

/// A friction law as model files, help and reports know it.
#[derive(Debug, Clone, Copy)]
pub struct FrictionDescription {
    /// The name used in model files, in kebab case.
    pub name: &'static str,
    /// Author, year and equation.
    pub source: &'static str,
    /// Its numbers in the model file.
    pub numbers: &'static [FrictionKey],
    /// Two of its keys: the value of the first must be below that of the second.
    pub below: Option<[&'static str; 2]>,
}
