//! The interface of a linear contact law.

use std::fmt::Debug;

/// A linear contact law `F_N = K δ + D δ̇`, cut at zero: it tells where D comes from.
pub trait LinearLaw: Debug + Sync {
    /// The name used in model files, in kebab case.
    fn name(&self) -> &'static str;
    /// Author, year and the equation of D, as shown in help and reports.
    fn source(&self) -> &'static str;
    /// The damping ratio ξ of `D = 2ξ √(K m_eff)` for a nominal restitution in (0, 1], m_eff the mass that the contact meets
    /// along its normal where it begins. None where D itself is given.
    fn damping_ratio(&self, restitution: f64) -> Option<f64>;
    /// Whether D itself is given.
    fn has_given_damping(&self) -> bool {
        self.damping_ratio(0.5).is_none()
    }
}
