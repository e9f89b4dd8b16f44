//! Values with their tolerances, as drawings write them: `50 ± 0.05 mm`, `50 +0.02 -0.01 mm`, `50 h9`. What a study makes of them is known there.
//!
//! | What | File |
//! |---|---|
//! | a nominal value with its deviations | `written.rs` |
//! | the tables of ISO 286-1 for holes, shafts and fits | `iso_286.rs` |
//! | what is said where a single value is due | `in_model.rs` |

mod in_model;
mod iso_286;
mod written;

pub use in_model::{for_single_value, limits_of_class};
pub use iso_286::{Fit, FitError, FitLimits, class_deviations_m};
pub use written::{
    SeparateTolerance, Tolerance, number_and_unit, parse_tolerance, separate_tolerance, signed_parts, states_nominal,
};
