//! The forms of the normal force: the numbers of a law and its equation, as the equations of motion evaluate them.
//!
//! One form a file: a struct over [`Real`] that implements [`NormalContact`], and one line in the list at the end of this file. A form is
//! made into a [`NormalLaw`] by `into`, and asked through [`NormalContact`]: nothing outside this folder names a variant.

mod bai_zhao;
mod contact;
mod linear;
mod liu;
mod logarithmic;
mod pereira;
mod point;

pub use bai_zhao::BaiZhaoContact;
pub use contact::{NormalContact, NormalForce, PlayState};
pub use linear::{LinearContact, damping_ratio_that_delivers, restitution_of_damping_ratio};
pub use liu::LiuContact;
pub use logarithmic::{LogarithmicContact, inverse_logarithmic};
pub use pereira::PereiraContact;
pub use point::PointContact;

use loosepin_math::{Real, numbers};

/// The enum of all laws, and what it hands on to them.
macro_rules! normal_laws {
    ($($variant:ident($contact:ident)),* $(,)?) => {
        /// The normal force law of a contact with its numbers. Which one it is belongs to the mechanism and is the same in
        /// all lanes.
        #[derive(Debug, Clone, Copy)]
        pub enum NormalLaw<T> {
            $(#[doc = concat!("The numbers of `", stringify!($contact), "`.")] $variant($contact<T>)),*
        }

        numbers!(enum NormalLaw { $($variant(contact)),* });

        $(impl<T> From<$contact<T>> for NormalLaw<T> {
            fn from(contact: $contact<T>) -> Self {
                Self::$variant(contact)
            }
        })*

        impl<T: Real> NormalContact<T> for NormalLaw<T> {
            #[inline(always)]
            fn elastic_n(&self, penetration_m: T) -> T {
                match self {
                    $(Self::$variant(contact) => contact.elastic_n(penetration_m)),*
                }
            }
            #[inline(always)]
            fn elastic_at_root_n(&self, root: T) -> T {
                match self {
                    $(Self::$variant(contact) => contact.elastic_at_root_n(root)),*
                }
            }
            #[inline(always)]
            fn damping_factor(&self) -> T {
                match self {
                    $(Self::$variant(contact) => contact.damping_factor()),*
                }
            }
            #[inline(always)]
            fn force(&self, penetration_m: T, rate_m_s: T, state: &PlayState<T>) -> NormalForce<T> {
                match self {
                    $(Self::$variant(contact) => contact.force(penetration_m, rate_m_s, state)),*
                }
            }
            #[inline(always)]
            fn stored_energy_j(&self, penetration_m: T) -> T {
                match self {
                    $(Self::$variant(contact) => contact.stored_energy_j(penetration_m)),*
                }
            }
            #[inline(always)]
            fn stiffness(&self) -> Option<(T, f64)> {
                match self {
                    $(Self::$variant(contact) => contact.stiffness()),*
                }
            }
            #[inline(always)]
            fn is_smooth_in_root(&self) -> bool {
                match self {
                    $(Self::$variant(contact) => contact.is_smooth_in_root()),*
                }
            }
            #[inline(always)]
            fn force_at_root(&self, root: T, rate_m_s: T, state: &PlayState<T>) -> NormalForce<T> {
                match self {
                    $(Self::$variant(contact) => contact.force_at_root(root, rate_m_s, state)),*
                }
            }
            #[inline(always)]
            fn largest_force_n(&self, penetration_m: T, rate_m_s: T, state: &PlayState<T>) -> T {
                match self {
                    $(Self::$variant(contact) => contact.largest_force_n(penetration_m, rate_m_s, state)),*
                }
            }
            #[inline(always)]
            fn limit_m(&self) -> Option<T> {
                match self {
                    $(Self::$variant(contact) => contact.limit_m()),*
                }
            }
            #[inline(always)]
            fn has_abrupt_onset(&self) -> bool {
                match self {
                    $(Self::$variant(contact) => contact.has_abrupt_onset()),*
                }
            }
            #[inline(always)]
            fn needs_effective_mass(&self) -> bool {
                match self {
                    $(Self::$variant(contact) => contact.needs_effective_mass()),*
                }
            }
        }
    };
}

normal_laws! {
    Point(PointContact),
    Linear(LinearContact),
    Logarithmic(LogarithmicContact),
    Liu(LiuContact),
    BaiZhao(BaiZhaoContact),
    Pereira(PereiraContact),
}
