//! The interface of a line-contact law.

use super::pair::LinePair;
use crate::contact::normal::NormalLaw;
use std::fmt::Debug;

/// A line-contact law (`docs/contact-laws.md`), with the energy loss of a point-contact law: F_N = F_el(δ)(1 + χ δ̇/v0).
pub trait LineLaw: Debug + Sync {
    /// The name used in model files, in kebab case.
    fn name(&self) -> &'static str;
    /// Author, year and equation, and which of several published versions it is, as shown in help and reports.
    fn source(&self) -> &'static str;
    /// The point-contact law whose χ it has where the model file names none.
    fn default_damping(&self) -> &'static str {
        "lankarani-nikravesh"
    }
    /// The smallest and largest radial clearance that the law was fitted to, m; none for a law without a fit.
    fn fitted_clearances_m(&self) -> Option<[f64; 2]> {
        None
    }
    /// The law for a pair with the factor χ of the energy loss.
    fn contact(&self, pair: &LinePair, damping_factor: f64) -> NormalLaw<f64>;
}
