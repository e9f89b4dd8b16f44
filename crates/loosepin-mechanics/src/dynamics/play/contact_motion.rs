//! Motion, unknowns and force of one contact.

use loosepin_math::{Real, Vec2};

/// The root u = √δ of a penetration as an unknown of its own, for contact that is smooth from its beginning to its end.
#[derive(Debug, Clone, Copy)]
pub struct DepthRoot<T> {
    /// One where the root is an unknown, zero where the penetration is read off the positions.
    pub is_unknown: T,
    /// u, √m, where it is an unknown.
    pub root: T,
    /// Whether any penetration may have to be read off the positions. Where none has, the root is an unknown, or the contact is open and
    /// its root zero: the force is the same.
    pub may_be_read: bool,
}

/// Unknowns of a contact in the state vector, beside the motion of its bodies.
#[derive(Debug, Clone, Copy)]
pub struct ContactUnknowns<T> {
    /// The root of the penetration, where the contact has one.
    pub root: Option<DepthRoot<T>>,
    /// Mean deflection z of the bristles, m, where the friction law has them.
    pub bristle_m: Option<T>,
}

impl<T> ContactUnknowns<T> {
    /// Nothing: the penetration is read off the positions, and bristles have settled.
    pub fn none() -> Self {
        Self { root: None, bristle_m: None }
    }
}

/// How the two bodies of a joint with play come near each other at one place.
#[derive(Debug, Clone, Copy)]
pub struct ContactMotion<T> {
    /// n, in the ground's frame: the second body (journal, slider) is pushed back along -n.
    pub normal: Vec2<T>,
    /// δ, m: positive in contact.
    pub penetration_m: T,
    /// δ̇, m/s.
    pub penetration_rate_m_s: T,
    /// From the joint's points P_i and P_j to where the normal force acts on their bodies, m, in the ground's frame.
    pub reaches_m: [Vec2<T>; 2],
}

/// How the two surfaces slide on each other where they touch.
#[derive(Debug, Clone, Copy)]
pub(in crate::dynamics) struct Sliding<T> {
    /// v_T that friction goes by, m/s.
    pub sliding_m_s: T,
    /// Sliding velocity of the second body's material on the first's, m/s.
    pub material_m_s: T,
    /// Moment arms of a force along t about P_i on the first body (from it, not on it) and about P_j on the second, m.
    pub arms_m: [T; 2],
}

/// The force of one contact.
#[derive(Debug, Clone, Copy)]
pub struct ContactForce<T> {
    /// F_j: force on the second body (journal), N, in the ground's frame; the first one (bearing) gets the opposite.
    pub on_journal_n: Vec2<T>,
    /// Moment about the journal centre P_j on the journal's body, N m.
    pub moment_on_journal_n_m: T,
    /// Moment about the bearing centre P_i on the bearing's body, N m.
    pub moment_on_bearing_n_m: T,
    /// Power that the normal contact turns into heat: -(F_el - F_N) δ̇ = (F_N - F_el) δ̇, W.
    pub contact_loss_w: T,
    /// Power that friction turns into heat, -F_T v_T with the material sliding velocity, and a film of oil, W.
    pub friction_loss_w: T,
    /// The part of the film in it, W.
    pub film_loss_w: T,
    /// Normal force F_N, N.
    pub normal_n: T,
    /// Penetration rate δ̇, m/s.
    pub penetration_rate_m_s: T,
    /// Rate ż of the deflection of the bristles, m/s; zero without any.
    pub bristle_rate_m_s: T,
    /// Sliding velocity v_T of the friction law, m/s; zero without friction and wear.
    pub sliding_m_s: T,
    /// F_N |v_T| summed over the sectors of an elastic foundation, W; `None` for a contact at one point.
    pub spread_path_w: Option<T>,
    /// Normal force here over that of the contact's law, and on an elastic foundation the force itself, N: one but for the ends of a slot,
    /// which are stiffer, the inner flank of a circular slot, which is less stiff, and the edges of a guide, on which the block leans.
    pub force_share: T,
    /// Abscissa of the corner along the guide's line, m; zero but for a slider.
    pub along_m: T,
}

impl<T: Real> ContactForce<T> {
    /// F_N |v_T|, W: what the contact adds to the friction path ∫F_N |v_T| dt. A contact that pulls does not wear.
    #[inline(always)]
    pub fn friction_path_w(&self) -> T {
        self.spread_path_w.unwrap_or_else(|| self.normal_n.max(T::zero()) * self.sliding_m_s.abs())
    }
}

/// The gap function of a contact, positive in contact, and the second derivative of the penetration.
#[derive(Debug, Clone, Copy)]
pub struct GapMotion<T> {
    /// g and its first two derivatives over the time; [`crate::mechanism::GapMeasure`] says what it measures.
    pub gap: [T; 3],
    /// δ̈, m/s².
    pub penetration_acceleration_m_s2: T,
    /// ξ of a pin along its slot's line, m, and its first two derivatives over the time; zeros where there is no straight slot.
    pub along: [T; 3],
}

impl<T: Real> GapMotion<T> {
    /// Motion of a contact which is not in a straight slot.
    #[inline(always)]
    pub(in crate::dynamics) fn without_slot(gap: [T; 3], penetration_acceleration_m_s2: T) -> Self {
        Self { gap, penetration_acceleration_m_s2, along: [T::zero(); 3] }
    }
}
