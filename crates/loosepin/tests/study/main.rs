//! Whole studies, and bounds that are known otherwise.

#![allow(clippy::disallowed_methods, reason = "tests make files of their own")]

mod allowed_fits;
mod allowed_together;
mod any_statistic;
mod contact_law_lists;
mod drafts;
mod drawn_journals;
mod efforts;
mod epistemic_inputs;
mod exact_bounds;
mod further_turns;
mod inner_bands;
mod kept_runs;
mod paths;
mod planar_in_space;
mod position_tolerance;
mod promise;
mod proven_ends;
mod requirements;
mod shares;
mod silent;
mod space;
mod stress;
mod study_accuracy;
mod surrogates;
mod warm;
