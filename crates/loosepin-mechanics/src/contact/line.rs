//! Line contact of a cylinder in a cylinder: what its laws share.

use super::normal::NormalLaw;
use super::{bai_zhao, dubowsky_freudenstein, esdu, johnson, liu, pereira, radzimovsky};
use std::fmt::Debug;

/// A pin in a hole as line-contact laws see it.
#[derive(Debug, Clone, Copy)]
pub struct LinePair {
    /// Radius R_i of the bearing, m.
    pub bearing_radius_m: f64,
    /// Radial clearance c, m.
    pub clearance_m: f64,
    /// Length L of the bearing, m.
    pub length_m: f64,
    /// Compliances (1 - ν²)/E of bearing and journal, 1/Pa.
    pub compliances_1_pa: [f64; 2],
}

impl LinePair {
    /// Radius R_j = R_i - c of the journal, m.
    pub fn journal_radius_m(&self) -> f64 {
        self.bearing_radius_m - self.clearance_m
    }
    /// h = ((1 - ν_i²)/E_i + (1 - ν_j²)/E_j)/π, 1/Pa: with 1/π, as the line-contact laws have it.
    pub fn h_1_pa(&self) -> f64 {
        (self.compliances_1_pa[0] + self.compliances_1_pa[1]) / std::f64::consts::PI
    }
    /// E* = 1/(π h), Pa.
    pub fn equivalent_modulus_pa(&self) -> f64 {
        1.0 / (self.compliances_1_pa[0] + self.compliances_1_pa[1])
    }
}

/// A line-contact law (method, section 2.2), with the energy loss of a point-contact law: F_N = F_el(δ)(1 + χ δ̇/v0).
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

/// Every line-contact law, in the order of the method's table.
pub static LINE_LAWS: &[&dyn LineLaw] = &[
    &johnson::Johnson,
    &esdu::Esdu78035,
    &dubowsky_freudenstein::DubowskyFreudenstein,
    &radzimovsky::Radzimovsky,
    &liu::Liu,
    &bai_zhao::BaiZhao,
    &pereira::Pereira,
];
