//! The quasi-static answer and the deviation of a run from the ideal motion.
//!
//! To first order in the clearances a journal at eccentricity e_k moves an output by g_k·e_k; g_k comes from the loop
//! equations by the implicit function theorem on dual numbers. The same way gives the effect of every dimension.

mod accuracy_output;
mod check;
mod cycle;
mod cycle_worst_case;
mod dead_centre;
mod deviation_ends;
mod diagnostic;
mod dimension;
mod efforts;
mod error;
mod in_space;
mod loops;
mod motion;
mod overhang;
mod path;
mod play_effect;
mod play_reach;
mod position;
pub use loosepin_result::motion as record;
mod round_off;
mod sensitivity;
mod together;
mod transmission;
mod unproven;
mod worst_case;

pub use check::{check_quasi_static, quasi_static_check};
pub use deviation_ends::{
    AllDeviationEnds, DeviationEnds, DeviationQuestion, DimensionLimit, FoundDeviation, deviation_ends,
    deviation_ends_until,
};
pub use dimension::{DimensionDirection, dimension_direction};
pub use error::AccuracyError;
pub use loops::DisplacedLoops;
pub use motion::{
    AskedPose, MotionPlan, Scatter, ScatterCorrelation, motion, motion_until, motion_with_worst_cases,
    motion_with_worst_cases_until,
};
pub use play_reach::PlayReach;
pub use position::{PositionOutput, position_outputs};
pub use sensitivity::{dimension_derivatives, play_gradients};
pub use worst_case::{
    WorstCaseExtremes, WorstPosition, disc_standard_deviation_si, first_order_si, rim_standard_deviation_si,
    starts_on_borders, worst_case_extremes,
};
