//! State at the end of a run, from which another run can continue.

use loosepin_text::units::extended;
use serde::{Deserialize, Serialize};

/// All that the motion after the end of a run depends on. A mechanism that follows its drives alone has the time and its values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EndState {
    /// Time since the start of the first run.
    #[serde(with = "extended")]
    pub time_s: f64,
    /// Free coordinates in the order of the mechanism, m or rad; those of flexible bodies belong to them.
    #[serde(with = "extended")]
    pub coordinates_si: Vec<f64>,
    /// Their rates.
    #[serde(with = "extended")]
    pub rates_si: Vec<f64>,
    /// Deflections of the bristles of friction: those of contacts, then those of ideal joints.
    #[serde(with = "extended")]
    pub bristles_si: Vec<f64>,
    /// Integrals of the errors of controls.
    #[serde(with = "extended")]
    pub error_integrals_si: Vec<f64>,
    /// Names of the contacts.
    pub contacts: Vec<String>,
    /// Whether each contact is closed.
    pub is_closed: Vec<bool>,
    /// Inverse of the speed at which each closed contact began, which contact laws remember, s/m; 0 of an open one.
    #[serde(with = "extended")]
    pub inverse_impact_speeds_s_m: Vec<f64>,
    /// Mass that each closed contact met where it began; 0 where its law does not ask for it, and of an open one.
    #[serde(with = "extended")]
    pub effective_masses_kg: Vec<f64>,
    /// Paths of all quantities of the model.
    pub paths: Vec<String>,
    /// Their values in the run.
    #[serde(with = "extended")]
    pub values_si: Vec<f64>,
}
