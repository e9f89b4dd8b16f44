//! State of a contact: whether it is closed, and the numbers that it holds from its beginning.

use loosepin_math::Real;

/// Whether pin and hole touch, and what the present contact holds from its beginning to its end.
#[derive(Debug, Clone, Copy)]
pub struct PlayState<T> {
    /// One while in contact, zero in flight.
    pub contact: T,
    /// 1/v0 of the present contact, s/m; anything finite in flight.
    pub inverse_impact_speed_s_m: T,
    /// m_eff, kg: the mass that the contact met along its normal where it began, the inverse of the mechanism's inverse mass.
    /// Zero where the law does not ask for it, and in flight.
    pub effective_mass_kg: T,
}

impl<T: Real> PlayState<T> {
    /// No contact.
    pub fn flight() -> Self {
        Self { contact: T::zero(), inverse_impact_speed_s_m: T::zero(), effective_mass_kg: T::zero() }
    }
}
