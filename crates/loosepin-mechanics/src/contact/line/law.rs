//! Description of a line-contact law.

use super::pair::LinePair;
use crate::contact::normal::NormalLaw;
use crate::contact::point::PointLaw;

/// A line-contact law (`docs/contact-laws.md`), with the energy loss of a point-contact law: F_N = F_el(δ)(1 + χ δ̇/v0).
#[derive(Debug)]
pub struct LineLaw {
    /// The name used in model files, in kebab case.
    pub name: &'static str,
    /// Author, year and equation, and which of several published versions it is, as shown in help and reports.
    pub source: &'static str,
    /// The point-contact law whose χ it has where the model file names none.
    pub default_damping: &'static PointLaw,
    /// The smallest and largest radial clearance that the law was fitted to, m; `None` for a law without a fit.
    pub fitted_clearances_m: Option<[f64; 2]>,
    /// The law for a pair with the factor χ of the energy loss.
    pub contact: fn(pair: &LinePair, damping_factor: f64) -> NormalLaw<f64>,
}
