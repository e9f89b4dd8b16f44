//! What a linear contact law is.

/// A linear contact law `F_N = K δ + D δ̇`, cut at zero: it tells where D comes from.
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
}
