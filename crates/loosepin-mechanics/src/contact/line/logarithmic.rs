//! The numbers that the logarithmic laws share.

use super::pair::LinePair;
use crate::contact::normal::{LogarithmicContact, NormalLaw};

/// δ = s ln(a/s), s = F h/L, with the length a, m, and the factor χ of the energy loss.
pub(super) fn logarithmic_law(pair: &LinePair, scale_m: f64, damping_factor: f64) -> NormalLaw<f64> {
    LogarithmicContact { stiffness_n_m: pair.length_m / pair.h_1_pa(), scale_m, damping_factor }.into()
}
