//! What a point-contact law is.

/// A point-contact law `F_N = K δⁿ (1 + χ δ̇/v0)`, \[SC16\] eq. (8): it gives the factor χ of its energy loss.
#[derive(Debug)]
pub struct PointLaw {
    /// The name used in model files, in kebab case.
    pub name: &'static str,
    /// Author, year and the equation of χ, as shown in help and reports.
    pub source: &'static str,
    /// χ for a nominal coefficient of restitution in (0, 1].
    pub damping_factor: fn(restitution: f64) -> f64,
}
