//! The interface of a form of the normal force, and the state of a contact that it is given.

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

/// A normal force and its elastic part.
#[derive(Debug, Clone, Copy)]
pub struct NormalForce<T> {
    /// F_N, N, never negative.
    pub total_n: T,
    /// F_el, N: the part that is stored and given back.
    pub elastic_n: T,
}

impl<T: Real> NormalForce<T> {
    /// The force where the stiffness is `share` times that of the law.
    #[inline(always)]
    pub fn scale(&mut self, share: T) {
        self.total_n *= share;
        self.elastic_n *= share;
    }
}

/// The numbers of a normal force law and its equations: what the equations of motion evaluate.
///
/// The contact loses the power (F_N - F_el) δ̇, also while F_N is cut at zero. Most laws are an elastic force and a factor:
/// `F_N = F_el(δ) (1 + χ δ̇/v0)`, cut at zero; they give F_el and χ. A law with another loss gives the forces themselves.
pub trait NormalContact<T: Real> {
    /// F_el at penetration δ, m, N: zero where δ is negative.
    fn elastic_n(&self, penetration_m: T) -> T;

    /// F_el at the root u = √δ of the penetration, √m. A negative root, just beyond the end of contact, continues the force
    /// smoothly where the law has a root.
    #[inline(always)]
    fn elastic_at_root_n(&self, root: T) -> T {
        self.elastic_n(root * root)
    }

    /// χ; zero where the loss has another form.
    fn damping_factor(&self) -> T;

    /// The force at penetration δ, m, and penetration rate δ̇, m/s. In flight it is zero. For a negative δ, just beyond the end of
    /// contact, it is zero where F_el and its loss begin at zero; a damper without a spring's help goes by the contact in `state`.
    #[inline(always)]
    fn force(&self, penetration_m: T, rate_m_s: T, state: &PlayState<T>) -> NormalForce<T> {
        with_loss(self.elastic_n(penetration_m), self.damping_factor(), rate_m_s, state.inverse_impact_speed_s_m)
    }

    /// The elastic energy stored at penetration δ: ∫ F_el dδ, J.
    fn stored_energy_j(&self, penetration_m: T) -> T;

    /// K, N/mⁿ, and n of `F_el = K δⁿ`; `None` for an elastic force of another form.
    #[inline(always)]
    fn stiffness(&self) -> Option<(T, f64)> {
        None
    }

    /// Whether the force is smooth in the root u = √δ where contact begins: then u may be an unknown during a contact.
    fn is_smooth_in_root(&self) -> bool {
        false
    }

    /// The force at the root u = √δ of the penetration, √m, for a law that is smooth in it.
    #[inline(always)]
    fn force_at_root(&self, root: T, rate_m_s: T, state: &PlayState<T>) -> NormalForce<T> {
        with_loss(self.elastic_at_root_n(root), self.damping_factor(), rate_m_s, state.inverse_impact_speed_s_m)
    }

    /// An upper limit of the force up to a penetration, at rates up to the larger of `rate_m_s` and v0, N.
    #[inline(always)]
    fn largest_force_n(&self, penetration_m: T, rate_m_s: T, state: &PlayState<T>) -> T {
        let fastest = (rate_m_s * state.inverse_impact_speed_s_m).max(T::one());
        self.elastic_n(penetration_m) * self.damping_factor().mul_add(fastest, T::one())
    }

    /// The penetration beyond which the law says nothing, m, if there is one. A run that goes beyond fails; until that is seen
    /// the force is continued somehow.
    #[inline(always)]
    fn limit_m(&self) -> Option<T> {
        None
    }

    /// Whether the slope of the force changes infinitely fast where contact begins, as with a logarithm or an exponent just above
    /// one. The work of the contact shows that one derivative earlier than the velocities, so that the energy account is then
    /// held to the tolerance too.
    #[inline(always)]
    fn has_abrupt_onset(&self) -> bool {
        false
    }

    /// Whether the force depends on [`PlayState::effective_mass_kg`].
    #[inline(always)]
    fn needs_effective_mass(&self) -> bool {
        false
    }
}

/// `F_N = F_el (1 + χ δ̇/v0)`, \[SC16\] eq. (8), the factor cut at zero: the loss that most laws share.
#[inline(always)]
fn with_loss<T: Real>(elastic_n: T, damping_factor: T, rate_m_s: T, inverse_impact_speed_s_m: T) -> NormalForce<T> {
    let factor = (damping_factor * rate_m_s).mul_add(inverse_impact_speed_s_m, T::one()); // eq. (8), the bracket
    NormalForce { total_n: elastic_n * factor.max(T::zero()), elastic_n }
}
