//! The table of point-contact laws.

use std::fmt::Debug;

/// A point-contact law `F_N = K δⁿ (1 + χ δ̇/v0)` (method, section 2.1): it gives the factor χ of its energy loss.
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

/// Lankarani and Nikravesh 1990, the law of the source paper and the default.
#[derive(Debug)]
pub struct LankaraniNikravesh;

impl PointLaw for LankaraniNikravesh {
    fn name(&self) -> &'static str {
        "lankarani-nikravesh"
    }
    fn source(&self) -> &'static str {
        "Lankarani and Nikravesh 1990, [SC16] eq. (8): χ = 3(1 - c_e²)/4"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        3.0 * (1.0 - restitution * restitution) / 4.0 // eq. (8)
    }
}

/// Every point-contact law, in the order of the method's table.
pub static POINT_LAWS: &[&dyn PointLaw] = &[&LankaraniNikravesh];

/// The law called `name` in model files.
pub fn point_law(name: &str) -> Option<&'static dyn PointLaw> {
    POINT_LAWS.iter().copied().find(|law| law.name() == name)
}
