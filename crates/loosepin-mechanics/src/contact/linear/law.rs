//! Description of a linear contact law.

use crate::contact::normal::{LinearContact, NormalLaw, restitution_of_damping_ratio};

/// A linear contact law `F_N = K δ + D δ̇`, cut at zero; it defines D.
#[derive(Debug)]
pub struct LinearLaw {
    /// The name used in model files, in kebab case.
    pub name: &'static str,
    /// Author, year and the equation of D, as shown in help and reports.
    pub source: &'static str,
    /// The damping ratio ξ of `D = 2ξ √(K m_eff)` for a nominal restitution in (0, 1], m_eff the mass that the contact meets
    /// along its normal where it begins. None where D itself is given.
    pub damping_ratio: Option<fn(restitution: f64) -> f64>,
}

impl LinearLaw {
    /// Whether D itself is given.
    pub fn has_given_damping(&self) -> bool {
        self.damping_ratio.is_none()
    }

    /// The law with its numbers: K, N/m, and the nominal restitution, or D, N s/m, where that is given.
    pub fn contact(&self, stiffness_n_m: f64, damping: f64) -> NormalLaw<f64> {
        let ratio = self.damping_ratio.map(|ratio| ratio(damping));
        let damping_n_s_m = if ratio.is_some() { 0.0 } else { damping };
        let (damping_ratio, has_ratio) = (ratio.unwrap_or(0.0), ratio.is_some());
        LinearContact { stiffness_n_m, damping_n_s_m, damping_ratio, has_ratio }.into()
    }

    /// The restitution that a free impact delivers for the nominal one; `None` where D is given: it then depends on the masses that meet.
    pub fn delivered_restitution(&self, restitution: f64) -> Option<f64> {
        self.damping_ratio.map(|ratio| restitution_of_damping_ratio(ratio(restitution)))
    }
}
