//! The sections that a page and a terminal show of a study, each made once.
//! Figures of a page alone stand in `page`.

mod accuracy;
mod allowed;
mod answers;
mod bounds;
mod columns;
mod contributors;
mod promise;
mod runs;
mod surrogate;
mod surrogate_words;
mod treatment_sentences;
mod treatments;

pub(crate) use accuracy::accuracy_section;
pub(crate) use allowed::{allowed_section, rare_section};
pub(crate) use answers::answers_section;
pub(crate) use bounds::{bounds_excerpt, bounds_section, places_section};
pub(crate) use columns::{degrees_section, percentiles_section};
pub(crate) use contributors::{contributors_excerpt, contributors_overview, contributors_section, what_narrows};
pub(crate) use promise::promise_section;
pub(crate) use runs::{double_loop_words, failures_section, runs_section};
pub(crate) use surrogate::surrogate_section;
pub(crate) use treatments::treatments_section;
