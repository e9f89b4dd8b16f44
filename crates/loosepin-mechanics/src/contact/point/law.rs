//! The interface of a point-contact law.

use std::fmt::Debug;

/// A point-contact law `F_N = K δⁿ (1 + χ δ̇/v0)`, \[SC16\] eq. (8): it gives the factor χ of its energy loss.
pub trait PointLaw: Debug + Sync {
    /// The name used in model files, in kebab case.
    fn name(&self) -> &'static str;
    /// Author, year and the equation of χ, as shown in help and reports.
    fn source(&self) -> &'static str;
    /// χ for a nominal coefficient of restitution `restitution` in (0, 1].
    fn damping_factor(&self, restitution: f64) -> f64;
    /// Whether χ grows without limit as the coefficient of restitution goes to zero.
    fn diverges_at_zero_restitution(&self) -> bool {
        false
    }
}
